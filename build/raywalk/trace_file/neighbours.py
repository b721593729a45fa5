"""Which rays lie beside a ray in the picture and came there with the same history.

The neighbours of a camera ray are those of its pixel; those of a reflected ray are
the reflected rays of its parent's neighbours, and so on. All come earlier in the
file, so both sides of the codec know them when they reach the ray.
"""

from __future__ import annotations

import numpy as np

NONE = -1


def follow(step: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """step[rows], with -1 leading to -1."""
    if not len(step):
        return np.full(rows.shape, NONE)
    return np.where(rows >= 0, step[rows], NONE)


def in_raster(n: int) -> np.ndarray:
    """(4, n * n): left, up, up-left, up-right of n x n camera rays, -1 where there is none."""
    row, column = np.divmod(np.arange(n * n), n)
    here = np.arange(n * n)
    return np.stack([
        np.where(column > 0, here - 1, NONE),
        np.where(row > 0, here - n, NONE),
        np.where((row > 0) & (column > 0), here - n - 1, NONE),
        np.where((row > 0) & (column < n - 1), here - n + 1, NONE),
    ])  # fmt: skip


def six(sides: np.ndarray) -> np.ndarray:
    """(6, m): the four and left of left, up of up."""
    left, up = sides[0], sides[1]
    return np.concatenate([sides, [follow(left, left), follow(up, up)]])


def alike(rows: np.ndarray, group: np.ndarray) -> np.ndarray:
    """Neighbours outside of a ray's group replaced by -1."""
    return np.where((rows >= 0) & (group[rows] == group), rows, NONE)


def last_alike(kind: np.ndarray) -> np.ndarray:
    """(m,) the last row before each one of the same kind, -1 if it is the first."""
    order = np.argsort(kind, kind="stable")
    before = np.full(len(kind), NONE)
    same = kind[order[1:]] == kind[order[:-1]]
    before[order[1:][same]] = order[:-1][same]
    return before
