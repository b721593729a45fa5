"""A float64 bounding-volume tree over triangles: the judge where float32 Embree cannot be.

Wide enough boxes and a watertight triangle test leave no hole, at vertices and edges
either; it also gives all hits along a ray and counts the tests a ray made.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.geometry.exact_triangle import exact_hit
from raywalk.geometry.triangle import (
    distance_sq_to,
    height_over,
    shear,
    sided_hit,
    triangle_hit,
    triangle_normal,
    vector,
)
from raywalk.optics.compiled import inlined, kernel, lean

LEAF = 4  # triangles in a leaf at most
STACK = 64  # while it is built; median splits halve: 2^64 triangles would fit
# A ray leaves the triangles in whose planes, but for the error bound, it starts: those closer than
# this many bounds, and those that continue its own face, up to this cosine. Between them they
# hold all neighbours: the planes of others part by more than the bound within that distance.
NEAR, PARALLEL = 1000.0, 1.0 - 1e-6
ON = 4.0  # error bounds: a point this close to a triangle is on it
REPEATED = 1e-12  # share of t by which the hits of neighbours on their common edge differ at most


class Bvh(NamedTuple):
    """Nodes in depth-first order, so a ray walks them without a stack: into a node, to its first
    child, which follows it, or to the next triangles; past it, to `skip`."""

    low: np.ndarray  # (nodes, 3)
    high: np.ndarray  # (nodes, 3)
    skip: np.ndarray  # (nodes,) int32: what follows all that is in it; of a first child the second
    first: np.ndarray  # (nodes,) int32: a leaf's first place in `order`
    held: np.ndarray  # (nodes,) int32: its triangles, 0 for an inner node
    order: np.ndarray  # (triangles,) int32: triangle ids, leaf by leaf
    # Where rounding would decide, the world's vertices do.
    faces: np.ndarray  # (triangles, 3) int64
    world: np.ndarray  # (vertices, 3)
    world_rest: np.ndarray  # (vertices, 3) what float64 leaves over of them
    off: float  # how far the corners that queries use may be off them


@kernel
def build_bvh(corners):
    """Bvh by median splits along the widest side of the centroids. corners: (n, 3, 3)."""
    n = corners.shape[0]
    nodes = max(1, 2 * n)
    low, high = np.full((nodes, 3), np.inf), np.full((nodes, 3), -np.inf)
    second = np.full(nodes, -1, np.int32)
    first, count = np.zeros(nodes, np.int32), np.zeros(nodes, np.int32)
    order = np.arange(n).astype(np.int32)
    centroid = (corners[:, 0] + corners[:, 1] + corners[:, 2]) / 3.0
    begin, end = np.zeros(STACK, np.int32), np.zeros(STACK, np.int32)
    parent = np.full(STACK, -1, np.int32)
    end[0], depth, made = n, 1, 0
    while depth > 0:
        depth -= 1
        a, b, node = begin[depth], end[depth], made
        made += 1
        if parent[depth] >= 0:
            second[parent[depth]] = node
        enclose(corners, order[a:b], low[node], high[node])
        if b - a <= LEAF:
            first[node], count[node] = a, b - a
            continue
        axis = widest_axis(centroid, order[a:b])
        order[a:b] = order[a:b][np.argsort(centroid[order[a:b], axis], kind="mergesort")]
        middle = (a + b) // 2
        begin[depth], end[depth], parent[depth] = middle, b, node
        begin[depth + 1], end[depth + 1], parent[depth + 1] = a, middle, -1
        depth += 2
    skip = np.full(made, made, np.int32)
    for node in range(made):
        if second[node] >= 0:
            skip[node + 1], skip[second[node]] = second[node], skip[node]
    return low[:made], high[:made], skip, first[:made], count[:made], order


@lean
def enclose(corners, members, low, high):
    """Box of some triangles, widened by a few roundings so that its test never cuts a hit off."""
    for m in members:
        for c in range(3):
            for k in range(3):
                low[k] = min(low[k], corners[m, c, k])
                high[k] = max(high[k], corners[m, c, k])
    for k in range(3):
        slack = 1e-14 * max(abs(low[k]), abs(high[k]))  # 50 roundings; costs no speed
        low[k] -= slack
        high[k] += slack


@lean
def widest_axis(centroid, members):
    """Axis along which the members' centroids spread most."""
    best, widest = 0, -1.0
    for k in range(3):
        smallest, largest = np.inf, -np.inf
        for m in members:
            smallest = min(smallest, centroid[m, k])
            largest = max(largest, centroid[m, k])
        if largest - smallest > widest:
            best, widest = k, largest - smallest
    return best


@lean
def box_entry(low, high, node, o, d, t_max):
    """Where a ray enters a node's box (0 if it starts inside); inf if it misses it before t_max.

    low, high: (nodes, 3); o, d: three numbers each.
    """
    t_in, t_out = 0.0, t_max
    for k in range(3):
        if d[k] == 0.0:
            if o[k] < low[node, k] or o[k] > high[node, k]:
                return np.inf
            continue
        a, b = (low[node, k] - o[k]) / d[k], (high[node, k] - o[k]) / d[k]
        if a > b:
            a, b = b, a
        # Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013: two ulps keep it watertight.
        t_in, t_out = max(t_in, a - 4.5e-16 * abs(a)), min(t_out, b + 4.5e-16 * abs(b))
    return t_in if t_in <= t_out else np.inf


@lean
def start_error(bvh, o, bound):
    """How far a ray's origin and the corners may be off their places in the world, together."""
    return bvh.off + bound + 2.3e-16 * max(abs(o[0]), max(abs(o[1]), abs(o[2])))


@lean
def settled_hit(bvh, k, start, d, known, error):
    """`triangle_hit` of triangle k decided exactly; known, error: as `sided_hit` gave them."""
    a, b, c = bvh.faces[k, 0], bvh.faces[k, 1], bvh.faces[k, 2]
    return exact_hit(
        start, d, vector(bvh.world, a), vector(bvh.world_rest, a), vector(bvh.world, b),
        vector(bvh.world_rest, b), vector(bvh.world, c), vector(bvh.world_rest, c),
        known, error,
    )  # fmt: skip


@lean
def bvh_nearest(bvh, corners, start, o, d, t_max, own, bound):
    """Nearest hit of one ray: (t, triangle, u, v, tests); triangle -1 if none before t_max.

    start: the ray's origin in the world, o: as the corners are; own: triangle the ray starts on,
    else -1: onto its plane `o` was moved, off which `start` may be, and decides alone; bound: how
    far its origin may be off the surface it starts on (`is_left` says which triangles are left
    then, not hit).
    tests counts boxes and triangles. Ties go to the lowest triangle.
    """
    sheared, off = shear(d[0], d[1], d[2]), start_error(bvh, o, bound)
    node, tests = 0, 0
    best, who, u, v = t_max, -1, 0.0, 0.0
    while node < len(bvh.skip):
        tests += 1
        if box_entry(bvh.low, bvh.high, node, o, d, best) == np.inf:
            node = bvh.skip[node]
        else:
            for place in range(bvh.first[node], bvh.first[node] + bvh.held[node]):
                triangle = bvh.order[place]
                tests += 1
                if triangle == own:
                    continue
                t, a, b = met_before(
                    bvh, corners, triangle, own, start, o, d, sheared, off, bound, best
                )
                if t == np.inf or (t == best and not (0 <= who and triangle < who)):
                    continue
                best, who, u, v = t, triangle, a, b
            node += 1
    return (best if who >= 0 else np.inf), who, u, v, tests


@inlined
def met_before(bvh, corners, triangle, own, start, o, d, sheared, off, bound, best):
    """(t, u, v) of one ray and one triangle with 0 < t <= best, else t is inf: decided exactly
    where rounding would decide. Arguments as in `bvh_nearest`; off: what `start_error` gave."""
    t, u, v, sure, error = sided_hit(o, corners, triangle, sheared, off)
    if not sure and own >= 0:
        t, u, v = triangle_hit(o, corners, triangle, *sheared)
    elif not sure:
        t, u, v = settled_hit(bvh, triangle, start, d, (t, u, v), error)
    if not 0.0 < t <= best:
        return np.inf, 0.0, 0.0
    if bound > 0.0 and is_left(corners, triangle, own, o, d, t, bound):
        return np.inf, 0.0, 0.0
    return t, u, v


@lean
def is_left(corners, triangle, own, o, d, t, bound):
    """Whether a ray that starts at o, on the mesh, starts on this triangle or in its face, and is
    said to meet it at t by rounding only."""
    if abs(height_over(o, corners, triangle)) > bound:
        return False
    if own >= 0:
        ax, ay, az = triangle_normal(corners, own)
        bx, by, bz = triangle_normal(corners, triangle)
        if abs(ax * bx + ay * by + az * bz) > PARALLEL:
            return True
    if distance_sq_to(o, corners, triangle) <= (NEAR * bound) ** 2:
        return True
    # Far off in its plane: seen edge-on, it may be met where it is not.
    met = (o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2])
    return distance_sq_to(met, corners, triangle) > (ON * bound) ** 2


@lean
def bvh_all(bvh, corners, start, o, d, found, entering):
    """All hits of one ray with t > 0, nearest first; returns their number.

    Fills found (t) and entering (bool: against the triangle's normal), with room for one hit
    a triangle. A ray through an edge or vertex meets all triangles there; those it passes in
    the same sense are one hit.
    """
    sheared, off = shear(d[0], d[1], d[2]), start_error(bvh, o, 0.0)
    node, filled = 0, 0
    while node < len(bvh.skip):
        if box_entry(bvh.low, bvh.high, node, o, d, np.inf) == np.inf:
            node = bvh.skip[node]
        else:
            for place in range(bvh.first[node], bvh.first[node] + bvh.held[node]):
                triangle = bvh.order[place]
                t, a, b, sure, error = sided_hit(o, corners, triangle, sheared, off)
                if not sure:
                    t, _, _ = settled_hit(bvh, triangle, start, d, (t, a, b), error)
                if 0.0 < t < np.inf:
                    nx, ny, nz = triangle_normal(corners, triangle)
                    insert(found, entering, filled, t, nx * d[0] + ny * d[1] + nz * d[2] < 0.0)
                    filled += 1
            node += 1
    return without_repeats(found, entering, filled)


@lean
def insert(found, entering, filled, t, enters):
    """Puts a hit in its place among those found before."""
    place = filled
    while place > 0 and found[place - 1] > t:
        found[place], entering[place] = found[place - 1], entering[place - 1]
        place -= 1
    found[place], entering[place] = t, enters


@lean
def without_repeats(found, entering, filled):
    """Drops hits in the same sense as the one before and, but for rounding, in its place."""
    kept = 0
    for k in range(filled):
        again = kept > 0 and entering[k] == entering[kept - 1]
        if again and found[k] - found[kept - 1] <= REPEATED * found[k]:
            continue
        found[kept], entering[kept] = found[k], entering[k]
        kept += 1
    return kept
