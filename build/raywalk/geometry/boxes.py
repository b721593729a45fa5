"""Boxes round objects, and which of them touch: asked of all pairs, without looking at each."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from raywalk.geometry.faces import PLANE
from raywalk.geometry.primitives import Primitives
from raywalk.optics.compiled import kernel

if TYPE_CHECKING:
    from raywalk.geometry.mesh_target import MeshTarget

# Boxes further apart than this share of their sizes and places do not touch: a million times
# the error of a hit point.
SLACK = 1e-9


def boxes_of(primitives: Primitives, meshes: list[MeshTarget], slack: float = SLACK) -> np.ndarray:
    """(objects, 2, 3) the lowest and highest corner of each object's box, a little wider; endless
    ones of planes.

    slack: by how much, as a share of the coordinates' sizes.
    """
    boxes = np.empty((len(primitives.row_of), 2, 3))
    half = np.abs(primitives.to_world).sum(axis=2)
    half[primitives.shape["code"] == PLANE] = np.inf
    boxes[primitives.object, 0] = primitives.centre - half
    boxes[primitives.object, 1] = primitives.centre + half
    for mesh in meshes:
        boxes[mesh.index] = mesh.centre + mesh.bvh.low[0], mesh.centre + mesh.bvh.high[0]
    slacks = slack * np.abs(boxes).max(axis=(1, 2), initial=0.0, where=np.isfinite(boxes))
    boxes[:, 0] -= slacks[:, None]
    boxes[:, 1] += slacks[:, None]
    return boxes


def touching(
    primitives: Primitives, boxes: np.ndarray, asked: np.ndarray, most: int
) -> tuple[np.ndarray, bool]:
    """(m, 2) int32 pairs of objects, the lower one first and in order, whose boxes touch and of
    which one at least is asked for, and whether these are all: there are `most` else.

    asked: (objects,) bool. Of a plane it is the plane that touches a box, not its half-space.
    """
    is_endless = ~np.isfinite(boxes).all(axis=(1, 2))
    finite = np.flatnonzero(~is_endless)
    found, count = _pairs_with_planes(primitives, boxes, asked, is_endless, most)
    low, high = boxes[finite, 0], boxes[finite, 1]
    axis = _thinnest_axis(low, high)
    order = np.argsort(low[:, axis], kind="stable")
    one, other, is_all = sweep(
        low[order], high[order], asked[finite][order], axis, max(0, most - count)
    )
    found.append(np.column_stack([finite[order[one]], finite[order[other]]]))
    pairs = np.sort(np.concatenate(found).astype(np.int32), axis=1)
    return pairs[np.lexsort([pairs[:, 1], pairs[:, 0]])], bool(is_all and count <= most)


def _thinnest_axis(low: np.ndarray, high: np.ndarray) -> int:
    """Along which boxes overlap the fewest others: they are small beside the way they spread."""
    if not len(low):
        return 0
    spread = np.ptp(low, axis=0) + 1e-300
    return int(np.argmin((high - low).mean(axis=0) / spread))


@kernel
def sweep(low, high, asked, axis, most):
    """Pairs of touching boxes that are sorted by their lower ends along the axis: two (m,) int64,
    and whether none is left out."""
    room = min(most, 1024)
    one, other = np.empty(room, np.int64), np.empty(room, np.int64)
    filled = 0
    b, c = (axis + 1) % 3, (axis + 2) % 3
    for i in range(low.shape[0]):
        for j in range(i + 1, low.shape[0]):
            if low[j, axis] > high[i, axis]:
                break
            if low[j, b] > high[i, b] or low[i, b] > high[j, b]:
                continue
            if low[j, c] > high[i, c] or low[i, c] > high[j, c]:
                continue
            if not (asked[i] or asked[j]):
                continue
            if filled == most:
                return one[:filled], other[:filled], False
            if filled == room:
                room = min(most, 2 * room)
                one = np.concatenate((one, np.empty(room - filled, np.int64)))
                other = np.concatenate((other, np.empty(room - filled, np.int64)))
            one[filled], other[filled] = i, j
            filled += 1
    return one[:filled], other[:filled], True


def _pairs_with_planes(
    primitives: Primitives, boxes: np.ndarray, asked: np.ndarray, is_endless: np.ndarray, most: int
) -> tuple[list[np.ndarray], int]:
    """Pairs of which one is a plane, up to about as many as are wanted, and their number."""
    found: list[np.ndarray] = [np.empty((0, 2), np.int32)]
    count = 0
    for k in np.flatnonzero(is_endless):
        if count > most:
            break
        row = primitives.row_of[k]
        met = meets_plane(boxes, primitives.centre[row], primitives.to_local[row, 1])
        met |= is_endless & (np.arange(len(boxes)) > k)
        met &= asked | asked[k]
        others = np.flatnonzero(met)
        found.append(np.column_stack([np.full(len(others), k), others]))
        count += len(others)
    return found, count


def meets_plane(boxes: np.ndarray, point: np.ndarray, across: np.ndarray) -> np.ndarray:
    """(objects,) bool: whether a plane runs through a box; never through an endless one.

    across: its normal, of any length.
    """
    finite = np.isfinite(boxes).all(axis=(1, 2))
    boxes = np.where(finite[:, None, None], boxes, 0.0)
    middle, half = boxes.mean(axis=1), (boxes[:, 1] - boxes[:, 0]) / 2
    slack = SLACK * (np.abs(boxes).max(axis=(1, 2), initial=0.0) + np.abs(point).max())
    level = np.abs((middle - point) @ across)
    return finite & (level <= half @ np.abs(across) + slack * np.abs(across).sum())
