"""Where a mesh's vertices stand in the world, to twice float64's digits.

Queries use coordinates round the mesh's centre. Whom it shares an edge with has others: only
the world's are the same for all.
"""

from __future__ import annotations

import numpy as np

from raywalk.geometry.along_ray import sum_error

SPLITTER = 134217729.0  # 2^27 + 1, cuts a float64 into halves whose products are exact


def in_world(
    linear: np.ndarray, offset: np.ndarray, vertices: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """linear @ vertex + offset of each vertex, (v, 3) float64, and what that leaves over, (v, 3).

    linear: (3, 3); offset: (3,); vertices: (v, 3). Sums carry their errors (Ogita, Rump and
    Oishi, "Accurate sum and dot product", SIAM J. Sci. Comput. 26(6), 2005); where nothing is
    rounded the rest is exactly 0.
    """
    world, rest = np.empty_like(vertices), np.empty_like(vertices)
    # As numpy has them: compiling them for arrays would take longer.
    total_of = getattr(sum_error, "py_func", sum_error)
    for row in range(3):
        total, error = np.full(len(vertices), offset[row]), np.zeros(len(vertices))
        for k in range(3):
            product = linear[row, k] * vertices[:, k]
            error += _product_error(linear[row, k], vertices[:, k], product)
            before, total = total, total + product
            error += total_of(before, product, total)
        world[:, row] = total + error
        rest[:, row] = error - (world[:, row] - total)
    return world, rest


def _product_error(a: np.ndarray, b: np.ndarray, product: np.ndarray) -> np.ndarray:
    """a b - product exactly, product being a b rounded. numpy has no fused operation: Dekker, "A
    floating-point technique for extending the available precision", Numer. Math. 18, 1971."""
    cut = SPLITTER * a
    ah = cut - (cut - a)
    al = a - ah
    cut = SPLITTER * b
    bh = cut - (cut - b)
    bl = b - bh
    return np.asarray(((ah * bh - product) + ah * bl + al * bh) + al * bl)


def off_world(
    vertices: np.ndarray, centre: np.ndarray, world: np.ndarray, rest: np.ndarray
) -> float:
    """How far vertices round a centre are off the world's at most, along an axis."""
    total_of = getattr(sum_error, "py_func", sum_error)
    away = world - centre
    exact = away + (total_of(world, -centre, away) + rest)
    # The difference's own rounding is at most one of the largest vertex.
    return float(np.abs(exact - vertices).max() + 2.3e-16 * np.abs(vertices).max())
