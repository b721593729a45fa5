"""Hits landed on their surfaces, eight at a time: from where a root says that a ray meets a
primitive to the point on its exact surface, and the normal there.

Neighbouring rays mostly meet the same primitive, so a block's hits are landed by runs of one row.
The formulas of spheres and planes have no branch and hold the row's constants for the whole run;
what those leave out is marked, and landed one by one (`surface.py`).
"""

from __future__ import annotations

import math

from raywalk.geometry.along_ray import point_along
from raywalk.geometry.blocks import BLOCK, WORD
from raywalk.geometry.roots import CLOSE, NOWHERE
from raywalk.geometry.rows import centre_of, matrix_of, times
from raywalk.geometry.sides import POINT_ERROR
from raywalk.geometry.solids import SLIGHT
from raywalk.optics.compiled import inlined, lean

PITCH = BLOCK + WORD  # as in blocks.py; the last run is landed in whole eights
# Rows of a table of hits. Laid out: the ray's origin and direction, the root, the object it leaves.
# Made: point and normal in the world; the refined root; where on a plane's checker the point is;
# SIDE: of a solid 1 where the ray comes out and -1 where it goes in, of others the cosine at the
# outward normal, and YET of hits that are yet to land.
O, D, P, N = range(0, 12 * PITCH, 3 * PITCH)
T, LEAVES, BETTER, HX, HZ, SIDE = range(12 * PITCH, 18 * PITCH, PITCH)
TABLE = 18 * PITCH
YET = 2.0


@lean
def lay_out_hits(table, columns, count, origin, direction, leaving, t):
    """Fills the first part of the table for hits (count,) of the rays in columns."""
    for n in range(count):
        i = columns[n]
        for c in range(3):
            table[O + c * PITCH + n], table[D + c * PITCH + n] = origin[i, c], direction[i, c]
        table[T + n], table[LEAVES + n] = t[i], leaving[i]


@inlined
def feet_on_sphere(table, primitives, k, count):
    """Where the first hits (count,) of a table, which are of row k, a sphere, are on the canonical
    one: as `refined` and `on_surface` have it, written to P and N. Marks those that graze the
    sphere: they are left."""
    cx, cy, cz, ex, ey, ez = centre_of(primitives, k)
    a, b, c, d, e, f, g, h, i = matrix_of(primitives.to_local, k)
    who, stretch = primitives.object[k], primitives.stretch[k]
    for n in range(count):
        ox, oy, oz = vector(table, O, n)
        dx, dy, dz = vector(table, D, n)
        t, leaves = table[T + n], table[LEAVES + n]
        wx, wy, wz = point_along(ox, oy, oz, dx, dy, dz, t, cx, cy, cz, ex, ey, ez)
        x, y, z = times(a, b, c, d, e, f, g, h, i, wx, wy, wz)
        sx, sy, sz = times(a, b, c, d, e, f, g, h, i, ox - cx, oy - cy, oz - cz)
        dx, dy, dz = times(a, b, c, d, e, f, g, h, i, dx, dy, dz)
        again = leaves == who
        reach = abs(ox) + abs(oy) + abs(oz) + (abs(cx) + abs(cy) + abs(cz))
        bound = POINT_ERROR * stretch * reach if leaves != NOWHERE else 0.0
        # The small root of a s^2 + 2 b s + c = 0.
        square, slope = dx * dx + dy * dy + dz * dz, x * dx + y * dy + z * dz
        over = x * x + y * y + z * z - 1.0
        half = 0.5 / slope
        first = -over * half
        bend = square * first * half
        step = first * (1.0 - bend * (1.0 - 2.0 * bend))
        better = t + step if (abs(step) < CLOSE * t) & (not again) else t
        step = better - t
        x, y, z = x + step * dx, y + step * dy, z + step * dz
        length = math.sqrt(x * x + y * y + z * z)
        x, y, z = x / length, y / length, z / length
        comes_out = again | (sx * sx + sy * sy + sz * sz - 1.0 <= 2.0 * bound)
        lands = again | (abs(square * over) < SLIGHT * slope * slope)
        table[BETTER + n] = better
        table[SIDE + n] = (1.0 if comes_out else -1.0) if lands else YET
        table[P + n], table[P + PITCH + n], table[P + 2 * PITCH + n] = x, y, z
        table[N + n], table[N + PITCH + n], table[N + 2 * PITCH + n] = x, y, z


@inlined
def into_world(table, primitives, k, count):
    """Points and unit normals from where hits are on row k's canonical shape, which is left in P,
    and the gradients there, left in N; the sides of those that are of no solid."""
    cx, cy, cz, ex, ey, ez = centre_of(primitives, k)
    a, b, c, d, e, f, g, h, i = matrix_of(primitives.to_world, k)
    p, q, r, s, t, u, v, w, m = matrix_of(primitives.to_local, k)
    for n in range(count):
        hx, hy, hz = vector(table, P, n)
        gx, gy, gz = vector(table, N, n)
        wx, wy, wz = times(a, b, c, d, e, f, g, h, i, hx, hy, hz)
        nx, ny, nz = times(p, s, v, q, t, w, r, u, m, gx, gy, gz)  # by the transposed inverse
        length = math.sqrt(nx * nx + ny * ny + nz * nz)
        nx, ny, nz = nx / length, ny / length, nz / length
        dx, dy, dz = vector(table, D, n)
        side = nx * dx + ny * dy + nz * dz
        table[SIDE + n] = side if table[SIDE + n] == 0.0 else table[SIDE + n]
        table[P + n], table[P + PITCH + n] = cx + (ex + wx), cy + (ey + wy)
        table[P + 2 * PITCH + n] = cz + (ez + wz)
        table[N + n], table[N + PITCH + n], table[N + 2 * PITCH + n] = nx, ny, nz


@inlined
def land_on_plane(table, primitives, k, count):
    """The same of row k, a plane, all the way into the world."""
    cx, cy, cz, ex, ey, ez = centre_of(primitives, k)
    a, b, c, d, e, f, g, h, i = matrix_of(primitives.to_local, k)
    p, _, q, r, _, s, u, _, v = matrix_of(primitives.to_world, k)
    who = primitives.object[k]
    # The gradient (0, 1, 0) by the transposed inverse: zeros keep the signs that this gives them.
    nx, ny, nz = times(a, d, g, b, e, h, c, f, i, 0.0, 1.0, 0.0)
    length = math.sqrt(nx * nx + ny * ny + nz * nz)
    nx, ny, nz = nx / length, ny / length, nz / length
    for n in range(count):
        ox, oy, oz = vector(table, O, n)
        rx, ry, rz = vector(table, D, n)
        t = table[T + n]
        wx, wy, wz = point_along(ox, oy, oz, rx, ry, rz, t, cx, cy, cz, ex, ey, ez)
        x, y, z = times(a, b, c, d, e, f, g, h, i, wx, wy, wz)
        dx, dy, dz = times(a, b, c, d, e, f, g, h, i, rx, ry, rz)
        step = -y / dy
        goes = (abs(step) < CLOSE * t) & (table[LEAVES + n] != who)
        better = t + step if goes else t
        step = better - t
        x, z = x + step * dx, z + step * dz
        table[BETTER + n], table[HX + n], table[HZ + n] = better, x, z
        table[SIDE + n] = nx * rx + ny * ry + nz * rz
        table[N + n], table[N + PITCH + n], table[N + 2 * PITCH + n] = nx, ny, nz
        table[P + n] = cx + (ex + (p * x + q * z))
        table[P + PITCH + n] = cy + (ey + (r * x + s * z))
        table[P + 2 * PITCH + n] = cz + (ez + (u * x + v * z))


@inlined
def vector(table, row, n):
    """Three rows of hit n."""
    return table[row + n], table[row + PITCH + n], table[row + 2 * PITCH + n]
