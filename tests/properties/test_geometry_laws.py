"""Laws that hits obey on any shape, from any side, at any scale."""

from __future__ import annotations

import math

import numpy as np
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from raywalk.bench.made_scenes import placed, scene_of
from raywalk.geometry.compiled import CompiledScene, Rays, rays_from
from raywalk.geometry.sides import TIE
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Box, Cone, Cylinder, Ellipsoid, Sphere

ALWAYS_THE_SAME = settings(derandomize=True, deadline=None, max_examples=100)
place = st.floats(-2.0, 2.0)
size = st.floats(0.1, 1.5)
angle = st.floats(-180.0, 180.0)
triple = st.tuples(place, place, place)
# Rows of a batch: every example traces them all at once.
COUNT = 64


@st.composite
def solids(draw):
    """A convex solid somewhere in the middle."""
    centre = np.array(draw(triple))
    half = np.array([draw(size) for _ in range(3)])
    kind = draw(st.sampled_from(["sphere", "ellipsoid", "box", "cylinder", "cone", "frustum"]))
    if kind == "sphere":
        return Sphere(tuple(centre), half[0])
    if kind == "ellipsoid":
        return Ellipsoid(tuple(centre), tuple(half), (draw(angle), draw(angle), draw(angle)))
    if kind == "box":
        return Box(tuple(centre - half), tuple(centre + half))
    axis = np.array(draw(triple))
    assume(np.linalg.norm(axis) > 0.1)
    ends = tuple(centre - axis), tuple(centre + axis)
    if kind == "cylinder":
        return Cylinder(*ends, half[0])
    return Cone(*ends, half[0], half[1] if kind == "frustum" else 0.0)


def rays_of(seed: int) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    origin = rng.uniform(-6.0, 6.0, (COUNT, 3))
    direction = rng.uniform(-2.0, 2.0, (COUNT, 3)) - origin
    return origin, direction / np.linalg.norm(direction, axis=1, keepdims=True)


@ALWAYS_THE_SAME
@given(solids(), st.integers(0, 2**32 - 1))
def test_hits_lie_on_their_rays_and_normals_face_them(shape, seed: int) -> None:
    """p = o + t d to the rounding of the lengths involved; n.d <= 0, |n| = 1."""
    origin, direction = rays_of(seed)
    hits = CompiledScene(scene_of([shape])).hits(rays_from(origin, direction))
    met = np.isfinite(hits.t)
    along = origin[met] + hits.t[met, None] * direction[met]
    # At a grazing hit the surface point nearest by scaling is further along by 1 / cosine.
    cosine = np.abs((hits.normal[met] * direction[met]).sum(axis=1))
    slack = 2e-14 / np.maximum(cosine, 1e-6)
    assert (np.abs(along - hits.point[met]).max(axis=1, initial=0.0) < slack).all()
    assert ((hits.normal[met] * direction[met]).sum(axis=1) <= 0.0).all()
    assert np.abs(np.linalg.norm(hits.normal[met], axis=1) - 1.0).max(initial=0.0) < 4e-16


@ALWAYS_THE_SAME
@given(solids(), st.integers(0, 2**32 - 1))
def test_a_ray_that_enters_a_solid_leaves_it(shape, seed: int) -> None:
    """Straight on from a hit from outside there is one more, from inside, and then none."""
    origin, direction = rays_of(seed)
    compiled = CompiledScene(scene_of([shape]))
    first = compiled.hits(rays_from(origin, direction))
    met = np.isfinite(first.t) & ~first.inside
    # Rays that only touch: their way through is rounding.
    met &= np.abs((first.normal * direction).sum(axis=1)) > 1e-6
    on = Rays(first.point, direction, first.object, ~first.inside, first.triangle).take(met)
    second = compiled.hits(on)
    assert np.isfinite(second.t).all()
    assert second.inside.all()
    away = Rays(second.point, on.direction, second.object, ~second.inside, second.triangle)
    assert np.isinf(compiled.nearest(away)[0]).all()


#: Its middle lies midway between two float64 numbers in y.
TIED = Cylinder(start=(0.0, 0.554058050284085, 2.0), end=(0.0, 1.4259419497159151, 2.0), radius=1.0)


@ALWAYS_THE_SAME
@given(solids(), st.integers(0, 2**32 - 1), st.integers(-60, 60))
@example(TIED, 0, -3)
def test_scaling_by_a_power_of_two_changes_last_bits_at_most(shape, seed, power) -> None:
    """Everything scales with the scene: hits and misses, and t but for what 50 digits of the scaled
    shape leave undecided, which of two float64 numbers a centre midway between them is, or the last
    bit of a rest. Then both are within two last bits, of the lengths involved, of the exact one."""
    scale = math.ldexp(1.0, power)
    origin, direction = rays_of(seed)
    plain = CompiledScene(scene_of([shape]))
    scaled = CompiledScene(scene_of([SceneObject("scaled", shape, 0, placed(scale))]))
    expected = plain.nearest(rays_from(origin, direction))[0] * scale
    found = scaled.nearest(rays_from(origin * scale, direction))[0]
    hit = np.isfinite(expected)
    assert (np.isfinite(found) == hit).all()
    lengths = expected[hit] + scale * np.abs(origin[hit]).max(axis=1)
    assert (np.abs(found[hit] - expected[hit]) <= 4 * np.spacing(lengths)).all()


@ALWAYS_THE_SAME
@given(solids(), solids(), st.integers(0, 2**32 - 1))
def test_the_nearest_of_two_is_the_nearer_one(one, other, seed: int) -> None:
    """A scene of two answers with the smaller of what each alone answers.

    Where faces lie in one place the lower object wins, later by a share of TIE at most.
    """
    rays = rays_from(*rays_of(seed))
    alone = [CompiledScene(scene_of([shape])).nearest(rays)[0] for shape in (one, other)]
    both = CompiledScene(scene_of([one, other])).nearest(rays)[0]
    nearer = np.minimum(*alone)
    assert (np.isinf(both) == np.isinf(nearer)).all()
    met = np.isfinite(nearer)
    assert (np.abs(both[met] - nearer[met]) <= TIE * nearer[met] + np.spacing(nearer[met])).all()


@ALWAYS_THE_SAME
@given(solids(), st.integers(0, 2**32 - 1), st.floats(0.1, 8.0))
def test_a_limit_only_cuts(shape, seed: int, limit: float) -> None:
    """Before t_max the same is met, beyond it there is nothing.

    1e-12: a ray with a limit asks whether something is in its way (shadow rays do), so its
    distance is not found again from its own hit point; grazing ones keep that many digits here.
    """
    rays = rays_from(*rays_of(seed))
    compiled = CompiledScene(scene_of([shape]))
    free = compiled.nearest(rays)[0]
    cut = compiled.nearest(rays, np.full(COUNT, limit))[0]
    met = free < limit
    assert (np.isfinite(cut) == met).all()
    assert np.abs(cut[met] - free[met]).max(initial=0.0) < 1e-12


@ALWAYS_THE_SAME
@given(solids(), st.integers(0, 2**32 - 1))
def test_all_crossings_begin_with_the_nearest(shape, seed: int) -> None:
    """crossings and nearest tell the same story, in order."""
    rays = rays_from(*rays_of(seed))
    compiled = CompiledScene(scene_of([shape]))
    start, t, _ = compiled.crossings(rays)
    nearest = compiled.nearest(rays)[0]
    for k in range(COUNT):
        listed = t[start[k] : start[k + 1]]
        assert (np.diff(listed) >= 0).all()
        assert (listed[0] if len(listed) else np.inf) == nearest[k]
