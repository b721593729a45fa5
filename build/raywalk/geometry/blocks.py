"""Rays in blocks of columns: which of them may meet a sphere, a group and then eight at a time.

A kernel that follows one ray through all primitives waits for each of its own sums. So rays are
laid out as a block, BLOCK of them, a row for each coordinate, all rows in one array:

                ray 0   ray 1   ray 2   ...   ray 255
        OX       ox      ox      ox             ox       and the same of OY, OZ, DX, DY, DZ
        DD       d.d     d.d     d.d            d.d      squares of the directions
        LEAVES   object  object  object         object   what each starts on, or NOWHERE
        INNER    0 or 1  0 or 1  0 or 1         0 or 1   whether it goes inwards there
        BEST     best    best    best           best     how far each has to look yet
        MET      object  object  object         object   met there, or NOWHERE

`block[OX + j]` is ray j's. One primitive is asked of the whole block at once; its bounding sphere
leaves few rays over, the candidates. Where rays are neighbours, as of a camera, a mirror or a lamp,
it is asked of narrow cones first, each round a group of rays, most of which miss it as a whole:

        rays     0 ... 31 | 32 ... 63 | 64 ... 95 | ... | 224 ... 255
        cone         0    |     1     |     2     | ... |      7

(A row of 32 pixels is seen under so small an angle that squares of the picture would spare little
more; and rays may stay in the order they come in, mirrored ones and those to lamps as well.)

Planes, of which all rays are candidates, and spheres, for each word of eight rays with a candidate
among them, are met where the rays lie (`meeting.py`); candidates of other shapes are listed and
given to the exact roots (`candidates.py`). Loops over a block have no branch, and rows of one array
lie a constant apart, so the compiler knows that none overwrites another and takes eight columns at
a time. Hits are brought onto their surfaces by runs of one primitive (`landing.py`).
"""

from __future__ import annotations

import math

import numpy as np

from raywalk.geometry.roots import NOWHERE, is_past
from raywalk.optics.compiled import inlined, lean

BLOCK = 256  # a block and what is made of it stay in the first two caches
ROW = BLOCK + 8  # a power of two apart, rows would all take the same few lines of the cache
OX, OY, OZ, DX, DY, DZ, DD, LEAVES, INNER = range(0, 9 * ROW, ROW)
BEST, MET, NEAR, NEW_BEST, NEW_MET = range(9 * ROW, 14 * ROW, ROW)
BLOCK_SIZE = 14 * ROW
WORD = 8  # marks that are read at once
# Rows of a table of cones, a column a group: the point that its rays start around, and how far from
# it; the axis, unit; cosine and sine of the widest angle at that.
GROUP = 32
GROUPS, MIDDLE = BLOCK // GROUP, GROUP // 2
CX, CY, CZ, AX, AY, AZ, COS, SIN, WIDTH = range(0, 9 * GROUPS, GROUPS)
CONES = 9 * GROUPS


@inlined
def fill_block(block, origin, direction, leaving, inner, t_max, first, size):
    """Lays `size` rays from row `first` on out in columns; what is left over repeats the last."""
    for j in range(size):
        i = first + j
        dx, dy, dz = direction[i, 0], direction[i, 1], direction[i, 2]
        block[OX + j], block[OY + j], block[OZ + j] = origin[i, 0], origin[i, 1], origin[i, 2]
        block[DX + j], block[DY + j], block[DZ + j] = dx, dy, dz
        block[DD + j] = dx * dx + dy * dy + dz * dz
    for j in range(size):
        i = first + j
        block[LEAVES + j], block[INNER + j] = leaving[i], inner[i]
        block[BEST + j], block[MET + j] = t_max[i], NOWHERE
    for row in range(0, BLOCK_SIZE, ROW):
        for j in range(size, BLOCK):
            block[row + j] = block[row + size - 1]


@lean
def find_cones(block, cones):
    """Fills cones (CONES,); returns whether any is narrow enough to be asked."""
    is_any_narrow = False
    for g in range(GROUPS):
        find_cone(block[GROUP * g :], cones[g:])
        is_any_narrow |= cones[COS + g] > 0.0
    return is_any_narrow


@inlined
def find_cone(group, cone):
    """One that holds the first GROUP rays, half again as wide as the first and last of them are
    from the middle one; as wide as can be, COS 0, if a ray is outside of that."""
    x, y, z = group[OX + MIDDLE], group[OY + MIDDLE], group[OZ + MIDDLE]
    ax, ay, az = group[DX + MIDDLE], group[DY + MIDDLE], group[DZ + MIDDLE]
    first = squares_from(group, 0, x, y, z, ax, ay, az)
    last = squares_from(group, GROUP - 1, x, y, z, ax, ay, az)
    apart, turned = 2.25 * max(first[0], last[0]), 2.25 * max(first[1], last[1]) + 1e-12
    outside = 0
    for j in range(GROUP):
        far, chord = squares_from(group, j, x, y, z, ax, ay, az)
        # Directions that are not unit, of probes, end anywhere.
        outside += (far > apart) | (chord > turned) | (abs(group[DD + j] - 1.0) > 1e-12)
    turned = turned if outside == 0 and turned < 2.0 else 2.0
    cone[CX], cone[CY], cone[CZ], cone[AX], cone[AY], cone[AZ] = x, y, z, ax, ay, az
    cone[COS], cone[SIN] = 1.0 - 0.5 * turned, math.sqrt(turned - 0.25 * turned * turned)
    cone[WIDTH] = math.sqrt(apart)


@inlined
def squares_from(block, j, x, y, z, ax, ay, az):
    """How far ray j starts from a point, and its direction ends from an axis's end, squared."""
    px, py, pz = block[OX + j] - x, block[OY + j] - y, block[OZ + j] - z
    tx, ty, tz = block[DX + j] - ax, block[DY + j] - ay, block[DZ + j] - az
    return px * px + py * py + pz * pz, tx * tx + ty * ty + tz * tz


@inlined
def mark_candidates(block, cones, is_any_narrow, cx, cy, cz, reach_sq, marks, near):
    """marks (BLOCK,) uint8: 0 where a ray certainly misses the sphere. Of groups that do as a
    whole, no ray is asked. near: (GROUPS,) uint8, room to work in."""
    if not is_any_narrow:
        mark_rays(block, BLOCK, cx, cy, cz, reach_sq, marks)
        return
    mark_groups(cones, cx, cy, cz, math.sqrt(reach_sq), near)
    for g in range(GROUPS):
        if near[g]:
            mark_rays(block[GROUP * g :], GROUP, cx, cy, cz, reach_sq, marks[GROUP * g :])
        else:
            marks[GROUP * g : GROUP * g + GROUP] = 0


@inlined
def mark_groups(cones, cx, cy, cz, reach, near):
    """near (GROUPS,) uint8: 0 where all of a cone certainly misses the sphere.

    A centre that is `off` the axis and `along` it is off * cos - along * sin outside of a cone from
    one point; of rays that start WIDTH around that, as much less.
    """
    for g in range(GROUPS):
        x, y, z = cx - cones[CX + g], cy - cones[CY + g], cz - cones[CZ + g]
        along = x * cones[AX + g] + y * cones[AY + g] + z * cones[AZ + g]
        square, cos = x * x + y * y + z * z, cones[COS + g]
        off_sq = square - along * along - 1e-13 * square  # as `is_past` has it
        least = reach + cones[WIDTH + g] + along * cones[SIN + g]
        is_beyond = (least < 0.0) | (off_sq * (cos * cos) > least * least)
        near[g] = not ((cos > 0.0) & (off_sq > 0.0) & is_beyond)


@inlined
def mark_rays(block, count, cx, cy, cz, reach_sq, marks):
    """The same of the first `count` rays, one by one."""
    for j in range(count):
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
