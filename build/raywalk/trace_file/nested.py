"""The rays of finer grids inside the tiles of a coarser one: they are there already, as pixel
centres of grids nest. Their mean is what a tile looks like with so many rays."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np

from raywalk.trace.tree import level_pixels

Json = dict[str, Any]


def nested_counts(n: int, resolutions: tuple[int, ...]) -> list[int]:
    """How many rays across a tile there can be: 1, and 3, 5 ... of the finer grids."""
    return [each // n for each in sorted(resolutions) if each % n == 0 and (each // n) % 2]


def nested_samples(picture: np.ndarray, n: int, resolutions: tuple[int, ...]) -> Json:
    """{"n", "across": [1, 3, ...], "samples": [base64 of k n x k n x 3 bytes, one for each],
    "means": [base64 of n x n x 3, likewise]}. picture: (size, size, 3) uint8."""
    across = nested_counts(n, resolutions)
    grids = [grid_of(picture, n * k) for k in across]
    means = [means_of(grid, n) for grid in grids]
    return {
        "n": n, "across": across,
        "samples": [_packed(grid) for grid in grids], "means": [_packed(mean) for mean in means],
    }  # fmt: skip


def grid_of(picture: np.ndarray, n: int) -> np.ndarray:
    """(n, n, 3) the pixels that an n x n grid's rays are."""
    return picture.reshape(-1, 3)[level_pixels(picture.shape[0], n)].reshape(n, n, 3)


def means_of(grid: np.ndarray, n: int) -> np.ndarray:
    """(n, n, 3) uint8, each the mean of the rays in a tile, rounded as colours are."""
    k = grid.shape[0] // n
    tiles = grid.reshape(n, k, n, k, 3).astype(float)
    return np.floor(tiles.mean(axis=(1, 3)) + 0.5).astype(np.uint8)


def _packed(colours: np.ndarray) -> str:
    return base64.b64encode(np.ascontiguousarray(colours).tobytes()).decode("ascii")
