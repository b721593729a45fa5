"""One glossary: what it says of terms, where texts have them, and what no text may say."""

from __future__ import annotations

import re
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path

import pytest

from raywalk.commands.check import run as check
from raywalk.pipeline.wording import avoided_words, texts_of
from raywalk.scene.lesson_text import lesson_html
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scenes
from raywalk.scene.translation import Spoken, read_spoken
from raywalk.site.terms import first_seen, letters_of, marked
from raywalk.terms.glossary import read_glossary
from raywalk.words import languages
from raywalk.words.catalogue import DEFAULT, entries, read_tree

ROOT = Path(__file__).parents[2]
SCENES = ROOT / "scenes"
# What people read of the project besides lessons and pages; the changelog tells old words by name.
DOCS = [
    "README.md", "CONTRIBUTING.md", "ARCHITECTURE.md", "scenes/README.md", "models/README.md",
    "site_src/kiosk/START-HERE.txt", "build/raywalk/trace_file/FORMAT.md",
]  # fmt: skip
LONGEST = 260  # letters of a meaning: two sentences


def spoken(code: str) -> list[Spoken]:
    scenes = read_scenes(SCENES)
    own = [Spoken(scene, True) for scene in scenes]
    return own if code == DEFAULT else read_spoken(scenes, code)


def scenes_in(code: str) -> list[Scene]:
    return [each.scene for each in spoken(code)]


def test_about_sixty_terms_are_told_in_every_language():
    """The same ones, each once, in a sentence or two."""
    told = {code: read_glossary(code).terms for code in languages()}
    ids = sorted(term.id for term in told[DEFAULT])
    assert len(ids) == len(set(ids)) >= 60
    for code, terms in told.items():
        assert sorted(term.id for term in terms) == ids, code
        assert len({term.term for term in terms}) == len(terms)
        for term in terms:
            assert len(term.says) <= LONGEST and term.says[-1] in ".?", term
            assert len(re.findall(r"[.:;](?= )|\.$", term.says)) <= 4, term


@pytest.mark.parametrize("code", languages())
def test_the_glossary_keeps_to_its_own_words(code):
    """No form of a term, and no meaning, has words that are to be avoided."""
    glossary = read_glossary(code)
    for term in glossary.terms:
        for text in (term.term, term.says, *(form.replace("*", "") for form in term.forms)):
            assert not list(glossary.avoided_in(text)), text


@pytest.mark.parametrize("code", languages())
def test_no_lesson_says_what_the_glossary_says_to_avoid(code):
    """As `raywalk check` names it."""
    assert not list(avoided_words(spoken(code), code))


def written() -> Iterator[tuple[str, str, str]]:
    for code in languages():
        for key, entry in entries(read_tree(code)):
            for text in [entry] if isinstance(entry, str) else entry.values():
                yield code, f"{code}.json {key}", text
    for name in DOCS:
        if (ROOT / name).is_file():
            yield DEFAULT, name, (ROOT / name).read_text(encoding="utf-8")


def test_no_sentence_of_pages_and_no_document_does_so_either():
    """Templates hold no sentences of their own: those of words/*.json stand for them."""
    found = [
        f"{where}: {avoided}"
        for code, where, text in written()
        for avoided in read_glossary(code).avoided_in(text)
    ]
    assert not found


@pytest.mark.parametrize(
    "text, says",
    [
        ("Der Sichtkegel ist offen.", 'Sichtkegel": say "Sichtpyramide" (sie hat vier ebene'),
        ("ein Gesichtsfeld von 45 Grad", 'say "Öffnungswinkel"'),
        ("Gerastert sieht man das nicht.", 'say "Rasterisierung"'),
        ("Raten Sie\nnicht.", 'Raten Sie": say "vorhersagen"'),
        ("im halben Schatten", 'say "Halbschatten (Penumbra)"|say "Halbschatten"'),
        ("der Umgebungsanteil und der Glanzanteil", 'say "ambienter Anteil"'),
        ("das Gesetz von Snellius", 'say "snelliussches Gesetz"'),
    ],
)
def test_words_of_the_german_list_are_found(text, says):
    """Inflected, over a line's end, and with the reason where it is not obvious."""
    found = [str(avoided) for avoided in read_glossary("de").avoided_in(text)]
    assert any(re.search(each.replace("(", r"\(").replace(")", r"\)"), found[0])
               for each in says.split("|")), found  # fmt: skip


@pytest.mark.parametrize("code", languages())
def test_each_wording_to_avoid_is_found_and_what_to_say_instead_is_not(code):
    """Within a sentence; its own `say` is free of all that is to be avoided."""
    glossary = read_glossary(code)
    assert len(glossary.wordings) >= 9
    for wording in glossary.wordings:
        example = wording.avoid.replace("*", "")
        [found] = glossary.avoided_in(f"So: {example}, one and all.")
        assert found.say == wording.say and found.words in example
        assert not list(glossary.avoided_in(wording.say)), wording


@pytest.mark.parametrize(
    "code, text, ids",
    [
        ("de", "Zwei Schattenstrahlen", ["shadow-ray"]),
        ("de", "wegen des ambienten Anteils", ["ambient"]),
        ("de", "Snelliussche Gesetze", ["snell"]),
        ("de", "Ein Strahlensatz, eine Pixelei", []),
        ("de", "Streifend trifft er. Streift er sie, ist er teuer", ["grazing"]),
        ("de", "ein Streifen dieser Kachel", ["tile"]),
        ("de", "An den Spiegeln, im Halbschatten", ["mirror", "penumbra"]),
        ("en", "Shadow\nrays, camera rays and rays", ["shadow-ray", "camera-ray", "ray"]),
        ("en", "The boxes in boxes hold boxes", ["bvh", "box"]),
        ("en", "an array of tilers", []),
    ],
)
def test_terms_are_found_inflected_and_the_longest_first(code, text, ids):
    """Not within other words."""
    assert [found.term.id for found in read_glossary(code).first_in(text)] == ids


def test_a_step_has_each_term_marked_once_and_says_the_same_as_before():
    """Not in formulas, code or links; without its links the HTML is what it was."""
    html = lesson_html("A **ray**, a ray, $ray$, `ray`, [a mirror](https://a.example/). A mirror.")
    made = marked(html, read_glossary())
    links = re.findall(r'<a class="term" href="\.\./\.\./glossary/index\.html#([\w-]+)">', made)
    assert links == ["ray", "mirror"]
    assert '<strong><a class="term"' in made and "<code>ray</code>" in made
    assert re.sub(r'<a class="term"[^>]*>(.*?)</a>', r"\1", made) == html


@pytest.mark.parametrize("code", languages())
def test_where_a_term_is_first_seen_its_step_has_it(code):
    """And no step before it, in the order of the scenes."""
    glossary, scenes = read_glossary(code), scenes_in(code)
    places = first_seen(glossary, scenes)
    assert len(places) >= 40
    steps = {
        (scene.id, k): {
            found.term.id for text in (step.text, step.answer) for found in glossary.found_in(text)
        }
        for scene in scenes
        for k, step in enumerate(scene.lesson, start=1)
    }
    for id, place in places.items():
        with_it = [at for at, terms in steps.items() if id in terms]
        if (place.scene, place.step) in steps:
            assert with_it[0] == (place.scene, place.step)


def test_letters_lead_to_the_first_term_that_begins_so():
    """In the order of the glossary."""
    terms = read_glossary().terms
    letters = letters_of(terms)
    assert list(letters) == sorted(letters) and letters["A"] == terms[0].id


OWN = """
version = 1
title = "Ball"
teaches = "Something."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[[lesson]]
text = "The eye ray meets nothing."
[[lesson]]
text = "Why?"
answer = "Because."
choices = [
  { text = "So", because = "The view cone is empty.", right = true },
  { text = "No", because = "No." },
]
"""


def test_check_names_file_step_words_and_what_to_say(tmp_path: Path):
    """Warnings: nothing is refused. Own courses are asked the same."""
    folder = tmp_path / "01-own"
    folder.mkdir()
    (folder / "scene.toml").write_text(OWN, encoding="utf-8")
    told = [line for line in check(Namespace(scene=[], scenes=tmp_path)) if "say" in line]
    assert len(told) == 2
    assert re.search(r'01-own/scene\.toml: lesson\[0\]\.text: "eye ray": say "camera ray"', told[0])
    assert 'lesson[1].choices[0].because: "view cone": say "view frustum" (it has' in told[1]
    assert all(line.startswith("warning: ") for line in told)


def test_all_that_a_scene_says_is_looked_at():
    """Headlines, goals and choices too."""
    keys = {re.sub(r"\d+", "N", key) for scene in read_scenes(SCENES) for key, _ in texts_of(scene)}
    assert keys == {
        "title", "teaches", "goals[N]", "lesson[N].headline", "lesson[N].text",
        "lesson[N].answer", "lesson[N].choices[N].text", "lesson[N].choices[N].because",
    }  # fmt: skip
