"""The roots of candidates: pairs of a ray and a primitive that it may meet, eight at a time.

Spheres and boxes, most of what scenes are made of besides planes, have formulas without branches,
taken here for many pairs at once: the same operations in the same order as one ray's `roots`, which
finds all others.
"""

from __future__ import annotations

import math

from raywalk.geometry import blocks
from raywalk.geometry.along_ray import point_along
from raywalk.geometry.blocks import BLOCK, DX, DY, DZ, LEAVES, OX, OY, OZ
from raywalk.geometry.faces import BOX, SPHERE, TRIANGLE, TUBE
from raywalk.geometry.rims import is_rim_unsure, rim_pair
from raywalk.geometry.roots import AT_ONCE, FAR_SQ, NOWHERE, exact_pair, roots
from raywalk.geometry.seams import is_unsure
from raywalk.geometry.sides import POINT_ERROR
from raywalk.optics.compiled import inlined, lean

MOST = 2 * BLOCK  # pairs at once: a whole block may be added to a list that is almost full
PITCH = MOST + 8  # as in blocks.py
# Rows of a table of pairs: the ray's origin and direction in canonical space; where on the ray that
# origin is; the bound within which the ray starts on a surface; whether it leaves this primitive,
# and to its inner side; the root. The last two: how large the terms of canonical coordinates are.
LX, LY, LZ, RX, RY, RZ, SHIFT, BOUND, OWN, INNER, ROOT, SIZE, DRIFT = range(0, 13 * PITCH, PITCH)
TABLE = 13 * PITCH


@lean
def lay_out(table, primitives, block, columns, rows, count):
    """Fills the table up to ROOT for pairs (count,) of columns and rows of primitives."""
    centre, rest, m = primitives.centre, primitives.centre_rest, primitives.to_local
    stretch, reach_sq = primitives.stretch, primitives.reach_sq
    who, edged = primitives.object, primitives.is_edged
    for p in range(count):
        j, k = columns[p], rows[p]
        cx, cy, cz = centre[k, 0], centre[k, 1], centre[k, 2]
        ox, oy, oz = block[OX + j], block[OY + j], block[OZ + j]
        dx, dy, dz = block[DX + j], block[DY + j], block[DZ + j]
        leaves, bound, shift = block[LEAVES + j], 0.0, 0.0
        x, y, z = ox - cx, oy - cy, oz - cz
        if leaves != NOWHERE:
            reach = abs(ox) + abs(oy) + abs(oz) + abs(cx) + abs(cy) + abs(cz)
            bound = POINT_ERROR * stretch[k] * reach
        elif x * x + y * y + z * z > FAR_SQ * reach_sq[k]:
            # From many sizes away: from the point nearest to the centre, where rounding is a share
            # of the shape's size and not of the way.
            shift = max(0.0, -(x * dx + y * dy + z * dz) / (dx * dx + dy * dy + dz * dz))
            ex, ey, ez = rest[k, 0], rest[k, 1], rest[k, 2]
            x, y, z = point_along(ox, oy, oz, dx, dy, dz, shift, cx, cy, cz, ex, ey, ez)
        table[LX + p] = m[k, 0, 0] * x + m[k, 0, 1] * y + m[k, 0, 2] * z
        table[LY + p] = m[k, 1, 0] * x + m[k, 1, 1] * y + m[k, 1, 2] * z
        table[LZ + p] = m[k, 2, 0] * x + m[k, 2, 1] * y + m[k, 2, 2] * z
        table[RX + p] = m[k, 0, 0] * dx + m[k, 0, 1] * dy + m[k, 0, 2] * dz
        table[RY + p] = m[k, 1, 0] * dx + m[k, 1, 1] * dy + m[k, 1, 2] * dz
        table[RZ + p] = m[k, 2, 0] * dx + m[k, 2, 1] * dy + m[k, 2, 2] * dz
        table[SHIFT + p], table[BOUND + p] = shift, bound
        table[OWN + p], table[INNER + p] = leaves == who[k], block[blocks.INNER + j]
        if edged[k]:
            size = max(abs(x), max(abs(y), abs(z))) + max(abs(cx), max(abs(cy), abs(cz)))
            table[SIZE + p] = stretch[k] * size
            table[DRIFT + p] = stretch[k] * max(abs(dx), max(abs(dy), abs(dz)))


@lean
def find_roots(table, primitives, block, columns, rows, count):
    """Fills the table's ROOT for pairs (count,) with these rows of primitives, in the order of
    rows: the first parameter t > 0 at which each pair meets, else inf."""
    lay_out(table, primitives, block, columns, rows, count)
    shape, start = primitives.shape, 0
    while start < count:
        code, end = shape[rows[start]].code, start + 1
        while end < count and shape[rows[end]].code == code:
            end += 1
        if code == SPHERE:
            sphere_roots(table[start:], end - start)
        else:
            if code == BOX:
                box_roots(table[start:], end - start)
            other_roots(table, primitives, block, columns, rows, start, end)
        start = end


@lean
def sphere_roots(table, count):
    """`sphere_root` of pairs (count,)."""
    for p in range(count):
        table[ROOT + p] = sphere_root(
            table[LX + p], table[LY + p], table[LZ + p], table[RX + p], table[RY + p],
            table[RZ + p], table[SHIFT + p], table[BOUND + p], table[OWN + p] > 0.0,
            table[INNER + p] > 0.0,
        )  # fmt: skip


@inlined
def sphere_root(x, y, z, dx, dy, dz, shift, bound, own, inner):
    """As `sphere_interval` and `chord_exit` have it."""
    dd = dx * dx + dy * dy + dz * dz
    towards = x * dx + y * dy + z * dz
    middle = -towards / dd
    mx, my, mz = x + middle * dx, y + middle * dy, z + middle * dz
    half_sq = 1.0 - (mx * mx + my * my + mz * mz)
    height = x * x + y * y + z * z - 1.0
    half, product = math.sqrt(abs(half_sq) / dd), height / dd
    late, early = middle + half, middle - half
    from_late, from_early = product / late, product / early
    before = from_late if from_late < late else late
    behind = from_early if from_early > early else early
    near = before if middle > 0.0 else early
    far = late if middle > 0.0 else (behind if early < 0.0 else early)
    meets = (half_sq >= 0.0) & (near <= far)
    ahead = near if near > -shift else (far if far > -shift else math.inf)
    free = shift + (ahead if meets else math.inf)
    # A ray that leaves the surface, or starts on it.
    chord = -2.0 * towards / dd
    chord = chord if chord > AT_ONCE else AT_ONCE
    goes_in = (own & inner) | ((not own) & (towards < 0.0))
    on_it = (bound > 0.0) & (abs(height) <= 2.0 * bound)
    bound_root = chord if goes_in else math.inf
    return bound_root if own | on_it else free


@lean
def box_roots(table, count):
    """As `slab_interval` has it three times; NaN for rays that leave the box or start on it."""
    for p in range(count):
        x, y, z = table[LX + p], table[LY + p], table[LZ + p]
        shift, bound = table[SHIFT + p], table[BOUND + p]
        near, far = slab(x, table[RX + p], -math.inf, math.inf)
        near, far = slab(y, table[RY + p], near, far)
        near, far = slab(z, table[RZ + p], near, far)
        ahead = near if near > -shift else (far if far > -shift else math.inf)
        ax, ay, az = abs(x), abs(y), abs(z)
        height = ax if ax > ay else ay
        height = (height if height > az else az) - 1.0
        on_it = (bound > 0.0) & (abs(height) <= 2.0 * bound)
        root = shift + (ahead if near <= far else math.inf)
        table[ROOT + p] = math.nan if (table[OWN + p] > 0.0) | on_it else root


@lean
def slab(o, d, near, far):
    """What is in |x| <= 1 of an interval."""
    first, second = (-1.0 - o) / d, (1.0 - o) / d
    low, high = (first if first <= second else second), (second if first <= second else first)
    within = abs(o) <= 1.0
    low = low if d != 0.0 else (-math.inf if within else math.inf)
    high = high if d != 0.0 else (math.inf if within else -math.inf)
    return (low if low > near else near), (high if high < far else far)


@lean
def other_roots(table, primitives, block, columns, rows, start, end):
    """Of other shapes, and of boxes where a ray starts on them; decided exactly at the edges and
    rims of those that share theirs."""
    edged, shape = primitives.is_edged, primitives.shape
    for p in range(start, end):
        k, own, shift = rows[p], table[OWN + p] > 0.0, table[SHIFT + p]
        x, y, z = table[LX + p], table[LY + p], table[LZ + p]
        dx, dy, dz = table[RX + p], table[RY + p], table[RZ + p]
        if shape[k].code != BOX or not table[ROOT + p] >= 0.0:
            near, _ = roots(
                shape[k], x, y, z, dx, dy, dz, own, table[INNER + p] > 0.0, table[BOUND + p], -shift
            )
            table[ROOT + p] = shift + near
        if not edged[k]:
            continue
        j, size, drift = columns[p], table[SIZE + p], table[DRIFT + p]
        o = block[OX + j], block[OY + j], block[OZ + j]
        d = block[DX + j], block[DY + j], block[DZ + j]
        bound = table[BOUND + p]
        if shape[k].code == BOX or shape[k].code == TRIANGLE:
            if not own and is_unsure(shape[k].code, x, y, z, dx, dy, dz, size, drift, bound):
                table[ROOT + p], _ = exact_pair(primitives, k, shape[k].code, o, d)
        elif (shape[k].code == TUBE or not own) and is_rim_unsure(
            shape[k], x, y, z, dx, dy, dz, size, drift, bound
        ):
            table[ROOT + p], _ = rim_pair(
                shape[k], primitives.corner, primitives.corner_rest, k, x, y, z, dx, dy, dz, shift,
                own, table[INNER + p] > 0.0, bound, o, d,
            )  # fmt: skip
