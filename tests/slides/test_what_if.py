"""A step with switches set: its slide shows what a fresh trace of the scene altered so would."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.cases import cases

from raywalk.slides.figure import Dot, Slide, Text, flat
from raywalk.slides.layout import WIDE
from raywalk.stops.decoded import read_trace

from .conftest import BALLS, make

# What a step's view switches, and the same said by the scene's file.
CASES = {
    "one light off": ('lights = { "light 1" = 0 }', [("position = [1, 2, 3]", "intensity = 0")]),
    "one light dimmed": (
        'lights = { "light 2" = 0.35 }', [("position = [-2, 2, 1]", "intensity = 0.35")],
    ),
    "no bounces": ("bounces = 0", [("depth = 4", "")]),
    "one bounce": ("bounces = 1", [("depth = 4", "")]),
    "no shadows": ("shadows = false", [("size = 63", "shadows = false")]),
}  # fmt: skip
# Both round to 8 bits: a term stored a fifth of half a step off may tip a value over the edge.
APART = 1


def with_step(switches: str) -> str:
    return f"""
[[lesson]]
text = "**With switches.** What is left of the colour?"
view = {{ resolution = 7, pixel = [2, 4], tiles = "filled", switches = {{ {switches} }} }}
"""


def altered(name: str) -> str:
    """The scene whose file says what the switches say."""
    switches, changes = CASES[name]
    text = BALLS
    for line, more in changes:
        text = text.replace(line, f"{line}\n{more}")
    if switches.startswith("bounces"):
        text = text.replace("depth = 4", f"depth = {switches[-1]}")
    return text


@pytest.mark.parametrize("name", cases(CASES, ["one light dimmed", "one bounce"]))
def test_switched_tiles_are_those_of_a_fresh_trace(name, tmp_path: Path):
    """Every tile of 7 x 7 in the figure and of 21 x 21 beside it, and the selected pixel's rays."""
    [stop] = make(tmp_path / "switched", BALLS + with_step(CASES[name][0])).lesson().stops
    fresh = make(tmp_path / "fresh", altered(name) + with_step("")).sources().traced
    assert stop.is_switched and stop.picture and stop.tiles is not None
    for n, tiles in ((7, stop.tiles.reshape(-1)), (21, stop.picture.tiles)):
        want = read_trace(fresh / f"{n}.json.gz")
        assert np.abs(tiles.astype(int) - want.tiles.astype(int)).max() <= APART
        if n == stop.n:
            pixel = stop.pixel[1] * n + stop.pixel[0]
            assert len(stop.rows) == (want.pixel == pixel).sum()


def only_step(made) -> Slide:
    return next(slide for slide in made.deck().slides if slide.kind == "step")


def test_its_slide_says_what_is_switched_and_puts_the_lamp_out(made):
    """The words in the figure's corner, a hollow lamp, the switched colour, notes that tell it."""
    lesson = with_step('lights = { "light 1" = 0 }, bounces = 1, shadows = false')
    scene = made(lesson)
    slide = only_step(scene)
    words = [item.words for item in flat(slide.items) if isinstance(item, Text)]
    assert {"at most 1 bounce", "light 1 is off", "without shadows"} <= set(words)
    lamps = {i.name: i.fill for i in flat(slide.items) if isinstance(i, Dot) and "light" in i.name}
    assert lamps == {"light 1": "ground", "light 2": "lamp"}
    [stop] = scene.lesson().stops
    assert ", ".join(map(str, stop.bytes)) in words
    assert any("from light 1: it is switched off" in note for note in slide.notes)


def test_its_shaded_view_is_lit_as_switched(made):
    """All lights off and no ambient light: nothing of the scene is brighter than black."""
    from PIL import Image

    lesson = with_step('lights = { "light 1" = 0, "light 2" = 0 }, without = ["ambient"]')
    view = made(lesson).sources().sights / "view-0.png"
    assert np.asarray(Image.open(view))[..., :3].max() == 0


def test_the_worksheet_asks_of_the_scene_as_it_is(made):
    """Its answers come from a step without switches, or there are only the lesson's own."""
    from raywalk.slides.sheet_questions import questions

    assert questions(made(with_step("bounces = 0")).lesson()) == []


def test_tiles_may_show_costs(made):
    """The number of rays by cividis; the lightest tiles are those that took most."""
    text = '[[lesson]]\ntext = "Work."\nview = { resolution = 7, tiles = "filled", \
colours = "rays", rays = [] }'
    sources = made(text).sources()
    [stop] = sources.lesson(WIDE).stops
    trace = read_trace(sources.traced / "7.json.gz")
    shot = np.isin(trace.visibility, (0, 1)).sum(axis=1) + 1.0
    rays = np.zeros(49)
    np.add.at(rays, trace.pixel, shot)
    assert stop.tiles is not None
    assert (stop.tiles[rays == rays.max()] == [0xFE, 0xE8, 0x38]).all()
    assert (stop.tiles[rays == rays.min()] == [0x00, 0x22, 0x4E]).all()
