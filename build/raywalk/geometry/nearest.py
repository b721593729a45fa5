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
    OX,
    OY,
    OZ,
    fill_block,
    list_marked,
    mark_candidates,
)
from raywalk.geometry.candidates import MOST, ROOT, TABLE, find_roots
from raywalk.geometry.roots import CLOSE, NOWHERE, lies_on, settled_roots
from raywalk.optics.compiled import kernel


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
    block, marks, row = np.empty(BLOCK_SIZE), np.empty(BLOCK, np.uint8), np.empty(BLOCK, np.int32)
    columns, rows = np.empty(MOST + 1, np.int64), np.empty(MOST, np.int64)
    table, codes = np.empty(TABLE), np.empty(MOST, np.int64)
    # Columns taken out once: handed over in the loop the table costs more than the arithmetic.
    centre, reach_sq = primitives.centre, primitives.reach_sq
    for first in range(0, count, BLOCK):
        size, listed = min(BLOCK, count - first), 0
        fill_block(block, origin, direction, t_max, first, size)
        row[:] = NOWHERE
        for k in range(reach_sq.shape[0] + 1):
            is_last = k == reach_sq.shape[0]
            if not is_last:
                mark_candidates(block, centre[k, 0], centre[k, 1], centre[k, 2], reach_sq[k], marks)
                start, listed = listed, list_marked(marks, size, columns, listed)
                rows[start:listed] = k
            if listed > MOST - BLOCK or is_last:
                find_roots(
                    table, codes, primitives, block, columns, rows, listed, first, leaving, inner
                )
                keep_nearest(primitives, table, block, columns, rows, listed, row)
                listed = 0
        for j in range(size):
            if row[j] != NOWHERE:
                t[first + j], met[first + j] = block[BEST + j], primitives.object[row[j]]
    return t, met


@kernel
def keep_nearest(primitives, table, block, columns, rows, count, row):
    """Writes roots of pairs (count,) to BEST of their columns, and their rows to row (BLOCK,),
    where they are nearer than what was met before."""
    for p in range(count):
        near, j = table[ROOT + p], columns[p]
        best = block[BEST + j]
        if not near < best:
            continue
        is_close = row[j] != NOWHERE and best - near <= CLOSE * best
        if not is_close or not ties(primitives, row[j], block, j, near):
            block[BEST + j], row[j] = near, rows[p]


@kernel
def ties(primitives, k, block, j, t):
    """Whether ray j at t is on row k's surface too."""
    ox, oy, oz = block[OX + j], block[OY + j], block[OZ + j]
    return lies_on(primitives, k, ox, oy, oz, block[DX + j], block[DY + j], block[DZ + j], t)


@kernel
def all_primitives(primitives, origin, direction):
    """Every hit of n rays that start in free space: ray (h,), t (h,), object (h,), by ray."""
    count, rows = origin.shape[0], primitives.shape.shape[0]
    ray = np.empty(count * rows * 2, np.int32)
    t = np.empty(count * rows * 2)
    met = np.empty(count * rows * 2, np.int32)
    filled = 0
    for i in range(count):
        ox, oy, oz = origin[i, 0], origin[i, 1], origin[i, 2]
        dx, dy, dz = direction[i, 0], direction[i, 1], direction[i, 2]
        for k in range(rows):
            pair = settled_roots(primitives, k, ox, oy, oz, dx, dy, dz, False, False, False)
            for root in pair:
                if root < np.inf:
                    ray[filled], t[filled], met[filled] = i, root, primitives.object[k]
                    filled += 1
    return ray[:filled], t[:filled], met[:filled]
