"""Rims that two share, of discs, cylinders and cones: the same verdict from both.

A line that crosses a rim's plane within the rim enters the endless cylinder or cone before, and
leaves it behind; one that crosses beside the rim does both before, or both behind. So on which side
of its end a tube is met, and whether a disc is, follow from one sign, which is worked out from the
same numbers for all who have the rim, to 30 digits.
"""

from __future__ import annotations

import math

from raywalk.geometry.along_ray import product_error, sum_error
from raywalk.geometry.faces import CYLINDER, DISC, TUBE, goes_in, height, is_near
from raywalk.geometry.seams import ROUNDINGS
from raywalk.geometry.solids import chord_exit, side_interval
from raywalk.optics.compiled import kernel, lean

LOW, HIGH = 0, 4  # where the rims at z = -1 (of a disc: 0) and z = 1 stand in a row of corners
# A rim's centre, then the rows that make a place seen from it canonical: the rim is the unit circle
# in z = 0. All zeros: a cone's tip, which has none.
CENTRE, FRAME = 0, 1
# Products of sums of two float64 each are off by some 2^-100 of their terms; nearer than this to a
# rim is on it.
DOUBLED = 1e-29
AT_ONCE = 1e-300  # as in roots.py


@kernel
def is_rim_unsure(shape, x, y, z, dx, dy, dz, size, drift, bound):
    """Whether rounding may decide on which side of its own rims a line passes.

    x, y, z and dx, dy, dz: canonical; size, drift, bound: as in `is_unsure`.
    """
    if shape.code == DISC:
        starts_on_it = bound > 0.0 and abs(z) <= bound
        return not starts_on_it and passes_rim(0.0, 1.0, x, y, z, dx, dy, dz, size, drift)
    if shape.code == CYLINDER and bound > 0.0 and abs(height(shape, x, y, z)) <= 2.0 * bound:
        return False  # closed: what leaves it needs no end
    off = size + bound / ROUNDINGS
    return passes_rim(1.0, 1.0, x, y, z, dx, dy, dz, off, drift) or (
        shape.tip > 0.0 and passes_rim(-1.0, shape.tip, x, y, z, dx, dy, dz, off, drift)
    )


@kernel
def passes_rim(end, width, x, y, z, dx, dy, dz, size, drift):
    """Whether a line passes a circle about the z axis by no more than rounding."""
    off, least = 2.0 * ROUNDINGS * (1.0 + size), ROUNDINGS * drift
    if abs(dz) <= least:  # along the plane
        across = dx * dx + dy * dy
        way = (abs(x * dx + y * dy) / math.sqrt(across) + 1.0 + width) / math.sqrt(across)
        return abs(end - z) <= off + 2.0 * least * way
    t = (end - z) / dz
    u, v = x + t * dx, y + t * dy
    off = (off + 2.0 * least * abs(t)) * (abs(dx) + abs(dy) + abs(dz))
    return not abs(math.sqrt(u * u + v * v) - width) * abs(dz) > off


@kernel
def rim_pair(shape, corner, rest, k, x, y, z, dx, dy, dz, shift, own, inner, bound, o, d):
    """Both roots t > 0 (else inf) of row k, the nearer first, its ends decided by its rims.

    x to dz: canonical, from where t is `shift`; own to bound: as in `roots`; o, d: world.
    """
    if shape.code == TUBE and not own and bound > 0.0 and is_near(shape, x, y, z, bound):
        own, inner = True, goes_in(shape, x, y, z, dx, dy, dz, bound)
    if own and not inner:
        return math.inf, math.inf
    low = at_rim(corner, rest, k, LOW, o, d)
    if shape.code == DISC:
        return (low[1] if low[0] and low[1] > 0.0 else math.inf), math.inf
    high = at_rim(corner, rest, k, HIGH, o, d)
    if own:
        near, far = 0.0, max(AT_ONCE, chord_exit(shape, x, y, z, dx, dy, dz))
    else:
        near, far = side_interval(shape, x, y, z, dx, dy, dz)
        near, far = shift + near, shift + far
    if not near <= far:  # as flat as rounding, or not at all
        near = far = low[1] if low[0] else (high[1] if high[0] else math.inf)
    first, last = math.inf, -math.inf
    for is_far in (False, True):
        t = far if is_far else near
        if (is_far or not own) and 0.0 < t < math.inf and is_between(low, high, is_far, near, far):
            first, last = min(first, t), max(last, t)
    if shape.code == CYLINDER:
        for cap in (low, high):
            if cap[0] and cap[1] > 0.0:
                first, last = min(first, cap[1]), max(last, cap[1])
    return first, (last if last > first else math.inf)


@lean
def is_between(low, high, is_far, near, far):
    """Whether the nearer or farther root of a side lies between the ends."""
    return not is_above(low, is_far, near, far, -1.0) and not is_above(high, is_far, near, far, 1.0)


@lean
def is_above(rim, is_far, near, far, side):
    """Whether a root lies beyond the plane of a rim; side: -1 if "beyond" is down."""
    within, t, rise, level = rim
    if rise == 0.0:
        return side * level > 0.0
    # Beside the rim, the plane is crossed before both roots or behind both.
    is_behind = is_far if within else (far == math.inf or 0.5 * (near + far) > t)
    return is_behind == (side * rise > 0.0)


@lean
def at_rim(corner, rest, k, at, o, d):
    """Where a line crosses the plane of a rim: whether within the rim, which is part of it; t; how
    fast it rises there; and how high o is above it. A cone's tip is crossed nowhere."""
    x, xl = placed(corner, rest, k, at, 0, o)
    y, yl = placed(corner, rest, k, at, 1, o)
    z, zl = placed(corner, rest, k, at, 2, o)
    dx, dxl = turned(corner, rest, k, at + FRAME, d[0], 0.0, d[1], 0.0, d[2], 0.0)
    dy, dyl = turned(corner, rest, k, at + FRAME + 1, d[0], 0.0, d[1], 0.0, d[2], 0.0)
    dz, dzl = turned(corner, rest, k, at + FRAME + 2, d[0], 0.0, d[1], 0.0, d[2], 0.0)
    if dz == 0.0:
        return False, math.inf, 0.0, z
    # By a power of two, which rounds nothing: squares must not leave float64's range.
    by = math.ldexp(1.0, -math.frexp(max(abs(dx), max(abs(dy), abs(dz))))[1])
    dx, dxl, dy, dyl, dz, dzl = by * dx, by * dxl, by * dy, by * dyl, by * dz, by * dzl
    a, al, a_size = difference(x, xl, dz, dzl, z, zl, dx, dxl)
    b, bl, b_size = difference(y, yl, dz, dzl, z, zl, dy, dyl)
    a_size, b_size = abs(a) * a_size, abs(b) * b_size
    a, al = times(a, al, a, al)
    b, bl = times(b, bl, b, bl)
    square, square_rest = plus(a, al, b, bl)
    one, one_rest = times(dz, dzl, dz, dzl)
    outside, _ = plus(square, square_rest, -one, -one_rest)
    within = outside <= DOUBLED * (a_size + b_size + one)
    return within, -z * (by / dz), dz, z


@lean
def placed(corner, rest, k, at, row, o):
    """One canonical coordinate of a place, as a float64 and what that lacks."""
    x, y, z = o[0] - corner[k, at, 0], o[1] - corner[k, at, 1], o[2] - corner[k, at, 2]
    return turned(
        corner, rest, k, at + FRAME + row,
        x, sum_error(o[0], -corner[k, at, 0], x) - rest[k, at, 0],
        y, sum_error(o[1], -corner[k, at, 1], y) - rest[k, at, 1],
        z, sum_error(o[2], -corner[k, at, 2], z) - rest[k, at, 2],
    )  # fmt: skip


@lean
def turned(corner, rest, k, row, x, xl, y, yl, z, zl):
    """Product of a row of corners with a vector, as a float64 and what that lacks."""
    one, one_rest = times(corner[k, row, 0], rest[k, row, 0], x, xl)
    two, two_rest = times(corner[k, row, 1], rest[k, row, 1], y, yl)
    three, three_rest = times(corner[k, row, 2], rest[k, row, 2], z, zl)
    both, both_rest = plus(one, one_rest, two, two_rest)
    return plus(both, both_rest, three, three_rest)


@lean
def difference(a, al, b, bl, c, cl, e, el):
    """a b - c e, what that lacks, and the size of its terms."""
    one, one_rest = times(a, al, b, bl)
    other, other_rest = times(c, cl, e, el)
    value, lacks = plus(one, one_rest, -other, -other_rest)
    return value, lacks, abs(one) + abs(other)


@lean
def times(a, al, b, bl):
    """Product of two numbers that lack al and bl, and what it lacks."""
    product = a * b
    return product, product_error(a, b, product) + (a * bl + al * b)


@lean
def plus(a, al, b, bl):
    """Their sum, and what it lacks, which is no more than its rounding."""
    total = a + b
    error = sum_error(a, b, total) + (al + bl)
    value = total + error
    return value, sum_error(total, error, value)
