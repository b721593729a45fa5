"""One ray and one triangle, watertight: Woop, Benthin and Wald, JCGT 2(1), 2013.

Space is sheared so that the ray runs along +z from the origin; neighbours that share
an edge compute that edge's sign from the same numbers, so no ray slips between them.
"""

from __future__ import annotations

import math

from raywalk.optics.compiled import inlined, lean


@lean
def vector(rows, i):
    """Row i of (n, 3) as three numbers: a view of the row would cost more than the arithmetic."""
    return rows[i, 0], rows[i, 1], rows[i, 2]


@lean
def shear(dx, dy, dz):
    """Axis order and shear constants (kx, ky, kz, sx, sy, sz) of a ray direction."""
    ax, ay, az = abs(dx), abs(dy), abs(dz)
    if ax >= ay and ax >= az:
        kx, ky, kz, along, u, v = 1, 2, 0, dx, dy, dz
    elif ay >= az:
        kx, ky, kz, along, u, v = 2, 0, 1, dy, dz, dx
    else:
        kx, ky, kz, along, u, v = 0, 1, 2, dz, dx, dy
    return kx, ky, kz, u / along, v / along, 1.0 / along


@inlined
def part(o, k):
    """One of three numbers, chosen without a jump."""
    return o[0] if k == 0 else (o[1] if k == 1 else o[2])


@inlined
def edge_weights(o, corners, k, kx, ky, kz, sx, sy):
    """Corners a, b, c of row k sheared so that the ray is the z axis, and the ray's edge functions
    (Woop et al. 2013): on which side of the edges opposite to a, b and c it passes."""
    x, y, z = part(o, kx), part(o, ky), part(o, kz)
    az, bz, cz = corners[k, 0, kz] - z, corners[k, 1, kz] - z, corners[k, 2, kz] - z
    ax = corners[k, 0, kx] - x - sx * az
    ay = corners[k, 0, ky] - y - sy * az
    bx = corners[k, 1, kx] - x - sx * bz
    by = corners[k, 1, ky] - y - sy * bz
    cx = corners[k, 2, kx] - x - sx * cz
    cy = corners[k, 2, ky] - y - sy * cz
    weights = cx * by - cy * bx, ax * cy - ay * cx, bx * ay - by * ax
    return (ax, ay, az), (bx, by, bz), (cx, cy, cz), weights


@lean
def triangle_hit(o, corners, k, kx, ky, kz, sx, sy, sz):
    """(t, u, v) with point = (1-u-v) a + u b + v c; t is inf where the ray's line misses.

    o: origin, three numbers; corners: (n, 3, 3) float64, of which row k is asked, its rows a, b,
    c in the same frame. Either side hits. Edges count as inside. A degenerate triangle is
    never hit.
    """
    (_, _, az), (_, _, bz), (_, _, cz), (wa, wb, wc) = edge_weights(
        o, corners, k, kx, ky, kz, sx, sy
    )
    if (wa < 0.0 or wb < 0.0 or wc < 0.0) and (wa > 0.0 or wb > 0.0 or wc > 0.0):
        return math.inf, 0.0, 0.0
    total = wa + wb + wc
    if total == 0.0:
        return math.inf, 0.0, 0.0
    # A weighted mean, not a plane equation: a sliver's normal is noise, its corners are not.
    t = sz * (wa * az + wb * bz + wc * cz) / total
    return t, wb / total, wc / total


# Roundings behind a sheared coordinate, in shares of the largest.
SHEARED = 3.0 * 2.220446049250313e-16


@lean
def sided_hit(o, corners, k, sheared, off):
    """`triangle_hit`, and whether rounding cannot have decided it; if it can, in place of (t, u, v)
    its three edges' d . ((p - o) x (q - o)), and how far these may be off.

    sheared: what `shear` gave; off: how far o and the corners may be off, together.
    """
    kx, ky, kz, sx, sy, sz = sheared
    (ax, ay, az), (bx, by, bz), (cx, cy, cz), (wa, wb, wc) = edge_weights(
        o, corners, k, kx, ky, kz, sx, sy
    )
    wide = max(max(abs(ax), abs(ay)), max(max(abs(bx), abs(by)), max(abs(cx), abs(cy))))
    deep = max(abs(az), max(abs(bz), abs(cz)))
    # Each coordinate is off by this at most, and each product of two by it times the other.
    error = 8.0 * wide * (2.0 * off + SHEARED * (wide + deep))
    low, high = min(wa, min(wb, wc)), max(wa, max(wb, wc))
    if low < -error and high > error:
        return math.inf, 0.0, 0.0, True, 0.0
    if not (low > error or high < -error):
        return -wa / sz, -wb / sz, -wc / sz, False, error / abs(sz)
    total = wa + wb + wc
    # A weighted mean, not a plane equation: a sliver's normal is noise, its corners are not.
    return sz * (wa * az + wb * bz + wc * cz) / total, wb / total, wc / total, True, 0.0


@lean
def triangle_normal(corners, k):
    """Unit normal of row k of corners (n, 3, 3) by the winding a, b, c (right hand rule)."""
    ux, uy, uz = (
        corners[k, 1, 0] - corners[k, 0, 0],
        corners[k, 1, 1] - corners[k, 0, 1],
        corners[k, 1, 2] - corners[k, 0, 2],
    )
    vx, vy, vz = (
        corners[k, 2, 0] - corners[k, 0, 0],
        corners[k, 2, 1] - corners[k, 0, 1],
        corners[k, 2, 2] - corners[k, 0, 2],
    )
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    length = math.sqrt(nx * nx + ny * ny + nz * nz)
    return nx / length, ny / length, nz / length


@lean
def height_over(o, corners, k):
    """Signed distance of a point from triangle k's plane, positive on the normal's side."""
    nx, ny, nz = triangle_normal(corners, k)
    x, y, z = o[0] - corners[k, 0, 0], o[1] - corners[k, 0, 1], o[2] - corners[k, 0, 2]
    return nx * x + ny * y + nz * z


@lean
def distance_sq_to(o, corners, k):
    """Squared distance of a point from triangle k, edges and corners included.

    o: three numbers. Ericson, Real-Time Collision Detection, 2005, sec. 5.1.5: the region that
    the point lies over tells which corner, edge or face is closest.
    """
    a, b, c = corner(corners, k, 0), corner(corners, k, 1), corner(corners, k, 2)
    e, f, p = minus(b, a), minus(c, a), minus(o, a)
    d1, d2 = dot(e, p), dot(f, p)
    if d1 <= 0.0 and d2 <= 0.0:
        return dot(p, p)
    q = minus(o, b)
    d3, d4 = dot(e, q), dot(f, q)
    if d3 >= 0.0 and d4 <= d3:
        return dot(q, q)
    r = minus(o, c)
    d5, d6 = dot(e, r), dot(f, r)
    if d6 >= 0.0 and d5 <= d6:
        return dot(r, r)
    if d1 * d4 - d3 * d2 <= 0.0 and d1 >= 0.0 and d3 <= 0.0:
        return off_line_sq(p, e, d1 / (d1 - d3))
    if d5 * d2 - d1 * d6 <= 0.0 and d2 >= 0.0 and d6 <= 0.0:
        return off_line_sq(p, f, d2 / (d2 - d6))
    if d3 * d6 - d5 * d4 <= 0.0 and d4 >= d3 and d5 >= d6:
        return off_line_sq(q, minus(c, b), (d4 - d3) / ((d4 - d3) + (d5 - d6)))
    height = height_over(o, corners, k)
    return height * height


@lean
def solid_angle(o, corners, k):
    """Solid angle of triangle k from a point, in shares of the whole sphere; positive from
    behind its normal.

    Van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30(2), 1983. o: three numbers.
    """
    a = minus(corner(corners, k, 0), o)
    b = minus(corner(corners, k, 1), o)
    c = minus(corner(corners, k, 2), o)
    la, lb, lc = math.sqrt(dot(a, a)), math.sqrt(dot(b, b)), math.sqrt(dot(c, c))
    volume = (
        a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
    )
    rest = dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
    return math.atan2(volume, la * lb * lc + rest) / (2.0 * math.pi)


@lean
def corner(corners, k, c):
    """Corner c of triangle k as three numbers."""
    return corners[k, c, 0], corners[k, c, 1], corners[k, c, 2]


@lean
def minus(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


@lean
def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@lean
def off_line_sq(p, along, share):
    """Squared length of p - share * along."""
    x, y, z = p[0] - share * along[0], p[1] - share * along[1], p[2] - share * along[2]
    return x * x + y * y + z * z


@lean
def has_vertex(faces, triangle, vertex):
    """Whether a triangle has this vertex."""
    return (
        faces[triangle, 0] == vertex or faces[triangle, 1] == vertex or faces[triangle, 2] == vertex
    )


@lean
def shares_vertex(faces, one, other):
    """Whether two triangles have a vertex in common."""
    p, q, r = faces[one, 0], faces[one, 1], faces[one, 2]
    return has_vertex(faces, other, p) or has_vertex(faces, other, q) or has_vertex(faces, other, r)
