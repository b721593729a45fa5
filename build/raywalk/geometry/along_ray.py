"""Points along a ray as seen from a shape, exact but for their own last digit.

A point o + t d seen from a centre c is small where the ray passes the shape, however far
away it starts; computed as it stands, it would keep the rounding of the way. Each
product and sum is carried together with its error instead (Knuth, The Art of Computer Programming,
vol. 2, sec. 4.2.2; of a product one fused operation gives it), and only the result is rounded.
"""

from __future__ import annotations

from raywalk.optics.compiled import kernel
from raywalk.optics.fused import fused


@kernel
def product_error(a, b, product):
    """a b - product exactly, product being a b rounded."""
    return fused(a, b, -product)


@kernel
def sum_error(a, b, total):
    """a + b - total exactly, total being a + b rounded."""
    b_part = total - a
    return (a - (total - b_part)) + (b - b_part)


@kernel
def along(o, d, t, c, rest):
    """One coordinate of o + t d - (c + rest), rounded once.

    rest: what the float64 centre c lacks.
    """
    start, way = o - c, t * d
    point = start + way
    error = sum_error(o, -c, start) + product_error(t, d, way) + sum_error(start, way, point)
    return point + (error - rest)


@kernel
def point_along(ox, oy, oz, dx, dy, dz, t, cx, cy, cz, x_rest, y_rest, z_rest):
    """The point o + t d as seen from the centre c + rest, each coordinate rounded once."""
    return (
        along(ox, dx, t, cx, x_rest),
        along(oy, dy, t, cy, y_rest),
        along(oz, dz, t, cz, z_rest),
    )


@kernel
def sharp_product(matrix, rest, k, x, y, z):
    """Row k of (n, 3, 3) matrices and their rests times a vector, rounded once: for matrices
    that cancel."""
    return (
        sharp_row(matrix, rest, k, 0, x, y, z),
        sharp_row(matrix, rest, k, 1, x, y, z),
        sharp_row(matrix, rest, k, 2, x, y, z),
    )


@kernel
def sharp_row(matrix, rest, k, r, x, y, z):
    """One coordinate of `sharp_product`."""
    a, b, c = matrix[k, r, 0] * x, matrix[k, r, 1] * y, matrix[k, r, 2] * z
    first = a + b
    total = first + c
    error = product_error(matrix[k, r, 0], x, a) + product_error(matrix[k, r, 1], y, b)
    error += product_error(matrix[k, r, 2], z, c)
    error += sum_error(a, b, first) + sum_error(first, c, total)
    error += rest[k, r, 0] * x + rest[k, r, 1] * y + rest[k, r, 2] * z
    return total + error
