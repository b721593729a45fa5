"""Each canonical shape is taken to where the author's numbers say."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.geometry.by_hand import SHAPES, SOLIDS

from raywalk.scene.model import SceneObject
from raywalk.scene.placement import placement
from raywalk.scene.shapes import (
    Box,
    Cylinder,
    Disc,
    Ellipsoid,
    Mesh,
    Plane,
    Shape,
    Sphere,
    Triangle,
)

X, Y, Z, ORIGIN = (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 0)
A, B, C = (1.0, 2.0, 3.0), (4.0, -1.0, 2.5), (0.5, 7.0, -2.0)
# About x, then y, then z: x stays, goes to -z, stays; y to z to x to y; z to -y, stays, to x.
QUARTERS = (90.0, 90.0, 90.0)
# Of a shape: canonical points, and where they must come to lie.
LANDMARKS = {
    Sphere(A, 2.0): {ORIGIN: A, X: (3, 2, 3), Y: (1, 4, 3), Z: (1, 2, 5)},
    Ellipsoid(A, (2.0, 3.0, 4.0)): {ORIGIN: A, X: (3, 2, 3), Y: (1, 5, 3), Z: (1, 2, 7)},
    Ellipsoid(ORIGIN, (2.0, 3.0, 4.0), QUARTERS): {X: (0, 0, -2), Y: (0, 3, 0), Z: (4, 0, 0)},
    Box((-1.0, 2.0, 3.0), (5.0, 3.0, 9.0)): {(-1, -1, -1): (-1, 2, 3), (1, 1, 1): (5, 3, 9)},
    Cylinder(A, B, 2.0): {(0, 0, -1): A, Z: B},
    Triangle(A, B, C): {ORIGIN: A, X: B, Y: C},
    Plane(A, (0.0, 5.0, 0.0)): {ORIGIN: A, X: (2, 2, 3), Y: (1, 3, 3)},
    Disc(A, (0.0, 5.0, 0.0), 2.0): {ORIGIN: A, Z: (1, 4, 3)},
    Mesh("m", Path("m.ply")): {ORIGIN: ORIGIN, X: X, Y: Y, Z: Z},
}
MOVED = np.array([[0, 2, 0, 1], [0, 0, 3, 2], [4, 0, 0, 3], [0, 0, 0, 1]], float)


def word(shape: Shape) -> str:
    return shape.word


@pytest.mark.parametrize("transform", [np.eye(4), MOVED], ids=["as it is", "transformed"])
@pytest.mark.parametrize("shape", LANDMARKS, ids=word)
def test_landmarks_stand_where_the_numbers_say(shape: Shape, transform: np.ndarray) -> None:
    """Centres, ends, corners: first the shape's own numbers, then the object's transform."""
    linear, centre = placement(SceneObject("o", shape, 0, transform))
    for canonical, own in LANDMARKS[shape].items():
        expected = transform[:3, :3] @ own + transform[:3, 3]
        # entries are rounded once, of numbers up to 30; the sum of four of them again
        np.testing.assert_allclose(linear @ canonical + centre, expected, rtol=0, atol=1e-14)


AXES = [(0.0, 5.0, 0.0), (3.0, 0.0, 0.0), (0.0, 0.0, -2.0), (1.0, 2.0, -3.0), (-3.0, 2.0, 1.0)]


@pytest.mark.parametrize("axis", AXES)
def test_round_shapes_and_planes_stand_square_on_their_axis(axis: tuple[float, ...]) -> None:
    """Axis and radii are at right angles, as long as the numbers say, and right-handed."""
    along = np.array(axis) / np.linalg.norm(axis)
    end = tuple(np.add(A, axis))
    for shape, upright, lengths in (
        (Disc(A, axis, 2.0), 2, (2.0, 2.0, 2.0)),
        (Plane(A, axis), 1, (1.0, 1.0, 1.0)),
        (Cylinder(A, end, 2.0), 2, (2.0, 2.0, float(np.linalg.norm(axis)) / 2)),
    ):
        linear, _ = placement(SceneObject("o", shape, 0))
        np.testing.assert_allclose(linear.T @ linear, np.diag(lengths) ** 2, rtol=0, atol=1e-14)
        np.testing.assert_allclose(linear[:, upright], along * lengths[upright], rtol=1e-15)
        assert np.linalg.det(linear) > 0


def test_a_triangle_stands_on_its_normal() -> None:
    """The third axis is (b - a) x (c - a), so that the map can be inverted."""
    linear, _ = placement(SceneObject("o", Triangle(A, B, C), 0))
    np.testing.assert_allclose(linear[:, 2], np.cross(np.subtract(B, A), np.subtract(C, A)))


@pytest.mark.parametrize("name", SOLIDS)
def test_reach_height_and_volume_of_a_solid_agree(name: str, rng: np.random.Generator) -> None:
    """What lies inside is within reach, is as much as the volume says, and ends at height 0."""
    solid = SHAPES[name].canonical
    assert solid.height is not None
    count = 20000
    points = rng.uniform(-1.0, 1.0, (count, 3))
    inside = np.array([solid.height(*p) < 0 for p in points.tolist()])
    assert np.linalg.norm(points[inside], axis=1).max() <= solid.reach
    share = solid.volume / 8.0
    # 4 standard errors, of a box none
    assert inside.mean() == pytest.approx(share, abs=4 * np.sqrt(share * (1 - share) / count))
    for way in rng.normal(size=(100, 3)):
        low, high = 0.0, 2.0 / np.linalg.norm(way)
        for _ in range(60):
            middle = (low + high) / 2
            if solid.height(*(middle * way).tolist()) < 0:
                low = middle
            else:
                high = middle
        assert abs(solid.height(*(low * way).tolist())) < 1e-14
