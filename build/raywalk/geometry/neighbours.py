"""Which bodies of glass can touch what: what a scene of glass apart from glass need not ask."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from raywalk.geometry.boxes import boxes_of, touching
from raywalk.geometry.primitives import Primitives
from raywalk.scene.model import Scene

if TYPE_CHECKING:
    from raywalk.geometry.mesh_target import MeshTarget


class Neighbours(NamedTuple):
    """The clear objects that may have a surface where an object has, of each object in order."""

    start: np.ndarray  # (objects + 1,) int64: those of object k are object[start[k]:start[k + 1]]
    object: np.ndarray  # (n,) int32

    def any(self) -> bool:
        return bool(len(self.object))

    def beside(self, k: int) -> np.ndarray:
        """(objects,) bool: those that object k is a neighbour of."""
        beside = np.zeros(len(self.start) - 1, bool)
        beside[np.searchsorted(self.start, np.flatnonzero(self.object == k), "right") - 1] = True
        return beside


def neighbours(primitives: Primitives, meshes: list[MeshTarget], clear: np.ndarray) -> Neighbours:
    """From boxes, so some that do not touch are neighbours too.

    clear: (objects,) bool.
    """
    pairs = np.empty((0, 2), np.int32)
    if clear.any():
        every = len(clear) * len(clear)
        pairs, _ = touching(primitives, boxes_of(primitives, meshes), clear, every)
    both = np.concatenate([pairs, pairs[:, ::-1]])
    both = both[clear[both[:, 1]]]
    both = both[np.lexsort([both[:, 1], both[:, 0]])]
    start = np.searchsorted(both[:, 0], np.arange(len(clear) + 1))
    return Neighbours(start, np.ascontiguousarray(both[:, 1]))


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
