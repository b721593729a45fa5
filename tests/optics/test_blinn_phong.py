"""Blinn-Phong against forms that can be checked by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tests.geometry.by_hand import scene_of

from raywalk.optics.blinn_phong import diffuse_cosine, highlight, strength
from raywalk.optics.shade import light_factors, local_colours, towards_lights
from raywalk.scene.model import Light, Material
from raywalk.trace.lighting import NO_BASE
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
@pytest.mark.parametrize("cosine", [1.0, 0.8, 0.5, 0.1])  # at 0.5, l + e is a unit vector as it is
def test_the_highlight_is_full_where_light_mirrors_into_the_eye(
    cosine: float, shininess: float
) -> None:
    """h = n, so (n.h)^s = 1 to the roundings of one normalisation, times s."""
    sine = math.sqrt(1.0 - cosine * cosine)
    found = highlight(*UP, sine, cosine, 0.0, -sine, cosine, 0.0, shininess)
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
    assert highlight(*UP, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0) == 0.0  # along the surface: from 0 on


def test_the_factors_are_dot_products_in_any_direction(rng: np.random.Generator) -> None:
    """n.l and n.(l + e) / |l + e|, each 0 where it is below, for 1000 random directions."""
    for _ in range(1000):
        n, l, e = (v / np.linalg.norm(v) for v in rng.normal(size=(3, 3)))
        half = (l + e) / np.linalg.norm(l + e)
        assert diffuse_cosine(*n, *l) == pytest.approx(max(0.0, n @ l), abs=1e-15)  # 5 roundings
        # the same, and over the half vector's length, of which 1000 pairs leave 0.01 and more
        assert highlight(*n, *l, *e, 1.0) == pytest.approx(max(0.0, n @ half), abs=1e-13)


def test_attenuation_is_the_quotient_it_says() -> None:
    """I / (a0 + a1 D + a2 D^2) with numbers that are exact."""
    assert strength(2.0, 12.0, 1.0, 0.5, 0.25) == 12.0 / 3.0
    assert strength(3.0, 1.0, 1.0, 0.0, 0.0) == 1.0  # the default does not fall off


@pytest.mark.parametrize("distance", [0.0, 1e-320, 1e-200, 1e-155, 1e-30, 1e150])
@pytest.mark.parametrize("falloff", [(0.0, 0.0, 1.0), (0.0, 1.0, 0.0), (0.0, 0.0, 0.0)])
def test_no_falloff_gives_infinity(distance: float, falloff: tuple[float, ...]) -> None:
    """Light is 0 where the quotient divides by 0, and finite beside it: black times infinity
    would be no number."""
    divisor = falloff[0] + falloff[1] * distance + falloff[2] * distance * distance
    found = strength(distance, 1.0, *falloff)
    assert found == (min(1.0 / divisor, 1e300) if divisor else 0.0)


# With a black channel.
RED = Material("red", (0.1, 0.2, 0.3), (0.9, 0.0, 0.5), (1.0, 1.0, 0.0), 20.0)


def tables(material: Material, *lights: Light) -> tuple[Materials, Lights]:
    """One material and these lights."""
    scene = scene_of([], [material], lights)
    return compile_materials(scene), compile_lights(scene)


def shaded(
    light: Light, point: tuple[float, float, float], material_of_floor: Material = RED
) -> np.ndarray:
    """The local colour of a point on a floor, seen from straight above."""
    materials, lights = tables(material_of_floor, light)
    at, normal = np.array([point]), np.array([UP])
    rows, material = np.zeros(1, np.int64), np.zeros(1, np.int32)
    to_light, distance, facing = towards_lights(rows, at, normal, lights.position)
    diffuse, specular, colour = np.zeros((1, 1)), np.zeros((1, 1)), np.zeros((1, 3))
    light_factors(
        materials, lights, 0, rows, material, normal, -normal, to_light, distance, diffuse, specular
    )
    lit = facing[:, None]
    local_colours(materials, lights, rows, material, NO_BASE, lit, diffuse, specular, colour)
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


@pytest.mark.parametrize("away", [0.5, 1.0, 2.0, 3.0])
def test_a_light_straight_above_gives_all_it_has(away: float) -> None:
    """Seen from above too: n.l = n.h = 1, so I / (1 + D) (kd + ks)."""
    lamp = Light("lamp", (0.0, away, 0.0), intensity=2.0, attenuation=(1.0, 1.0, 0.0))
    reach = 2.0 / (1.0 + away)
    expected = [0.1 + reach * 1.9, 0.2 + reach * 1.0, 0.3 + reach * 0.5]
    np.testing.assert_allclose(shaded(lamp, (0.0, 0.0, 0.0)), expected, rtol=4e-16)


@pytest.mark.parametrize("part", ["diffuse", "specular"])
@pytest.mark.parametrize("channel", range(3))
def test_one_channel_is_enough_to_be_lit(channel: int, part: str) -> None:
    """What is black in all three is not worked out; a pure red, green or blue is."""
    colour = tuple(float(c == channel) for c in range(3))
    lamp = Light("lamp", (0.0, 2.0, 0.0))
    found = shaded(lamp, (0.0, 0.0, 0.0), Material("pure", **{part: colour}))
    assert found.tolist() == pytest.approx(colour, abs=1e-15)


@pytest.mark.parametrize("based", [False, True], ids=["", "base colours"])
def test_many_points_are_shaded_as_one_by_one(rng: np.random.Generator, based: bool) -> None:
    """Points, normals, rays, materials and lights at random, in rows out of order: each colour is
    B ambient + sum of V I / (a0 + a1 D + a2 D^2) (B kd n.l + ks (n.h)^s) light."""
    looks = [Material(f"m{m}", *rng.random((3, 3)), 1.0 + 9.0 * rng.random()) for m in range(4)]
    lamps = [
        Light(f"l{k}", *rng.random((2, 3)), 1.0 + rng.random(), rng.random(3)) for k in range(3)
    ]
    scene = scene_of([], looks, lamps)
    materials, lights = compile_materials(scene), compile_lights(scene)
    count, rows = 60, rng.permutation(60)[:50]
    point, normal, incoming = rng.normal(size=(3, count, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    incoming /= np.linalg.norm(incoming, axis=1, keepdims=True)
    material = rng.integers(0, 4, count).astype(np.int32)
    visible = rng.random((count, 3)) < 0.7
    diffuse, specular = np.zeros((2, count, 3))
    to_light, distance, facing = towards_lights(rows, point, normal, lights.position)
    l = (lights.position[:, None] - point[rows]).reshape(-1, 3)
    np.testing.assert_allclose(to_light * distance[:, None], l, rtol=0, atol=1e-14)
    np.testing.assert_allclose(np.linalg.norm(to_light, axis=1), 1.0, rtol=0, atol=4e-16)
    assert (facing == ((l * np.tile(normal[rows], (3, 1))).sum(axis=1) > 0)).all()
    light_factors(
        materials,
        lights,
        0,
        rows,
        material,
        normal,
        incoming,
        to_light,
        distance,
        diffuse,
        specular,
    )
    colour, base = np.zeros((count, 3)), rng.random((count if based else 0, 3))
    local_colours(materials, lights, rows, material, base, visible, diffuse, specular, colour)
    for i in rows:
        look, own = looks[material[i]], base[i] if based else np.ones(3)
        expected = own * look.ambient
        for k, lamp in enumerate(lamps):
            away = np.linalg.norm(lamp.position - point[i])
            l = (lamp.position - point[i]) / away
            half = (l - incoming[i]) / np.linalg.norm(l - incoming[i])
            reach = lamp.intensity / (lamp.attenuation @ np.array([1.0, away, away * away]))
            shine = own * look.diffuse * max(0.0, normal[i] @ l)
            shine += np.multiply(look.specular, max(0.0, normal[i] @ half) ** look.shininess)
            expected += visible[i, k] * reach * shine * lamp.colour
        # some 30 roundings, in highlights times an exponent of up to 10
        np.testing.assert_allclose(colour[i], expected, rtol=1e-13, atol=1e-14)
    assert not colour[np.setdiff1d(np.arange(count), rows)].any()


@pytest.mark.parametrize("falloff", [(1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)])
def test_a_light_at_the_very_point_leaves_the_ambient_colour(falloff: tuple[float, ...]) -> None:
    """It has no direction, faces nothing, and gives no NaN."""
    lamp = Light("lamp", (1.0, 2.0, 3.0), attenuation=falloff)  # type: ignore[arg-type]
    assert shaded(lamp, (1.0, 2.0, 3.0)).tolist() == [0.1, 0.2, 0.3]
    at = np.array([[1.0, 2.0, 3.0]])
    to_light, distance, facing = towards_lights(np.zeros(1, np.int64), at, -at, at)
    assert not (to_light.any() or distance.any() or facing.any())


@pytest.mark.parametrize("away", [1e-155, 1e-160, 1e-200])
def test_a_light_almost_at_the_point_is_bright_but_a_number(away: float) -> None:
    """1 / D^2 overflows; black channels stay as dark as they are."""
    colour = shaded(Light("lamp", (0.0, away, 0.0), attenuation=(0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))
    assert np.isfinite(colour).all()
