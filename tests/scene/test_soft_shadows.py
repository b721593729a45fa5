"""The lessons on soft shadows: how much of the lamp two pixels see, as the lessons say."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from raywalk.scene.read import read_scene
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


@pytest.mark.parametrize("language", ["scene.toml", "lesson.de.toml"])
def test_the_lessons_fill_these_numbers_in(language):
    """They stand there as slots; the one fraction in words is that of four points."""
    of = "of" if language == "scene.toml" else "von"
    said = {"4": ["3/4"], "16": ["**{lit}", f" {of} 16**"], "64": ["**{lit}", f" {of} 64**"]}
    for lamp, parts in (said | {"large": said["64"]}).items():
        text = (SCENES / LESSONS[lamp] / language).read_text(encoding="utf-8")
        assert all(part in text for part in parts)
