"""Corners that are one: equal ones, and at open edges those nearer than a file can tell."""

from __future__ import annotations

import numpy as np

from raywalk.models.edges import edges_of, joined, open_edges

# Corners nearer than this share of the model's size are one: more than the last digit of float32,
# less than anything that is meant to be there.
WELD = 1e-6
# A model counts at most as this many times as large as the middle half of its corners: a stray
# corner far out must not weld all others.
STRAY = 100.0
# Steps of a float32 number that a corner may be off its other copies.
STEPS = 2.0


def weld_equal(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Joins vertices of exactly equal position, as formats without sharing (STL) need."""
    order, is_first = sorted_rows(vertices)
    index = np.empty(len(vertices), np.int32)  # a file of 2 GB has fewer
    index[order] = np.cumsum(is_first, dtype=np.int32) - 1
    return vertices[order[is_first]], index[faces]


def sorted_rows(rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """An order (n,) of rows (n, k) by their first column, then the next; and which (n,) bool of
    them, so sorted, differ from the one before. `np.unique` of rows needs thrice the memory."""
    order = np.lexsort(rows.T[::-1]).astype(np.int32)
    is_first = np.zeros(len(rows), bool)
    is_first[:1] = True
    for column in rows.T:
        values = column[order]
        is_first[1:] |= values[1:] != values[:-1]
    return order, is_first


def weld_cracks(
    vertices: np.ndarray, faces: np.ndarray, weld: float | None, grain: float
) -> tuple[np.ndarray, int]:
    """Faces (f, 3) in which corners of open edges are joined that are nearly equal, and how many
    corners went.

    A closed surface is left as it is, however fine. weld: share of the size, WELD if not given;
    then corners are joined too that the file's numbers (grain: their step) cannot tell apart.
    """
    ends = np.unique(open_edges(edges_of(faces), faces))
    if not len(ends) or weld == 0:
        return faces, 0
    points = vertices[ends]
    reach = (WELD if weld is None else weld) * size_of(vertices)
    if weld is None:
        reach = max(reach, STEPS * grain * float(np.abs(points).max()))
    one, other = near_pairs(points, reach)
    if not len(one):
        return faces, 0
    root, _, _ = joined(len(ends), one, other, np.zeros(len(one), bool))
    stands_for = np.arange(len(vertices), dtype=np.int32)
    stands_for[ends] = ends[root]
    return stands_for[faces], int((root != np.arange(len(ends))).sum())


def size_of(vertices: np.ndarray) -> float:
    """Largest side of the box round a model, but for single corners far out."""
    if not len(vertices):
        return 0.0
    side = float((vertices.max(axis=0) - vertices.min(axis=0)).max())
    low, high = np.percentile(vertices, [25, 75], axis=0)
    most = STRAY * float((high - low).max())
    return min(side, most) if most > 0 else side


def near_pairs(points: np.ndarray, reach: float) -> tuple[np.ndarray, np.ndarray]:
    """Pairs (p,), (p,) of points (n, 3) at most this far apart.

    Sorted along a direction in which no wall of a model lies, near ones are close together.
    """
    across = np.array([0.6134, 0.5421, 0.5743])
    place = points @ (across / np.linalg.norm(across))
    order = np.argsort(place, kind="stable")
    place, sorted_points = place[order], points[order]
    ones, others = [np.zeros(0, np.int64)], [np.zeros(0, np.int64)]
    here = np.arange(len(points))
    for step in range(1, len(points)):
        here = here[here + step < len(points)]
        here = here[place[here + step] - place[here] <= reach]
        if not len(here):
            break
        apart = sorted_points[here + step] - sorted_points[here]
        near = here[(apart**2).sum(axis=1) <= reach * reach]
        ones.append(order[near])
        others.append(order[near + step])
    return np.concatenate(ones), np.concatenate(others)
