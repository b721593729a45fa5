"""Many linear equations in few unknowns, brought down to as many rows as there are unknowns.

In a kernel, as a library's sums may depend on how many cores it finds, and so would the bytes.
"""

from __future__ import annotations

import numpy as np

from raywalk.optics.compiled import kernel


@kernel
def triangular(table):
    """(c, c) R of table (n, c) = Q R, by Householder reflections; 0 below where n < c.

    Q R has the singular values and the right singular vectors of R, and the least squares
    solutions too. Golub and Van Loan, Matrix Computations, 4th ed., sec. 5.2.
    """
    work, (rows, columns) = table.copy(), table.shape
    for k in range(min(rows, columns)):
        square = 0.0
        for i in range(k, rows):
            square += work[i, k] * work[i, k]
        if square == 0.0:
            continue
        length = np.sqrt(square) if work[k, k] < 0.0 else -np.sqrt(square)
        head = work[k, k] - length  # of the reflection; the rest of it stays below the diagonal
        for j in range(k + 1, columns):
            along = head * work[k, j]
            for i in range(k + 1, rows):
                along += work[i, k] * work[i, j]
            along /= length * head
            work[k, j] += along * head
            for i in range(k + 1, rows):
                work[i, j] += along * work[i, k]
        work[k, k] = length
    small = np.zeros((columns, columns))
    for i in range(min(rows, columns)):
        small[i, i:] = work[i, i:]
    return small


def gradient_rule(point: np.ndarray, normal: np.ndarray) -> np.ndarray:
    """(3 n, 9) equations normal x (M point + b) = 0 in M's xx, yy, zz, xy, xz, yz and b."""
    x, y, z, one = *point.T, np.ones(len(point))
    gradient = np.zeros((3, len(point), 9))  # M point + b, component by component
    for row, places, parts in (
        (0, [0, 3, 4, 6], (x, y, z, one)), (1, [1, 3, 5, 7], (y, x, z, one)),
        (2, [2, 4, 5, 8], (z, x, y, one)),
    ):  # fmt: skip
        gradient[row][:, places] = np.stack(parts, axis=1)
    n = normal.T[:, :, None]
    across = [n[b] * gradient[c] - n[c] * gradient[b] for b, c in ((1, 2), (2, 0), (0, 1))]
    return np.stack(across, axis=1).reshape(-1, 9) + 0.0  # no zero is negative
