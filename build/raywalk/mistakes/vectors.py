"""Vectors as columns: (3, n) arrays, so that a formula for one ray is the formula for all.

`origin + t * direction` is as a book writes it: t (n,) is spread over x, y and z.
"""

from __future__ import annotations

import numpy as np


def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(n,) scalar products of vectors (3, n), or of one vector (3,) with itself or another."""
    total = a[0] * b[0]
    total += a[1] * b[1]  # in place: each new array costs as much as its arithmetic
    total += a[2] * b[2]
    return np.asarray(total)


def length(a: np.ndarray) -> np.ndarray:
    """(n,) lengths of vectors (3, n)."""
    return np.asarray(np.sqrt(dot(a, a)))


def unit(a: np.ndarray) -> np.ndarray:
    """(3, n) the vectors, each made one long. A vector of length 0 has no direction: NaN."""
    return np.asarray(a / length(a))


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(3,) vector product, right-handed."""
    return np.array(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )


def turned(matrix: np.ndarray, a: np.ndarray) -> np.ndarray:
    """(3, n) a (3, 3) matrix times vectors (3, n), summed in the order x, y, z on any machine."""
    total = matrix[:, :1] * a[0]
    total += matrix[:, 1:2] * a[1]
    total += matrix[:, 2:] * a[2]
    return np.asarray(total)


def column(vector: np.ndarray | tuple[float, ...]) -> np.ndarray:
    """(3, 1) one vector that goes with many."""
    return np.asarray(vector).reshape(3, 1)
