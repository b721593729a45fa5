"""A primitive's numbers, taken out of the table once for many rays."""

from __future__ import annotations

from raywalk.optics.compiled import inlined


@inlined
def centre_of(primitives, k):
    """Row k's centre, and what that lacks."""
    centre, rest = primitives.centre, primitives.centre_rest
    return centre[k, 0], centre[k, 1], centre[k, 2], rest[k, 0], rest[k, 1], rest[k, 2]


@inlined
def matrix_of(m, k):
    """The numbers of row k's (3, 3) matrix."""
    return (
        m[k, 0, 0], m[k, 0, 1], m[k, 0, 2], m[k, 1, 0], m[k, 1, 1], m[k, 1, 2], m[k, 2, 0],
        m[k, 2, 1], m[k, 2, 2],
    )  # fmt: skip


@inlined
def times(a, b, c, d, e, f, g, h, i, x, y, z):
    """The matrix of these rows times a vector."""
    return a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z
