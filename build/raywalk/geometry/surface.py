"""What a hit looks like: its point on the exact surface, normals, side and material."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from raywalk.geometry.along_ray import sharp_product
from raywalk.geometry.blocks import BLOCK
from raywalk.geometry.faces import SPHERE, height, is_solid, on_surface
from raywalk.geometry.landing import (
    AGAIN,
    BOUND,
    PITCH,
    SIDE,
    TABLE,
    G,
    H,
    L,
    N,
    P,
    R,
    S,
    T,
    X,
    face_rays,
    into_world,
    land,
    lay_out_hits,
)
from raywalk.geometry.refine import refined
from raywalk.geometry.roots import NOWHERE
from raywalk.optics.compiled import inlined, kernel


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
    and refines their t.

    The normal faces the incoming ray, but for rounding where that grazes a solid. Of rays that met
    nothing, point and normal are 0; rows of those that met a mesh stay as they are.
    """
    table, columns, rows = np.empty(TABLE), np.empty(BLOCK, np.int64), np.empty(BLOCK, np.int64)
    for first in range(0, origin.shape[0], BLOCK):
        count = 0
        for i in range(first, min(first + BLOCK, origin.shape[0])):
            if met[i] == NOWHERE:
                for c in range(3):
                    point[i, c] = normal[i, c] = 0.0
                inside[i], material[i] = False, -1
            elif primitives.row_of[met[i]] >= 0:
                columns[count], rows[count] = i, primitives.row_of[met[i]]
                count += 1
        if count:
            lay_out_hits(
                table, primitives, rows, columns, count, origin, direction, leaving, t, met
            )
            land(table, count)
            land_others(table, primitives, rows, count)
            into_world(table, primitives.to_world, primitives.to_local, rows, count)
            face_rays(table, count)
            for n in range(count):
                write_hit(table, n, columns[n], appearance, t, met, point, normal, inside, material)


@inlined
def write_hit(table, n, i, appearance, t, met, point, normal, inside, material):
    """Hit n as ray i's."""
    t[i] = table[T + n]
    inside[i] = table[SIDE + n] > 0.0
    sign = -1.0 if inside[i] else 1.0
    for c in range(3):
        point[i, c] = table[P + c * PITCH + n]
        normal[i, c] = sign * table[N + c * PITCH + n]
    material[i] = square_material(appearance, met[i], table[H + n], table[H + 2 * PITCH + n])


@kernel
def land_others(table, primitives, rows, count):
    """What `land` left: other shapes, those thin or skewed, and grazing rays, one by one."""
    to_local, rest, shapes = primitives.to_local, primitives.to_local_rest, primitives.shape
    is_thin, is_skewed = primitives.is_thin, primitives.is_skewed
    for n in range(count):
        if table[SIDE + n] < 2.0:
            continue
        k = rows[n]
        shape, t, again = shapes[k], table[T + n], table[AGAIN + n] > 0.0
        x, y, z = table[L + n], table[L + PITCH + n], table[L + 2 * PITCH + n]
        dx, dy, dz = table[R + n], table[R + PITCH + n], table[R + 2 * PITCH + n]
        if is_skewed[k]:
            x, y, z = sharp_product(
                to_local, rest, k, table[X + n], table[X + PITCH + n], table[X + 2 * PITCH + n]
            )
        if not again:
            better = refined(t, shape, x, y, z, dx, dy, dz)
            step = better - t
            table[T + n], x, y, z = better, x + step * dx, y + step * dy, z + step * dz
        solid = is_solid(shape)
        sx, sy, sz = table[S + n], table[S + PITCH + n], table[S + 2 * PITCH + n]
        # Asked of the start, not of the hit, where rounding may turn the normal of a grazing ray.
        leaves = solid and (again or height(shape, sx, sy, sz) <= 2.0 * table[BOUND + n])
        hx, hy, hz, gx, gy, gz = on_surface(shape, x, y, z, dx, dy, dz, leaves)
        if is_thin[k]:
            hx, hy, hz = shortest_way(shape, to_local, k, x, y, z, hx, hy, hz, gx, gy, gz)
            if shape.code == SPHERE:
                gx, gy, gz = hx, hy, hz
        table[H + n], table[H + PITCH + n], table[H + 2 * PITCH + n] = hx, hy, hz
        table[G + n], table[G + PITCH + n], table[G + 2 * PITCH + n] = gx, gy, gz
        table[SIDE + n] = (1.0 if leaves else -1.0) if solid else 0.0
