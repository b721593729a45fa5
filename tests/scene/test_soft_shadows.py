"""The lessons on soft shadows: how much of the lamp two pixels see, as the lessons say."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from raywalk.pipeline.filling import filled
from raywalk.pipeline.lesson_checks import figures_now
from raywalk.scene.read import read_scene
from raywalk.scene.translation import Spoken, read_spoken
from raywalk.trace.pixel_tree import pixel_tree

SCENES = Path(__file__).parents[2] / "scenes"
LESSONS = {
    "1": "12-soft-shadows-1", "4": "13-soft-shadows-4", "16": "14-soft-shadows-16",
    "64": "15-soft-shadows-64", "large": "16-soft-shadows-large",
}  # fmt: skip
RIGHT, LEFT, MIDDLE = (10, 11), (9, 11), (7, 11)  # of the 15 x 15 grid


@cache
def scene_of(lamp):
    return read_scene(SCENES / LESSONS[lamp])


@cache
def seen(lamp, pixel):
    """How many of the lamp's points reach the point of the floor that a pixel shows."""
    tree = pixel_tree(scene_of(lamp), 15, 15, *pixel)["tree"]
    assert tree["object"] == "floor"
    return sum(light["visible"] for light in tree["lights"])


@pytest.mark.parametrize(
    ("lamp", "right", "left"),
    [("1", 1, 0), ("4", 3, 0), ("16", 10, 1), ("64", 39, 6), ("large", 39, 22)],
)
def test_two_pixels_see_as_much_of_the_lamp_as_is_said(lamp, right, left):
    """Independently found: by the schoolbook quadratic in plain numpy, and by another tracer."""
    assert (seen(lamp, RIGHT), seen(lamp, LEFT)) == (right, left)


@pytest.mark.parametrize(("lamp", "share"), [("1", 1), ("4", 4), ("16", 15), ("64", 61)])
def test_a_third_pixel_sees_nearly_all_of_it(lamp, share):
    """The lesson asks how much sixty-four points change what sixteen say: a sixty-fourth."""
    assert seen(lamp, (11, 11)) == share


def test_a_few_points_of_the_floor_are_in_the_large_lamps_full_shadow():
    """The lesson says "hardly any of it": fewer than half of those of the small lamp's."""
    dark = {
        lamp: sum(
            not any(light["visible"] for light in tree["lights"])
            for column in range(15)
            for row in range(9, 15)
            if (tree := pixel_tree(scene_of(lamp), 15, 15, column, row)["tree"])["object"]
            == "floor"
        )
        for lamp in ("64", "large")
    }
    assert dark["large"] < dark["64"] / 2


def test_a_point_below_the_ball_is_in_full_shadow_of_the_small_lamp():
    """The lesson calls it umbra; the large lamp lights it a little."""
    assert seen("16", MIDDLE) == seen("64", MIDDLE) == 0 < seen("large", MIDDLE)


def test_only_the_lamp_differs():
    """Else the comparison would be of two things at once."""
    first = scene_of("1")
    for lamp in LESSONS:
        scene = scene_of(lamp)
        assert (scene.camera, scene.render, scene.materials) == (
            first.camera, first.render, first.materials,
        )  # fmt: skip
        assert [each.shape for each in scene.objects] == [each.shape for each in first.objects]
        assert sum(light.intensity for light in scene.lights) == pytest.approx(0.9, abs=1e-14)
        middle = [sum(light.position[k] for light in scene.lights) for k in range(3)]
        assert [v / len(scene.lights) for v in middle] == pytest.approx([0, 2.5, 0], abs=1e-14)


FIGURES = {  # in the order of the steps; of other lessons' lamps too
    "4": ["3/4"],
    "16": ["**10 of 16**", "3/4", "**1 of 16**"],
    "64": ["**39 of 64**", "10 of 16", "40 of 64", "**6 of 64**", "1 of 16", "4 of 64", "saw 15",
           "from 60/64 to 61/64"],
    "large": ["6 of 64", "**22 of 64**", "39 of 64", "39 of 64"],
}  # fmt: skip


@pytest.mark.parametrize("code", ["en", "de"])
@pytest.mark.parametrize("lamp", FIGURES)
def test_the_lessons_say_these_numbers_one_lamp_beside_the_other(lamp, code):
    """Filled from the traces: nothing of it is typed."""
    own = scene_of(lamp)
    spoken = {"en": [Spoken(own, True)], "de": read_spoken([own], "de")}
    figures = figures_now(own, [each.scene for [each] in spoken.values()])
    [told] = filled(spoken, [figures])[code]
    said = " ".join(f"{step.text} {step.answer}" for step in told.scene.lesson)
    said, at = " ".join(said.split()), 0
    for figure in FIGURES[lamp]:
        words = figure if code == "en" else german(figure)
        at = said.index(words, at) + len(words)


def german(figure):
    for english, word in {" of ": " von ", "saw": "Pixel", "from": "von", " to ": " auf "}.items():
        figure = figure.replace(english, word)
    return figure
