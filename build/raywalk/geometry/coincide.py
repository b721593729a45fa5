"""Surfaces that lie in one another: which of two is seen there is a rule, not a picture's business.

A surface is sampled, and the samples are asked whether they lie on another one that faces the same
way. What only touches, as a box that stands on a floor, faces it, and hides the place. Only those
are asked whose boxes touch, and that have faces in one plane or are curved alike.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from raywalk.geometry.boxes import boxes_of, touching
from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.faces import DISC, PLANE, TRIANGLE, TUBE
from raywalk.geometry.samples import (
    CLOSE,
    PARALLEL,
    SAMPLES,
    faces_of,
    middles,
    points_on,
    rows_under,
    which_share,
    world_samples,
)

# Pairs whose boxes touch, and of these, pairs that are looked at point by point: of what lies in
# heaps there are more, and nobody reads as many warnings.
MOST_PAIRS, MOST_ASKED = 2_000_000, 50_000


class Samples(NamedTuple):
    """Points of one object's surface."""

    point: np.ndarray  # (n, 3) world
    normal: np.ndarray  # (n, 3) unit, outward
    is_open: bool  # seen from both sides


def coinciding(compiled: CompiledScene) -> tuple[list[tuple[int, int]], bool]:
    """Pairs of objects that share a part of their surfaces, the one that is seen there first, and
    whether all were looked at."""
    table, rows = compiled.primitives, compiled.primitives.row_of
    boxes = boxes_of(table, compiled.meshes, 2.0 * CLOSE)
    everything = np.ones(len(boxes), bool)
    pairs, is_all = touching(table, boxes, everything, MOST_PAIRS)
    plain = (rows[pairs] >= 0).all(axis=1)
    sizes = np.abs(boxes).max(axis=(1, 2), initial=0.0, where=np.isfinite(boxes))[table.object]
    sizes = np.maximum(sizes, np.abs(table.centre).max(axis=1, initial=0.0))
    shared, seen = which_share(table, *faces_of(table), sizes, rows[pairs[plain]], MOST_ASKED)
    found = pairs[plain][shared]
    code = table.shape["code"]
    planes = pairs[plain][(code[rows[pairs[plain]]] == PLANE).all(axis=1)]
    found = [*map(tuple, found), *(pair for pair in planes if _is_one_plane(compiled, *rows[pair]))]
    found += [pair for pair in pairs[~plain] if _shares_mesh(compiled, *pair)]
    in_order = [
        tuple(sorted((int(one), int(other)), key=lambda k: int(compiled.rank[k])))
        for one, other in sorted(map(tuple, found))
    ]
    return [(one, other) for one, other in in_order], is_all and seen == plain.sum()


def _shares_mesh(compiled: CompiledScene, one: int, other: int) -> bool:
    """The same of two objects of which one at least is a mesh."""
    return _lies_in(compiled, one, other) or _lies_in(compiled, other, one)


def _lies_in(compiled: CompiledScene, one: int, other: int) -> bool:
    point, normal, is_open = samples_of(compiled, one)
    if not len(point):
        return False
    on, facing = surface_at(compiled, other, point)
    cosine = (facing * normal).sum(axis=1)
    if is_open or _is_open(compiled, other):
        cosine = np.abs(cosine)
    return bool((on & (cosine > PARALLEL)).any())


def _is_open(compiled: CompiledScene, k: int) -> bool:
    for mesh in compiled.meshes:
        if mesh.index == k:
            return not mesh.triangles.closed
    code = compiled.primitives.shape["code"][compiled.primitives.row_of[k]]
    return code in (DISC, TRIANGLE, TUBE)


def _is_one_plane(compiled: CompiledScene, one: int, other: int) -> bool:
    """Whether two endless planes are one, whichever way they face."""
    table = compiled.primitives
    a, b = table.to_local[one, 1], table.to_local[other, 1]
    cosine = abs(a @ b) / np.sqrt((a @ a) * (b @ b))
    away = abs(a @ (table.centre[other] - table.centre[one])) / np.sqrt(a @ a)
    size = np.abs(table.centre[[one, other]]).max(initial=1e-300)
    return bool(cosine > PARALLEL and away <= CLOSE * size)


def surface_at(compiled: CompiledScene, k: int, point: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Which of (n, 3) points lie on object k's surface, but not at its edges: (n,) bool, and its
    outward unit normal there (n, 3)."""
    for mesh in compiled.meshes:
        if mesh.index == k:
            # Only here: a scene without a mesh runs none of it.
            from raywalk.geometry.mesh_points import closest_on_mesh

            return closest_on_mesh(mesh, point, CLOSE)
    on, normal = points_on(compiled.primitives, compiled.primitives.row_of[k], point)
    return on, normal


def samples_of(compiled: CompiledScene, k: int, count: int = SAMPLES) -> Samples:
    """Points of an object's surface, well inside its faces; none of an endless plane."""
    for mesh in compiled.meshes:
        if mesh.index == k:
            step = max(1, len(mesh.corners) // count)
            a, b, c = mesh.corners[::step].transpose(1, 0, 2)
            # Nowhere special on the triangle: its middle may be another's edge.
            point = mesh.centre + 0.41 * a + 0.27 * b + 0.32 * c
            normal = np.cross(b - a, c - a)
            normal /= np.linalg.norm(normal, axis=1, keepdims=True)
            return Samples(point, normal, not mesh.triangles.closed)
    table, row = compiled.primitives, compiled.primitives.row_of[k]
    if table.shape["code"][row] == PLANE:
        return Samples(np.empty((0, 3)), np.empty((0, 3)), False)
    point, normal = world_samples(table, row, count)
    return Samples(point, normal, _is_open(compiled, k))


def middles_of(compiled: CompiledScene) -> np.ndarray:
    """(objects, 3) a point in the middle of each, the mean of some of its surface's; NaN of
    planes."""
    table = compiled.primitives
    out = np.full((len(table.row_of), 3), np.nan)
    out[table.object] = middles(table, SAMPLES // 10)
    out[table.object[table.shape["code"] == PLANE]] = np.nan
    for mesh in compiled.meshes:
        out[mesh.index] = samples_of(compiled, mesh.index).point.mean(axis=0)
    return out


def objects_at(compiled: CompiledScene, point: np.ndarray) -> Iterator[int]:
    """Objects on whose surface a point (3,) lies, in order."""
    table = compiled.primitives
    met = table.object[rows_under(table, *map(float, point))].tolist()
    for mesh in compiled.meshes:
        on, _ = surface_at(compiled, mesh.index, point[None])
        met += [mesh.index] if on[0] else []
    yield from sorted(met)
