"""On which side of an edge a ray passes, exactly: so that all who share an edge agree.

A ray o + t d passes the edge from p to q on the side that d . ((p - o) x (q - o)) has for its
sign. Where float64 cannot tell that sign, the sum is carried as an unrounded one (Shewchuk,
"Adaptive precision floating-point arithmetic and fast robust geometric predicates", Discrete &
Computational Geometry 18, 1997). Corners are a float64 and what it leaves over of the exact
place, so objects of any kind whose corners are equal leave nothing open between them.
"""

from __future__ import annotations

import numpy as np

from raywalk.geometry.along_ray import product_error, sum_error
from raywalk.optics.compiled import kernel, lean

# Terms of a corner seen from the origin: their difference, its rounding, what the corner lacks.
SEEN = 3
# Six products of two such sums and a direction's component, each of them four terms.
TERMS = 6 * SEEN * SEEN * 4
# What the sum with its first-order errors may be off by, as a share of its terms' sizes: those
# errors are summed in float64, some 20 roundings of 2^-53 times 2^-53, ten times over.
DOUBLED = 2.5e-30


@lean
def edge_side(o, d, p, p_rest, q, q_rest):
    """d . ((p - o) x (q - o)), its sign exact, its size to a few roundings.

    All are three numbers each, of a size whose cube float64 can hold; p_rest and q_rest are what
    the float64 corners lack.
    """
    px, pxl = seen(p[0], p_rest[0], o[0])
    py, pyl = seen(p[1], p_rest[1], o[1])
    pz, pzl = seen(p[2], p_rest[2], o[2])
    qx, qxl = seen(q[0], q_rest[0], o[0])
    qy, qyl = seen(q[1], q_rest[1], o[1])
    qz, qzl = seen(q[2], q_rest[2], o[2])
    x, x_error, x_size = across(py, pyl, pz, pzl, qy, qyl, qz, qzl, d[0])
    y, y_error, y_size = across(pz, pzl, px, pxl, qz, qzl, qx, qxl, d[1])
    z, z_error, z_size = across(px, pxl, py, pyl, qx, qxl, qy, qyl, d[2])
    first = x + y
    total = first + z
    error = sum_error(x, y, first) + sum_error(first, z, total) + (x_error + y_error + z_error)
    total += error
    if abs(total) > DOUBLED * (x_size + y_size + z_size):
        return total
    return summed(o, d, p, p_rest, q, q_rest)


@lean
def seen(p, rest, o):
    """p + rest - o as a float64 and what that lacks."""
    away = p - o
    return away, sum_error(p, -o, away) + rest


@lean
def across(a, al, b, bl, c, cl, e, el, by):
    """by (a e - b c), what its rounding lost, and the size of its terms: one component of a cross
    product, of numbers that lack al, bl, cl and el."""
    one, other = a * e, b * c
    turn = one - other
    error = product_error(a, e, one) - product_error(b, c, other) + sum_error(one, -other, turn)
    error += (a * el + al * e) - (b * cl + bl * c)
    value = by * turn
    size = abs(by) * (abs(one) + abs(other))
    return value, product_error(by, turn, value) + by * error, size


@kernel
def summed(o, d, p, p_rest, q, q_rest):
    """The same as a sum of float64 products that keeps every digit."""
    one, other = np.empty((3, SEEN)), np.empty((3, SEEN))
    for k in range(3):
        one[k, 0], other[k, 0] = p[k] - o[k], q[k] - o[k]
        one[k, 1] = sum_error(p[k], -o[k], one[k, 0])
        other[k, 1] = sum_error(q[k], -o[k], other[k, 0])
        one[k, 2], other[k, 2] = p_rest[k], q_rest[k]
    terms, filled = np.empty(TERMS), 0
    for k in range(3):
        m, n = (k + 1) % 3, (k + 2) % 3
        for i in range(SEEN):
            for j in range(SEEN):
                filled = add_product(terms, filled, d[k], one[m, i], other[n, j])
                filled = add_product(terms, filled, -d[k], one[n, i], other[m, j])
    total = 0.0
    for k in range(filled):  # from the smallest on
        total += terms[k]
    return total


@lean
def add_product(terms, filled, a, b, c):
    """Adds a b c to a sum in place; returns how many terms it has now."""
    if a == 0.0 or b == 0.0 or c == 0.0:
        return filled
    high = b * c
    low = product_error(b, c, high)
    for part in (high, low):
        product = a * part
        filled = add_term(terms, filled, product_error(a, part, product))
        filled = add_term(terms, filled, product)
    return filled


@lean
def add_term(terms, filled, term):
    """Shewchuk's Grow-Expansion without zeros: terms that do not overlap, the largest last, so that
    the last has the sum's sign."""
    kept = 0
    for k in range(filled):
        total = term + terms[k]
        error = sum_error(term, terms[k], total)
        if error != 0.0:
            terms[kept] = error
            kept += 1
        term = total
    if term != 0.0:
        terms[kept] = term
        kept += 1
    return kept
