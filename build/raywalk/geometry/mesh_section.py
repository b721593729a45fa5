"""Where a plane cuts a mesh: the lines in which triangles meet it, walked along as chains."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from raywalk.optics.compiled import kernel

if TYPE_CHECKING:
    from raywalk.geometry.cross_section import Cut
    from raywalk.geometry.mesh_file import Triangles


def mesh_chains(triangles: Triangles, cut: Cut) -> Iterator[tuple[np.ndarray, bool]]:
    """Points (k, 2) of each chain in the cut's coordinates, and whether it is closed."""
    corners, faces = triangles.vertices, triangles.faces
    height = corners @ cut.normal - cut.normal @ (cut.origin - triangles.centre)
    # An edge is one number: its lower vertex times their count plus the higher one.
    crossed = crossed_edges(height, faces)
    if not len(crossed):
        return
    ends, place = np.unique(crossed, return_inverse=True)
    low, high = np.divmod(ends, len(height))
    share = height[low] / (height[low] - height[high])
    points = corners[low] + share[:, None] * (corners[high] - corners[low]) + triangles.centre
    flat = cut.flat(points)
    walked, start = chains(place.reshape(-1, 2), len(ends))
    for begin, end in zip(start[:-1].tolist(), start[1:].tolist(), strict=True):
        is_closed = bool(walked[begin] == walked[end - 1]) and end - begin > 3
        yield flat[walked[begin : end - 1 if is_closed else end]], is_closed


@kernel
def crossed_edges(height, faces):
    """(2 k,) int64: both edges of each triangle that the plane at height 0 crosses.

    height: (v,) of the vertices; one at 0 counts as above.
    """
    count, filled = height.shape[0], 0
    found = np.empty(2 * faces.shape[0], np.int64)
    for f in range(faces.shape[0]):
        for k in range(3):
            a, b = faces[f, k], faces[f, (k + 1) % 3]
            if (height[a] >= 0.0) != (height[b] >= 0.0):
                found[filled] = np.int64(min(a, b)) * count + max(a, b)
                filled += 1
    return found[:filled]


@kernel
def chains(links, count):
    """Walks along links (k, 2) between `count` points, along each once: the points passed, one
    chain after the other, and where each begins. Chains that have an end come first."""
    first = np.zeros(count + 1, np.int64)
    for k in range(links.shape[0]):
        first[links[k, 0] + 1] += 1
        first[links[k, 1] + 1] += 1
    first = np.cumsum(first)
    beside, held = np.empty(2 * links.shape[0], np.int64), np.zeros(count, np.int64)
    for k in range(links.shape[0]):
        for side in range(2):
            a = links[k, side]
            beside[first[a] + held[a]] = links[k, 1 - side]
            held[a] += 1
    is_end = held == 1
    passed, filled = np.empty(links.shape[0] + count, np.int64), 0
    start, made = np.zeros(count + links.shape[0] + 1, np.int64), 0
    for asked in (True, False):
        for begin in range(count):
            if held[begin] == 0 or (asked and not is_end[begin]):
                continue
            at = begin
            passed[filled] = at
            filled += 1
            while held[at] > 0:
                held[at] -= 1
                onward = beside[first[at] + held[at]]
                forget(beside, first[onward], held, onward, at)
                at = onward
                passed[filled] = at
                filled += 1
            made += 1
            start[made] = filled
    return passed[:filled], start[: made + 1]


@kernel
def forget(beside, first, held, point, other):
    """Takes one `other` out of what lies beside a point; the rest keeps its order."""
    k = first
    while beside[k] != other:
        k += 1
    held[point] -= 1
    while k < first + held[point]:
        beside[k] = beside[k + 1]
        k += 1
