"""The nearest primitive along each ray, and all of them in order."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.blocks import (
    BEST,
    BLOCK,
    BLOCK_SIZE,
    CONES,
    DX,
    DY,
    DZ,
    GROUPS,
    MET,
    NEAR,
    OX,
    OY,
    OZ,
    WORD,
    fill_block,
    find_cones,
    list_marked,
    mark_candidates,
)
from raywalk.geometry.candidates import MOST, ROOT, TABLE, find_roots
from raywalk.geometry.faces import PLANE, SPHERE
from raywalk.geometry.meeting import meet_plane, meet_sphere
from raywalk.geometry.roots import CLOSE, NOWHERE, lies_on, passes_by, settled_roots
from raywalk.geometry.sphere_tree import DEPTH, WIDE, candidates_in_tree, put_in_order
from raywalk.optics.compiled import inlined, kernel, lean


@kernel
def nearest_primitive(primitives, origin, direction, leaving, inner, t_max):
    """Nearest primitive of n rays; ties go to the first row.

    Two surfaces tie where the nearer hit lies on the other surface too, but for rounding:
    coplanar faces do not flicker.

    origin, direction: (n, 3); leaving: (n,) object a ray starts on, or NOWHERE;
    inner: (n,) whether it leaves to that object's inner side; t_max: (n,) where to stop.
    Returns t (n,) float64, inf where nothing is met before t_max, and object (n,) int32.
    """
    count = origin.shape[0]
    t, met = np.empty(count), np.empty(count, np.int32)
    block, cones, table = np.empty(BLOCK_SIZE), np.empty(CONES), np.empty(TABLE)
    marks, near = np.empty(BLOCK, np.uint8), np.empty(GROUPS, np.uint8)
    words = marks.view(np.uint64)
    columns, rows = np.empty(MOST + 1, np.int64), np.empty(MOST, np.int64)
    # Columns taken out once: handed over in the loop the table costs more than the arithmetic.
    c, m, reach_sq = primitives.centre, primitives.to_local, primitives.reach_sq
    who, stretch = primitives.object, primitives.stretch
    for first in range(0, count, BLOCK):
        size, listed = min(BLOCK, count - first), 0
        fill_block(block, origin, direction, leaving, inner, t_max, first, size)
        is_any_narrow = find_cones(block, cones)
        for k in range(reach_sq.shape[0]):
            code = primitives.shape[k].code
            is_met_here = code == PLANE or code == SPHERE
            if listed > MOST - BLOCK or (is_met_here and listed > 0):
                keep_nearest(primitives, table, block, columns, rows, listed)
                listed = 0
            if code == PLANE:
                if meet_plane(
                    block, who[k], c[k, 0], c[k, 1], c[k, 2],
                    m[k, 1, 0], m[k, 1, 1], m[k, 1, 2], stretch[k],
                ):  # fmt: skip
                    settle_ties(primitives, who[k], block, BLOCK)
                continue
            mark_candidates(
                block, cones, is_any_narrow, c[k, 0], c[k, 1], c[k, 2], reach_sq[k], marks, near
            )
            if code == SPHERE:
                for word in range(words.shape[0]):
                    if words[word] != 0 and meet_sphere(block[WORD * word :], primitives, k):
                        settle_ties(primitives, who[k], block[WORD * word :], WORD)
            else:
                start, listed = listed, list_marked(marks, size, columns, listed)
                rows[start:listed] = k
        if listed > 0:
            keep_nearest(primitives, table, block, columns, rows, listed)
        write_nearest(block, size, t[first:], met[first:])
    return t, met


@kernel
def nearest_among_many(primitives, tree, endless, origin, direction, leaving, inner, t_max):
    """The same with a tree over the bounded primitives; endless: (e,) the other rows."""
    count = origin.shape[0]
    t, met = np.empty(count), np.empty(count, np.int32)
    block, marks, stack = np.empty(BLOCK_SIZE), np.empty(WIDE, np.uint8), np.empty(DEPTH, np.int64)
    columns, rows, table = np.empty(MOST, np.int64), np.empty(MOST, np.int64), np.empty(TABLE)
    own = np.empty(primitives.reach_sq.shape[0], np.int64)  # one ray's candidates
    for first in range(0, count, BLOCK):
        size, listed = min(BLOCK, count - first), 0
        fill_block(block, origin, direction, leaving, inner, t_max, first, size)
        for j in range(size):
            found = candidates_in_tree(tree, block, j, marks, stack, own)
            for k in endless:
                found = put_in_order(own, found, k)
            for place in range(found):
                if listed == MOST:
                    keep_nearest(primitives, table, block, columns, rows, listed)
                    listed = 0
                columns[listed], rows[listed], listed = j, own[place], listed + 1
        keep_nearest(primitives, table, block, columns, rows, listed)
        write_nearest(block, size, t[first:], met[first:])
    return t, met


@inlined
def write_nearest(block, size, t, met):
    """What a block met."""
    for j in range(size):
        t[j] = block[BEST + j] if block[MET + j] != NOWHERE else np.inf
        met[j] = np.int32(block[MET + j])


@lean
def keep_nearest(primitives, table, block, columns, rows, count):
    """Finds the roots of pairs (count,) and writes them to BEST, and whose they are to MET, of
    their columns, where they are nearer than what was met before. A ray's rows must ascend."""
    find_roots(table, primitives, block, columns, rows, count)
    for p in range(count):
        near, j = table[ROOT + p], columns[p]
        best = block[BEST + j]
        if not near < best:
            continue
        is_close = block[MET + j] != NOWHERE and best - near <= CLOSE * best
        if not is_close or not ties(primitives, block, j, near):
            block[BEST + j], block[MET + j] = near, primitives.object[rows[p]]


@lean
def settle_ties(primitives, who, block, count):
    """The same of object `who` for the first columns (count,), where `keep_nearer` left it open."""
    for j in range(count):
        if block[NEAR + j] < block[BEST + j] and not ties(primitives, block, j, block[NEAR + j]):
            block[BEST + j], block[MET + j] = block[NEAR + j], who


@lean
def ties(primitives, block, j, t):
    """Whether ray j at t is on the surface of what it met, too."""
    k = primitives.row_of[int(block[MET + j])]
    ox, oy, oz = block[OX + j], block[OY + j], block[OZ + j]
    return lies_on(primitives, k, ox, oy, oz, block[DX + j], block[DY + j], block[DZ + j], t)


@kernel
def all_primitives(primitives, origin, direction):
    """Every hit of n rays that start in free space: ray (h,), t (h,), object (h,), by ray."""
    count, rows = origin.shape[0], primitives.shape.shape[0]
    room, filled = 2 * count + 2, 0  # every ray may meet every primitive twice, but few do
    ray, t, met = np.empty(room, np.int32), np.empty(room), np.empty(room, np.int32)
    for i in range(count):
        ox, oy, oz = origin[i, 0], origin[i, 1], origin[i, 2]
        dx, dy, dz = direction[i, 0], direction[i, 1], direction[i, 2]
        dd = dx * dx + dy * dy + dz * dz
        for k in range(rows):
            if passes_by(primitives, k, ox, oy, oz, dx, dy, dz, dd):
                continue
            if filled + 2 > room:
                ray = np.concatenate((ray, np.empty(room, np.int32)))
                t = np.concatenate((t, np.empty(room)))
                met = np.concatenate((met, np.empty(room, np.int32)))
                room *= 2
            pair = settled_roots(primitives, k, ox, oy, oz, dx, dy, dz, False, False, False)
            for root in pair:
                if root < np.inf:
                    ray[filled], t[filled], met[filled] = i, root, primitives.object[k]
                    filled += 1
    return ray[:filled], t[:filled], met[:filled]
