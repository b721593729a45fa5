"""Textures: where on a shape a picture lies, and what it says there, by closed forms."""

from __future__ import annotations

import numpy as np
import pytest
from tests.geometry.by_hand import scene_of

from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.texture_lookup import looked_up
from raywalk.geometry.texture_places import ends_of, places_on, upright_on
from raywalk.scene.exact import rounded
from raywalk.scene.shapes import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Ellipsoid,
    Plane,
    Shape,
    Sphere,
    Triangle,
)

# Row 0 on top: a b over c d.
A, B, C, D = [255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]
FOUR = np.array([[A, B], [C, D]], np.uint8)
ONCE = (1.0, 1.0)
SHAPES = [
    Sphere((0, 0, 0), 2.0), Ellipsoid((1, 0, 0), (1, 2, 3), (10, 20, 30)),
    Plane((1, 2, 3), (0, 1, 0)), Plane((0, 0, 0), (0, -1, 0)), Plane((0, 0, 0), (0.3, 0.2, -1)),
    Plane((0, 0, 0), (-2, 1, 1)), Disc((0, 1, 0), (1, 2, 3), 2.0), Disc((0, 1, 0), (0, 0, 1), 0.5),
    Box((-1, -2, -3), (1, 1, 1)), Triangle((0, 0, 0), (2, 0, 0.5), (0, 3, 1)),
    Cylinder((0, 0, 0), (0, 2, 0), 0.5), Cylinder((0, 0, 0), (-2, 0.3, 0), 0.5),
    Cylinder((0, 0, 0), (0, 0, 1), 2.0, False), Cone((0, 0, 0), (0, 2, 0), 1.0, 0.3),
    Cone((0, 0, 0), (0, -2, 0), 0.3, 1.0), Cone((0, 0, 0), (1, 0, 2), 1.0, 0.0),
]  # fmt: skip


def at(place: tuple[float, float], filter: str, **more: object) -> list[float]:
    """What the four pixels say there, of 255."""
    found = looked_up(
        FOUR, np.array([place]), filter, more.get("repeat", ONCE), more.get("ends", (False, False))
    )  # type: ignore[arg-type]
    return [float(value) for value in 255 * found[0]]


@pytest.mark.parametrize("filter", ["nearest", "bilinear"])
def test_at_its_centre_a_pixel_has_its_own_colour(filter: str) -> None:
    """Column i from the left and row j from below at ((i + 1/2) / w, (j + 1/2) / h), exactly; and a
    whole number of pictures further on again."""
    for place, colour in (
        ((0.25, 0.75), A),
        ((0.75, 0.75), B),
        ((0.25, 0.25), C),
        ((0.75, 0.25), D),
    ):
        assert at(place, filter) == colour
        assert at((place[0] + 3, place[1] - 7), filter) == colour


def test_halfway_between_centres_bilinear_is_the_mean_and_nearest_one_of_both() -> None:
    """Exactly: 127.5 of 255 between black and full, a quarter of all four in the middle."""
    assert at((0.5, 0.75), "bilinear") == [127.5, 127.5, 0]
    assert at((0.25, 0.5), "bilinear") == [127.5, 0, 127.5]
    assert at((0.5, 0.5), "bilinear") == [127.5, 127.5, 127.5]
    assert at((0.375, 0.75), "bilinear") == [0.75 * 255, 0.25 * 255, 0]
    assert at((0.5, 0.75), "nearest") == B
    assert at((np.nextafter(0.5, 0), 0.75), "nearest") == A


def test_a_picture_goes_on_beyond_its_edge_or_ends_there() -> None:
    """Round a sphere left meets right: halfway between them there is their mean. At a pole nothing
    follows: the last row goes on."""
    assert at((0.0, 0.75), "bilinear") == at((1.0, 0.75), "bilinear") == [127.5, 127.5, 0]
    assert at((0.25, 1.0), "bilinear") == [127.5, 0, 127.5]
    ends = (False, True)
    assert at((0.25, 1.0), "bilinear", ends=ends) == at((0.25, 1.0), "nearest", ends=ends) == A
    assert at((0.25, 0.0), "bilinear", ends=ends) == at((0.25, 0.0), "nearest", ends=ends) == C


def test_repeat_says_how_many_pictures_stand_in_a_unit() -> None:
    """From (0, 0) on; where it ends, with the picture's part that is there."""
    assert at((0.25 / 3, 0.75 / 2), "nearest", repeat=(3.0, 2.0)) == A
    assert at((1.25 / 3, 1.75 / 2), "bilinear", repeat=(3.0, 2.0)) == A
    assert at((1.0, 1.0), "nearest", repeat=(1.5, 1.5), ends=(True, True)) == C


def test_bilinear_is_continuous_everywhere(rng: np.random.Generator) -> None:
    """Two places 1e-9 apart, over edges and seams too, differ by the steepest slope at most."""
    pixels = rng.integers(0, 256, (5, 7, 3)).astype(np.uint8)
    places = rng.uniform(-2, 2, (2000, 2))
    places[::2] = np.round(places[::2] * 70) / 70  # many on edges and centres
    aside = places + rng.choice([-1e-9, 1e-9], places.shape)
    steps = np.abs(
        looked_up(pixels, places, "bilinear", ONCE) - looked_up(pixels, aside, "bilinear", ONCE)
    )
    assert steps.max() <= 1e-9 * (5 + 7) * 1.01 + 1e-15  # a pixel's width is 1/7, or 1/5


def surface_points(shape: Shape, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Own places before the shape's centre is added, (n, 3), of rays that meet it from outside, and
    the unit normals there."""
    linear, centre = (rounded(part) for part in shape.placement())
    scene = scene_of([shape])
    count = 400
    target = 0.3 * rng.normal(size=(count, 3)) @ linear.T
    origin = 20 * rng.normal(size=(count, 3))
    hits = CompiledScene(scene).hits(rays_from(centre + origin, target - origin))
    met = (hits.object == 0) & ~hits.inside
    return hits.point[met] - centre, hits.normal[met]


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape.word)
def test_pictures_are_not_mirrored_and_lie_evenly(shape: Shape, rng: np.random.Generator) -> None:
    """Seen from outside u grows to the right of v: the turn from one to the other is against the
    clock, everywhere but at edges and seams."""
    inverse = np.linalg.inv(rounded(shape.placement()[0]))
    point, normal = surface_points(shape, rng)
    assert len(point) > 20
    first = np.cross(normal, np.roll(normal, 1, axis=1) + np.array([0.1, 0.2, 0.3]))
    first /= np.linalg.norm(first, axis=1, keepdims=True)
    second = np.cross(normal, first)
    h = 1e-6

    def along(way: np.ndarray) -> np.ndarray:
        ends = [places_on(shape, (point + k * h * way) @ inverse.T) for k in (-1, 1)]
        return (ends[1] - ends[0]) / (2 * h)

    a, b = along(first), along(second)
    turn = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    smooth = np.abs(np.concatenate([a, b], axis=1)).max(axis=1) < 100
    assert smooth.mean() > 0.9
    assert (turn[smooth] > 0).all()


@pytest.mark.parametrize("shape", SHAPES, ids=lambda shape: shape.word)
def test_finite_shapes_show_the_picture_within_0_and_1(
    shape: Shape, rng: np.random.Generator
) -> None:
    """Along axes that end there."""
    point, _ = surface_points(shape, rng)
    places = places_on(shape, point @ np.linalg.inv(rounded(shape.placement()[0])).T)
    for axis, ends in enumerate(ends_of(shape)):
        if ends or not isinstance(shape, Plane):
            assert places[:, axis].min() >= -1e-12
            assert places[:, axis].max() <= 1 + 1e-12


@pytest.mark.parametrize(
    ("point", "place"),
    [
        ((0, 0, 1), (0.5, 0.5)), ((1, 0, 0), (0.75, 0.5)), ((-1, 0, 0), (0.25, 0.5)),
        ((0, 1, 0), (None, 1.0)), ((0, -1, 0), (None, 0.0)), ((0, 0.5, 0.75**0.5), (0.5, 2 / 3)),
        ((0.5**0.5, 0, 0.5**0.5), (0.625, 0.5)),
        ((1e-9, 0, -1), (1.0, 0.5)), ((-1e-9, 0, -1), (0.0, 0.5)),
        ((3e-9, 1, 4e-9), (None, 1 - 5e-9 / np.pi)),
    ],
)  # fmt: skip
def test_round_a_sphere_the_picture_is_a_map(
    point: tuple[float, ...], place: tuple[float | None, float]
) -> None:
    """Middle +z, right +x, pole +y, seam at -z; next to the pole with all digits."""
    found = places_on(Sphere((0, 0, 0), 1), np.array([point], float))[0]
    for value, expected in zip(found, place, strict=True):
        assert expected is None or value == pytest.approx(expected, rel=0, abs=2e-10)
    if point == (3e-9, 1, 4e-9):
        assert 1 - found[1] == pytest.approx(5e-9 / np.pi, rel=1e-6)


def test_flat_pictures_stand_upright_for_who_looks_at_them() -> None:
    """Walls with y up; floor and ceiling with -z up, right and left of it as one sees it."""
    looked = {
        (0, 0, 1): ([1, 0, 0], [0, 1, 0]), (0, 0, -1): ([-1, 0, 0], [0, 1, 0]),
        (1, 0, 0): ([0, 0, -1], [0, 1, 0]), (-1, 0, 0): ([0, 0, 1], [0, 1, 0]),
        (0, 1, 0): ([1, 0, 0], [0, 0, -1]), (0, -1, 0): ([-1, 0, 0], [0, 0, -1]),
    }  # fmt: skip
    for normal, (right, up) in looked.items():
        found = upright_on(np.array(normal, float))
        assert [each.tolist() for each in found] == [right, up]
