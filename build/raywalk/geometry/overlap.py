"""Glass that overlaps other glass with neither inside the other: no order of media is right.

A ray's medium is the one it entered last. That is right for glass inside glass, and for
glass beside glass; where two bodies share a part, either could fill it, and an author
should know.
"""

from __future__ import annotations

import numpy as np

from raywalk.geometry.boxes import boxes_of, touching
from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.containment import winding_number
from raywalk.geometry.faces import PLANE
from raywalk.geometry.samples import level_over, which_cut, world_samples
from raywalk.scene.model import Scene

SAMPLES = 256  # points a surface: overlaps of a few per cent are found, slighter ones may not be
# Closer to a surface than this share of its body's size is on it: touching is not overlapping.
TOUCHING = 1e-6
MOST_PAIRS = 200_000  # that are looked at: nobody reads as many warnings


def overlap_warnings(scene: Scene, compiled: CompiledScene) -> list[str]:
    """A sentence for each pair of overlapping glass objects."""
    clear, rows = compiled.is_clear, compiled.primitives.row_of
    if not clear.any():
        return []
    boxes = boxes_of(compiled.primitives, compiled.meshes)
    pairs, _ = touching(compiled.primitives, boxes, clear, MOST_PAIRS)
    pairs = pairs[clear[pairs].all(axis=1)]
    plain = (rows[pairs] >= 0).all(axis=1)
    cut = np.zeros(len(pairs), bool)
    cut[plain] = which_cut(compiled.primitives, _on_sphere(SAMPLES), rows[pairs[plain]], TOUCHING)
    for k in np.flatnonzero(~plain):
        one, other = pairs[k].tolist()
        cut[k] = any(
            _is_cut(levels(compiled, to, surface_points(compiled, of)))
            for of, to in ((one, other), (other, one))
        )
    return [
        f'"{scene.objects[a].name}" and "{scene.objects[b].name}" are both clear and overlap, and '
        "neither lies inside the other: in the part they share, light is in the one it entered last"
        for a, b in pairs[cut].tolist()
    ]


def _is_cut(level: np.ndarray) -> bool:
    """Whether a surface lies partly inside and partly outside a body."""
    return bool((level < -TOUCHING).any() and (level > TOUCHING).any())


def surface_points(compiled: CompiledScene, k: int) -> np.ndarray:
    """(n, 3) points spread over a closed object's surface; none of an endless plane."""
    for mesh in compiled.meshes:
        if mesh.index == k:
            corners = mesh.corners.reshape(-1, 3)
            return np.asarray(mesh.centre + corners[:: max(1, len(corners) // SAMPLES)])
    table, row = compiled.primitives, compiled.primitives.row_of[k]
    if table.shape["code"][row] == PLANE:
        return np.empty((0, 3))
    return np.asarray(world_samples(table, row, SAMPLES)[0])


def levels(compiled: CompiledScene, k: int, points: np.ndarray) -> np.ndarray:
    """(n,) how far outside a closed object points are, about in shares of its size."""
    for mesh in compiled.meshes:
        if mesh.index == k:
            local = points - mesh.centre
            in_box = (local >= mesh.bvh.low[0]).all(axis=1) & (local <= mesh.bvh.high[0]).all(
                axis=1
            )
            turns = np.zeros(len(points))
            turns[in_box] = [winding_number(mesh.corners, point) for point in local[in_box]]
            return 0.5 - turns
    table, row = compiled.primitives, compiled.primitives.row_of[k]
    return np.array([level_over(table, row, x, y, z) for x, y, z in points.tolist()])


def _on_sphere(count: int) -> np.ndarray:
    """(n, 3) unit vectors, evenly spread: a spiral by the golden angle (Vogel, 1979)."""
    z = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    angle = np.arange(count) * np.pi * (3.0 - np.sqrt(5.0))
    ring = np.sqrt(1.0 - z * z)
    return np.column_stack([ring * np.cos(angle), ring * np.sin(angle), z])
