"""The rays that lessons select do what the text says of them."""

from pathlib import Path

import numpy as np
import pytest

from raywalk.scene.read import read_scenes

SCENES = Path(__file__).parents[2] / "scenes"
BLOCKED, REACHED, BEHIND, UNTESTED = 0, 1, 2, 3

# (key, resolution, pixel): the objects met one after the other, and what the last hit
# knows of each light. An empty name is the open.
SAID = {
    ("1", 15, (4, 3)): (["blue sphere"], [UNTESTED]),
    ("1", 15, (0, 0)): ([""], None),
    ("1", 15, (9, 10)): (["red sphere"], [UNTESTED]),
    ("1", 15, (6, 4)): (["blue sphere"], [UNTESTED]),
    ("1", 15, (9, 8)): (["green sphere"], [UNTESTED]),
    ("2", 15, (4, 3)): (["blue sphere"], [REACHED]),
    ("2", 15, (9, 8)): (["green sphere"], [BLOCKED]),
    ("2", 15, (10, 9)): (["green sphere"], [REACHED]),
    ("2", 15, (9, 4)): (["blue sphere"], [BEHIND]),
    ("2", 33, (16, 17)): (["green sphere"], [REACHED]),
    ("2", 33, (17, 17)): (["green sphere"], [BLOCKED]),
    ("3", 15, (10, 13)): (["floor"], [REACHED, REACHED]),
    ("3", 15, (9, 7)): (["red ellipsoid"], [REACHED, BEHIND]),
    ("3", 15, (13, 7)): ([""], None),
    ("3", 15, (13, 8)): (["floor"], [REACHED, REACHED]),
    ("3", 15, (9, 11)): (["floor"], [REACHED, BLOCKED]),
    ("3", 15, (3, 10)): (["floor"], [BLOCKED, BLOCKED]),
    ("3", 15, (0, 9)): (["floor"], [BLOCKED, REACHED]),
    ("4", 15, (4, 8)): (["mirror A", "floor"], [REACHED, REACHED]),
    ("4", 15, (7, 8)): (["mirror A", "red sphere"], [REACHED, BEHIND]),
    ("4", 15, (11, 8)): (["mirror B", "blue sphere"], [BEHIND, BEHIND]),
    ("4", 15, (5, 6)): (["mirror A", ""], None),
    ("4", 15, (9, 7)): (["mirror B", "mirror A"], None),
    ("5", 15, (9, 7)): (["mirror B", "mirror A", "back wall"], [REACHED, REACHED]),
    ("5", 15, (10, 7)): (["mirror B", "mirror A", ""], None),
    ("5", 15, (7, 8)): (["mirror A", "red sphere"], [REACHED, BEHIND]),
    ("5", 33, (21, 16)): ([*["mirror B", "mirror A"] * 2, "mirror B", "back wall"], None),
    ("5", 77, (50, 38)): ([*["mirror B", "mirror A"] * 3, "mirror B", ""], None),
    ("6", 15, (6, 3)): (["bunny"], [REACHED]),
    ("6", 15, (12, 10)): ([""], None),
    ("6", 15, (8, 2)): ([""], None),
    ("7", 15, (8, 8)): (["bunny"], [REACHED]),
    ("7", 33, (10, 8)): (["bunny"], [BLOCKED]),
    ("7", 33, (9, 8)): (["bunny"], [REACHED]),
    ("7", 15, (6, 11)): (["bunny"], [BLOCKED]),
}


@pytest.fixture(scope="module")
def tracers():
    from raywalk.trace.wavefront import Tracer

    return {scene.key: Tracer(scene) for scene in read_scenes(SCENES) if scene.key in "1234567"}


@pytest.mark.parametrize("key, n, pixel", SAID)
def test_a_lessons_ray_meets_what_the_text_says(key, n, pixel, tracers):
    """Objects in order, and whether the last hit sees the lights."""
    column, row = pixel
    waves = tracers[key].waves(np.array([row * n + column]), n, n)
    objects = tracers[key].scene.objects
    met = [int(wave.hits.object[0]) for wave in waves]
    names, visibility = SAID[key, n, pixel]
    assert [objects[i].name if i >= 0 else "" for i in met] == names
    if visibility is not None:
        assert list(waves[-1].lighting.visibility[0]) == visibility


def test_ten_bounces_are_enough_for_scene_5(tracers):
    """The lesson says so: no mirror is reached by a ray that may bounce no more."""
    size = 1155
    middle = slice(size // 4, 3 * size // 4)  # the mirrors stand in the middle rows
    pixels = np.arange(size * size).reshape(size, size)[middle, size // 2 : 7 * size // 8]
    waves = tracers["5"].waves(pixels.ravel(), size, size)
    assert len(waves) == 1 + 9  # camera rays, and nine bounces
