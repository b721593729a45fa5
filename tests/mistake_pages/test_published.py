"""The built site's pages of mistakes, in each language."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from PIL import Image

from raywalk.mistakes.table import BY_NAME
from raywalk.mistakes.world import left_out
from raywalk.scene.read import read_scenes
from raywalk.site.pages import home_of
from raywalk.words import languages, read_words

ROOT = Path(__file__).parents[2]
DIST = ROOT / "dist"
LIMIT = 150_000  # bytes of all that a page loads besides the site's own style and script
ROW = re.compile(r"<tr[^>]*>.*?</tr>", re.DOTALL)


def page(code: str, name: str = "") -> tuple[Path, str]:
    path = DIST / home_of(code) / "mistakes" / name / "index.html"
    return path, path.read_text("utf-8")


@pytest.mark.parametrize("code", languages())
def test_each_mistake_has_its_page_and_all_links_lead_somewhere(code: str) -> None:
    """Pictures, scenes, neighbours; the page of all leads to each."""
    assert set(re.findall(r'<li id="([\w-]+)">', page(code)[1])) == set(BY_NAME)
    for name in ["", *BY_NAME]:
        path, text = page(code, name)
        for link in re.findall(r'(?:href|src)="([^"#:]+)', text):
            assert (path.parent / link).is_file(), (name, link)
        assert f'lang="{code}"' in text and "<script>" not in text and "style=" not in text


def test_pictures_are_those_of_one_size_and_pages_are_light() -> None:
    """231 pixels across; each page, with what it alone loads, below its budget."""
    shown = [name for name in BY_NAME if "wrong.webp" in page("en", name)[1]]
    assert len(shown) >= len(BY_NAME) - 1
    for name in shown:
        folder = DIST / "mistakes" / name
        with Image.open(folder / "wrong.webp") as wrong:
            assert wrong.size == (231, 231)
        weight = sum(path.stat().st_size for path in folder.iterdir())
        weight += max(path.stat().st_size for path in (DIST / "mistakes").glob("right-*.webp"))
        assert weight < LIMIT, name


@pytest.mark.parametrize("code", languages())
def test_what_is_marked_is_the_first_that_differs(code: str) -> None:
    """Where they part is marked once; above it all is said of both, below it the two cells of the
    first row differ."""
    parts = read_words(code).say("pages.mistakes.parts")
    for name in BY_NAME:
        text = page(code, name)[1]
        if 'class="events"' not in text:
            continue
        rows = ROW.findall(text.split('class="events"')[1].split("<tbody>")[1])
        marked = [k for k, row in enumerate(rows) if f">{parts}<" in row]
        assert len(marked) == 1, name
        before, first = rows[: marked[0]], rows[marked[0] + 1]
        assert before and all('<td colspan="2">' in row for row in before), name
        right, wrong = re.findall(r"<td[^>]*>(.*?)</td>", first, re.DOTALL)
        assert right != wrong and "differs first" in first, name


def test_scenes_with_meshes_are_named_as_left_out() -> None:
    """Those, and no other."""
    text = page("en")[1].split('class="left-out"')[1]
    own = [each for each in read_scenes(ROOT / "scenes") if not each.base]
    without = {each.id for each in own if any(left_out(obj) for obj in each.objects)}
    assert set(re.findall(r"scenes/([\w-]+)/index", text)) == without and without


def test_pages_lead_to_a_pixel_that_the_scenes_page_has() -> None:
    """A grid that is there, and a pixel in it."""
    for name in BY_NAME:
        for id, n, x, y in re.findall(
            r"scenes/([\w-]+)/index\.html#n=(\d+)&amp;p=(\d+),(\d+)", page("en", name)[1]
        ):
            assert (DIST / "scenes" / id / f"{n}.js").is_file()
            assert int(x) < int(n) and int(y) < int(n)


def test_nobody_carries_them_who_did_not_ask() -> None:
    """A worker keeps them when they are looked at, not before."""
    build = (DIST / "sw.js").read_text("utf-8").split("const BUILD = ")[1].split(";\n")[0]
    assert not [name for name in json.loads(build)["first"] if "mistakes/" in name]
