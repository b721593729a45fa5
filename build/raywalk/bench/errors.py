"""Errors of hits against the truth: distance, point, normal, and what was hit at all."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from mpmath import mpf  # type: ignore[import-untyped]

from raywalk.bench.contenders import Met
from raywalk.bench.made_scenes import scene_of
from raywalk.bench.truth import at, cross, inner, minus, nearest_hit, triangle_meets, unit, vector
from raywalk.scene.shapes import Sphere

OTHER = 1e-3  # relative: further off than this, another surface was hit, or tessellation ended
LOOSE = 1e-6  # candidates of a triangle's truth: by barycentric coordinates, in float64


@dataclass(frozen=True)
class Truth:
    """Of n rays, to 50 digits."""

    t: list  # None for a miss
    point: list
    normal: list  # unit


@dataclass(frozen=True)
class Errors:
    """Over the rays that hit by truth and by the way; wrong counts the others."""

    median: float  # |t - truth| / truth
    largest: float
    point: float  # median distance of the point from the true one
    normal: float  # median angle between the normals, radians
    wrong: int  # hit instead of miss, miss instead of hit, or another surface


def sphere_truth(spheres: Sequence[Sphere], origin: np.ndarray, direction: np.ndarray) -> Truth:
    """By mpmath, all spheres for every ray."""
    scene = scene_of(spheres)
    truth = Truth([], [], [])
    for o, d in zip(origin, direction, strict=True):
        hit = nearest_hit(scene, o, d)
        truth.t.append(hit and hit.t)
        truth.point.append(hit and at(vector(o), vector(d), hit.t))
        truth.normal.append(hit and unit(hit.normal))
    return truth


def mesh_truth(corners: np.ndarray, origin: np.ndarray, direction: np.ndarray) -> Truth:
    """In rationals, over the triangles that float64 cannot exclude."""
    truth = Truth([], [], [])
    a = corners[:, 0]
    one, other = corners[:, 1] - a, corners[:, 2] - a
    for o, d in zip(origin, direction, strict=True):
        best, who = None, -1
        for k in candidates(a, one, other, o, d):
            t = triangle_meets(corners[k], o, d)
            if t is not None and t > 0 and (best is None or t < best):
                best, who = t, int(k)
        exact = None if best is None else mpf(best.numerator) / mpf(best.denominator)
        truth.t.append(exact)
        truth.point.append(None if best is None else at(vector(o), vector(d), exact))
        truth.normal.append(None if best is None else facet_normal(corners[who]))
    return truth


def candidates(
    a: np.ndarray, one: np.ndarray, other: np.ndarray, o: np.ndarray, d: np.ndarray
) -> np.ndarray:
    """Triangles that a ray hits or misses by little (Moeller and Trumbore, JGT 2(1), 1997)."""
    across = np.cross(d, other)
    volume = (one * across).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        u = ((o - a) * across).sum(axis=1) / volume
        v = (np.cross(o - a, one) @ d) / volume
        outside = (u < -LOOSE) | (v < -LOOSE) | (u + v > 1 + LOOSE)
    return np.flatnonzero(~outside)


def facet_normal(corners: np.ndarray) -> tuple:
    a, b, c = (vector(corner) for corner in corners)
    return unit(cross(minus(b, a), minus(c, a)))


def errors_of(met: Met, truth: Truth, either_way: bool = False) -> Errors:
    """Met holds the truth's rays, in its order.

    either_way: rays aimed at vertices may pass a silhouette's on either side; where another
    surface was met, the errors leave them out.
    """
    relative, points, normals, wrong = [], [], [], 0
    for k, true in enumerate(truth.t):
        t = float(met.t[k])
        if (true is None) != bool(np.isinf(t)):
            wrong += 1
        elif true is not None:
            error = float(abs(true - t) / true)
            wrong += error > OTHER
            if either_way and error > OTHER:
                continue
            relative.append(error)
            points.append(distance(truth.point[k], met.point[k]))
            normals.append(angle(truth.normal[k], met.normal[k]))
    return Errors(
        float(np.median(relative)), max(relative), float(np.median(points)),
        float(np.median(normals)), wrong,
    )  # fmt: skip


def distance(true: tuple, got: np.ndarray) -> float:
    off = minus(true, tuple(mpf(float(x)) for x in got))
    return float(inner(off, off) ** 0.5)


def angle(true: tuple, got: np.ndarray) -> float:
    """Small angle between a unit normal and one of any length and sign, by its sine."""
    other = unit(tuple(mpf(float(x)) for x in got))
    if inner(true, other) < 0:
        other = minus((0, 0, 0), other)
    off = minus(true, other)
    return float(inner(off, off) ** 0.5)
