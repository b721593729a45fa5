"""Rays that leave a surface: they never meet it where they stand, and always find a way out.

The law is pbrt's Reintersect: take a hit, send a ray off it, and the surface must not be hit
again at once. Here it holds without any epsilon, at every scale and place.
"""

from __future__ import annotations

import itertools
import math

import mpmath  # type: ignore[import-untyped]
import numpy as np
import pytest
from mpmath import mpf
from tests.geometry.by_hand import SHAPES, SOLIDS, moved, random_affine, scene_of, unit

from raywalk.geometry.compiled import CompiledScene, Hits, Rays, rays_from
from raywalk.optics.scatter import mirror_directions
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Plane, Sphere

EPS = np.finfo(float).eps
RAYS = 2000
PLACES = [(s, 0.0) for s in (1e-6, 1e-3, 1.0, 1e3, 1e6)] + [(1.0, 1e4), (1.0, 1e6), (1.0, 1e7)]


def hit_from_around(
    compiled: CompiledScene, rng: np.random.Generator, scale: float, middle: np.ndarray
) -> tuple[Rays, Hits]:
    """Hits of rays from all sides, and from inside, of a shape of about this size."""
    away = np.where(np.arange(RAYS) % 3 == 0, 0.2, 4.0)[:, None]
    origin = middle + scale * away * unit(rng.normal(size=(RAYS, 3)))
    target = middle + scale * 0.6 * rng.normal(size=(RAYS, 3))
    rays = rays_from(origin, unit(target - origin))
    hits = compiled.hits(rays)
    met = hits.object >= 0
    return rays.take(met), Hits(*(column[met] for column in hits))


def leaving(hits: Hits, direction: np.ndarray, across: bool) -> Rays:
    """Rays from hits: on the side that was hit, or across the surface."""
    return Rays(hits.point, direction, hits.object, hits.inside ^ across, hits.triangle)


def to_one_side(rng: np.random.Generator, normal: np.ndarray, flattest: float) -> np.ndarray:
    """Random unit directions on the normals' side, from steep to a grazing angle."""
    flat = unit(np.cross(normal, rng.normal(size=normal.shape)))
    height = 10.0 ** rng.uniform(math.log10(flattest), 0.0, size=(len(normal), 1))
    return unit(flat + height * normal)


@pytest.mark.parametrize(("scale", "offset"), PLACES, ids="scale {:g}".format)
@pytest.mark.parametrize("kind", SHAPES)
def test_a_ray_never_hits_again_what_it_leaves_outwards(
    rng: np.random.Generator, kind: str, scale: float, offset: float
) -> None:
    """2000 rays off the side that was hit, down to grazing 1e-12, from every shape, at every
    scale and place: a convex shape is never met again from outside, a flat one from no side."""
    middle = offset * np.array([1.0, -0.7, 0.4])
    shape = moved(SHAPES[kind], scale, middle)
    compiled = CompiledScene(scene_of([SceneObject(kind, shape, 0)]))
    _, hits = hit_from_around(compiled, rng, scale, middle)
    assert len(hits.t) > 300
    out = leaving(hits, to_one_side(rng, hits.normal, 1e-12), across=False)
    again = compiled.nearest(out)[1] >= 0
    if kind in SOLIDS or kind.startswith("open"):
        again &= ~hits.inside  # inside, they have to meet the far wall
    assert not again.any()


@pytest.mark.parametrize("transformed", [False, True], ids=["as it is", "transformed"])
@pytest.mark.parametrize("kind", SOLIDS)
def test_a_ray_into_a_solid_always_comes_out(
    rng: np.random.Generator, kind: str, transformed: bool
) -> None:
    """2000 rays inwards, down to grazing 1e-12, each meet the far wall, from inside."""
    matrix = random_affine(rng) if transformed else np.eye(4)
    compiled = CompiledScene(scene_of([SceneObject(kind, SHAPES[kind], 0, matrix)]))
    rays, hits = hit_from_around(compiled, rng, 1.0, matrix[:3, 3])
    rays, hits = rays.take(~hits.inside), Hits(*(column[~hits.inside] for column in hits))
    inwards = leaving(hits, to_one_side(rng, -hits.normal, 1e-12), across=True)
    out = compiled.hits(inwards)
    assert (out.object == 0).all()
    # A chord of 1e-12 is shorter than the roundings of its ends: then the side is not known.
    assert out.inside[out.t > 1e-6].all()


@pytest.mark.parametrize("kind", ["sphere", "ellipsoid"])
def test_a_grazing_chord_has_its_true_length(rng: np.random.Generator, kind: str) -> None:
    """In a sphere a ray at angle a under the surface comes out after 2 r sin(a), however flat:
    to a relative 1e-6 down to a = 1e-9, as 16 roundings of the start's height allow."""
    compiled = CompiledScene(scene_of([Sphere((0.3, -0.2, 0.5), 1.3)]))
    _, hits = hit_from_around(compiled, rng, 1.0, np.zeros(3))
    hits = Hits(*(column[~hits.inside] for column in hits))
    flat = unit(np.cross(hits.normal, rng.normal(size=hits.normal.shape)))
    for k in range(1, 10):
        angle = 10.0**-k
        direction = unit(math.cos(angle) * flat - math.sin(angle) * hits.normal)
        t = compiled.nearest(leaving(hits, direction, across=True))[0]
        np.testing.assert_allclose(t, 2 * 1.3 * math.sin(angle), rtol=1e-15 / angle + 1e-14)


@pytest.mark.parametrize("seed", range(4), ids="seed {}".format)
def test_nothing_shades_itself(seed: int) -> None:
    """Shadow acne: in random scenes at random scale and place, every free point on a lone convex
    shape that faces a light is reached by it."""
    rng = np.random.default_rng(seed)
    for _ in range(12):
        scale, offset = 10.0 ** rng.uniform(-6, 6), 10.0 ** rng.uniform(-2, 7)
        if offset * EPS > 1e-5 * scale:
            offset = scale * 1e3  # a shape as small as the roundings of its place is none
        middle = offset * unit(rng.normal(size=3))
        kind = str(rng.choice(list(SHAPES)))
        compiled = CompiledScene(scene_of([moved(SHAPES[kind], scale, middle)]))
        _, hits = hit_from_around(compiled, rng, scale, middle)
        hits = Hits(*(column[~hits.inside] for column in hits))
        light = middle + scale * 5 * unit(rng.normal(size=3))
        way = light - hits.point
        reach = np.linalg.norm(way, axis=1)
        facing = (way * hits.normal).sum(axis=1) > 0
        blocked = compiled.nearest(leaving(hits, unit(way), False), reach)[1] >= 0
        assert not (blocked & facing).any()


@pytest.mark.parametrize(
    ("bounces", "bound"), [(10, 8e-15), (50, 3e-13), (100, 1e-12), (1000, 1e-10)]
)
def test_a_ray_stays_in_a_mirrored_sphere(bounces: int, bound: float) -> None:
    """A ray from the surface at angle a to the normal turns by pi - 2 a each bounce, in one
    plane: after n bounces it stands where that says, within the stress matrix's bounds. Errors grow
    as n^2 with the angle's own, so single angles may be 3 times worse than the median."""
    compiled = CompiledScene(scene_of([Sphere((0.0, 0.0, 0.0), 1.0)]))
    errors = []
    for angle in np.linspace(0.1, 1.4, 15):
        slope = -math.cos(angle), math.sin(angle), 0.0
        rays = Rays(
            np.array([[1.0, 0.0, 0.0]]), np.array([slope]),
            np.zeros(1, np.int32), np.ones(1, bool), np.full(1, -1, np.int32),
        )  # fmt: skip
        for _ in range(bounces):
            hits = compiled.hits(rays)
            assert hits.object[0] == 0
            assert hits.inside[0]
            onward = mirror_directions(rays.direction, hits.normal, hits.normal)
            rays = leaving(hits, onward, across=False)
        turned = bounces * (mpmath.pi - 2 * mpmath.atan2(mpf(slope[1]), -mpf(slope[0])))
        x, y, _ = rays.origin[0]
        errors.append(max(abs(mpf(x) - mpmath.cos(turned)), abs(mpf(y) - mpmath.sin(turned))))
    assert np.median(errors) < bound
    assert max(errors) < 3 * bound


@pytest.mark.parametrize(("bounces", "bound"), [(100, 3e-15), (1000, 1e-13)])
def test_a_ray_climbs_between_parallel_mirrors(bounces: int, bound: float) -> None:
    """Mirrors at x = 0 and x = 1, slope 1 / 4: after n bounces y = n / 4, a binary fraction.
    Within the stress matrix's bounds, relative to the height."""
    compiled = CompiledScene(scene_of([Plane((0, 0, 0), (1, 0, 0)), Plane((1, 0, 0), (-1, 0, 0))]))
    rays = Rays(
        np.zeros((1, 3)), unit(np.array([[1.0, 0.25, 0.0]])),
        np.zeros(1, np.int32), np.zeros(1, bool), np.full(1, -1, np.int32),
    )  # fmt: skip
    for n in range(bounces):
        hits = compiled.hits(rays)
        assert hits.object[0] == (n + 1) % 2
        rays = leaving(hits, mirror_directions(rays.direction, hits.normal, hits.normal), False)
    assert abs(rays.origin[0, 1] / (bounces / 4) - 1) < bound


@pytest.mark.parametrize("k", range(1, 5))
def test_rays_pass_between_touching_spheres_as_they_should(
    rng: np.random.Generator, k: int
) -> None:
    """Two unit spheres that touch at the origin; a ray through x = 0 at height h runs freely, one
    that leaves the left sphere next to the contact towards the right one meets the right one."""
    compiled = CompiledScene(scene_of([Sphere((-1, 0, 0), 1.0), Sphere((1, 0, 0), 1.0)]))
    h = 10.0**-k
    turn = rng.uniform(0, 2 * np.pi, size=500)
    around = np.stack([np.zeros(500), np.cos(turn), np.sin(turn)], axis=1)
    across = np.cross(around, [1.0, 0.0, 0.0])
    free = compiled.hits(rays_from(h * around - 3 * across, across))
    assert (free.object == -1).all()
    left = h * around - [math.sin(h) ** 2 / (1 + math.cos(h)), 0, 0]  # on the left sphere
    left[:, 1:] = math.sin(h) * around[:, 1:]
    rays = Rays(
        left, np.tile([1.0, 0.0, 0.0], (500, 1)),
        np.zeros(500, np.int32), np.zeros(500, bool), np.full(500, -1, np.int32),
    )  # fmt: skip
    t, met, _, _ = compiled.nearest(rays)
    assert (met == 1).all()
    # The gap at distance s = sin(h) from the axis is 2 (1 - sqrt(1 - s^2)).
    gap = 2 * math.sin(h) ** 2 / (1 + math.cos(h))
    np.testing.assert_allclose(t, gap, rtol=0, atol=4e-16)


def test_a_ray_at_the_very_contact_goes_through_the_other_sphere() -> None:
    """Two spheres touch at the origin: from there, away from the left one, the right one is met
    on its far side only, after its diameter: the contact itself is not hit again."""
    compiled = CompiledScene(scene_of([Sphere((-1, 0, 0), 1.0), Sphere((1, 0, 0), 1.0)]))
    rays = Rays(
        np.zeros((1, 3)), np.array([[1.0, 0.0, 0.0]]),
        np.zeros(1, np.int32), np.zeros(1, bool), np.full(1, -1, np.int32),
    )  # fmt: skip
    hits = compiled.hits(rays)
    assert (hits.object[0], hits.t[0], hits.inside[0]) == (1, 2.0, True)


@pytest.mark.parametrize("thickness", [1e-4, 1e-6, 1e-8])
def test_the_walls_of_a_thin_shell_keep_their_order(
    rng: np.random.Generator, thickness: float
) -> None:
    """A ray through a hollow sphere meets outer, inner, inner, outer wall, to 1e-8 thin."""
    compiled = CompiledScene(scene_of([Sphere((0, 0, 0), 1.0 - thickness), Sphere((0, 0, 0), 1.0)]))
    origin = 5 * unit(rng.normal(size=(2000, 3)))
    rays = rays_from(origin, unit(0.3 * rng.normal(size=(2000, 3)) - origin))
    start, _, met = compiled.crossings(rays)
    order = [tuple(met[a:b]) for a, b in itertools.pairwise(start)]
    assert set(order) <= {(1, 0, 0, 1), (1, 1), ()}
    assert order.count((1, 0, 0, 1)) > 1800
    first = compiled.hits(rays)
    through = np.flatnonzero([o == (1, 0, 0, 1) for o in order])
    hits = Hits(*(column[through] for column in first))
    inner = compiled.nearest(leaving(hits, rays.direction[through], across=True))
    assert (inner[1] == 0).all()
