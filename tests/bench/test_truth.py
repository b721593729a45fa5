"""The judges agree with each other and with closed forms: who judges must be judged."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from mpmath import mp, mpf

from raywalk.bench.cases import BrokenBounds, Case, refuse_broken
from raywalk.bench.convex import wrong_verdicts
from raywalk.bench.families import around, in_ball, towards
from raywalk.bench.made_scenes import icosphere, scene_of
from raywalk.bench.truth import nearest_hit, triangle_meets
from raywalk.bench.twofold import Twofold, error_of, nearest_root, sphere_roots
from raywalk.scene.shapes import Box, Cylinder, Disc, Ellipsoid, Plane, Shape, Sphere, Triangle

DOWN = np.array([0.0, 0.0, -1.0])


@pytest.mark.parametrize(
    ("shape", "expected"),
    [
        (Sphere((0.0, 0.0, 0.0), 1.0), 4.0),
        (Ellipsoid((0.0, 0.0, 1.0), (3.0, 2.0, 0.5)), 3.5),
        (Cylinder((-1.0, 0.0, 0.0), (1.0, 0.0, 0.0), 0.5), 4.5),
        (Cylinder((0.0, 0.0, -1.0), (0.0, 0.0, 1.0), 0.5), 4.0),
        (Cylinder((0.0, 0.0, -1.0), (0.0, 0.0, 1.0), 0.5, capped=False), None),
        (Box((-1.0, -1.0, -3.0), (1.0, 1.0, 2.0)), 3.0),
        (Plane((7.0, 7.0, -1.0), (0.0, 0.0, 1.0)), 6.0),
        (Disc((0.5, 0.0, 1.0), (0.0, 0.0, 1.0), 0.6), 4.0),
        (Disc((0.5, 0.0, 1.0), (0.0, 0.0, 1.0), 0.4), None),
        (Triangle((-1.0, -1.0, 0.0), (1.0, -1.0, 0.0), (0.0, 1.0, 0.0)), 5.0),
    ],
)
def test_truth_meets_shapes_where_anyone_sees_it(shape: Shape, expected: float | None) -> None:
    """A ray down the z axis from z = 5: the heights of the shapes are whole numbers."""
    hit = nearest_hit(scene_of([shape]), np.array([0.0, 0.0, 5.0]), DOWN)
    assert (hit and float(hit.t)) == expected


def test_triangles_are_decided_in_rationals_on_their_edges() -> None:
    """A ray at a corner hits; one beside it by the smallest float64 misses."""
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    assert triangle_meets(corners, np.array([0.0, 0.0, 2.0]), DOWN) == Fraction(2)
    assert triangle_meets(corners, np.array([-5e-324, 0.0, 2.0]), DOWN) is None


def test_twofold_numbers_hold_thirty_digits(rng: np.random.Generator) -> None:
    """(a b - c) / sqrt(d) of 200 random numbers against mpmath; 2^-100 is about 8e-31."""
    a, b, c, d = rng.uniform(0.5, 2.0, (4, 200))
    found = (Twofold(a) * b - c) / Twofold(d).sqrt()
    for k in range(200):
        true = (mpf(a[k]) * mpf(b[k]) - mpf(c[k])) / mp.sqrt(mpf(d[k]))
        error = abs(mpf(float(found.hi[k])) + mpf(float(found.lo[k])) - true)
        assert error < mpf(2) ** -100 * 4


def test_sphere_roots_agree_with_mpmath(rng: np.random.Generator) -> None:
    """300 rays at a sphere: same verdict, t the same to float64's last digit and beyond."""
    origin, direction = around(rng, 300)
    centre, radius = np.array([0.1, -0.2, 0.3]), 0.8
    near, far, depth = sphere_roots(origin, direction, centre, radius)
    true = nearest_root(near, far)
    scene = scene_of([Sphere((0.1, -0.2, 0.3), 0.8)])
    for k in range(300):
        hit = nearest_hit(scene, origin[k], direction[k])
        assert (hit is None) == bool(depth[k] < 0)
        if hit:
            assert error_of(np.array([float(hit.t)]), true[k : k + 1])[0] <= np.spacing(
                float(hit.t)
            )


def test_clipping_agrees_with_rationals(rng: np.random.Generator) -> None:
    """150 rays near a polyhedron of 80 facets, by clipping and facet by facet."""
    solid = icosphere(1)
    origin, direction = towards(*(3.0 * np.ones((150, 3)), 1.05 * in_ball(rng, 150)))
    by_facets = np.array([
        any(triangle_meets(corner, o, d) is not None for corner in solid)
        for o, d in zip(origin, direction, strict=True)
    ])  # fmt: skip
    assert wrong_verdicts(solid, origin, direction, by_facets) == 0
    assert wrong_verdicts(solid, origin, direction, ~by_facets) == 150


def test_a_bound_can_be_broken_and_nan_breaks_it() -> None:
    """A benchmark that cannot fail is none."""
    good, bad, none = (
        Case("subject", name, "metric", 1.0, value, 10, 7)
        for name, value in (("good", 1.0), ("bad", 1.1), ("none", float("nan")))
    )
    refuse_broken([good])
    with pytest.raises(BrokenBounds, match="seed 7") as raised:
        refuse_broken([good, bad, none])
    assert len(raised.value.broken) == 2
