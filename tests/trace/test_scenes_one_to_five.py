"""Single pixels of scenes 1 to 5 against closed forms and a schoolbook tracer."""

from __future__ import annotations

import math

import numpy as np
import pytest

from raywalk.scene.model import Scene
from raywalk.trace.wavefront import Tracer

from .schoolbook import SIZE, WORLDS

# One pixel (column, row) for each thing that can happen to a ray of a scene.
PIXELS = {
    "01-shading": {
        "nothing met": (5, 478), "red": (93, 907), "blue": (423, 291), "green": (918, 764),
        "highlight on red": (203, 698), "highlight on blue": (379, 280),
    },
    "02-shadows": {
        "turned away": (280, 973), "lit": (302, 280), "in the shadow of another": (764, 643),
        "highlight, lit": (203, 698),
    },
    "03-two-lights": {
        "both lights": (148, 1028), "half shadow, first light": (181, 929),
        "half shadow, second light": (225, 764), "full shadow": (302, 841),
        "ellipsoid": (599, 577), "ellipsoid's highlight": (753, 434), "blocked": (555, 698),
    },
    "04-one-bounce": {
        "back wall": (775, 104), "floor between": (269, 830), "red ball": (775, 764),
        "floor in the mirror": (412, 687), "ball in the mirror": (599, 676),
        "mirror in a mirror: black": (775, 577), "mirror into the dark": (511, 500),
    },
    "05-many-bounces": {
        "two mirrors, then floor": (808, 621), "two mirrors, then wall": (775, 533),
        "two mirrors, then nothing": (797, 555), "the other way round": (676, 665),
        "wall in the mirror": (907, 412),
    },
}  # fmt: skip
CASES = [
    pytest.param(scene, pixel, id=f"{scene} {what}")
    for scene, pixels in PIXELS.items()
    for what, pixel in pixels.items()
]


@pytest.fixture(scope="module")
def tracers(course: dict[str, Scene]) -> dict[str, Tracer]:
    return {name: Tracer(course[name]) for name in WORLDS}


def colours(tracer: Tracer, pixels: np.ndarray) -> np.ndarray:
    return np.asarray(tracer.waves(pixels, SIZE, SIZE)[0].colour)


def test_the_middle_ray_of_scene_1_touches_the_blue_ball(tracers: dict[str, Tracer]) -> None:
    """Pixel (577, 577) of 1155 looks along -z exactly. The blue ball, 1 above the axis with r = 1,
    is touched at (0, 0, 0) after 5 units, normal (0, -1, 0); the red and green ones are
    sqrt(1.25) away. The light (-2, 1, 1) is behind that normal, n.l = -1 / sqrt(6), and so is h:
    what is left is the ambient colour 0.1."""
    waves = tracers["01-shading"].waves(np.array([577 * SIZE + 577]), SIZE, SIZE)
    hits = waves[0].hits
    assert (hits.object[0], hits.t[0], hits.normal[0].tolist()) == (2, 5.0, [0.0, -1.0, 0.0])
    assert waves[0].colour[0].tolist() == [0.1, 0.1, 0.1]


def test_a_pixel_worked_out_by_hand(tracers: dict[str, Tracer]) -> None:
    """Scene 2, column 577, on the axis x = 0, row 302. With k = tan(22.5) and
    y = k (1 - 605 / 1155) the ray (0, 0, 5) + s (0, y, -1) meets the blue ball (0, 1, 0), r = 1:
    s^2 (y^2 + 1) - 2 s (y + 5) + 25 = 0 [from s^2 y^2 - 2 s y + 1 + 25 - 10 s + s^2 = 1], the
    smaller root. n = p - (0, 1, 0); l towards (-2, 1, 1). There n.l < 0: the light has set."""
    y = math.tan(math.radians(22.5)) * (1 - 605 / 1155)
    a, b = y * y + 1, y + 5
    s = (b - math.sqrt(b * b - 25 * a)) / a
    p = (0.0, s * y, 5 - s)
    n = (p[0], p[1] - 1, p[2])
    l = (-2 - p[0], 1 - p[1], 1 - p[2])
    assert sum(x * z for x, z in zip(n, l, strict=True)) < 0
    tracer = tracers["02-shadows"]
    waves = tracer.waves(np.array([302 * SIZE + 577]), SIZE, SIZE)
    assert np.abs(waves[0].hits.point[0] - p).max() < 1e-14
    assert np.abs(waves[0].hits.normal[0] - n).max() < 1e-14
    assert waves[0].colour[0].tolist() == [0.1, 0.1, 0.1]


@pytest.mark.parametrize(("scene", "pixel"), CASES)
def test_a_pixel_has_the_schoolbooks_colour(
    tracers: dict[str, Tracer], scene: str, pixel: tuple[int, int]
) -> None:
    """Within 1e-12: t's roundings (1e-15) times a highlight's slope (100), or times what two
    mirrors enlarge (each up to 20), times some 2 for the schoolbook's own."""
    column, row = pixel
    found = colours(tracers[scene], np.array([row * SIZE + column]))[0]
    expected = WORLDS[scene].colour(column, row)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize("scene", WORLDS)
def test_a_grid_of_pixels_has_the_schoolbooks_colours(
    tracers: dict[str, Tracer], scene: str
) -> None:
    """All 33 x 33 tiles within 1e-12 too; measured 1.5e-13."""
    step = SIZE // 33
    pixels = [(c * step + step // 2, r * step + step // 2) for r in range(33) for c in range(33)]
    found = colours(tracers[scene], np.array([row * SIZE + column for column, row in pixels]))
    expected = np.array([WORLDS[scene].colour(column, row) for column, row in pixels])
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)
