"""The nearest primitive along each ray, and all of them in order."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.blocks import (
    BEST,
    BLOCK,
    BLOCK_SIZE,
    DX,
    DY,
    DZ,
    MET,
    NEAR,
    OX,
    OY,
    OZ,
    fill_block,
    list_marked,
    mark_candidates,
    meet_plane,
)
from raywalk.geometry.candidates import MOST, ROOT, TABLE, find_roots
from raywalk.geometry.faces import PLANE
from raywalk.geometry.roots import CLOSE, NOWHERE, lies_on, passes_by, settled_roots
from raywalk.geometry.sphere_tree import DEPTH, WIDE, candidates_in_tree, put_in_order
from raywalk.optics.compiled import inlined, kernel


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
    t, met = np.full(count, np.inf), np.full(count, NOWHERE, np.int32)
    block, marks = np.empty(BLOCK_SIZE), np.empty(BLOCK, np.uint8)
    columns, rows = np.empty(MOST + 1, np.int64), np.empty(MOST, np.int64)
    table = np.empty(TABLE)
    # Columns taken out once: handed over in the loop the table costs more than the arithmetic.
    c, m, reach_sq = primitives.centre, primitives.to_local, primitives.reach_sq
    who, stretch = primitives.object, primitives.stretch
    for first in range(0, count, BLOCK):
        size, listed = min(BLOCK, count - first), 0
        fill_block(block, origin, direction, leaving, inner, t_max, first, size)
        for k in range(reach_sq.shape[0] + 1):
            is_last = k == reach_sq.shape[0]
            is_plane = not is_last and primitives.shape[k].code == PLANE
            if listed > MOST - BLOCK or ((is_last or is_plane) and listed > 0):
                keep_nearest(primitives, table, block, columns, rows, listed)
                listed = 0
            if is_plane:
                meet_plane(
                    block, k, who[k], c[k, 0], c[k, 1], c[k, 2],
                    m[k, 1, 0], m[k, 1, 1], m[k, 1, 2], stretch[k], marks,
                )  # fmt: skip
                settle_ties(primitives, k, block, marks, size, columns)
            elif not is_last:
                mark_candidates(block, c[k, 0], c[k, 1], c[k, 2], reach_sq[k], marks)
                start, listed = listed, list_marked(marks, size, columns, listed)
                rows[start:listed] = k
        write_nearest(block, size, who, t[first:], met[first:])
    return t, met


@kernel
def nearest_among_many(primitives, tree, endless, origin, direction, leaving, inner, t_max):
    """The same with a tree over the bounded primitives; endless: (e,) the other rows."""
    count = origin.shape[0]
    t, met = np.full(count, np.inf), np.full(count, NOWHERE, np.int32)
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
        write_nearest(block, size, primitives.object, t[first:], met[first:])
    return t, met


@inlined
def write_nearest(block, size, who, t, met):
    """What a block met; rows of what met nothing stay as they are."""
    for j in range(size):
        if block[MET + j] != NOWHERE:
            t[j], met[j] = block[BEST + j], who[int(block[MET + j])]


@kernel
def keep_nearest(primitives, table, block, columns, rows, count):
    """Finds the roots of pairs (count,) and writes them to BEST, and their rows to MET, of their
    columns, where they are nearer than what was met before. A ray's rows must ascend."""
    find_roots(table, primitives, block, columns, rows, count)
    for p in range(count):
        near, j = table[ROOT + p], columns[p]
        best, met = block[BEST + j], int(block[MET + j])
        if not near < best:
            continue
        is_close = met != NOWHERE and best - near <= CLOSE * best
        if not is_close or not ties(primitives, met, block, j, near):
            block[BEST + j], block[MET + j] = near, rows[p]


@inlined
def settle_ties(primitives, k, block, marks, size, columns):
    """The same of row k for the marked columns, whose roots are NEAR; columns: room for a list."""
    for place in range(list_marked(marks, size, columns, 0)):
        j = columns[place]
        if not ties(primitives, int(block[MET + j]), block, j, block[NEAR + j]):
            block[BEST + j], block[MET + j] = block[NEAR + j], k


@kernel
def ties(primitives, k, block, j, t):
    """Whether ray j at t is on row k's surface too."""
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
