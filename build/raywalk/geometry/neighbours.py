"""Which bodies of glass can touch what: what a scene of glass apart from glass need not ask."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from raywalk.geometry.faces import PLANE
from raywalk.geometry.primitives import Primitives
from raywalk.scene.model import Scene

if TYPE_CHECKING:
    from raywalk.geometry.mesh_target import MeshTarget

# Boxes further apart than this share of their sizes and places do not touch: a million times
# the error of a hit point.
SLACK = 1e-9


def neighbours(primitives: Primitives, meshes: list[MeshTarget], clear: np.ndarray) -> np.ndarray:
    """(objects, objects) bool: the second is clear and may have a surface where the first has.

    clear: (objects,) bool. From boxes, so some that do not touch are neighbours too.
    """
    boxes = np.empty((len(clear), 2, 3))
    half = np.abs(primitives.to_world).sum(axis=2)
    boxes[primitives.object, 0] = primitives.centre - half
    boxes[primitives.object, 1] = primitives.centre + half
    for mesh in meshes:
        boxes[mesh.index] = mesh.centre + mesh.bvh.low[0], mesh.centre + mesh.bvh.high[0]
    slack = SLACK * np.abs(boxes).max(axis=(1, 2), initial=0.0)
    boxes[:, 0] -= slack[:, None]
    boxes[:, 1] += slack[:, None]
    met = np.asarray((boxes[:, None, 0] <= boxes[None, :, 1]).all(axis=2))
    met &= met.T
    is_plane = primitives.shape["code"] == PLANE
    for row in np.flatnonzero(is_plane):
        k = primitives.object[row]
        met[k] = _meets_plane(boxes, primitives.centre[row], primitives.to_local[row, 1])
        met[:, k] = met[k]
    both_planes = np.isin(
        np.arange(len(clear)), primitives.object[primitives.shape["code"] == PLANE]
    )
    met |= both_planes[:, None] & both_planes[None, :]
    np.fill_diagonal(met, False)
    return np.asarray(met & clear[None, :])


def outermost_first(scene: Scene, primitives: Primitives, meshes: list[MeshTarget]) -> np.ndarray:
    """(objects,) int ranks by volume, the largest 0: what lies in another is smaller.

    Of equals the lower object lies inside: as where surfaces tie it is the one that is met.
    """
    volume = np.zeros(len(scene.objects))
    for row, k in enumerate(primitives.object):
        scale = abs(float(np.linalg.det(primitives.to_world[row])))
        volume[k] = scale * scene.objects[k].shape.canonical.volume
    for mesh in meshes:
        a, b, c = mesh.corners.transpose(1, 0, 2)
        volume[mesh.index] = abs(float((a * np.cross(b, c)).sum())) / 6.0
    order = np.lexsort([-np.arange(len(volume)), -_rounded(volume)])
    return np.argsort(order)


def _rounded(volume: np.ndarray) -> np.ndarray:
    """Nine digits: equal bodies stay equal when they are made of other shapes, or turned."""
    with np.errstate(divide="ignore", invalid="ignore"):
        steps = 10.0 ** (np.floor(np.log10(volume)) - 8.0)
        return np.where((volume > 0) & (volume < np.inf), np.round(volume / steps) * steps, volume)


def _meets_plane(boxes: np.ndarray, point: np.ndarray, across: np.ndarray) -> np.ndarray:
    """(objects,) bool: whether a plane runs through a box. across: its normal, of any length."""
    middle, half = boxes.mean(axis=1), (boxes[:, 1] - boxes[:, 0]) / 2
    slack = SLACK * (np.abs(boxes).max(axis=(1, 2)) + np.abs(point).max())
    level = np.abs((middle - point) @ across)
    return np.asarray(level <= half @ np.abs(across) + slack * np.abs(across).sum())
