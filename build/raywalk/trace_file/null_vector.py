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


@kernel
def gradient_rule(point, normal):
    """(3 n, 9) equations normal x (M point + b) = 0 in M's xx, yy, zz, xy, xz, yz and b."""
    table = np.zeros((3 * point.shape[0], 9))
    for i in range(point.shape[0]):
        x, y, z = point[i, 0], point[i, 1], point[i, 2]
        for a in range(3):  # the cross product's component along axis a
            b, c = (a + 1) % 3, (a + 2) % 3
            for row, share in ((c, normal[i, b]), (b, -normal[i, c])):
                into = table[3 * i + a]
                into[6 + row] += share
                if row == 0:
                    into[0] += share * x
                    into[3] += share * y
                    into[4] += share * z
                elif row == 1:
                    into[1] += share * y
                    into[3] += share * x
                    into[5] += share * z
                else:
                    into[2] += share * z
                    into[4] += share * x
                    into[5] += share * y
    return table
