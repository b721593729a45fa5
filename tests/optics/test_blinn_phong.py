"""Blinn-Phong against forms that can be checked by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tests.geometry.by_hand import scene_of

from raywalk.optics.blinn_phong import diffuse_cosine, highlight, strength
from raywalk.optics.shade import light_factors, local_colours, towards_light
from raywalk.scene.model import Light, Material
from raywalk.trace.tables import Lights, Materials, compile_lights, compile_materials

UP = (0.0, 1.0, 0.0)


@pytest.mark.parametrize("degrees", [0, 30, 45, 60, 89, 90])
def test_diffuse_light_falls_with_the_cosine(degrees: int) -> None:
    """n.l = cos(angle) while the light is above the surface."""
    angle = math.radians(degrees)
    light = math.sin(angle), math.cos(angle), 0.0
    assert diffuse_cosine(*UP, *light) == pytest.approx(math.cos(angle), abs=1e-16)


def test_light_from_behind_gives_nothing() -> None:
    """max(0, .) cuts at 90 degrees."""
    assert diffuse_cosine(*UP, 0.6, -0.8, 0.0) == 0.0
    assert highlight(*UP, 0.6, -0.8, 0.0, 0.6, -0.8, 0.0, 10.0) == 0.0


@pytest.mark.parametrize("shininess", [1.0, 10.0, 100.0, 1000.0])
def test_the_highlight_is_full_where_light_mirrors_into_the_eye(shininess: float) -> None:
    """h = n, so (n.h)^s = 1 to the roundings of one normalisation, times s."""
    found = highlight(*UP, 0.6, 0.8, 0.0, -0.6, 0.8, 0.0, shininess)
    assert found == pytest.approx(1.0, abs=3e-16 * shininess)


@pytest.mark.parametrize("shininess", [1.0, 10.0, 100.0])
def test_the_highlight_falls_with_half_the_angle_between(shininess: float) -> None:
    """Eye on the normal, light at angle a: h stands at a / 2, so the factor is cos(a/2)^s."""
    for angle in np.linspace(0.0, 3.0, 31):
        found = highlight(*UP, math.sin(angle), math.cos(angle), 0.0, *UP, shininess)
        expected = math.cos(angle / 2) ** shininess
        # 3 roundings, times s, and at 3 rad over the half vector's length of 0.14
        assert found == pytest.approx(expected, abs=3e-15 * shininess)


def test_shininess_zero_and_light_straight_behind_are_numbers() -> None:
    """x^0 = 1 for a half vector above the surface; l = -e leaves no half vector: 0."""
    assert highlight(*UP, 0.6, 0.8, 0.0, *UP, 0.0) == 1.0
    assert highlight(*UP, 0.6, 0.8, 0.0, -0.6, -0.8, 0.0, 0.0) == 0.0


def test_attenuation_is_the_quotient_it_says() -> None:
    """I / (a0 + a1 D + a2 D^2) with numbers that are exact."""
    assert strength(2.0, 12.0, 1.0, 0.5, 0.25) == 12.0 / 3.0
    assert strength(3.0, 1.0, 1.0, 0.0, 0.0) == 1.0  # the default does not fall off


@pytest.mark.parametrize("distance", [0.0, 1e-320, 1e-200, 1e-155, 1e-30, 1e150])
@pytest.mark.parametrize("falloff", [(0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (0.0, 0.0, 0.0)])
def test_no_falloff_gives_infinity(distance: float, falloff: tuple[float, ...]) -> None:
    """Light is 0 where the quotient divides by 0, and finite beside it: black times infinity
    would be no number."""
    assert math.isfinite(strength(distance, 1.0, *falloff))


def tables(*lights: Light) -> tuple[Materials, Lights]:
    """One coloured material with a black channel, and these lights."""
    material = Material("red", (0.1, 0.2, 0.3), (0.9, 0.0, 0.5), (1.0, 1.0, 0.0), 20.0)
    scene = scene_of([], [material], lights)
    return compile_materials(scene), compile_lights(scene)


def shaded(light: Light, point: tuple[float, float, float]) -> np.ndarray:
    """The local colour of a point on a floor, seen from straight above."""
    materials, lights = tables(light)
    at, normal = np.array([point]), np.array([UP])
    rows, material = np.zeros(1, np.int64), np.zeros(1, np.int32)
    to_light, distance, facing = towards_light(rows, at, normal, lights.position[0])
    diffuse, specular, colour = np.zeros((1, 1)), np.zeros((1, 1)), np.zeros((1, 3))
    light_factors(
        materials, rows, material, normal, -normal, to_light, distance,
        lights.intensity[0], lights.attenuation[0], 0, diffuse, specular,
    )  # fmt: skip
    lit = facing[:, None]
    local_colours(materials, lights, rows, material, lit, diffuse, specular, colour)
    return colour[0]


def test_the_local_colour_is_ambient_plus_diffuse_plus_specular() -> None:
    """Light at (3, 4, 0), strength 2 / (1 + 5) = 1/3: n.l = 4/5, h at half of acos(4/5),
    whose cosine is sqrt((1 + 4/5) / 2) = sqrt(9/10)."""
    lamp = Light("lamp", (3.0, 4.0, 0.0), (1.0, 0.5, 1.0), 2.0, (1.0, 1.0, 0.0))
    shine = 0.9 ** (20 / 2)
    expected = [
        0.1 + (0.9 * 0.8 + shine) / 3,
        0.2 + (0.0 + shine) / 3 * 0.5,
        0.3 + 0.5 * 0.8 / 3,
    ]
    np.testing.assert_allclose(shaded(lamp, (0.0, 0.0, 0.0)), expected, rtol=0, atol=1e-15)


@pytest.mark.parametrize("falloff", [(1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)])
def test_a_light_at_the_very_point_leaves_the_ambient_colour(falloff: tuple[float, ...]) -> None:
    """It has no direction, faces nothing, and gives no NaN."""
    lamp = Light("lamp", (1.0, 2.0, 3.0), attenuation=falloff)  # type: ignore[arg-type]
    assert shaded(lamp, (1.0, 2.0, 3.0)).tolist() == [0.1, 0.2, 0.3]


@pytest.mark.parametrize("away", [1e-155, 1e-160, 1e-200])
def test_a_light_almost_at_the_point_is_bright_but_a_number(away: float) -> None:
    """1 / D^2 overflows; black channels stay as dark as they are."""
    colour = shaded(Light("lamp", (0.0, away, 0.0), attenuation=(0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))
    assert np.isfinite(colour).all()
