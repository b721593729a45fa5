"""Rays of one mesh: which float32 may have got wrong, and what float64 says of those."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.bvh import bvh_all, bvh_nearest
from raywalk.geometry.float32_copy import STEEPEST
from raywalk.geometry.mesh_sides import holds_ahead, is_near, leaves
from raywalk.geometry.sides import POINT_ERROR
from raywalk.geometry.triangle import (
    height_over,
    minus,
    shear,
    triangle_hit,
    triangle_normal,
    vector,
)
from raywalk.optics.compiled import kernel, lean

# Cosine below which rounding, far from the origin too, may take a ray through a face it runs along.
ALONG = 1e-9


@lean
def onto_plane(o, corners, k, n):
    """A start o moved onto the plane of the triangle k that it leaves, whose unit normal is n.

    Far from the origin a world point is off its triangle by 1e-16 of that distance. A ray that
    leaves flatly from so far below would run on inside, and meet a neighbour from behind.
    """
    height = height_over(o, corners, k)
    return o[0] - height * n[0], o[1] - height * n[1], o[2] - height * n[2]


@lean
def is_clear(trusted, k, u, v):
    """Whether a place on triangle k is far enough from its edges, and from other triangles."""
    return 1.0 - u - v > trusted[k, 0] and u > trusted[k, 1] and v > trusted[k, 2]


@lean
def is_grazed(corners, k, d):
    """Whether a direction runs so flat along triangle k that float32 loses the depth of a hit."""
    nx, ny, nz = triangle_normal(corners, k)
    along = nx * d[0] + ny * d[1] + nz * d[2]
    return along * along < STEEPEST * STEEPEST * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2])


@lean
def is_along(corners, k, d):
    """Whether a direction runs along triangle k but for rounding."""
    nx, ny, nz = triangle_normal(corners, k)
    return abs(nx * d[0] + ny * d[1] + nz * d[2]) <= ALONG


@lean
def starts_clear(corners, trusted, k, at):
    """Whether a point of triangle k lies where nothing else is so close that LIFT could skip it."""
    nx, ny, nz = triangle_normal(corners, k)
    kx, ky, kz, sx, sy, sz = shear(nx, ny, nz)
    _, u, v = triangle_hit(at, corners, k, kx, ky, kz, sx, sy, sz)  # straight down on its plane
    return is_clear(trusted, k, u, v)


@lean
def origin_bound(o, centre):
    """How far a ray's origin, relative to the mesh's centre, may be off the surface it is on."""
    reach = abs(o[0]) + abs(o[1]) + abs(o[2])
    return POINT_ERROR * (reach + 2.0 * (abs(centre[0]) + abs(centre[1]) + abs(centre[2])))


@kernel
def doubtful(bvh, corners, centre, trusted, origin, direction, own, error):
    """Indices of the rays that start this close to a triangle other than their own, or along
    their own."""
    asked, filled = np.empty(origin.shape[0], np.int64), 0
    for i in range(origin.shape[0]):
        o = (origin[i, 0] - centre[0], origin[i, 1] - centre[1], origin[i, 2] - centre[2])
        flat = own[i] >= 0 and is_along(corners, own[i], vector(direction, i))
        if not flat and own[i] >= 0 and starts_clear(corners, trusted, own[i], o):
            continue
        if flat or is_near(bvh, corners, o, error[i], own[i]):
            asked[filled] = i
            filled += 1
    return asked[:filled]


@kernel
def next_leaves(corners, triangle, direction):
    """(n,) bool: whether rays pass the triangle they meet next outwards; not if they meet none."""
    answer = np.zeros(triangle.shape[0], np.bool_)
    for i in range(triangle.shape[0]):
        if triangle[i] >= 0:
            answer[i] = leaves(corners, triangle[i], vector(direction, i))
    return answer


@kernel
def in_any_shell(bvh, corners, centre, origin, direction, own):
    """(n,) bool: whether rays are in a mesh of several layers, just beyond their origins."""
    answer = np.zeros(origin.shape[0], np.bool_)
    for i in range(origin.shape[0]):
        o, d = minus(vector(origin, i), centre), vector(direction, i)
        if own[i] >= 0:
            o = onto_plane(o, corners, own[i], triangle_normal(corners, own[i]))
        answer[i] = holds_ahead(bvh, corners, o, d, own[i], origin_bound(o, centre))
    return answer


@kernel
def every_hit(bvh, corners, origin, local, direction):
    """All hits of each ray: index (h,) and t (h,), nearest first."""
    found, entering = np.empty(corners.shape[0]), np.empty(corners.shape[0], np.bool_)
    total = 0
    for i in range(local.shape[0]):
        start, o, d = vector(origin, i), vector(local, i), vector(direction, i)
        total += bvh_all(bvh, corners, start, o, d, found, entering)
    ray, t = np.empty(total, np.int32), np.empty(total)
    filled = 0
    for i in range(local.shape[0]):
        start, o, d = vector(origin, i), vector(local, i), vector(direction, i)
        n = bvh_all(bvh, corners, start, o, d, found, entering)
        ray[filled : filled + n], t[filled : filled + n] = i, found[:n]
        filled += n
    return ray, t


@kernel
def tests_made(bvh, corners, origin, local, direction, t_max, own, bound):
    """Boxes and triangles tested per ray."""
    tests = np.empty(local.shape[0], np.int32)
    for i in range(local.shape[0]):
        at_surface = bound if own[i] >= 0 else 0.0
        _, _, _, _, tests[i] = bvh_nearest(
            bvh, corners, vector(origin, i), vector(local, i), vector(direction, i), t_max[i],
            own[i], at_surface,
        )  # fmt: skip
    return tests
