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
