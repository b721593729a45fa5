"""Every sentence stands once, in site_src/words/, and each one is spoken by something."""

from __future__ import annotations

import json
import re
import subprocess
from functools import cache
from pathlib import Path

import pytest

from raywalk.words import languages, read_words
from raywalk.words.catalogue import entries, linked, read_tree, slots_of, words_from
from raywalk.words.plurals import RULES, plural_form

ROOT = Path(__file__).parent.parent.parent
TELLERS = (
    "site_src/viewer/**/*.ts", "site_src/check/**/*.ts", "site_src/templates/*.html",
    "build/raywalk/**/*.py",
)  # fmt: skip
# say("a.b"), tell(...), phrases(...), also with a part put in: say(`a.${b}.c`), say(f"a.{b}"),
# say("a." ~ b); and keys named on their own: (isOn ? "a.b" : "a.c").
CALL = re.compile(r"(?:say|tell|phrases)\(\s*(f?)([`\"])([\w.${}?: \"']+?)\2(\s*~)?")


@cache
def source() -> str:
    files = [path for pattern in TELLERS for path in sorted(ROOT.glob(pattern))]
    files = [path for path in files if not path.name.endswith(".d.ts")]  # made from the keys
    return "\n".join(path.read_text(encoding="utf-8") for path in files)


@cache
def keys_said() -> list[re.Pattern[str]]:
    """What is said, as patterns of keys: a part put in may be any word."""
    patterns = []
    for is_f, quote, key, joined in CALL.findall(source()):
        if "." not in key:
            continue  # somebody else's tell(...)
        parts = re.split(r"\$?\{.*?\}+(?=[.`\w]|$)", key) if is_f or quote == "`" else [key]
        pattern = r"\w*".join(map(re.escape, parts)) + (r"\w+" if joined else "")
        patterns.append(re.compile(pattern))
    return patterns


def test_every_key_is_spoken_by_something() -> None:
    """A sentence that nobody says is dead weight in a translator's work."""
    english = dict(entries(read_words("en").tree))
    spoken = [key for key in english if not key.startswith("language.")]
    named = set(re.findall(r"[\"`]([a-z]\w*(?:\.\w+)+)[\"`]", source()))
    unused = [
        key for key in spoken if key not in named and not any(p.fullmatch(key) for p in keys_said())
    ]
    assert not unused


def test_every_key_that_is_spoken_is_there() -> None:
    """Templates and Python are not compiled: a misspelt key is found here."""
    english = [key for key, _ in entries(read_words("en").tree)]
    for pattern in keys_said():
        assert any(pattern.fullmatch(key) for key in english), pattern.pattern


@pytest.mark.parametrize("code", languages())
def test_every_language_has_the_same_sentences_with_the_same_slots(code: str) -> None:
    """What a translation lacks, has too much, or fills otherwise."""
    english, other = (dict(entries(read_tree(each))) for each in ("en", code))
    assert sorted(other) == sorted(english)
    for key, entry in english.items():
        assert slots_of(other[key]) == slots_of(entry), key
        assert set(linked(other[key])) == set(linked(entry)), key
        assert isinstance(other[key], str) == isinstance(entry, str), key


def test_a_sentence_is_filled_once() -> None:
    """What stands in a slot is never read as a slot."""
    words = words_from(
        {
            "language": {
                "code": "en", "name": "", "direction": "ltr",
                "decimal": ".", "group": "", "between": ", ",
            },
            "one": "A [ray](camera) meets **{name}**.",
            "many": {"one": "{count} ray", "other": "{count} rays"},
        }
    )  # fmt: skip
    said = words.say("one", name="**{name}** [x](y)")
    assert said == "A [ray](camera) meets ****{name}** [x](y)**."
    assert [words.say("many", count=n) for n in (0, 1, 2)] == ["0 rays", "1 ray", "2 rays"]


@pytest.mark.parametrize(
    ("key", "slots"),
    [
        ("no.such", {}),
        ("card", {}),
        ("card.t", {}),
        ("card.t", {"t": 1, "u": 2}),
        ("card.more", {}),
    ],
)
def test_unknown_keys_and_wrong_slots_are_refused(key: str, slots: dict[str, int]) -> None:
    """A page with a hole in a sentence is never written."""
    with pytest.raises(KeyError):
        read_words("en").say(key, **slots)


def test_python_chooses_a_plurals_form_as_browsers_do() -> None:
    """French says 0 in the singular, Polish and Arabic have more forms than two: for every language
    of the table, and each that there is."""
    counts = [*range(130), 1000, 1001, 999_999, 1_000_000, 2_000_000]
    script = (
        "const [codes, counts] = JSON.parse(process.argv[1]); console.log(JSON.stringify("
        "codes.map((code) => counts.map((n) => new Intl.PluralRules(code).select(n)))))"
    )
    codes = [*RULES, "pt-BR", "zh-Hant"]
    asked = json.dumps([codes, counts])
    theirs = json.loads(subprocess.run(["node", "-e", script, asked], check=True,
                                       capture_output=True, text=True).stdout)  # fmt: skip
    for code, forms in zip(codes, theirs, strict=True):
        assert [plural_form(code, n) for n in counts] == forms, code
    assert set(languages()) <= set(RULES)
    assert plural_form("en", "1") == "one" and plural_form("en", "1,001") == "other"
    with pytest.raises(KeyError, match='no rule for "tlh"'):
        plural_form("tlh", 1)
