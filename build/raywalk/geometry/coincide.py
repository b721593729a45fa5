"""Surfaces that lie in one another: which of two is seen there is a rule, not a picture's business.

A surface is sampled, and the samples are asked whether they lie on another one that faces the same
way. What only touches, as a box that stands on a floor, faces it, and hides the place.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.faces import DISC, PLANE, TRIANGLE, TUBE, face_normal, is_near
from raywalk.geometry.solids import solid_interval
from raywalk.scene.model import Scene

SAMPLES = 400  # a surface: what two share by less than a few hundredths of both may be missed
# As a share of the coordinates' sizes: surfaces this close are one to a person, and to the tracer
# from a little further away.
CLOSE = 1e-9
PARALLEL = 1.0 - 1e-9  # cosine from which two surfaces face one way
MARGIN = 1.0 - 1e-6  # canonical coordinates beyond belong to an edge


class Samples(NamedTuple):
    """Points of one object's surface."""

    point: np.ndarray  # (n, 3) world
    normal: np.ndarray  # (n, 3) unit, outward
    is_open: bool  # seen from both sides


def coinciding(scene: Scene, compiled: CompiledScene) -> Iterator[tuple[int, int]]:
    """Pairs of objects that share a part of their surfaces, the one that is seen there first."""
    count = len(scene.objects)
    samples = [samples_of(compiled, k) for k in range(count)]
    boxes = _boxes(compiled, samples)
    for one in range(count):
        near = (boxes[one, 0] <= boxes[one + 1 :, 1]) & (boxes[one + 1 :, 0] <= boxes[one, 1])
        for other in one + 1 + np.flatnonzero(near.all(axis=1)):
            if shares(compiled, samples, one, int(other)):
                pair = sorted((one, int(other)), key=lambda k: int(compiled.rank[k]))
                yield pair[0], pair[1]


def shares(compiled: CompiledScene, samples: list[Samples], one: int, other: int) -> bool:
    """Whether a part of one's surface lies in the other's, the same way round."""
    rows = compiled.primitives.row_of
    shapes = compiled.primitives.shape["code"]
    if all(rows[k] >= 0 and shapes[rows[k]] == PLANE for k in (one, other)):
        return _is_one_plane(compiled, int(rows[one]), int(rows[other]))
    return _lies_in(compiled, samples, one, other) or _lies_in(compiled, samples, other, one)


def _lies_in(compiled: CompiledScene, samples: list[Samples], one: int, other: int) -> bool:
    point, normal, is_open = samples[one]
    if not len(point):
        return False
    on, facing = surface_at(compiled, other, point)
    cosine = (facing * normal).sum(axis=1)
    if is_open or samples[other].is_open:
        cosine = np.abs(cosine)
    return bool((on & (cosine > PARALLEL)).any())


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
    table, row = compiled.primitives, compiled.primitives.row_of[k]
    shape, matrix = table.shape[row], table.to_local[row]
    local = (point - table.centre[row]) @ matrix.T
    reach = np.abs(point).sum(axis=1) + np.abs(table.centre[row]).sum()
    bound = CLOSE * table.stretch[row] * np.maximum(reach, np.abs(table.to_world[row]).max())
    on, normal = np.zeros(len(point), bool), np.zeros((len(point), 3))
    for i, (x, y, z) in enumerate(local.tolist()):
        on[i] = is_near(shape, x, y, z, bound[i]) and _is_within(shape["code"], x, y, z)
        if on[i]:
            normal[i] = _canonical_normal(shape, x, y, z) @ matrix
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    return on, np.divide(normal, length, out=normal, where=length > 0)


def _is_within(code: int, x: float, y: float, z: float) -> bool:
    """Whether a point of an open surface is inside of its edges."""
    if code == DISC:
        return x * x + y * y < MARGIN
    if code == TRIANGLE:
        return min(x, y, 1.0 - x - y) > 1.0 - MARGIN
    return abs(z) < MARGIN if code == TUBE else True


def _canonical_normal(shape: np.ndarray, x: float, y: float, z: float) -> np.ndarray:
    code = shape["code"]
    if code == PLANE:
        return np.array([0.0, 1.0, 0.0])
    if code in (DISC, TRIANGLE):
        return np.array([0.0, 0.0, 1.0])
    return np.array(face_normal(shape, x, y, z))


def samples_of(compiled: CompiledScene, k: int) -> Samples:
    """Points of an object's surface, well inside its faces; none of an endless plane."""
    for mesh in compiled.meshes:
        if mesh.index == k:
            step = max(1, len(mesh.corners) // SAMPLES)
            a, b, c = mesh.corners[::step].transpose(1, 0, 2)
            # Nowhere special on the triangle: its middle may be another's edge.
            point = mesh.centre + 0.41 * a + 0.27 * b + 0.32 * c
            normal = np.cross(b - a, c - a)
            normal /= np.linalg.norm(normal, axis=1, keepdims=True)
            return Samples(point, normal, not mesh.triangles.closed)
    table, row = compiled.primitives, compiled.primitives.row_of[k]
    shape = table.shape[row]
    local = _canonical_points(shape)
    normal = np.array([_canonical_normal(shape, x, y, z) for x, y, z in local.tolist()])
    normal = normal.reshape(-1, 3) @ table.to_local[row]
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    point = table.centre[row] + local @ table.to_world[row].T
    return Samples(point, normal, shape["code"] in (DISC, TRIANGLE, TUBE))


def _canonical_points(shape: np.ndarray) -> np.ndarray:
    """(n, 3) canonical points, at irregular places (R2 sequence, Roberts 2018)."""
    steps = np.arange(1, SAMPLES + 1)
    u, v = (steps * 0.7548776662466927) % 1.0, (steps * 0.5698402909980532) % 1.0
    code = shape["code"]
    if code == PLANE:
        return np.empty((0, 3))
    if code == TRIANGLE:
        u, v = np.where(u + v > 1.0, 1.0 - u, u), np.where(u + v > 1.0, 1.0 - v, v)
        return np.column_stack([u, v, np.zeros(SAMPLES)])
    if code == DISC:
        radius, angle = np.sqrt(u), 2.0 * np.pi * v
        flat = [radius * np.cos(angle), radius * np.sin(angle)]
        return np.column_stack([*flat, np.zeros(SAMPLES)])
    if code == TUBE:
        z, angle = 2.0 * u - 1.0, 2.0 * np.pi * v
        width = shape["tip"] + 0.5 * (1.0 - shape["tip"]) * (1.0 + z)
        return np.column_stack([width * np.cos(angle), width * np.sin(angle), z])
    z, angle = 2.0 * u - 1.0, 2.0 * np.pi * v
    ring = np.sqrt(1.0 - z * z)
    away = np.column_stack([ring * np.cos(angle), ring * np.sin(angle), z])
    reach = [solid_interval(shape, 0.0, 0.0, 0.0, *way)[1] for way in away.tolist()]
    return np.asarray(np.array(reach)[:, None] * away)


def _boxes(compiled: CompiledScene, samples: list[Samples]) -> np.ndarray:
    """(objects, 2, 3) boxes round each object, a little larger; endless ones round planes."""
    boxes = np.empty((len(samples), 2, 3))
    boxes[:, 0], boxes[:, 1] = -np.inf, np.inf
    table = compiled.primitives
    finite = table.shape["code"] != PLANE
    half = np.abs(table.to_world[finite]).sum(axis=2)
    boxes[table.object[finite], 0] = table.centre[finite] - half
    boxes[table.object[finite], 1] = table.centre[finite] + half
    for mesh in compiled.meshes:
        boxes[mesh.index] = mesh.centre + mesh.bvh.low[0], mesh.centre + mesh.bvh.high[0]
    slack = 2.0 * CLOSE * np.abs(boxes).max(axis=(1, 2), initial=0.0, where=np.isfinite(boxes))
    boxes[:, 0] -= slack[:, None]
    boxes[:, 1] += slack[:, None]
    return boxes
