"""What a hit looks like: its point on the exact surface, normals, side and material."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from raywalk.geometry.blocks import BLOCK, WORD
from raywalk.geometry.faces import PLANE, SPHERE, height, is_solid, on_surface
from raywalk.geometry.landing import (
    BETTER,
    HX,
    HZ,
    LEAVES,
    PITCH,
    SIDE,
    TABLE,
    YET,
    D,
    N,
    O,
    P,
    T,
    feet_on_sphere,
    into_world,
    land_on_plane,
    lay_out_hits,
    vector,
)
from raywalk.geometry.refine import from_close_up, refined
from raywalk.geometry.roots import NOWHERE
from raywalk.geometry.rows import matrix_of, times
from raywalk.geometry.sides import POINT_ERROR
from raywalk.optics.compiled import inlined, kernel, lean


class Appearance(NamedTuple):
    """Materials of a scene's objects, and the checkers of its planes."""

    material: np.ndarray  # (objects,) int32
    checker: np.ndarray  # (objects,) int32: material of odd squares, -1 without a checker
    checker_size: np.ndarray  # (objects,)
    checker_turn: np.ndarray  # (objects,) +1 or -1: direction of the second axis along canonical z


@kernel
def square_material(appearance, who, x, z):
    """Material of object `who` at a canonical point, which only a checker depends on."""
    odd = appearance.checker[who]
    if odd < 0:
        return appearance.material[who]
    size = appearance.checker_size[who]
    cell = math.floor(x / size) + math.floor(z * appearance.checker_turn[who] / size)
    return odd if cell % 2.0 == 1.0 else appearance.material[who]


@kernel
def shortest_way(shape, to_local, k, x, y, z, hx, hy, hz, gx, gy, gz):
    """A canonical point moved onto the surface as straight as the world has it, not as canonical
    coordinates do: one step of Newton's method along the world's gradient.

    h, g: its foot as `on_surface` found it, and the gradient there. Rounding leaves so little to go
    that the step's own error is nothing, but across a thin shape canonical lengths are large.
    """
    if shape.code == SPHERE:
        gx, gy, gz = x, y, z
        over = 0.5 * (x * x + y * y + z * z - 1.0)
    else:  # h lies straight in canonical space; of a cone's side it has the same z
        over = gx * (x - hx) + gy * (y - hy) + gz * (z - hz)
    wx = to_local[k, 0, 0] * gx + to_local[k, 1, 0] * gy + to_local[k, 2, 0] * gz
    wy = to_local[k, 0, 1] * gx + to_local[k, 1, 1] * gy + to_local[k, 2, 1] * gz
    wz = to_local[k, 0, 2] * gx + to_local[k, 1, 2] * gy + to_local[k, 2, 2] * gz
    by = over / (wx * wx + wy * wy + wz * wz)
    return (
        x - by * (to_local[k, 0, 0] * wx + to_local[k, 0, 1] * wy + to_local[k, 0, 2] * wz),
        y - by * (to_local[k, 1, 0] * wx + to_local[k, 1, 1] * wy + to_local[k, 1, 2] * wz),
        z - by * (to_local[k, 2, 0] * wx + to_local[k, 2, 1] * wy + to_local[k, 2, 2] * wz),
    )


@kernel
def primitive_surface(
    primitives, appearance, origin, direction, leaving, t, met, point, normal, inside, material
):
    """Fills point, normal (both (n, 3)), inside and material of the rays that met a primitive,
    and refines their t. Of the others, point and normal are 0, inside False and material -1.

    The normal faces the incoming ray, but for rounding where that grazes a solid.
    """
    table = np.zeros(TABLE)
    columns, rows = np.empty(BLOCK, np.int64), np.empty(BLOCK, np.int64)
    other_columns, other_rows = columns.copy(), rows.copy()
    ends = np.zeros(primitives.shape.shape[0], np.int64)
    for first in range(0, origin.shape[0], BLOCK):
        last = min(first + BLOCK, origin.shape[0])
        point[first:last], normal[first:last] = 0.0, 0.0
        inside[first:last], material[first:last] = False, -1
        count = list_hits(primitives.row_of, met, first, last, columns, rows)
        changes = 0
        for n in range(1, count):
            changes += rows[n] != rows[n - 1]
        if 4 * changes > count:
            put_alike_together(columns, rows, count, ends, other_columns, other_rows)
            columns, other_columns, rows, other_rows = other_columns, columns, other_rows, rows
        lay_out_hits(table, columns, count, origin, direction, leaving, t)
        start = 0
        while start < count:
            end = start + 1
            while end < count and rows[end] == rows[start]:
                end += 1
            land_run(table[start:], primitives, rows[start], end - start)
            start = end
        for n in range(count):
            write_hit(table, n, columns[n], appearance, t, met, point, normal, inside, material)


@lean
def list_hits(row_of, met, first, last, columns, rows):
    """Which of the rays from first to last met a primitive, and its row; returns how many."""
    count = 0
    for i in range(first, last):
        k = row_of[max(0, met[i])]
        columns[count], rows[count] = i, k  # without a branch, which none could predict
        count += (met[i] != NOWHERE) & (k >= 0)
    return count


@lean
def put_alike_together(columns, rows, count, ends, to_columns, to_rows):
    """Writes hits (count,) to the last two in the order of their rows, as these are first met.

    ends: (rows,) zeros, before and after.
    """
    kinds = end = 0
    for n in range(count):
        to_rows[kinds] = rows[n]
        kinds += ends[rows[n]] == 0
        ends[rows[n]] += 1
    for n in range(kinds):
        end, ends[to_rows[n]] = end + ends[to_rows[n]], end
    for n in range(count):
        place = ends[rows[n]]
        to_columns[place], to_rows[place] = columns[n], rows[n]
        ends[rows[n]] += 1
    for n in range(count):
        ends[rows[n]] = 0


@inlined
def land_run(table, primitives, k, count):
    """The first hits (count,) of a table, which are of row k."""
    code, is_apart = primitives.shape[k].code, primitives.is_skewed[k] or primitives.is_thin[k]
    # In whole eights: what is written after the last one is of no hit, or of one that comes later.
    whole = (count + WORD - 1) // WORD * WORD
    if code == PLANE and not is_apart:
        land_on_plane(table, primitives, k, whole)
        return
    is_round, left = code == SPHERE and not is_apart, count
    if is_round:
        feet_on_sphere(table, primitives, k, whole)
        left = 0
        for n in range(count):
            left += table[SIDE + n] == YET
    if left > 0:
        feet_one_by_one(table, primitives, k, count, is_round)
    into_world(table, primitives, k, whole)


@inlined
def write_hit(table, n, i, appearance, t, met, point, normal, inside, material):
    """Hit n as ray i's."""
    t[i] = table[BETTER + n]
    inside[i] = table[SIDE + n] > 0.0
    sign = -1.0 if inside[i] else 1.0
    for c in range(3):
        point[i, c] = table[P + c * PITCH + n]
        normal[i, c] = sign * table[N + c * PITCH + n]
    material[i] = square_material(appearance, met[i], table[HX + n], table[HZ + n])


@lean
def feet_one_by_one(table, primitives, k, count, only_left):
    """As `feet_on_sphere`, by one ray's formulas: for other shapes, those thin or skewed, and what
    that left over."""
    shape, is_skewed, is_thin = primitives.shape[k], primitives.is_skewed, primitives.is_thin[k]
    to_local, rest, solid = primitives.to_local, primitives.to_local_rest, is_solid(shape)
    centre, centre_rest = primitives.centre, primitives.centre_rest
    who, stretch = primitives.object[k], primitives.stretch[k]
    cx, cy, cz = centre[k, 0], centre[k, 1], centre[k, 2]
    a, b, c, d, e, f, g, h, i = matrix_of(to_local, k)
    for n in range(count):
        if only_left and table[SIDE + n] != YET:
            continue
        ox, oy, oz = vector(table, O, n)
        wx, wy, wz = vector(table, D, n)
        t, again, bound = table[T + n], table[LEAVES + n] == who, 0.0
        if table[LEAVES + n] != NOWHERE:
            reach = abs(ox) + abs(oy) + abs(oz) + (abs(cx) + abs(cy) + abs(cz))
            bound = POINT_ERROR * stretch * reach
        x, y, z, dx, dy, dz = from_close_up(
            centre, centre_rest, to_local, rest, is_skewed, k, ox, oy, oz, wx, wy, wz, t
        )
        if not again:
            better = refined(t, shape, x, y, z, dx, dy, dz)
            step, t = better - t, better
            x, y, z = x + step * dx, y + step * dy, z + step * dz
        sx, sy, sz = times(a, b, c, d, e, f, g, h, i, ox - cx, oy - cy, oz - cz)
        # Asked of the start, not of the hit, where rounding may turn the normal of a grazing ray.
        leaves = solid and (again or height(shape, sx, sy, sz) <= 2.0 * bound)
        hx, hy, hz, gx, gy, gz = on_surface(shape, x, y, z, dx, dy, dz, leaves)
        if is_thin:
            hx, hy, hz = shortest_way(shape, to_local, k, x, y, z, hx, hy, hz, gx, gy, gz)
            if shape.code == SPHERE:
                gx, gy, gz = hx, hy, hz
        table[BETTER + n], table[HX + n], table[HZ + n] = t, hx, hz
        table[P + n], table[P + PITCH + n], table[P + 2 * PITCH + n] = hx, hy, hz
        table[N + n], table[N + PITCH + n], table[N + 2 * PITCH + n] = gx, gy, gz
        table[SIDE + n] = (1.0 if leaves else -1.0) if solid else 0.0
