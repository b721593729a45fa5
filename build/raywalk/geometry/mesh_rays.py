"""Rays of one mesh: which float32 may have got wrong, and what float64 says of those."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.bvh import box_entry, bvh_all, bvh_nearest
from raywalk.geometry.float32_copy import STEEPEST
from raywalk.geometry.mesh_sides import holds_ahead, is_near, leaves, outline_hit
from raywalk.geometry.sides import POINT_ERROR
from raywalk.geometry.triangle import height_over, shear, triangle_hit, triangle_normal, vector
from raywalk.optics.compiled import kernel

# In the unit-sized copy, where float32 steps are 6e-8:
LIFT = 1e-6  # how far a ray that leaves the mesh starts off it for Embree
EARLIER = 2e-6  # how far before its origin any other ray starts
# Cosine below which rounding, far from the origin too, may take a ray through a face it runs along.
ALONG = 1e-9


@kernel
def enter_box(bvh, roomy, corners, centre, scale, origin, direction, t_max, own, local, starts):
    """Indices of the rays that cross the mesh's box before t_max.

    Fills local (n, 3), origins relative to the mesh's centre and, of rays that leave a triangle,
    on its plane; and starts (crossing, 3), where
    Embree's ray begins in the unit-sized copy: just off the triangle it leaves, else a little
    before its origin or where it enters `roomy` (2, 1, 3), the box with ROOM around it, so that
    rounding takes it behind no triangle and no wall.
    """
    crossing = np.empty(origin.shape[0], np.int64)
    filled = 0
    for i in range(origin.shape[0]):
        for k in range(3):
            local[i, k] = origin[i, k] - centre[k]
        if own[i] >= 0:
            onto_plane(corners, own[i], local, i)
        o, d = vector(local, i), vector(direction, i)
        length_sq = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
        # NaN passes every box test, and costs Embree as much as hundreds of other rays.
        if not 0.0 < length_sq < np.inf or np.isnan(o[0] + o[1] + o[2]):
            continue
        entry = box_entry(bvh.low, bvh.high, 0, o, d, t_max[i])
        if not entry < np.inf:
            continue
        side, n = 0.0, (0.0, 0.0, 0.0)
        if own[i] >= 0:
            n = triangle_normal(corners, own[i])
            side = LIFT if n[0] * d[0] + n[1] * d[1] + n[2] * d[2] > 0.0 else -LIFT
        else:
            entry = box_entry(roomy[0], roomy[1], 0, o, d, np.inf)
            entry -= EARLIER / (scale * np.sqrt(length_sq))
        for k in range(3):
            starts[filled, k] = (o[k] + entry * d[k]) * scale + side * n[k]
        crossing[filled] = i
        filled += 1
    return crossing[:filled]


@kernel
def onto_plane(corners, k, local, i):
    """Moves a start local[i] onto the plane of the triangle k that it leaves.

    Far from the origin a world point is off its triangle by 1e-16 of that distance. A ray that
    leaves flatly from so far below would run on inside, and meet a neighbour from behind.
    """
    height = height_over(vector(local, i), corners, k)
    nx, ny, nz = triangle_normal(corners, k)
    local[i, 0] -= height * nx
    local[i, 1] -= height * ny
    local[i, 2] -= height * nz


@kernel
def decide(
    corners, trusted, closed, local, direction, t_max, own, touching, crossing, proposed,
    t, triangle, uv,
):  # fmt: skip
    """Takes the proposals that float32 cannot have got wrong; returns the rays left open.

    closed: of an open mesh a ray that runs flat along it may meet nothing else, where float32 loses
    it. trusted: (triangles, 3) barycentric coordinates above which a hit is certain; touching: (n,)
    whether a ray starts so close to the mesh that float32 may place it behind it.
    """
    redo = np.empty(crossing.shape[0], np.int64)
    open_cases = 0
    for place in range(crossing.shape[0]):
        i, who = crossing[place], proposed[place]
        o, d = vector(local, i), vector(direction, i)
        unseen = who < 0 and not closed
        if unseen or touching[i] or (own[i] >= 0 and not starts_clear(corners, trusted, own[i], o)):
            redo[open_cases] = i
            open_cases += 1
            continue
        if who < 0:
            continue
        kx, ky, kz, sx, sy, sz = shear(d[0], d[1], d[2])
        distance, u, v = triangle_hit(o, corners, who, kx, ky, kz, sx, sy, sz)
        clear = is_clear(trusted, who, u, v)
        if who == own[i] or not clear or not distance > 0.0 or is_grazed(corners, who, d):
            redo[open_cases] = i
            open_cases += 1
        elif distance < t_max[i]:
            t[i], triangle[i], uv[i, 0], uv[i, 1] = distance, who, u, v
    return redo[:open_cases]


@kernel
def is_clear(trusted, k, u, v):
    """Whether a place on triangle k is far enough from its edges, and from other triangles."""
    return 1.0 - u - v > trusted[k, 0] and u > trusted[k, 1] and v > trusted[k, 2]


@kernel
def is_grazed(corners, k, d):
    """Whether a direction runs so flat along triangle k that float32 loses the depth of a hit."""
    nx, ny, nz = triangle_normal(corners, k)
    along = nx * d[0] + ny * d[1] + nz * d[2]
    return along * along < STEEPEST * STEEPEST * (d[0] * d[0] + d[1] * d[1] + d[2] * d[2])


@kernel
def is_along(corners, k, d):
    """Whether a direction runs along triangle k but for rounding."""
    nx, ny, nz = triangle_normal(corners, k)
    return abs(nx * d[0] + ny * d[1] + nz * d[2]) <= ALONG


@kernel
def starts_clear(corners, trusted, k, at):
    """Whether a point of triangle k lies where nothing else is so close that LIFT could skip it."""
    nx, ny, nz = triangle_normal(corners, k)
    kx, ky, kz, sx, sy, sz = shear(nx, ny, nz)
    _, u, v = triangle_hit(at, corners, k, kx, ky, kz, sx, sy, sz)  # straight down on its plane
    return is_clear(trusted, k, u, v)


@kernel
def origin_bound(o, centre):
    """How far a ray's origin, relative to the mesh's centre, may be off the surface it is on."""
    reach = abs(o[0]) + abs(o[1]) + abs(o[2])
    return POINT_ERROR * (reach + 2.0 * (abs(centre[0]) + abs(centre[1]) + abs(centre[2])))


@kernel
def redo_in_float64(
    bvh,
    corners,
    centre,
    glass,
    origin,
    local,
    direction,
    t_max,
    own,
    touching,
    redo,
    t,
    triangle,
    uv,
):
    """Traces rays again in the float64 tree and overwrites their results."""
    for i in redo:
        o, d, bound = vector(local, i), vector(direction, i), 0.0
        if own[i] >= 0 or touching[i]:
            bound = origin_bound(o, centre)
        start = vector(origin, i)
        distance, who, u, v, _ = bvh_nearest(bvh, corners, start, o, d, t_max[i], own[i], bound)
        if who >= 0:
            distance, who, u, v = outline_hit(
                bvh, corners, glass, start, o, d, own[i], bound, distance, who, u, v
            )
        t[i], triangle[i], uv[i, 0], uv[i, 1] = distance, who, u, v


@kernel
def start_close(bvh, corners, centre, origin, asked, radius):
    """(n,) bool: which of the asked points lie this close to a mesh."""
    close = np.zeros(origin.shape[0], np.bool_)
    for i in range(origin.shape[0]):
        if asked[i]:
            o = (origin[i, 0] - centre[0], origin[i, 1] - centre[1], origin[i, 2] - centre[2])
            close[i] = is_near(bvh, corners, o, radius, -1)
    return close


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
    local = np.empty((1, 3))
    for i in range(origin.shape[0]):
        for k in range(3):
            local[0, k] = origin[i, k] - centre[k]
        if own[i] >= 0:
            onto_plane(corners, own[i], local, 0)
        o, d = vector(local, 0), vector(direction, i)
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
