"""Rays in blocks of columns: which of them may meet a sphere, eight at a time.

A kernel that follows one ray through all primitives waits for each of its own sums. So rays are
laid out as a block, BLOCK of them, a row for each coordinate, all rows in one array:

                ray 0   ray 1   ray 2   ...   ray 255
        OX       ox      ox      ox             ox       and the same of OY, OZ, DX, DY, DZ
        DD       d.d     d.d     d.d            d.d      squares of the directions
        LEAVES   object  object  object         object   what each starts on, or NOWHERE
        INNER    0 or 1  0 or 1  0 or 1         0 or 1   whether it goes inwards there
        BEST     best    best    best           best     how far each has to look yet
        MET      row     row     row            row      of the primitive met there, or NOWHERE

`block[OX + j]` is ray j's. One primitive is asked of the whole block at once: its bounding sphere
leaves few rays over, the candidates, which are listed and given to the exact roots
(`candidates.py`). An endless plane, whose candidates all rays are, is met where they lie. Loops
over a block have no branch, and rows of one array lie a constant apart, so the compiler knows that
none overwrites another and takes eight columns at a time.
"""

from __future__ import annotations

import math

import numpy as np

from raywalk.geometry.roots import CLOSE, NOWHERE, is_past
from raywalk.geometry.sides import POINT_ERROR
from raywalk.optics.compiled import inlined, kernel

BLOCK = 256  # a block and what is made of it stay in the first two caches
ROW = BLOCK + 8  # a power of two apart, rows would all take the same few lines of the cache
OX, OY, OZ, DX, DY, DZ, DD, LEAVES, INNER = range(0, 9 * ROW, ROW)
BEST, MET, NEAR, NEW_BEST, NEW_MET = range(9 * ROW, 14 * ROW, ROW)
BLOCK_SIZE = 14 * ROW
WORD = 8  # marks that are read at once


@kernel
def fill_block(block, origin, direction, leaving, inner, t_max, first, size):
    """Lays `size` rays from row `first` on out in columns; what is left over repeats the last."""
    for j in range(BLOCK):
        i = first + min(j, size - 1)
        block[OX + j], block[OY + j], block[OZ + j] = origin[i, 0], origin[i, 1], origin[i, 2]
        dx, dy, dz = direction[i, 0], direction[i, 1], direction[i, 2]
        block[DX + j], block[DY + j], block[DZ + j] = dx, dy, dz
        block[DD + j], block[LEAVES + j] = dx * dx + dy * dy + dz * dz, leaving[i]
        block[INNER + j], block[BEST + j], block[MET + j] = inner[i], t_max[i], NOWHERE


@inlined
def mark_candidates(block, cx, cy, cz, reach_sq, marks):
    """marks (BLOCK,) uint8: 0 where a ray certainly misses the sphere."""
    for j in range(BLOCK):
        x, y, z = cx - block[OX + j], cy - block[OY + j], cz - block[OZ + j]
        along = x * block[DX + j] + y * block[DY + j] + z * block[DZ + j]
        marks[j] = not is_past(x * x + y * y + z * z, reach_sq, along, block[DD + j])


@inlined
def list_marked(marks, size, listed, filled):
    """Adds the marked of the first `size` columns to listed, in order, from place `filled` on, and
    returns where it ends now. There is room for one more than are marked."""
    words, start = marks.view(np.uint64), filled
    for word in range(words.shape[0]):
        if words[word] != 0:
            for j in range(WORD * word, WORD * word + WORD):
                listed[filled] = j  # without a branch, which none could predict
                filled += marks[j]
    while filled > start and listed[filled - 1] >= size:
        filled -= 1
    return filled


@inlined
def meet_plane(block, k, who, cx, cy, cz, mx, my, mz, stretch, marks):
    """Row k, a plane that is object `who`, met by a whole block: writes BEST and MET where it is
    nearer, and marks rays of which it must be asked whether it ties with what they met before.

    m: the plane's row of its matrix. As `flat_root` has it; NEAR: where each ray meets it.
    """
    for j in range(BLOCK):
        ox, oy, oz = block[OX + j], block[OY + j], block[OZ + j]
        y = mx * (ox - cx) + my * (oy - cy) + mz * (oz - cz)
        dy = mx * block[DX + j] + my * block[DY + j] + mz * block[DZ + j]
        t, leaves = -y / dy, block[LEAVES + j]
        reach = abs(ox) + abs(oy) + abs(oz) + abs(cx) + abs(cy) + abs(cz)
        bound = POINT_ERROR * stretch * reach if leaves != NOWHERE else 0.0
        meets = (t > 0.0) & (abs(y) > bound) & (dy != 0.0) & (leaves != who)
        near, best, met = t if meets else math.inf, block[BEST + j], block[MET + j]
        is_close = (met != NOWHERE) & (best - near <= CLOSE * best)
        takes = (near < best) & (not is_close)
        marks[j] = (near < best) & is_close
        block[NEAR + j] = near
        # Elsewhere than they are read from: in place it would be a store by halves, which is slow.
        block[NEW_BEST + j] = near if takes else best
        block[NEW_MET + j] = k if takes else met
    for j in range(BLOCK):
        block[BEST + j], block[MET + j] = block[NEW_BEST + j], block[NEW_MET + j]
