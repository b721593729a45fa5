"""Objects that share corners leave nothing open between them: judged in rationals."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from tests.geometry.by_hand import unit

from raywalk.bench.made_scenes import mesh_object, scene_of
from raywalk.bench.stress_seams import (
    KINDS,
    lost_at_seams,
    lost_grazing,
    off_their_rays,
    sheared_shapes,
    thin_shapes,
)
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.exact_edges import edge_side, summed
from raywalk.scene.model import Camera, Material, SceneObject
from raywalk.scene.shapes import Box, Triangle
from raywalk.trace.camera import camera_directions


@pytest.mark.parametrize("kind", KINDS)
def test_no_ray_passes_between_two_that_share_an_edge(kind: str) -> None:
    """2,000 rays aimed at edges and corners of ten pairs: none is lost that rationals hit."""
    assert lost_at_seams(kind, 2_000, 10, seed=20261122) == 0


def test_the_pixel_that_saw_through_a_quad_sees_it() -> None:
    """Two triangles on one edge, 1155 pixels wide: pixel (363, 791) looked at the background."""
    corners = [
        ((-0.8, -0.8, 0.0), (1.1, -1.35, 0.8), (0.8, 0.8, 0.0)),
        ((-0.8, -0.8, 0.0), (0.8, 0.8, 0.0), (-1.05, 1.1, 0.2)),
    ]
    compiled = CompiledScene(scene_of([Triangle(*three) for three in corners]))
    camera = Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0), fov=45.0)
    direction = camera_directions(camera, 1155, 1155, np.array([791 * 1155 + 363]))
    assert np.isfinite(compiled.nearest(rays_from(np.array([[0.0, 0.0, 5.0]]), direction))[0]).all()


@pytest.mark.parametrize("cosine", [1e-2, 1e-5, 1e-7, 1e-12])
def test_a_ray_along_an_open_mesh_is_not_lost(cosine: float) -> None:
    """However flat: one triangle, as an object and as a mesh, and a flat sheet of 72."""
    for kind in ("triangle", "one triangle as a mesh", "flat sheet"):
        assert lost_grazing(kind, cosine, 300, seed=20261122) == 0, kind


def test_a_hit_on_a_thin_shape_lies_on_its_ray() -> None:
    """Ellipsoids and cones a million times flatter than wide: the hit is within 4 of float64's own
    errors of o + t d, of sheared bodies within 8."""
    assert off_their_rays(thin_shapes(), 4.0, 400, seed=20261122) == 0
    assert off_their_rays(sheared_shapes(), 8.0, 400, seed=20261122) == 0


@pytest.mark.parametrize("size", [1.0, 1e-90, 1e90])
def test_an_edge_has_the_sign_that_rationals_give(rng: np.random.Generator, size: float) -> None:
    """Rays through points of the edge, of small whole numbers too, where the sum is exactly 0."""
    for turn in range(300):
        whole = turn % 3 == 0
        o, p, q = rng.integers(-3, 4, (3, 3)).astype(float) if whole else rng.normal(size=(3, 3))
        d = rng.integers(-3, 4, 3).astype(float) if whole else p + rng.uniform() * (q - p) - o
        p_rest, q_rest = (1e-17 * each if turn % 3 == 1 else 0.0 * each for each in (p, q))
        points = [size * each for each in (o, p, p_rest, q, q_rest)]
        o, p, p_rest, q, q_rest = (tuple(each.tolist()) for each in points)
        true = by_rationals(o, tuple(d.tolist()), p, p_rest, q, q_rest)
        for function in (edge_side, summed):
            found = function(o, tuple(d.tolist()), p, p_rest, q, q_rest)
            assert np.sign(found) == (true > 0) - (true < 0)


def by_rationals(o, d, p, p_rest, q, q_rest) -> Fraction:  # type: ignore[no-untyped-def]
    """d . ((p - o) x (q - o))."""
    one, other = (
        [Fraction(x) + Fraction(r) - Fraction(y) for x, r, y in zip(at, rest, o, strict=True)]
        for at, rest in ((p, p_rest), (q, q_rest))
    )
    return sum(
        (
            Fraction(d[k]) * (one[k - 2] * other[k - 1] - one[k - 1] * other[k - 2])
            for k in range(3)
        ),
        Fraction(0),
    )


def test_a_moved_mesh_and_a_triangle_share_their_edge_in_the_world(
    rng: np.random.Generator, tmp_path: Path
) -> None:
    """A thousand sizes from the origin, where the mesh's own coordinates are others."""
    a, b, c, e = rng.normal(size=(4, 3)) + 1000.0
    mesh = mesh_object(tmp_path / "one.ply", np.array([[a, b, c]]))
    other = Triangle(*(tuple(each.tolist()) for each in (a, c, e)))
    compiled = CompiledScene(scene_of([mesh, other]))
    inside = a + rng.uniform(0.1, 0.9, (500, 1)) * (c - a)
    middle = (b + e) / 2
    origin = inside + 4 * unit(np.cross(b - a, c - a) + np.cross(c - a, e - a)) + 0.01 * middle
    rays = rays_from(origin, unit(inside - origin))
    assert np.isfinite(compiled.nearest(rays)[0]).mean() > 0.4  # most meet one or the other


def edged_of(*shapes):
    """Which of these objects have their edges decided exactly."""
    named = [SceneObject(str(k), shape, 0) for k, shape in enumerate(shapes)]
    table = CompiledScene(scene_of(named, [Material("chalk")])).primitives
    return sorted(table.object[table.is_edged].tolist())


def test_boxes_that_share_no_corner_pay_for_no_exact_edges():
    """A box for itself is tight; one that touches another anywhere but at a corner is as well."""
    low, apart, on_top = (
        Box((0, 0, 0), (1, 1, 1)),
        Box((2, 0, 0), (3, 1, 1)),
        Box((0, 1, 0), (1, 2, 1)),
    )
    assert edged_of(low) == edged_of(low, apart) == []
    assert edged_of(low, apart, on_top) == [0, 2]
    assert edged_of(low, Triangle((1, 1, 1), (5, 5, 5), (5, 6, 5))) == [0, 1]
    assert edged_of(apart, Triangle((-0.0, 4, 0), (5, 5, 5), (5, 6, 5))) == [1]
