"""Lessons' figures are traced once: other words trace nothing, what changes one traces it."""

from __future__ import annotations

import pytest

from raywalk.pipeline import figures
from raywalk.pipeline.figures import figures_parts, filled_here, wanted_pixels
from raywalk.pipeline.parts import page_data_parts, trace_parts
from raywalk.scene.read import read_scene
from raywalk.work.digests import key_of
from raywalk.work.store import Store

SCENE = """
version = 1
title = "Ball"
teaches = "A ball."
camera = {{ eye = [0, 0, 5], target = [0, 0, 0] }}
render = {{ size = 105 }}
[[objects]]
type = "sphere"
center = [0, 0, 0]
radius = {radius}
material = "white"
[[lights]]
position = [1, 2, 3]
[[lesson]]
text = "{words}"
view = {{ resolution = 15, pixel = [7, {row}] }}
"""


@pytest.fixture
def scene(tmp_path):
    """Reads a scene that says these words."""

    def read(words="It is {t} far.", radius=1, row=7):
        file = tmp_path / "01-ball" / "scene.toml"
        file.parent.mkdir(exist_ok=True)
        file.write_text(SCENE.format(words=words, radius=radius, row=row), encoding="utf-8")
        return read_scene(file)

    return read


def key(scene):
    return key_of(figures_parts(scene, wanted_pixels([scene])[0]))


def test_other_words_and_other_slots_trace_nothing(scene):
    first = key(scene())
    assert key(scene("At {angle} degrees, {t} away.")) == first
    assert key(scene(row=8)) != first and key(scene("{t at 3,3}")) != first
    assert key(scene(radius=2)) != first


def test_what_is_kept_is_not_made_again(scene, tmp_path, monkeypatch):
    store = Store(tmp_path / "work")
    assert filled_here(store, scene()).lesson[0].text == "It is 4.00 far."

    def refuse(*_):
        raise AssertionError("it was traced again")

    monkeypatch.setattr(figures, "FIGURES", Refusing(figures.FIGURES.parts, refuse))
    assert filled_here(store, scene("{t : 1}!")).lesson[0].text == "4.0!"
    with pytest.raises(AssertionError):
        filled_here(store, scene(radius=2))


def test_a_figure_of_another_scene_changes_with_that_scene(scene, tmp_path):
    """And with nothing else: what it needs is kept under that scene's key."""
    store, other = Store(tmp_path / "work"), tmp_path / "02-large"
    other.mkdir()
    said = []
    for radius in (2, 3, 2):
        text = SCENE.format(words="Large.", radius=radius, row=7)
        (other / "scene.toml").write_text(text, encoding="utf-8")
        said.append(filled_here(store, scene("{t} and {t in 02-large}")).lesson[0].text)
    assert said == ["4.00 and 3.00", "4.00 and 2.00", "4.00 and 3.00"]


class Refusing:
    """A maker with another function."""

    def __init__(self, parts, make):
        self.parts, self.make = parts, make

    def __call__(self, *given):
        return self.make(*given)


def test_a_page_is_made_anew_when_a_figure_changes_and_a_trace_is_not_when_words_do(
    scene, tmp_path
):
    """The page's key has the filled words; the trace's has none."""
    store = Store(tmp_path / "work")
    pages, traces = set(), set()
    for radius, words in ((1, "{t}"), (2, "{t}"), (2, "{t} now")):
        filled = filled_here(store, scene(words, radius))
        pages.add(key_of(page_data_parts(filled, "a trace")))
        traces.add(key_of(trace_parts(filled)))
    assert (len(pages), len(traces)) == (3, 2)
