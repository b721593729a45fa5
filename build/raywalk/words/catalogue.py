"""The catalogue of sentences, one file a language; viewer/words.ts tells from the same files."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from raywalk.home import HOME
from raywalk.words.numbers import Numbers
from raywalk.words.plurals import plural_form
from raywalk.work.snapshot import text_of

FOLDER = HOME / "site_src" / "words"
DEFAULT = "en"
SLOT = re.compile(r"\{(\w+)\}", re.ASCII)
MARK = re.compile(r"\[.+?\]\((\w+)\)", re.ASCII)  # [text](what it is marked as)

Entry = str | Mapping[str, str]  # a text, or the forms of a plural


@dataclass(frozen=True, eq=False)
class Words:
    """One language's sentences, and its numbers."""

    code: str
    name: str  # in the language itself
    direction: str  # "ltr" or "rtl"
    tree: Mapping[str, Any]
    numbers: Numbers

    def say(self, key: str, /, **slots: object) -> str:
        """The sentence of a key, e.g. "card.pixel", its slots filled. Of a plural, `count` chooses
        the form. Raises KeyError for an unknown key, and for slots that are not the sentence's."""
        return fill(self.text(key, slots), slots)

    def the(self, name: str) -> str:
        """A name as it stands in a sentence: "green sphere" is the green sphere, but "mirror A" and
        "light 1" are called so. The catalogue tells which (`articled`), and how (`article`, in
        which $& is the name)."""
        is_articled = re.search(self.text("language.articled", {}), name)
        return self.text("language.article", {}).replace("$&", name) if is_articled else name

    def text(self, key: str, slots: Mapping[str, object], links: bool = False) -> str:
        """The sentence with its slots still open, after a check that exactly they are given;
        links: marks name slots too, which hold addresses."""
        found = find(self.tree, key)
        needed = slots_of(found) | (set(linked(found)) if links else set())
        if set(slots) != needed:
            raise KeyError(f"{key}: its slots are {sorted(needed)}, not {sorted(slots)}")
        if isinstance(found, str):
            return found
        return found.get(plural_form(self.code, slots["count"]), found["other"])


def languages() -> list[str]:
    """Codes of all languages that there are, the default one first."""
    return sorted(
        (path.stem for path in FOLDER.glob("*.json")), key=lambda code: (code != DEFAULT, code)
    )


def read_words(code: str = DEFAULT) -> Words:
    """A language's sentences; what it lacks is said in the default one. Raises KeyError if there
    is none of that code."""
    if code not in languages():
        raise KeyError(f'no language "{code}"; there are {", ".join(languages())}')
    return _words(*(text_of(FOLDER / f"{each}.json") for each in (DEFAULT, code)))


@lru_cache(maxsize=8)  # by the texts themselves: a file that is saved anew is read anew
def _words(below: str, own: str) -> Words:
    return words_from(_over(json.loads(below), json.loads(own)))


def read_tree(code: str) -> dict[str, Any]:
    """A language's catalogue as it stands in its file."""
    tree: dict[str, Any] = json.loads(text_of(FOLDER / f"{code}.json"))
    return tree


def missing_sentences(code: str) -> list[str]:
    """Keys that the default language has and this one lacks."""
    there = dict(entries(read_tree(code)))
    return [key for key, _ in entries(read_tree(DEFAULT)) if key not in there]


def _over(below: Mapping[str, Any], above: Mapping[str, Any]) -> dict[str, Any]:
    """`above`, with what it lacks from `below`."""
    return {**below, **above} | {
        key: _over(value, above[key])
        for key, value in below.items()
        if key in above and not is_entry(value) and not is_entry(above[key])
    }


def words_from(tree: Mapping[str, Any]) -> Words:
    """From the catalogue as read: its "language" tells how numbers are written."""
    about = tree["language"]
    numbers = Numbers(about["decimal"], about["group"], about["between"])
    return Words(about["code"], about["name"], about["direction"], tree, numbers)


def find(tree: Mapping[str, Any], key: str) -> Entry:
    """The entry of a dotted key; raises KeyError."""
    found: Any = tree
    for part in key.split("."):
        if not isinstance(found, Mapping) or part not in found:
            raise KeyError(f"no sentence has the key {key}")
        found = found[part]
    if not is_entry(found):
        raise KeyError(f"{key} is a group of sentences, none itself")
    return found


def is_entry(value: Any) -> bool:
    """A text, or the forms of a plural; not a group of entries."""
    return isinstance(value, str) or "other" in value


def entries(tree: Mapping[str, Any], before: str = "") -> Iterator[tuple[str, Entry]]:
    """All keys with their entries."""
    for name, value in tree.items():
        if is_entry(value):
            yield before + name, value
        else:
            yield from entries(value, f"{before}{name}.")


def slots_of(entry: Entry) -> set[str]:
    """Names of an entry's slots; a plural's are always with `count`."""
    if isinstance(entry, str):
        return set(SLOT.findall(entry))
    return {"count", *(name for form in entry.values() for name in SLOT.findall(form))}


def linked(entry: Entry) -> list[str]:
    """What the [text](mark)s of an entry are marked as."""
    forms = [entry] if isinstance(entry, str) else entry.values()
    return [of for form in forms for of in MARK.findall(form)]


def fill(text: str, slots: Mapping[str, object]) -> str:
    """Each {slot} replaced by what it is given."""
    return SLOT.sub(lambda slot: str(slots[slot[1]]), text)
