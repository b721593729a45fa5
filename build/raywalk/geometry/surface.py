"""What a hit looks like: its point on the exact surface, normals, side and material."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from raywalk.geometry.faces import SPHERE, height, is_solid, on_surface
from raywalk.geometry.nearest import NOWHERE
from raywalk.geometry.refine import from_close_up, refined
from raywalk.geometry.sides import POINT_ERROR
from raywalk.optics.compiled import kernel


class Appearance(NamedTuple):
    """Materials of a scene's objects, and the checkers of its planes."""

    material: np.ndarray  # (objects,) int32
    checker: np.ndarray  # (objects,) int32: material of odd squares, -1 without a checker
    checker_size: np.ndarray  # (objects,)
    checker_turn: np.ndarray  # (objects,) +1 or -1: direction of the second axis along canonical z


@kernel
def starts_in(shape, centre, to_local, stretch, k, ox, oy, oz, is_bound):
    """Whether a ray starts in the solid of row k, or on it: then it comes out where it meets it.

    Asked of the start, not of the hit, where rounding may turn the normal of a grazing ray.
    is_bound: the ray starts on a surface, perhaps this one's too.
    """
    x, y, z = ox - centre[k, 0], oy - centre[k, 1], oz - centre[k, 2]
    lx = to_local[k, 0, 0] * x + to_local[k, 0, 1] * y + to_local[k, 0, 2] * z
    ly = to_local[k, 1, 0] * x + to_local[k, 1, 1] * y + to_local[k, 1, 2] * z
    lz = to_local[k, 2, 0] * x + to_local[k, 2, 1] * y + to_local[k, 2, 2] * z
    bound = 0.0
    if is_bound:
        reach = abs(ox) + abs(oy) + abs(oz)
        reach += abs(centre[k, 0]) + abs(centre[k, 1]) + abs(centre[k, 2])
        bound = POINT_ERROR * stretch[k] * reach
    return height(shape, lx, ly, lz) <= 2.0 * bound


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

    The normal faces the incoming ray, but for rounding where that grazes a solid. Rows of rays
    that met nothing or a mesh stay as they are.
    """
    # Its columns are taken out once: handed over in the loop it costs small scenes 20 to 60 %.
    table = primitives
    centre, centre_rest, to_local = table.centre, table.centre_rest, table.to_local
    local_rest, is_skewed, to_world = table.to_local_rest, table.is_skewed, table.to_world
    shapes, row_of, stretch, is_thin = table.shape, table.row_of, table.stretch, table.is_thin
    for i in range(origin.shape[0]):
        if met[i] == NOWHERE or row_of[met[i]] < 0:
            continue
        k, again = row_of[met[i]], leaving[i] == met[i]
        shape = shapes[k]
        x, y, z, dx, dy, dz = from_close_up(
            centre, centre_rest, to_local, local_rest, is_skewed, k,
            origin[i, 0], origin[i, 1], origin[i, 2],
            direction[i, 0], direction[i, 1], direction[i, 2], t[i],
        )  # fmt: skip
        if not again:
            better = refined(t[i], shape, x, y, z, dx, dy, dz)
            step = better - t[i]
            t[i], x, y, z = better, x + step * dx, y + step * dy, z + step * dz
        solid = is_solid(shape)
        leaves = solid and (
            again
            or starts_in(
                shape, centre, to_local, stretch, k, origin[i, 0], origin[i, 1], origin[i, 2],
                leaving[i] != NOWHERE,
            )
        )  # fmt: skip
        hx, hy, hz, gx, gy, gz = on_surface(shape, x, y, z, dx, dy, dz, leaves)
        if is_thin[k]:
            hx, hy, hz = shortest_way(shape, to_local, k, x, y, z, hx, hy, hz, gx, gy, gz)
            if shape.code == SPHERE:
                gx, gy, gz = hx, hy, hz
        x, y, z = hx, hy, hz
        for c in range(3):
            away = to_world[k, c, 0] * x + to_world[k, c, 1] * y + to_world[k, c, 2] * z
            point[i, c] = centre[k, c] + (centre_rest[k, c] + away)
        # Gradients go by the transpose.
        nx = to_local[k, 0, 0] * gx + to_local[k, 1, 0] * gy + to_local[k, 2, 0] * gz
        ny = to_local[k, 0, 1] * gx + to_local[k, 1, 1] * gy + to_local[k, 2, 1] * gz
        nz = to_local[k, 0, 2] * gx + to_local[k, 1, 2] * gy + to_local[k, 2, 2] * gz
        length = math.sqrt(nx * nx + ny * ny + nz * nz)
        nx, ny, nz = nx / length, ny / length, nz / length
        side = nx * direction[i, 0] + ny * direction[i, 1] + nz * direction[i, 2]
        inside[i] = leaves if solid else side > 0.0
        sign = -1.0 if inside[i] else 1.0
        normal[i, 0], normal[i, 1], normal[i, 2] = sign * nx, sign * ny, sign * nz
        material[i] = square_material(appearance, met[i], x, z)
