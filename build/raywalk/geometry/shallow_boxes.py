"""The top of a mesh's bounding-volume tree, to be looked at: boxes, and which rays enter them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.geometry.bvh import box_entry
from raywalk.geometry.mesh_target import MeshTarget
from raywalk.geometry.triangle import vector
from raywalk.optics.compiled import kernel

LEVELS = 6  # of boxes in boxes, at most 2^6 - 1 = 63: more would be a tangle of lines


class ShallowBoxes(NamedTuple):
    """A mesh's bounding sphere and its topmost boxes; parents stand before their children."""

    centre: np.ndarray  # (3,) of the sphere, world
    radius: float
    node: np.ndarray  # (boxes,) int64: rows of the mesh's Bvh
    parent: np.ndarray  # (boxes,) int64: place of the parent here, -1 for the first
    low: np.ndarray  # (boxes, 3) world
    high: np.ndarray  # (boxes, 3) world


def shallow_boxes(mesh: MeshTarget) -> ShallowBoxes:
    """Level by level from the root down; a leaf ends its branch."""
    node, parent, begin = [0], [-1], 0
    for _ in range(LEVELS - 1):
        end = len(node)
        for place in range(begin, end):
            if mesh.bvh.held[node[place]] == 0:
                first = node[place] + 1
                node += [first, int(mesh.bvh.skip[first])]
                parent += [place, place]
        begin = end
    low, high = mesh.bvh.low[node] + mesh.centre, mesh.bvh.high[node] + mesh.centre
    middle = (low[0] + high[0]) / 2
    used = mesh.triangles.vertices[np.unique(mesh.triangles.faces)] + mesh.centre
    radius = float(np.sqrt(((used - middle) ** 2).sum(axis=1).max()))
    return ShallowBoxes(middle, radius, np.array(node), np.array(parent), low, high)


def boxes_entered(
    mesh: MeshTarget, boxes: ShallowBoxes,
    origin: np.ndarray, direction: np.ndarray, t_max: np.ndarray,
) -> np.ndarray:  # fmt: skip
    """(n, boxes) bool: the boxes that rays from free space enter before t_max.

    A box is tested if its parent is entered, and the first one always: as `count_tests` counts.
    """
    return np.asarray(
        entered(
            mesh.bvh.low, mesh.bvh.high, boxes.node, boxes.parent,
            origin - mesh.centre, direction, t_max,
        )
    )  # fmt: skip


@kernel
def entered(low, high, node, parent, local, direction, t_max):
    """(n, boxes) bool. local: (n, 3) origins relative to the mesh's centre."""
    found = np.zeros((local.shape[0], node.shape[0]), np.bool_)
    for i in range(local.shape[0]):
        o, d = vector(local, i), vector(direction, i)
        for k in range(node.shape[0]):
            if parent[k] < 0 or found[i, parent[k]]:
                found[i, k] = box_entry(low, high, node[k], o, d, t_max[i]) < np.inf
    return found


def crosses_sphere(boxes: ShallowBoxes, origin: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """(n,) bool: rays with unit directions that cross the bounding sphere ahead of them."""
    offset = origin - boxes.centre
    along = (offset * direction).sum(axis=1)
    away_sq = (offset**2).sum(axis=1) - along**2
    reaches = np.sqrt(np.maximum(boxes.radius**2 - away_sq, 0.0)) - along > 0
    return np.asarray((away_sq <= boxes.radius**2) & reaches)
