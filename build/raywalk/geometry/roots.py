"""Where one ray meets one primitive.

Leaving a surface needs no epsilon. A ray that starts on a primitive, by identity or
because its origin lies on that surface within the error bound of a hit point, is kept
apart by the side it leaves to: flat shapes and outward rays of convex ones cannot meet
it again, inward rays meet it at t_out (Waechter and Binder, Ray Tracing Gems, 2019,
ch. 6, and pbrt-v4 sec. 6.8 bound the error; identity makes the bound matter only
where two surfaces touch).
"""

from __future__ import annotations

import math

from raywalk.geometry.along_ray import point_along
from raywalk.geometry.faces import BOX, PLANE, TRIANGLE, TUBE, goes_in, is_flat, is_near
from raywalk.geometry.rims import is_rim_unsure, rim_pair
from raywalk.geometry.seams import exact_roots, is_unsure
from raywalk.geometry.sides import POINT_ERROR
from raywalk.geometry.solids import chord_exit, flat_root, line_roots
from raywalk.optics.compiled import inlined, kernel

NOWHERE = -1  # "leaves no surface", and "met no object"
SOMEWHERE = -2  # leaves whatever surface it starts on, to within the error of a hit point
AT_ONCE = 1e-300  # a distance that changes no coordinate and still is one
FAR_SQ = 64.0  # squared distance in reaches from which on a ray is met from closer up
CLOSE = 1e-6  # hits further apart than this share of t are not even asked whether they tie


@kernel
def to_local(matrix, x, y, z):
    """(3, 3) matrix times a vector given by components."""
    return (
        matrix[0, 0] * x + matrix[0, 1] * y + matrix[0, 2] * z,
        matrix[1, 0] * x + matrix[1, 1] * y + matrix[1, 2] * z,
        matrix[2, 0] * x + matrix[2, 1] * y + matrix[2, 2] * z,
    )


@kernel
def roots(shape, ox, oy, oz, dx, dy, dz, own, inner, bound, least):
    """Up to two parameters t > least (else inf) at which a ray meets a canonical primitive.

    least: 0, or where a ray from free space starts that is given from a point further along it.
    own: the ray starts on this primitive, to its inner side if `inner`.
    bound: how far, in canonical units, the origin may be off a surface it lies on; 0 for
    rays that start in free space.
    """
    if is_flat(shape):
        if own:
            return math.inf, math.inf
        t, level = flat_root(shape, ox, oy, oz, dx, dy, dz)
        if t > least and (abs(level) > bound or least < 0.0):
            return t, math.inf
        return math.inf, math.inf
    if not own and bound > 0.0 and is_near(shape, ox, oy, oz, bound):
        own = True  # touches another surface here: leave it as if it were its own
        inner = goes_in(shape, ox, oy, oz, dx, dy, dz, bound)
    if own:
        if not inner:
            return math.inf, math.inf
        # From an edge, or as flat as rounding, it comes out where it is; but it comes out.
        t_out = max(AT_ONCE, chord_exit(shape, ox, oy, oz, dx, dy, dz))
        if shape.code == TUBE and not abs(oz + t_out * dz) <= 1.0:
            t_out = math.inf
        return t_out, math.inf
    t_in, t_out = line_roots(shape, ox, oy, oz, dx, dy, dz)
    if not t_in > least:
        t_in = math.inf
    if not t_out > least:
        t_out = math.inf
    return (t_in, t_out) if t_in <= t_out else (t_out, t_in)


@inlined
def primitive_roots(primitives, k, ox, oy, oz, dx, dy, dz, own, inner, on_surface):
    """`roots` of row k for a world ray: moved to the centre first, then made canonical.

    Indexed element by element: views of rows would cost more than the arithmetic.
    """
    cx, cy, cz = primitives.centre[k, 0], primitives.centre[k, 1], primitives.centre[k, 2]
    bound = 0.0
    if on_surface:
        reach = abs(ox) + abs(oy) + abs(oz) + abs(cx) + abs(cy) + abs(cz)
        bound = POINT_ERROR * primitives.stretch[k] * reach
    x, y, z = ox - cx, oy - cy, oz - cz
    shift = 0.0
    if x * x + y * y + z * z > FAR_SQ * primitives.reach_sq[k] and not own and bound == 0.0:
        # From many sizes away: from the point nearest to the centre, where rounding is a share
        # of the shape's size and not of the way.
        shift = max(0.0, -(x * dx + y * dy + z * dz) / (dx * dx + dy * dy + dz * dz))
        ex, ey, ez = (
            primitives.centre_rest[k, 0],
            primitives.centre_rest[k, 1],
            primitives.centre_rest[k, 2],
        )
        x, y, z = point_along(ox, oy, oz, dx, dy, dz, shift, cx, cy, cz, ex, ey, ez)
    m, shape = primitives.to_local, primitives.shape[k]
    ly = m[k, 1, 0] * x + m[k, 1, 1] * y + m[k, 1, 2] * z
    ry = m[k, 1, 0] * dx + m[k, 1, 1] * dy + m[k, 1, 2] * dz
    if shape.code == PLANE:  # of an endless plane only its height matters
        return roots(shape, 0.0, ly, 0.0, 0.0, ry, 0.0, own, inner, bound, 0.0)
    lx = m[k, 0, 0] * x + m[k, 0, 1] * y + m[k, 0, 2] * z
    lz = m[k, 2, 0] * x + m[k, 2, 1] * y + m[k, 2, 2] * z
    rx = m[k, 0, 0] * dx + m[k, 0, 1] * dy + m[k, 0, 2] * dz
    rz = m[k, 2, 0] * dx + m[k, 2, 1] * dy + m[k, 2, 2] * dz
    near, far = roots(shape, lx, ly, lz, rx, ry, rz, own, inner, bound, -shift)
    return shift + near, shift + far


@inlined
def rounding_decides(
    centre, m, stretches, reach_sq, code, k, ox, oy, oz, dx, dy, dz, on_surface
):  # fmt: skip
    """Whether rounding may decide if a ray meets row k, a box or triangle that it does not leave.

    The first four are columns of the table.
    """
    cx, cy, cz = centre[k, 0], centre[k, 1], centre[k, 2]
    x, y, z = ox - cx, oy - cy, oz - cz
    stretch = stretches[k]
    bound = 0.0
    if on_surface:
        reach = abs(ox) + abs(oy) + abs(oz) + abs(cx) + abs(cy) + abs(cz)
        bound = POINT_ERROR * stretch * reach
    elif x * x + y * y + z * z > FAR_SQ * reach_sq[k]:
        shift = max(0.0, -(x * dx + y * dy + z * dz) / (dx * dx + dy * dy + dz * dz))
        x, y, z = point_along(ox, oy, oz, dx, dy, dz, shift, cx, cy, cz, 0.0, 0.0, 0.0)
    # What a coordinate may be off by is a share of the terms that it is a sum of.
    size = max(abs(x), max(abs(y), abs(z))) + max(abs(cx), max(abs(cy), abs(cz)))
    drift = max(abs(dx), max(abs(dy), abs(dz)))
    return is_unsure(
        code,
        m[k, 0, 0] * x + m[k, 0, 1] * y + m[k, 0, 2] * z,
        m[k, 1, 0] * x + m[k, 1, 1] * y + m[k, 1, 2] * z,
        m[k, 2, 0] * x + m[k, 2, 1] * y + m[k, 2, 2] * z,
        m[k, 0, 0] * dx + m[k, 0, 1] * dy + m[k, 0, 2] * dz,
        m[k, 1, 0] * dx + m[k, 1, 1] * dy + m[k, 1, 2] * dz,
        m[k, 2, 0] * dx + m[k, 2, 1] * dy + m[k, 2, 2] * dz,
        stretch * size, stretch * drift, bound,
    )  # fmt: skip


@kernel
def settled_roots(primitives, k, ox, oy, oz, dx, dy, dz, own, inner, on_surface):
    """The roots for certain: decided exactly where rounding could have decided them."""
    near, far = primitive_roots(primitives, k, ox, oy, oz, dx, dy, dz, own, inner, on_surface)
    if own or not primitives.is_edged[k]:
        return near, far
    code = primitives.shape[k].code
    if code != BOX and code != TRIANGLE:
        return settled_rims(primitives, k, near, far, (ox, oy, oz), (dx, dy, dz))
    if not rounding_decides(
        primitives.centre, primitives.to_local, primitives.stretch, primitives.reach_sq, code, k,
        ox, oy, oz, dx, dy, dz, on_surface,
    ):  # fmt: skip
        return near, far
    return exact_pair(primitives, k, code, (ox, oy, oz), (dx, dy, dz))


@kernel
def settled_rims(primitives, k, near, far, o, d):
    """The same of row k, which shares a rim, for a ray from free space that has these roots."""
    cx, cy, cz = primitives.centre[k, 0], primitives.centre[k, 1], primitives.centre[k, 2]
    x, y, z, shift = o[0] - cx, o[1] - cy, o[2] - cz, 0.0
    if x * x + y * y + z * z > FAR_SQ * primitives.reach_sq[k]:
        towards = x * d[0] + y * d[1] + z * d[2]
        shift = max(0.0, -towards / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]))
        x, y, z = point_along(o[0], o[1], o[2], d[0], d[1], d[2], shift, cx, cy, cz, 0.0, 0.0, 0.0)
    size = max(abs(x), max(abs(y), abs(z))) + max(abs(cx), max(abs(cy), abs(cz)))
    drift = max(abs(d[0]), max(abs(d[1]), abs(d[2])))
    m, shape, stretch = primitives.to_local, primitives.shape[k], primitives.stretch[k]
    lx, ly, lz = to_local(m[k], x, y, z)
    rx, ry, rz = to_local(m[k], d[0], d[1], d[2])
    if not is_rim_unsure(shape, lx, ly, lz, rx, ry, rz, stretch * size, stretch * drift, 0.0):
        return near, far
    return rim_pair(
        shape, primitives.corner, primitives.corner_rest, k, lx, ly, lz, rx, ry, rz, shift,
        False, False, 0.0, o, d,
    )  # fmt: skip


@kernel
def exact_pair(primitives, k, code, o, d):
    """Both roots t > 0 (else inf) of a box or triangle, the nearer first, by its exact corners."""
    one, other = exact_roots(primitives.corner, primitives.corner_rest, k, code, o, d)
    first = one if one > 0.0 else math.inf
    second = other if other > 0.0 else math.inf
    return (first, second) if first <= second else (second, first)


@kernel
def lies_on(primitives, k, ox, oy, oz, dx, dy, dz, t):
    """Whether the point o + t d is, within the error bound of hit points, on row k's surface."""
    cx, cy, cz = primitives.centre[k, 0], primitives.centre[k, 1], primitives.centre[k, 2]
    m, shape = primitives.to_local, primitives.shape[k]
    px, py, pz = ox + t * dx, oy + t * dy, oz + t * dz
    reach = abs(ox) + abs(oy) + abs(oz) + abs(px) + abs(py) + abs(pz)
    reach += abs(cx) + abs(cy) + abs(cz)
    bound = POINT_ERROR * primitives.stretch[k] * reach
    x, y, z = px - cx, py - cy, pz - cz
    lx = m[k, 0, 0] * x + m[k, 0, 1] * y + m[k, 0, 2] * z
    ly = m[k, 1, 0] * x + m[k, 1, 1] * y + m[k, 1, 2] * z
    lz = m[k, 2, 0] * x + m[k, 2, 1] * y + m[k, 2, 2] * z
    return is_near(shape, lx, ly, lz, bound)


@inlined
def is_past(square, reach_sq, along, dd):
    """Whether a ray certainly misses a sphere: it starts outside, and goes away or passes by.

    square: of its centre seen from the origin; along: that times the direction; dd: the direction's
    square. Without a branch, for loops that take eight at a time.
    """
    beyond = square - reach_sq
    # 1e-13 is a thousand roundings: from far away the sphere's own radius drowns, and the ray is
    # kept.
    by = beyond * dd - along * along > 1e-13 * square * dd
    return (beyond > 0.0) & ((along < 0.0) | by)


@kernel
def passes_by(primitives, k, ox, oy, oz, dx, dy, dz, dd):
    """Whether a ray certainly misses the sphere round row k. dd: the direction's square."""
    x, y, z = (
        primitives.centre[k, 0] - ox,
        primitives.centre[k, 1] - oy,
        primitives.centre[k, 2] - oz,
    )
    along = x * dx + y * dy + z * dz
    return is_past(x * x + y * y + z * z, primitives.reach_sq[k], along, dd)
