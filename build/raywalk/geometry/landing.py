"""Hits landed on their surfaces, eight at a time: from where a root says that a ray meets a
primitive to the point on its exact surface, and the normal there.

As with candidates, the formulas of spheres and planes have no branch and are taken for all alike;
what those leave out is marked, and landed one by one (`surface.py`). The ways to canonical
coordinates and back are the same for every shape.
"""

from __future__ import annotations

import math

from raywalk.geometry.along_ray import point_along
from raywalk.geometry.blocks import BLOCK
from raywalk.geometry.faces import PLANE, SPHERE
from raywalk.geometry.roots import CLOSE, NOWHERE
from raywalk.geometry.sides import POINT_ERROR
from raywalk.geometry.solids import SLIGHT
from raywalk.optics.compiled import inlined, kernel

PITCH = BLOCK + 8  # as in blocks.py
# Rows of a table of hits, three of what is a vector. Laid out: the ray's origin and direction, the
# primitive's centre, and what that lacks; the root, the shape, the bound within which the ray
# starts on a surface, whether it leaves this one, and whether `land` must leave it. Made: the hit
# point as seen from the centre; canonical hit point, direction and start; canonical foot and
# gradient; point and normal in the world. SIDE: of a solid 1 where the ray comes out and -1 where
# it goes in, of others the cosine at the outward normal, and 2 of hits that are yet to land.
O, D, C, REST, X, L, R, S, H, G, P, N = range(0, 36 * PITCH, 3 * PITCH)
T, CODE, BOUND, AGAIN, APART, SIDE = range(36 * PITCH, 42 * PITCH, PITCH)
TABLE = 42 * PITCH


@kernel
def lay_out_hits(table, primitives, rows, columns, count, origin, direction, leaving, t, met):
    """Fills the first part of the table for rays (count,) that meet rows (count,)."""
    centre, rest, stretch = primitives.centre, primitives.centre_rest, primitives.stretch
    shape, is_skewed, is_thin = primitives.shape, primitives.is_skewed, primitives.is_thin
    for n in range(count):
        i, k = columns[n], rows[n]
        reach = 0.0
        for c in range(3):
            table[O + c * PITCH + n], table[D + c * PITCH + n] = origin[i, c], direction[i, c]
            table[C + c * PITCH + n], table[REST + c * PITCH + n] = centre[k, c], rest[k, c]
            reach += abs(origin[i, c])
        reach += abs(centre[k, 0]) + abs(centre[k, 1]) + abs(centre[k, 2])
        table[T + n], table[CODE + n] = t[i], shape[k].code
        table[BOUND + n] = POINT_ERROR * stretch[k] * reach if leaving[i] != NOWHERE else 0.0
        table[AGAIN + n], table[APART + n] = leaving[i] == met[i], is_skewed[k] or is_thin[k]
    see_close(table, count)
    into_canonical(table, primitives.to_local, rows, count)


@kernel
def see_close(table, count):
    """The hit point as seen from the centre, exact but for its last digit."""
    for n in range(count):
        ox, oy, oz = vector(table, O, n)
        dx, dy, dz = vector(table, D, n)
        cx, cy, cz = vector(table, C, n)
        ex, ey, ez = vector(table, REST, n)
        x, y, z = point_along(ox, oy, oz, dx, dy, dz, table[T + n], cx, cy, cz, ex, ey, ez)
        table[X + n], table[X + PITCH + n], table[X + 2 * PITCH + n] = x, y, z


@kernel
def into_canonical(table, m, rows, count):
    """Hit points, directions and starts by the matrices of their rows."""
    for n in range(count):
        k = rows[n]
        ox, oy, oz = vector(table, O, n)
        cx, cy, cz = vector(table, C, n)
        x, y, z = vector(table, X, n)
        dx, dy, dz = vector(table, D, n)
        sx, sy, sz = ox - cx, oy - cy, oz - cz
        for r in range(3):
            a, b, c = m[k, r, 0], m[k, r, 1], m[k, r, 2]
            table[L + r * PITCH + n] = a * x + b * y + c * z
            table[R + r * PITCH + n] = a * dx + b * dy + c * dz
            table[S + r * PITCH + n] = a * sx + b * sy + c * sz


@kernel
def into_world(table, to_world, to_local, rows, count):
    """Feet, and gradients, which go by the transposed inverse."""
    for n in range(count):
        k = rows[n]
        hx, hy, hz = vector(table, H, n)
        gx, gy, gz = vector(table, G, n)
        for c in range(3):
            away = to_world[k, c, 0] * hx + to_world[k, c, 1] * hy + to_world[k, c, 2] * hz
            table[P + c * PITCH + n] = table[C + c * PITCH + n] + (
                table[REST + c * PITCH + n] + away
            )
            table[N + c * PITCH + n] = (
                to_local[k, 0, c] * gx + to_local[k, 1, c] * gy + to_local[k, 2, c] * gz
            )


@kernel
def land(table, count):
    """Refines the roots of spheres and planes, and finds their feet and gradients: as `refined`
    and `on_surface` have it."""
    for n in range(count):
        t, again = table[T + n], table[AGAIN + n] > 0.0
        x, y, z = vector(table, L, n)
        dx, dy, dz = vector(table, R, n)
        is_plane = table[CODE + n] == PLANE
        is_round = table[CODE + n] == SPHERE
        # The small root of a s^2 + 2 b s + c = 0.
        a, b, c = dx * dx + dy * dy + dz * dz, x * dx + y * dy + z * dz, x * x + y * y + z * z - 1.0
        half = 0.5 / b
        first = -c * half
        bend = a * first * half
        step = first * (1.0 - bend * (1.0 - 2.0 * bend))
        step = -y / dy if is_plane else step
        is_slight = abs(a * c) < SLIGHT * b * b
        better = t + step if (abs(step) < CLOSE * t) & (not again) else t
        step = better - t
        x, y, z = x + step * dx, y + step * dy, z + step * dz
        length = math.sqrt(x * x + y * y + z * z)
        sx, sy, sz = vector(table, S, n)
        starts_in = sx * sx + sy * sy + sz * sz - 1.0 <= 2.0 * table[BOUND + n]
        hx, hy, hz = x / length, y / length, z / length
        lands = (table[APART + n] == 0.0) & (is_plane | (is_round & (is_slight | again)))
        side = 0.0 if is_plane else (1.0 if again | starts_in else -1.0)
        table[SIDE + n] = side if lands else 2.0
        table[T + n] = better if lands else t
        table[H + n] = x if is_plane else hx
        table[H + PITCH + n] = 0.0 if is_plane else hy
        table[H + 2 * PITCH + n] = z if is_plane else hz
        table[G + n] = 0.0 if is_plane else hx
        table[G + PITCH + n] = 1.0 if is_plane else hy
        table[G + 2 * PITCH + n] = 0.0 if is_plane else hz


@kernel
def face_rays(table, count):
    """Normals made unit, and the sides of those that are of no solid."""
    for n in range(count):
        nx, ny, nz = vector(table, N, n)
        length = math.sqrt(nx * nx + ny * ny + nz * nz)
        nx, ny, nz = nx / length, ny / length, nz / length
        dx, dy, dz = vector(table, D, n)
        side = nx * dx + ny * dy + nz * dz
        table[SIDE + n] = side if table[SIDE + n] == 0.0 else table[SIDE + n]
        table[N + n], table[N + PITCH + n], table[N + 2 * PITCH + n] = nx, ny, nz


@inlined
def vector(table, row, n):
    """Three rows of hit n."""
    return table[row + n], table[row + PITCH + n], table[row + 2 * PITCH + n]
