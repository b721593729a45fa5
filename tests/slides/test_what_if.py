"""A step with switches set: its slide shows what a fresh trace of the scene altered so would."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from raywalk.scene import read_scene
from raywalk.slides.figure import Dot, Slide, Text, flat
from raywalk.slides.what_if import switched_trace, switches_of
from raywalk.trace_file import read_trace

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


@pytest.mark.parametrize("name", CASES)
def test_switched_tiles_are_those_of_a_fresh_trace(name, tmp_path: Path):
    """Every tile of 7 x 7 and 21 x 21, and every ray's colour of the selected pixel."""
    switched = make(tmp_path / "switched", BALLS + with_step(CASES[name][0]))
    fresh = make(tmp_path / "fresh", altered(name) + with_step("")).traced
    given = switched.scene.lesson[0].view["switches"]
    switches = switches_of(given, switched.scene)
    assert switches.is_set
    for n in (7, 21):
        trace = read_trace(switched.traced / f"{n}.json.gz")
        got = switched_trace(trace, switched.scene, switches)
        want = read_trace(fresh / f"{n}.json.gz")
        assert np.abs(got.tiles.astype(int) - want.tiles.astype(int)).max() <= APART
        assert (got.pixel >= 0).sum() == want.count


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
    seen = scene.lesson().seen[0]
    colour = ", ".join(map(str, seen.trace.tiles[3 * seen.view.index :][:3].tolist()))
    assert colour in words
    assert any("light 1 is switched off" in note for note in slide.notes)


def test_its_shaded_view_is_lit_as_switched(made):
    """All lights off and no ambient light: nothing of the scene is brighter than black."""
    from PIL import Image

    lesson = with_step('lights = { "light 1" = 0, "light 2" = 0 }, without = ["ambient"]')
    view = made(lesson).sources().sights / "view-0.png"
    assert np.asarray(Image.open(view))[..., :3].max() == 0


def test_the_worksheet_asks_of_the_scene_as_it_is(made):
    """Its answers come from a step without switches, or there are only the lesson's own."""
    from raywalk.slides.worksheet import questions

    assert questions(made(with_step("bounces = 0")).lesson()) == []


def test_tiles_may_show_costs(made):
    """The number of rays by cividis; the lightest tiles are those that took most."""
    text = '[[lesson]]\ntext = "Work."\nview = { resolution = 7, tiles = "filled", \
colours = "rays", rays = [] }'
    seen = made(text).lesson().seen[0]
    shot = np.isin(seen.trace.visibility, (0, 1)).sum(axis=1) + 1.0
    rays = np.zeros(49)
    np.add.at(rays, seen.trace.pixel, shot)
    assert (seen.tiles[rays == rays.max()] == [0xFE, 0xE8, 0x38]).all()
    assert (seen.tiles[rays == rays.min()] == [0x00, 0x22, 0x4E]).all()


def test_a_translation_keeps_the_lights_that_are_switched(made, tmp_path: Path):
    """Names of lights in a view follow the names that the language gives them."""
    from raywalk.scene.translation import TranslationFile, in_words_of

    scene = read_scene(made(with_step('lights = { "light 1" = 0 }')).scene.path.parent)
    names = {"light 1": "Licht 1", "light 2": "Licht 2"}
    told = {"title": "Zwei", "teaches": "Etwas.", "names": names, "lesson": [{"text": "Text."}]}
    spoken = in_words_of(TranslationFile.model_validate(told), scene)
    switches = switches_of(spoken.lesson[0].view["switches"], spoken)
    assert [switches.brightness(light.name) for light in spoken.lights] == [0, 1]
