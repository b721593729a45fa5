"""The sphere round a scene reaches to what stands out on each side."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.geometry.by_hand import scene_of, write_ply

from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.extent import finite_sphere
from raywalk.scene.model import Light
from raywalk.scene.shapes import Box, Cylinder, Ellipsoid, Mesh, Plane, Shape

LOW, HIGH = (-2.0, -3.0, -4.0), (7.0, 6.0, 5.0)
FLOOR = Plane((0.0, -100.0, 0.0), (0.0, 1.0, 0.0))
MIDDLE, HALF = np.add(LOW, HIGH) / 2, np.subtract(HIGH, LOW) / 2


def sphere_round(shapes: list[Shape], **scene) -> tuple[list[float], float]:
    made = scene_of(shapes, **scene)
    centre, radius = finite_sphere(made, CompiledScene(made))
    return centre.tolist(), radius


def assert_spans_the_box(found: tuple[list[float], float]) -> None:
    centre, radius = found
    np.testing.assert_allclose(centre, MIDDLE, rtol=1e-15)
    assert radius == pytest.approx(np.linalg.norm(HALF), rel=1e-15)


def test_each_finite_thing_can_be_what_stands_out() -> None:
    """Eye and target, two lights, a box; a plane never is, wherever its point lies."""
    lights = [Light("low", LOW), Light("high", HIGH)]
    inside = {"eye": (1.0, 2.0, 3.0), "target": (0.0, 0.0, 0.0)}
    assert_spans_the_box(sphere_round([FLOOR], eye=LOW, target=HIGH))
    assert_spans_the_box(sphere_round([FLOOR], lights=lights, **inside))
    assert_spans_the_box(sphere_round([FLOOR, Box(LOW, HIGH)], **inside))
    assert_spans_the_box(sphere_round([Ellipsoid(tuple(MIDDLE), tuple(HALF))], **inside))


def test_a_cylinder_and_a_mesh_stand_out_too(tmp_path: Path) -> None:
    """A rod of radius 1 along x: its box is |y|, |z| <= 1. A mesh: its corners."""
    rod = sphere_round([Cylinder((-4.0, 0.0, 0.0), (4.0, 0.0, 0.0), 1.0)], eye=(0.0, 0.0, 1.0))
    assert rod == ([0.0, 0.0, 0.0], pytest.approx(np.sqrt(18.0), rel=1e-15))
    corners = np.array([LOW, HIGH, (1.0, 2.0, 3.0)])
    mesh = Mesh("m", write_ply(tmp_path / "m.ply", corners, np.array([[0, 1, 2]])))
    assert_spans_the_box(sphere_round([mesh], eye=(1.0, 2.0, 3.0)))
