"""On which side of a closed mesh a ray is: at its edges, and where it touches something else."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.bvh import REPEATED, box_entry, is_left, met_before, start_error
from raywalk.geometry.triangle import (
    distance_sq_to,
    shear,
    solid_angle,
    triangle_hit,
    triangle_normal,
)
from raywalk.optics.compiled import lean

# Hits closer to an edge than this barycentric share are asked whether they tie with a neighbour's.
AT_EDGE = 1e-6


@lean
def is_near(bvh, corners, o, radius, own):
    """Whether a triangle other than `own` comes as close to a point as this."""
    node = 0
    while node < len(bvh.skip):
        apart = False
        for k in range(3):
            apart |= o[k] < bvh.low[node, k] - radius or o[k] > bvh.high[node, k] + radius
        if apart:
            node = bvh.skip[node]
        else:
            for place in range(bvh.first[node], bvh.first[node] + bvh.held[node]):
                triangle = bvh.order[place]
                if triangle != own and distance_sq_to(o, corners, triangle) <= radius * radius:
                    return True
            node += 1
    return False


@lean
def closest_triangle(corners, o):
    """The triangle closest to a point, and its squared distance from it."""
    best, square = -1, np.inf
    for k in range(corners.shape[0]):
        away = distance_sq_to(o, corners, k)
        if away < square:
            best, square = k, away
    return best, square


@lean
def is_around(corners, o):
    """Whether a closed mesh goes round a point."""
    return turns_round(corners, o) > 0.5


@lean
def turns_round(corners, o):
    """How often a closed mesh goes round a point: the sum of its triangles' solid angles."""
    turns = 0.0
    for k in range(corners.shape[0]):
        turns += solid_angle(o, corners, k)
    return turns


@lean
def outline_hit(bvh, corners, glass, start, o, d, own, bound, t, who, u, v):
    """The hit itself, or the one that ties with it at an edge where a front face meets a back
    face, with the t of the nearer: (t, triangle, u, v)."""
    if min(u, min(v, 1.0 - u - v)) > AT_EDGE:
        return t, who, u, v
    whose, a, b = tied_across(bvh, corners, start, o, d, own, bound, t, who)
    return of_two(corners, glass, o, d, t, (who, u, v), (whose, a, b))


@lean
def of_two(corners, glass, o, d, t, one, other):
    """Of two hits that tie at an outline the one that is seen: (t, triangle, u, v); other may be
    none, its triangle -1.

    Seen from outside an outline shows its front face, from inside its back face. Only glass is
    looked at from inside.
    """
    if other[0] < 0:
        return t, one[0], one[1], one[2]
    inside = False
    if glass:
        half = 0.5 * t
        inside = is_around(corners, (o[0] + half * d[0], o[1] + half * d[1], o[2] + half * d[2]))
    if leaves(corners, one[0], d) == inside:
        return t, one[0], one[1], one[2]
    return t, other[0], other[1], other[2]


@lean
def tied_across(bvh, corners, start, o, d, own, bound, t, who):
    """Of the triangles that a ray passes in the other sense than `who`, but for rounding in the
    same place, the nearest, then lowest: (triangle, u, v); triangle -1 if there is none."""
    sheared, off = shear(d[0], d[1], d[2]), start_error(bvh, o, bound)
    node = 0
    sense = leaves(corners, who, d)
    best, found, u, v = t * (1.0 + REPEATED), -1, 0.0, 0.0
    while node < len(bvh.skip):
        if box_entry(bvh.low, bvh.high, node, o, d, best) == np.inf:
            node = bvh.skip[node]
        else:
            for place in range(bvh.first[node], bvh.first[node] + bvh.held[node]):
                triangle = bvh.order[place]
                if triangle == own or leaves(corners, triangle, d) == sense:
                    continue
                distance, a, b = met_before(
                    bvh, corners, triangle, own, start, o, d, sheared, off, bound, best
                )
                if distance == np.inf or (distance == best and 0 <= found <= triangle):
                    continue
                best, found, u, v = distance, triangle, a, b
            node += 1
    return found, u, v


@lean
def leaves(corners, triangle, d):
    """Whether a ray passes a triangle along its normal: out of the mesh."""
    nx, ny, nz = triangle_normal(corners, triangle)
    return nx * d[0] + ny * d[1] + nz * d[2] > 0.0


@lean
def holds_ahead(bvh, corners, o, d, own, bound):
    """Whether a ray is in a mesh just beyond its start whose closed shells lie in one another or
    overlap: it is while it leaves shells more often than it enters them on its way out.

    A hit close to an edge may be counted for one triangle or two: then the mesh's turns round a
    place halfway to the next hit are counted.
    """
    kx, ky, kz, sx, sy, sz = shear(d[0], d[1], d[2])
    node, count, nearest, in_doubt = 0, 0, np.inf, False
    while node < len(bvh.skip):
        if box_entry(bvh.low, bvh.high, node, o, d, np.inf) == np.inf:
            node = bvh.skip[node]
        else:
            for place in range(bvh.first[node], bvh.first[node] + bvh.held[node]):
                triangle = bvh.order[place]
                t, u, v = triangle_hit(o, corners, triangle, kx, ky, kz, sx, sy, sz)
                if not 0.0 < t < np.inf or triangle == own:
                    continue
                if bound > 0.0 and is_left(corners, triangle, own, o, d, t, bound):
                    continue
                count += 1 if leaves(corners, triangle, d) else -1
                nearest = min(nearest, t)
                in_doubt |= min(u, min(v, 1.0 - u - v)) <= AT_EDGE
            node += 1
    if nearest == np.inf or not in_doubt:
        return count > 0
    half = 0.5 * nearest
    return is_around(corners, (o[0] + half * d[0], o[1] + half * d[1], o[2] + half * d[2]))
