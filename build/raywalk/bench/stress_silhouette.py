"""Spheres from afar and past their silhouettes: where b^2 - 4ac loses its digits."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from raywalk.bench.cases import Case, none_of
from raywalk.bench.embree32 import sphere_t
from raywalk.bench.families import around, directions, perpendicular
from raywalk.bench.made_scenes import nearest_t, scene_of
from raywalk.bench.twofold import error_of, nearest_root, sphere_roots
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.shapes import Sphere

UNIT = Sphere((0.0, 0.0, 0.0), 1.0)
# Distance: bound of the error of t, about one step of float64 there. It holds for the median;
# the dot product o.d alone may round by three steps, so the largest is held to 8.
FROM = {1e3: 1e-13, 1e5: 1e-11, 1e7: 2e-9}
MOST_STEPS = 8.0
TANGENT = 15  # decimals of the distance from the silhouette
# Rotated rays are rounded: their distance from the axis is only known to this.
ROUNDED = 2e-15


def cases(count: int, seed: int) -> Iterator[Case]:
    """Far away, then tangent."""
    for place, (distance, bound) in enumerate(FROM.items()):
        yield from seen_from(distance, bound, count, seed + place)
    yield tangent_along_axes(seed)
    for distance in (3.0, 1e5):
        yield tangent_anywhere(distance, count, seed)


def seen_from(distance: float, bound: float, count: int, seed: int) -> Iterator[Case]:
    """Error of t, median and largest; grazing rays (closer than 1e-3 of the radius) left out."""
    rng = np.random.default_rng(seed)
    origin, direction = around(rng, count, distance, aim=0.99)
    t = nearest_t([UNIT], origin, direction)
    near, far, depth = sphere_roots(origin, direction, np.zeros(3), 1.0)
    true = nearest_root(near, far)
    # A rounded direction moves the ray's foot by eps times the distance: it must not graze.
    kept = depth > max(1e-3, 4e-16 * distance)
    missed = int((kept & ~np.isfinite(t)).sum())
    errors = error_of(t, true)[kept] if not missed else np.full(1, np.inf)
    single = sphere_t(origin, direction, np.zeros(3), 1.0)[kept]
    error32 = np.abs(np.where(np.isfinite(single), single, 0.0) - true.hi[kept])
    rays = int(kept.sum())
    yield Case(
        "far away", f"unit sphere from {distance:g}", "error of t, median",
        bound, float(np.median(errors)), rays, seed, float(np.median(error32)), "same formula",
    )  # fmt: skip
    yield Case(
        "far away", f"unit sphere from {distance:g}, worst", "error of t in steps of float64, max",
        MOST_STEPS, float(errors.max() / np.spacing(distance)), rays, seed,
        float(error32.max() / np.spacing(distance)), "same formula",
    )  # fmt: skip


def tangent_along_axes(seed: int) -> Case:
    """Rays at 1 -+ 10^-k from an axis, along axes, so that their distance is exact."""
    wrong, rays = 0, 0
    compiled = CompiledScene(scene_of([UNIT]))
    worst = TANGENT + 1
    for k in range(1, TANGENT + 1):
        for axis in range(3):
            for sign in (-1.0, 1.0):
                origin, direction = np.zeros((2, 3)), np.zeros((2, 3))
                direction[:, axis], origin[:, axis] = -sign, 3.0 * sign
                origin[:, (axis + 1) % 3] = [1.0 - 10.0**-k, 1.0 + 10.0**-k]
                t = compiled.nearest(rays_from(origin, direction))[0]
                mistakes = int(not np.isfinite(t[0])) + int(np.isfinite(t[1]))
                wrong, rays = wrong + mistakes, rays + 2
                worst = min(worst, k) if mistakes else worst
    return Case(
        "tangent", f"at 1 -+ 10^-k, k = 1 to {TANGENT}", "wrong hit or miss, rays",
        0.0, float(wrong), rays, seed, note=f"right to k = {worst - 1}",
    )  # fmt: skip


def tangent_anywhere(distance: float, count: int, seed: int) -> Case:
    """The same from all sides, against the truth of the rays as rounded."""
    rng = np.random.default_rng(seed)
    direction = directions(rng, count)
    k = rng.uniform(1.0, TANGENT, count)
    off = 1.0 + rng.choice([-1.0, 1.0], count) * 10.0**-k
    origin = off[:, None] * perpendicular(rng, direction) - distance * direction
    t = nearest_t([UNIT], origin, direction)
    _, _, depth = sphere_roots(origin, direction, np.zeros(3), 1.0)
    clear = np.abs(depth) > 2.0 * ROUNDED
    wrong = np.isfinite(t) != (depth >= 0)
    wrong32 = np.isfinite(sphere_t(origin, direction, np.zeros(3), 1.0)) != (depth >= 0)
    name = f"from {distance:g}, all sides, closer than {ROUNDED:g} left out"
    return none_of(
        clear, wrong, seed, "tangent", name, "wrong hit or miss", wrong32, "same formula"
    )
