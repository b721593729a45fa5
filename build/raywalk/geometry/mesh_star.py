"""Hits close to an edge or a vertex, settled among the triangles that share a vertex there.

Embree's hit P is off by GROWN at most, as every triangle of its copy stands out by that. So what a
ray meets first lies close to P, or Embree would have named what lies before it; and of a triangle
that stands alone, only those that share a vertex with it come as close. If one of them is met,
exactly, close to P, that is the hit. If none is (the ray passes an outline), the tree must look on.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from raywalk.geometry.bvh import REPEATED, Bvh, met_before
from raywalk.geometry.float32_copy import crowded
from raywalk.geometry.mesh_sides import AT_EDGE, leaves, of_two
from raywalk.geometry.triangle import (
    corner,
    distance_sq_to,
    dot,
    has_vertex,
    height_over,
    minus,
    triangle_normal,
)
from raywalk.optics.compiled import inlined, kernel, lean

# In the unit-sized copy. On a triangle that is not grazed P is off by 1e-5 in depth, as STEEPEST
# has it, and a triangle that is met at Y is named by Embree within 2e-5 of Y: by its grown
# copy, a wall or a neighbour's grown edge. So Y is not further before P than 3e-5.
ASIDE = 2e-5  # P at most so far beside its triangle: at a sharp corner a grown copy reaches far
CLOSE = 4e-5  # the hit at most so far before or behind P
ALONE = 1e-4  # no other triangle comes so close to one that stands alone: the sum, and room


class Star(NamedTuple):
    """Who shares a vertex with whom."""

    # (triangles,) bool: only triangles that share a vertex with it come near it; (vertices,) bool:
    # only triangles that have it do.
    alone: np.ndarray
    vertex_alone: np.ndarray
    first: np.ndarray  # (vertices + 1,) int32: a vertex's first place in `around`
    around: np.ndarray  # (3 triangles,) int32: the triangles at each vertex


def star_of(bvh: Bvh, corners: np.ndarray, scale: float) -> Star:
    """Of a mesh's triangles (n, 3, 3); scale makes it 1 in size."""
    corner = bvh.faces.reshape(-1)
    order = np.argsort(corner, kind="stable")
    first = np.searchsorted(corner[order], np.arange(len(bvh.world) + 1))
    around = (order // 3).astype(np.int32)
    gap, every = ALONE / scale, np.arange(len(corners))
    alone = ~crowded(bvh, corners, corners, every, gap, False)
    return Star(alone, vertices_alone(bvh, corners, gap), first.astype(np.int32), around)


@kernel
def vertices_alone(bvh: Bvh, corners, gap):
    """(v,) bool: to which vertices only their own triangles come within the gap."""
    alone = np.zeros(bvh.world.shape[0], np.bool_)
    asked = np.zeros(bvh.world.shape[0], np.bool_)
    for me in range(corners.shape[0]):
        for c in range(3):
            vertex = bvh.faces[me, c]
            if not asked[vertex]:
                asked[vertex] = True
                alone[vertex] = is_vertex_alone(bvh, corners, vertex, corner(corners, me, c), gap)
    return alone


@lean
def is_vertex_alone(bvh, corners, vertex, place, gap):
    """Whether only triangles with this vertex come within the gap of its place."""
    node = 0
    while node < len(bvh.skip):
        misses = False
        for k in range(3):
            x = place[k]
            misses |= bvh.low[node, k] - gap > x or bvh.high[node, k] + gap < x
        if misses:
            node = bvh.skip[node]
            continue
        for spot in range(bvh.first[node], bvh.first[node] + bvh.held[node]):
            other = bvh.order[spot]
            if has_vertex(bvh.faces, other, vertex):
                continue
            if distance_sq_to(place, corners, other) <= gap * gap:
                return False
        node += 1
    return True


@lean
def nearest_in_star(bvh, corners, star, k, one, sense, own, start, o, d, sheared, off, bound, best):
    """Nearest hit up to t = best, then lowest, of the triangles that share a vertex with k: (t,
    triangle, u, v), and whether it is the only one there, but for rounding.

    one: the corner of k that they have, -1 if any; sense: 0, or of those alone that are left (1)
    or entered (-1).
    """
    faces, first, around = bvh.faces, star.first, star.around
    who, u, v, is_single = -1, 0.0, 0.0, True
    p, q = faces[k, 0], faces[k, 1]
    for c in range(max(one, 0), 3 if one < 0 else one + 1):
        vertex = faces[k, c]
        for place in range(first[vertex], first[vertex + 1]):
            triangle = around[place]
            if triangle == own:
                continue
            if one < 0 and c > 0 and has_vertex(faces, triangle, p):
                continue  # none of them twice
            if one < 0 and c > 1 and has_vertex(faces, triangle, q):
                continue
            if sense != 0 and leaves(corners, triangle, d) != (sense > 0):
                continue
            last = best * (1.0 + REPEATED)
            t, a, b = met_before(
                bvh, corners, triangle, own, start, o, d, sheared, off, bound, last
            )
            if t == np.inf:
                continue
            is_single = who < 0
            if t < best or (t == best and (who < 0 or triangle < who)):
                best, who, u, v = t, triangle, a, b
    return (best if who >= 0 else np.inf), who, u, v, is_single


@inlined
def settled_in_star(bvh, corners, star, glass, k, own, start, o, d, sheared, off, bound, scale):
    """(t, triangle, u, v) of the hit that Embree puts on triangle k, which is not grazed; triangle
    -1 if that does not tell. scale: makes the mesh 1 in size."""
    length = scale * math.sqrt(dot(d, d))
    nx, ny, nz = triangle_normal(corners, k)
    at = -height_over(o, corners, k) / (nx * d[0] + ny * d[1] + nz * d[2])
    place = (o[0] + at * d[0], o[1] + at * d[1], o[2] + at * d[2])
    one = lone_corner(bvh.faces, corners, star, k, place, CLOSE / scale)
    aside = ASIDE / scale
    if one < 0 and not (star.alone[k] and distance_sq_to(place, corners, k) <= aside * aside):
        return np.inf, -1, 0.0, 0.0
    t, who, u, v, is_single = nearest_in_star(
        bvh, corners, star, k, one, 0, own, start, o, d, sheared, off, bound, np.inf
    )
    if who < 0 or not abs(t - at) * length <= CLOSE:
        return np.inf, -1, 0.0, 0.0
    if is_single or min(u, min(v, 1.0 - u - v)) > AT_EDGE:
        return t, who, u, v
    if not REPEATED * t * length <= CLOSE:
        return np.inf, -1, 0.0, 0.0
    sense = -1 if leaves(corners, who, d) else 1
    _, other, a, b, _ = nearest_in_star(
        bvh, corners, star, k, one, sense, own, start, o, d, sheared, off, bound,
        t * (1.0 + REPEATED),
    )  # fmt: skip
    return of_two(corners, glass, o, d, t, (who, u, v), (other, a, b))


@lean
def lone_corner(faces, corners, star, k, place, close):
    """The corner of k that a place is this close to, if only triangles that have it are; or -1."""
    for c in range(3):
        away = minus(place, corner(corners, k, c))
        if dot(away, away) <= close * close:
            return c if star.vertex_alone[faces[k, c]] else -1
    return -1
