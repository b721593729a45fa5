"""How far a float32 copy of a mesh, 1 in size, can be trusted, and how it is made safe.

Embree answers in float32: a ray may pass a vertex through a crack, a sliver may vanish, two
close surfaces may change places. So Embree is given triangles that are a little too large,
which leave no crack, and whatever it names is taken only where float32 cannot have been
wrong. Everything else goes to the float64 tree.
"""

from __future__ import annotations

import numpy as np

from raywalk.geometry.bvh import Bvh
from raywalk.geometry.triangle import dot, minus, shares_vertex
from raywalk.optics.compiled import kernel, lean

# Lengths in the unit-sized copy. Rounding a ray and a vertex to float32 moves a hit by up to
# 5e-7 across the ray: start and vertex 1e-7 each, direction 2e-7 after a way of 3.5, the rest
# is Embree's own arithmetic.
GROWN = 1e-5  # edges of Embree's triangles stand out by this: 20 errors, so grazing ones too
BORDER = 2e-5  # a hit closer to an edge may belong to a neighbour, or to its grown edge
GAP = 1e-5  # surfaces closer than this may be met in the wrong order
# The depth of a grazed triangle is wrong by 5e-7 / cosine: GAP tells it apart above this.
STEEPEST = 0.05
# A triangle whose corners would move further than this when grown is covered by a rectangle.
MITRE = 100.0 * GROWN

# Sine of an edge's bend from which on a neighbour's grown edge stops a ray that float32 moves past
# it: the ray is some 1e-7 over the edge and runs between both planes, so it meets one of their
# grown edges within 2e-7 / sine.
BENT = 0.03
FLAT = 1e-9  # below it no ray passes over the edge in a mesh's size
WALL = 3e-6  # half a wall's height: six errors


def covers(corners: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Float32 triangles (m, 3, 3) that cover the unit-sized ones with GROWN to spare, and
    whom (m,) each stands for. corners: (n, 3, 3); faces: (n, 3), their vertices."""
    grown, reach = _moved_edges(corners, GROWN)
    thin = np.flatnonzero(~(reach.max(axis=1) < MITRE))
    low, high = _rectangles(corners[thin])
    bare, side = bare_edges(corners, faces)
    fenced = ~np.isin(bare, thin)
    walls, owner = _walls(corners, grown, bare[fenced], side[fenced])
    around, thin_owner = _walls_round(corners[thin], low, high)
    grown[thin] = low
    triangles = np.concatenate([grown, high, walls, around]).astype(np.float32)
    whose = np.concatenate([np.arange(len(corners)), thin, owner, thin[thin_owner]])
    return triangles, whose.astype(np.int32)


def trusted_above(corners: np.ndarray, scale: float, bvh: Bvh) -> np.ndarray:
    """(n, 3) barycentric coordinates above which a hit that Embree names is certain.

    More than 1 where none is: on triangles too small, or too close to others.
    """
    ab, bc, ca = (corners[:, (k + 1) % 3] - corners[:, k] for k in range(3))
    area = np.linalg.norm(np.cross(ab, ca), axis=1)
    opposite = np.stack([np.linalg.norm(edge, axis=1) for edge in (bc, ca, ab)], axis=1)
    border = BORDER * opposite / (scale * area[:, None])
    core, _ = _moved_edges(corners, -BORDER / scale)
    alone = np.flatnonzero(border.sum(axis=1) < 1.0)
    border[alone[crowded(bvh, corners, core, alone, GAP / scale, True)]] = 2.0
    return border


def _moved_edges(corners: np.ndarray, by: float) -> tuple[np.ndarray, np.ndarray]:
    """Triangles with all edges moved outwards in their planes, and how far that moves each
    corner (n, 3): by (u + v) / sin(angle), for its edges' unit directions u and v."""
    moved, reach = np.empty_like(corners), np.empty(corners.shape[:2])
    with np.errstate(divide="ignore", invalid="ignore"):  # slivers have no angle left
        for k in range(3):
            one = corners[:, (k + 1) % 3] - corners[:, k]
            other = corners[:, (k + 2) % 3] - corners[:, k]
            one /= np.linalg.norm(one, axis=1, keepdims=True)
            other /= np.linalg.norm(other, axis=1, keepdims=True)
            sine = np.linalg.norm(np.cross(one, other), axis=1, keepdims=True)
            shift = by * (one + other) / sine
            moved[:, k] = corners[:, k] - shift
            reach[:, k] = np.linalg.norm(shift, axis=1)
    return moved, reach


def bare_edges(corners: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Triangle (e,) and side (e,) of the edges past which a grazing ray may slip: whose other side
    has no triangle, or several, or one that bends away by little or doubles back.

    A ray that float32 moves past such an edge by its error meets nothing behind it, or a
    neighbour's grown edge too far on. Where an edge bends more, that is met soon enough.
    """
    ends = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2), axis=2).reshape(-1, 2)
    # As one number each: numpy sorts pairs six times as slowly.
    edge = ends[:, 0].astype(np.int64) * (int(faces.max(initial=0)) + 1) + ends[:, 1]
    _, which, count = np.unique(edge, return_inverse=True, return_counts=True)
    bare = count[which] != 2
    order = np.argsort(which, kind="stable")
    pairs = order[~bare[order]].reshape(-1, 2)
    inwards = _inwards(corners).reshape(-1, 3)
    one, other = inwards[pairs[:, 0]], inwards[pairs[:, 1]]
    bend = np.linalg.norm(np.cross(one, other), axis=1)  # its sine
    away = (one * other).sum(axis=1) > 0.0
    bare[pairs[(bend < BENT) & ((bend > FLAT) | away), 0]] = True
    return np.divmod(np.flatnonzero(bare), 3)


def _inwards(corners: np.ndarray) -> np.ndarray:
    """(n, 3, 3) of each side the unit direction across it, into its triangle."""
    out = np.empty_like(corners)
    for k in range(3):
        along = corners[:, (k + 1) % 3] - corners[:, k]
        into = corners[:, (k + 2) % 3] - corners[:, k]
        share = (into * along).sum(axis=1) / (along * along).sum(axis=1)
        into = into - share[:, None] * along
        out[:, k] = into / np.linalg.norm(into, axis=1, keepdims=True)
    return out


def _walls(
    corners: np.ndarray, grown: np.ndarray, who: np.ndarray, side: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Upright strips along these grown edges, two triangles each, and whom each stands for.

    With them a triangle and its edges make a flat box round it: a ray within float32's error of
    one that meets the triangle crosses the triangle's cover or a wall.
    """
    a, b, c = corners[who].transpose(1, 0, 2)
    up = np.cross(b - a, c - a)
    up *= WALL / np.linalg.norm(up, axis=1, keepdims=True)
    start, end = grown[who, side], grown[who, (side + 1) % 3]
    return _strips(start, end, up), np.tile(who, 2)


def _walls_round(
    corners: np.ndarray, low: np.ndarray, high: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The same round the rectangles of thin triangles: their row here each."""
    a, b, c = corners.transpose(1, 0, 2)
    up = np.cross(b - a, c - a)
    up *= WALL / np.linalg.norm(up, axis=1, keepdims=True)
    ring = [low[:, 0], low[:, 1], low[:, 2], high[:, 2], low[:, 0]]
    strips = [_strips(ring[k], ring[k + 1], up) for k in range(4)]
    return np.concatenate(strips), np.tile(np.arange(len(corners)), 8)


def _strips(start: np.ndarray, end: np.ndarray, up: np.ndarray) -> np.ndarray:
    """(2 n, 3, 3) both halves of rectangles that stand up and down from n lines."""
    low, high = (
        np.stack([start - up, end - up, end + up], 1),
        np.stack([start - up, end + up, start + up], 1),
    )
    return np.concatenate([low, high])


def _rectangles(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Both halves of a rectangle round each triangle, along its longest edge."""
    edges = np.roll(corners, -1, axis=1) - corners
    longest = np.argmax(np.linalg.norm(edges, axis=2), axis=1)
    rows = np.arange(len(corners))
    start, along = corners[rows, longest], edges[rows, longest]
    length = np.linalg.norm(along, axis=1, keepdims=True)
    along = along / length
    up = corners[rows, (longest + 2) % 3] - start
    up = up - (up * along).sum(axis=1, keepdims=True) * along
    height = np.linalg.norm(up, axis=1, keepdims=True)
    up = up / height
    a = start - GROWN * (along + up)
    b, d = a + (length + 2 * GROWN) * along, a + (height + 2 * GROWN) * up
    c = b + d - a
    return np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)


@kernel
def crowded(bvh: Bvh, corners, core, asked, gap, by_neighbours):
    """Whether another triangle comes closer than gap to the core of each asked one, bool.

    by_neighbours: those that share a vertex with it count too.
    """
    answer = np.zeros(asked.shape[0], np.bool_)
    low, high = np.empty(3), np.empty(3)
    for i in range(asked.shape[0]):
        me = asked[i]
        for k in range(3):
            low[k] = min(core[me, 0, k], core[me, 1, k], core[me, 2, k]) - gap
            high[k] = max(core[me, 0, k], core[me, 1, k], core[me, 2, k]) + gap
        node = 0
        while node < len(bvh.skip) and not answer[i]:
            misses = False
            for k in range(3):
                misses |= bvh.low[node, k] > high[k] or bvh.high[node, k] < low[k]
            if misses:
                node = bvh.skip[node]
                continue
            for place in range(bvh.first[node], bvh.first[node] + bvh.held[node]):
                other = bvh.order[place]
                is_asked = other != me and (
                    by_neighbours or not shares_vertex(bvh.faces, me, other)
                )
                if is_asked and not apart(core[me], corners[other], gap):
                    answer[i] = True
            node += 1
    return answer


@lean
def apart(a, b, gap):
    """Whether a plane keeps two triangles gap apart: along their normals, or square to an edge.

    The separating axis test without its nine axes from edge to edge, which this use can do
    without: it errs to the safe side.
    """
    for one in (a, b):
        p, q, r = corner_of(one, 0), corner_of(one, 1), corner_of(one, 2)
        normal = cross(minus(q, p), minus(r, p))
        if gap_along(a, b, normal) > gap:
            return True
        for edge in (minus(q, p), minus(r, q), minus(p, r)):
            if gap_along(a, b, cross(edge, normal)) > gap:
                return True
    return False


@lean
def gap_along(a, b, axis):
    """Distance between two triangles' shadows on an axis; negative where they overlap.

    a, b: (3, 3); axis: three numbers, as an array would be made anew for each.
    """
    length = np.sqrt(dot(axis, axis))
    if length == 0.0:
        return -np.inf
    a_low = b_low = np.inf
    a_high = b_high = -np.inf
    start = corner_of(a, 0)
    for k in range(3):
        # From a's corner, so that a place far from the origin costs no digits.
        on_a, on_b = (
            dot(minus(corner_of(a, k), start), axis),
            dot(minus(corner_of(b, k), start), axis),
        )
        a_low, a_high = min(a_low, on_a), max(a_high, on_a)
        b_low, b_high = min(b_low, on_b), max(b_high, on_b)
    return max(b_low - a_high, a_low - b_high) / length


@lean
def corner_of(triangle, k):
    """Corner k of one triangle (3, 3) as three numbers."""
    return triangle[k, 0], triangle[k, 1], triangle[k, 2]


@lean
def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
