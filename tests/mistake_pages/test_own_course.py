"""A course of one's own has pages of mistakes of its scenes, without a word more in its files."""

from __future__ import annotations

import json
import re
import shutil
from argparse import Namespace
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from raywalk.commands import check
from raywalk.errors import SourceErrors
from raywalk.mistake_pages.best import Shown, best_scenes
from raywalk.mistake_pages.clarity import write_clarity
from raywalk.mistake_pages.rounds import rounds_of
from raywalk.mistake_pages.write import write_mistakes
from raywalk.mistakes.table import BY_NAME
from raywalk.pipeline.mistakes import Mistakes, misnamed, unseen
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene
from raywalk.site.mistakes import Told, write_mistake_pages
from raywalk.words import read_words

ROOT = Path(__file__).parents[2]
ASSETS = {
    "style_css": "style.css",
    "page_js": "page.js",
    "words_js": "words.js",
    "kiosk_js": "k.js",
}
NOBODY = {"right": [], "wrong": []}  # what the viewer would tell of rays; it is asked elsewhere


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Scene:
    """Two balls under a lamp, no mirror and no glass, in a folder of another name."""
    folder = tmp_path_factory.mktemp("course") / "my-balls"
    shutil.copytree(ROOT / "scenes" / "02-shadows", folder)
    return read_scene(folder)


@pytest.fixture(scope="module")
def told(own: Scene, tmp_path_factory: pytest.TempPathFactory) -> Told:
    """All that pages of this course show: those of its questions' mistakes, which are enough."""
    folder = tmp_path_factory.mktemp("made")
    write_clarity(own, folder)
    said = {own.id: json.loads((folder / "clarity.json").read_text("utf-8"))}
    shown = best_scenes(said, {})
    rounds = rounds_of(shown, said)
    names = [question.name for each in rounds for question in each.questions]
    write_mistakes(own, names, folder)
    drawn: dict[str, Any] = json.loads((folder / "mistakes.json").read_text("utf-8"))
    few: dict[str, Shown] = {name: shown[name] for name in names}
    return Told(few, [], {own.id: drawn}, {own.id: dict.fromkeys(names, NOBODY)}, rounds)


def written(told: Told, own: Scene, out: Path) -> dict[str, str]:
    """Pages by their paths."""
    write_mistake_pages(out, ROOT / "site_src", [own], told, ASSETS, read_words("en"), "")
    return {
        page.relative_to(out / "mistakes").as_posix(): page.read_text("utf-8")
        for page in (out / "mistakes").rglob("*.html")
    }


def test_a_mistake_that_there_is_not_is_refused_with_the_nearest_name(
    own: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Before anything is traced, by a build and by `raywalk check`."""
    [error] = misnamed([replace(own, mistakes=("far-root", "shadow-acnes"))])
    assert (error.key, error.message) == ("mistakes[1]", 'there is no mistake "shadow-acnes"')
    assert "shadow-acne" in error.hint
    scene = own.path.read_text("utf-8").replace("version = 1", 'version = 1\nmistakes = ["acne"]')
    other = own.path.parent.parent / "named" / "scene.toml"
    shutil.copytree(own.path.parent, other.parent)  # its lesson's pictures, too
    other.write_text(scene, encoding="utf-8")
    monkeypatch.setattr(check, "check_scene", lambda *_: [])  # what is asked of rays takes seconds
    with pytest.raises(SourceErrors, match=r"mistakes\[0\]: there is no mistake \"acne\""):
        list(check.run(Namespace(scene=[str(other)], scenes=other.parent.parent)))


def test_what_a_scene_names_and_hardly_shows_is_told(own: Scene) -> None:
    """A line each; what it shows is none."""
    made = Mistakes({"far-root": Shown("a", (own.id,))}, (), {}, {}, (), ())
    scene = replace(own, mistakes=("far-root", "total-black"))
    assert list(unseen([scene], made)) == [
        f'{own.id}: warning: mistakes: "total-black" hardly shows in this scene'
    ]


def test_what_shows_in_its_scene_is_shown_and_asked(told: Told, own: Scene, tmp_path: Path) -> None:
    """Each question's pictures are of the own scene, and its choices have pages."""
    pages = written(told, own, tmp_path)
    assert set(pages) == {"index.html", "which/index.html", *(f"{m}/index.html" for m in BY_NAME)}
    asked = pages["which/index.html"]
    assert set(re.findall(r"/right-([\w-]+)\.webp", asked)) == {"my-balls"}
    for link in re.findall(r'href="(\.\./[\w-]+/index\.html)"', asked):
        assert link.removeprefix("../") in pages
    assert "scenes/my-balls/index.html#n=" in pages["shadows-forgotten/index.html"]


def test_no_family_is_asked_that_shows_nothing_in_it(told: Told) -> None:
    """Without mirrors and glass there is no round of them; shadows have one."""
    families = {each.family for each in told.rounds}
    assert {"camera", "shadow"} <= families and not families & {"mirror", "glass"}


def test_what_shows_nowhere_is_said_and_without_rounds_nothing_leads_to_them(
    told: Told, own: Scene, tmp_path: Path
) -> None:
    """A page has words without a picture; the page of all leads to no page that is not there."""
    assert "which/index.html" in written(told, own, tmp_path / "asked")["index.html"]
    silent = Told(told.shown, told.left_out, told.drawn, told.events, ())
    pages = written(silent, own, tmp_path / "silent")
    assert "which/index.html" not in pages and "which/index.html" not in pages["index.html"]
    nowhere = read_words("en").say("pages.mistakes.showsNowhere")
    assert (
        nowhere in pages["total-black/index.html"] and "<img" not in pages["total-black/index.html"]
    )


@pytest.mark.parametrize("name", ["", "which", "shadows-forgotten"])
def test_what_is_right_stands_before_what_is_wrong(
    told: Told, own: Scene, tmp_path: Path, name: str
) -> None:
    """In pairs of pictures and in tables alike."""
    page = written(told, own, tmp_path)[f"{name}/index.html".removeprefix("/")]
    pairs = page.split('<div class="pair">')[1:]
    assert all(pair.index("/right-") < pair.index("/wrong.webp") for pair in pairs)
    assert bool(pairs) == bool(name)


def test_a_page_shows_the_line_to_change_and_leads_to_its_term(
    told: Told, own: Scene, tmp_path: Path
) -> None:
    """As the words and terms.json say."""
    pages = written(told, own, tmp_path)
    phong = pages["phong-for-blinn/index.html"]
    assert "<code>max(0, n·h)^s, h = (l + e) / |l + e|</code>" in phong
    assert 'glossary/index.html#blinn-phong"' in phong
