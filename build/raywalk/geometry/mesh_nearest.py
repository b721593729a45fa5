"""The nearest hit of rays on one mesh, from Embree's proposal to the settled hit, in place.

Rays that cross the mesh's box are gathered into packets, which Embree answers. What it names is
asked of float64 at once, and taken where float32 cannot have been wrong. The rest stays open and is
settled after all packets: among the neighbours of what was named, else by the float64 tree.
"""

from __future__ import annotations

import math

import numpy as np

from raywalk.geometry.bvh import bvh_nearest, start_error
from raywalk.geometry.float32_copy import GAP
from raywalk.geometry.mesh_packets import (
    GEOMETRY,
    ORIGIN,
    TOWARD,
    TRIANGLE,
    ask,
    new_packet,
)
from raywalk.geometry.mesh_rays import (
    is_clear,
    is_grazed,
    onto_plane,
    origin_bound,
    starts_clear,
)
from raywalk.geometry.mesh_sides import is_near, outline_hit
from raywalk.geometry.mesh_star import settled_in_star
from raywalk.geometry.roots import NOWHERE, SOMEWHERE
from raywalk.geometry.sides import TIE
from raywalk.geometry.triangle import dot, minus, shear, triangle_hit, triangle_normal, vector
from raywalk.optics.compiled import inlined, kernel, lean

# In the unit-sized copy, where float32 steps are 6e-8:
LIFT = 1e-6  # how far a ray that leaves the mesh starts off it for Embree
EARLIER = 2e-6  # how far before its origin any other ray starts
# In place of a triangle: Embree named none, or was not asked.
NONE, UNASKED = -1, -2


@kernel
def meet_mesh(mesh, origin, direction, leaving, on, limit, rank, t, met, triangle, uv):
    """Enters what rays meet on a mesh before `limit` (n,) where that comes first, in place: t (n,),
    met (n,), triangle (n,) and uv (n, 2) hold what they meet elsewhere.

    leaving, on: (n,) the object and triangle that a ray starts on; rank: (objects,) of surfaces
    that tie the lowest is met.
    """
    # Columns are taken out once, and helpers take numbers, or arrays without a loop or a branch of
    # their own: numba counts references to arrays it hands over, which costs more than the rest.
    index, corners, trusted, bvh, query = (
        mesh.object,
        mesh.corners,
        mesh.trusted,
        mesh.bvh,
        mesh.query,
    )
    low, high, centre, scale = mesh.low, mesh.high, mesh.centre, mesh.scale
    stands_for, closed, glass, bundle = mesh.stands_for, mesh.closed, mesh.glass, mesh.bundle
    query = mesh.query
    count, lanes = origin.shape[0], query.lanes
    rays, valid, how = new_packet(lanes)
    words = rays.view(np.int32)
    who, local = np.empty(lanes, np.int64), np.empty((lanes, 3))
    open_rays, named = np.empty(count, np.int64), np.empty(count, np.int32)
    filled = left = 0
    for i in range(count):
        own = on[i] if leaving[i] == index else np.int32(-1)
        o, d = minus(vector(origin, i), centre), vector(direction, i)
        side, n = 0.0, (0.0, 0.0, 0.0)
        if own >= 0:
            n = triangle_normal(corners, own)
            o = onto_plane(o, corners, own, n)
            side = LIFT if dot(n, d) > 0.0 else -LIFT
        reach = min(limit[i], t[i] * (1.0 + TIE))
        entry = enters(low, high, o, d, reach)
        crosses = entry < np.inf
        asked = own < 0 and leaving[i] != NOWHERE and (glass or leaving[i] == SOMEWHERE)
        if crosses and asked and is_near(bvh, corners, o, GAP / scale, -1):
            # It may touch the mesh, and float32 place it behind it.
            open_rays[left], named[left] = i, UNASKED
            left += 1
            crosses = False
        if crosses:
            if own >= 0:
                entry = 0.0
            else:
                entry -= EARLIER / (scale * math.sqrt(dot(d, d)))
            for k in range(3):
                local[filled, k] = o[k]
                rays[ORIGIN + k, filled] = (o[k] + entry * d[k]) * scale + side * n[k]
                rays[TOWARD + k, filled] = d[k]
            who[filled] = i
            filled += 1
        if filled == lanes or (filled > 0 and i == count - 1):
            ask(query, rays, valid, how, filled, bundle)
            left = decide(
                corners, trusted, stands_for, closed, index, words, who, filled, local, direction,
                leaving, on, limit, rank, open_rays, named, left, t, met, triangle, uv,
            )  # fmt: skip
            filled = 0
    settle_all(
        mesh, origin, direction, leaving, on, limit, rank, open_rays[:left], named,
        t, met, triangle, uv,
    )  # fmt: skip


@inlined
def enters(low, high, o, d, reach):
    """Where a ray enters a box with room to spare (0 if it starts inside), inf if it misses it
    before `reach` or is none: NaN passes every test, and costs Embree as much as hundreds of rays.

    low, high, o, d: three numbers each. A division an axis; what is 0 / 0 excludes nothing.
    """
    x, y, z = 1.0 / d[0], 1.0 / d[1], 1.0 / d[2]
    first, last = between((low[0] - o[0]) * x, (high[0] - o[0]) * x, 0.0, reach)
    first, last = between((low[1] - o[1]) * y, (high[1] - o[1]) * y, first, last)
    first, last = between((low[2] - o[2]) * z, (high[2] - o[2]) * z, first, last)
    length_sq = dot(d, d)
    is_ray = 0.0 < length_sq < np.inf and not np.isnan(o[0] + o[1] + o[2])
    # Four roundings, of rays from far away.
    return first if is_ray and first * (1.0 - 1e-15) <= last * (1.0 + 1e-15) else np.inf


@inlined
def between(a, b, first, last):
    """(first, last) cut to what lies between a and b, in either order."""
    near, far = (a, b) if a < b else (b, a)
    return (near if near > first else first), (far if far < last else last)


@lean
def decide(
    corners, trusted, stands_for, closed, index, words, who, filled, local, direction,
    leaving, on, limit, rank, open_rays, named, left, t, met, triangle, uv,
):  # fmt: skip
    """Takes what Embree names of a packet's rays where float32 cannot have been wrong; the others
    are added to the open rays, whose number is returned.

    who: (lanes,) the rays; local: (lanes, 3) their origins relative to the mesh's centre.
    """
    for lane in range(filled):
        i = who[lane]
        own = on[i] if leaving[i] == index else np.int32(-1)
        proposed = stands_for[words[TRIANGLE, lane]] if words[GEOMETRY, lane] >= 0 else np.int32(-1)
        o, d = vector(local, lane), vector(direction, i)
        # Of an open mesh a flat ray may meet something else, where float32 loses it.
        unseen = proposed < 0 and not closed
        if unseen or (own >= 0 and not starts_clear(corners, trusted, own, o)):
            open_rays[left], named[left] = i, proposed
            left += 1
            continue
        if proposed < 0:
            continue
        kx, ky, kz, sx, sy, sz = shear(d[0], d[1], d[2])
        found, u, v = triangle_hit(o, corners, proposed, kx, ky, kz, sx, sy, sz)
        clear = is_clear(trusted, proposed, u, v)
        if proposed == own or not clear or not found > 0.0 or is_grazed(corners, proposed, d):
            open_rays[left], named[left] = i, proposed
            left += 1
        elif found < min(limit[i], reach_of(t[i], met[i] >= 0 and rank[index] < rank[met[i]])):
            t[i], met[i], triangle[i], uv[i, 0], uv[i, 1] = found, index, proposed, u, v
    return left


@lean
def settle_all(
    mesh, origin, direction, leaving, on, limit, rank, open_rays, named, t, met, triangle, uv
):
    """Settles the rays that `decide` left open. named: (left,) what Embree named of each."""
    for place in range(open_rays.shape[0]):
        i = open_rays[place]
        own = on[i] if leaving[i] == mesh.object else np.int32(-1)
        reach = min(limit[i], t[i] * (1.0 + TIE))
        start, d = vector(origin, i), vector(direction, i)
        found, who, u, v = settle(mesh, start, d, own, reach, named[place])
        if who >= 0 and found < min(
            limit[i], reach_of(t[i], met[i] >= 0 and rank[mesh.object] < rank[met[i]])
        ):
            t[i], met[i], triangle[i], uv[i, 0], uv[i, 1] = found, mesh.object, who, u, v


@inlined
def settle(mesh, start, d, own, reach, named):
    """(t, triangle, u, v) of an open ray, for certain; triangle -1 if it meets none before `reach`.

    named: what Embree named.
    """
    bvh, corners, star = mesh.bvh, mesh.corners, mesh.star
    o = minus(start, mesh.centre)
    if own >= 0:
        o = onto_plane(o, corners, own, triangle_normal(corners, own))
    bound = origin_bound(o, mesh.centre) if own >= 0 or named == UNASKED else 0.0
    is_clear_start = own < 0 or starts_clear(corners, mesh.trusted, own, o)
    is_known = named >= 0 and named != own
    if is_clear_start and is_known and not is_grazed(corners, named, d):
        sheared, off = shear(d[0], d[1], d[2]), start_error(bvh, o, bound)
        t, who, u, v = settled_in_star(
            bvh, corners, star, mesh.glass, named, own, start, o, d, sheared, off, bound,
            mesh.scale,
        )  # fmt: skip
        if who >= 0:
            return t, who, u, v
    t, who, u, v, _ = bvh_nearest(bvh, corners, start, o, d, reach, own, bound)
    if who < 0:
        return t, who, u, v
    return outline_hit(bvh, corners, mesh.glass, start, o, d, own, bound, t, who, u, v)


@lean
def reach_of(t, wins_ties):
    """Below which distance a hit comes before one at t."""
    return (1.0 + TIE if wins_ties else 1.0 - TIE) * t
