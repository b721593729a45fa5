"""What a hit looks like: its point on the exact surface, normals, side and material."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from raywalk.geometry.nearest import NOWHERE, to_local
from raywalk.geometry.solids import (
    DISC,
    PLANE,
    SPHERE,
    TRIANGLE,
    face_normal,
    height,
    is_at_edge,
    onto_surface,
    passed_face,
)
from raywalk.optics.compiled import kernel


class Looks(NamedTuple):
    """Materials of a scene's objects, and the checkers of its planes."""

    material: np.ndarray  # (objects,) int32
    checker: np.ndarray  # (objects,) int32: material of odd squares, -1 without a checker
    checker_size: np.ndarray  # (objects,)
    checker_turn: np.ndarray  # (objects,) +1 or -1: way of the second axis along canonical z


@kernel
def local_hit(primitives, k, o, d, t, again):
    """Canonical hit point of row k, moved onto the surface, and the outward gradient there.

    again: the ray started on this primitive, so it can only come out of it.
    """
    centre, matrix, shape = primitives.centre[k], primitives.to_local[k], primitives.shape[k]
    ox, oy, oz = to_local(matrix, o[0] - centre[0], o[1] - centre[1], o[2] - centre[2])
    dx, dy, dz = to_local(matrix, d[0], d[1], d[2])
    x, y, z = ox + t * dx, oy + t * dy, oz + t * dz
    if shape == PLANE:
        return x, 0.0, z, 0.0, 1.0, 0.0
    if shape == DISC or shape == TRIANGLE:
        return x, y, 0.0, 0.0, 0.0, 1.0
    if is_at_edge(shape, x, y, z):
        # A convex solid holds the middle of the way if and only if the ray comes out of it.
        half = 0.5 * t
        leaves = again or height(shape, ox + half * dx, oy + half * dy, oz + half * dz) < 0.0
        gx, gy, gz = passed_face(shape, x, y, z, dx, dy, dz, leaves)
    else:
        gx, gy, gz = face_normal(shape, x, y, z)
    x, y, z = onto_surface(shape, x, y, z, gx, gy, gz)
    if shape == SPHERE:
        gx, gy, gz = x, y, z
    return x, y, z, gx, gy, gz


@kernel
def outward(primitives, k, gx, gy, gz):
    """Unit world normal of a canonical gradient: gradients go by the transpose."""
    nx, ny, nz = to_local(primitives.to_local[k].T, gx, gy, gz)
    length = math.sqrt(nx * nx + ny * ny + nz * nz)
    return nx / length, ny / length, nz / length


@kernel
def square_material(looks, who, x, z):
    """Material of object `who` at a canonical point, which only a checker depends on."""
    odd = looks.checker[who]
    if odd < 0:
        return looks.material[who]
    size = looks.checker_size[who]
    cell = math.floor(x / size) + math.floor(z * looks.checker_turn[who] / size)
    return odd if cell % 2.0 == 1.0 else looks.material[who]


@kernel
def primitive_surface(
    primitives, looks, origin, direction, leaving, t, met, point, normal, inside, material
):
    """Fills point, normal (both (n, 3)), inside and material of the rays that met a primitive.

    The normal faces the incoming ray. Rows of rays that met nothing or a mesh stay as they are.
    """
    for i in range(origin.shape[0]):
        if met[i] == NOWHERE or primitives.row_of[met[i]] < 0:
            continue
        k = primitives.row_of[met[i]]
        x, y, z, gx, gy, gz = local_hit(
            primitives, k, origin[i], direction[i], t[i], leaving[i] == met[i]
        )
        px, py, pz = to_local(primitives.to_world[k], x, y, z)
        point[i, 0] = primitives.centre[k, 0] + px
        point[i, 1] = primitives.centre[k, 1] + py
        point[i, 2] = primitives.centre[k, 2] + pz
        nx, ny, nz = outward(primitives, k, gx, gy, gz)
        side = nx * direction[i, 0] + ny * direction[i, 1] + nz * direction[i, 2]
        inside[i] = side > 0.0
        sign = -1.0 if inside[i] else 1.0
        normal[i, 0], normal[i, 1], normal[i, 2] = sign * nx, sign * ny, sign * nz
        material[i] = square_material(looks, met[i], x, z)
