"""Planes and spheres met by the rays of a block where they lie, eight at a time: the same
operations in the same order as one ray's `roots`.
"""

from __future__ import annotations

import math

from raywalk.geometry.along_ray import point_along
from raywalk.geometry.blocks import (
    BEST,
    BLOCK,
    DD,
    DX,
    DY,
    DZ,
    INNER,
    LEAVES,
    MET,
    NEAR,
    NEW_BEST,
    NEW_MET,
    OX,
    OY,
    OZ,
    WORD,
)
from raywalk.geometry.candidates import sphere_root
from raywalk.geometry.roots import CLOSE, FAR_SQ, NOWHERE
from raywalk.geometry.rows import centre_of, matrix_of, times
from raywalk.geometry.sides import POINT_ERROR
from raywalk.optics.compiled import inlined


@inlined
def meet_plane(block, who, cx, cy, cz, mx, my, mz, stretch):
    """A plane that is object `who`, met by a whole block: writes BEST and MET where it is nearer.
    Returns whether any ray must be asked whether it ties with what that met before.

    m: the plane's row of its matrix. As `flat_root` has it; NEAR: where each ray meets it.
    """
    any_ties = False
    for j in range(BLOCK):
        ox, oy, oz = block[OX + j], block[OY + j], block[OZ + j]
        y = mx * (ox - cx) + my * (oy - cy) + mz * (oz - cz)
        dy = mx * block[DX + j] + my * block[DY + j] + mz * block[DZ + j]
        t, leaves = -y / dy, block[LEAVES + j]
        reach = abs(ox) + abs(oy) + abs(oz) + abs(cx) + abs(cy) + abs(cz)
        bound = POINT_ERROR * stretch * reach if leaves != NOWHERE else 0.0
        meets = (t > 0.0) & (abs(y) > bound) & (dy != 0.0) & (leaves != who)
        any_ties |= keep_nearer(block, j, who, t if meets else math.inf)
    renew(block, BLOCK)
    return any_ties


@inlined
def meet_sphere(block, primitives, k):
    """Row k, a sphere, likewise, by the first WORD of rays. As `lay_out` has it."""
    cx, cy, cz, ex, ey, ez = centre_of(primitives, k)
    a, b, c, d, e, f, g, h, i = matrix_of(primitives.to_local, k)
    who, stretch = primitives.object[k], primitives.stretch[k]
    far_sq, any_ties = FAR_SQ * primitives.reach_sq[k], False
    for j in range(WORD):
        ox, oy, oz = block[OX + j], block[OY + j], block[OZ + j]
        dx, dy, dz = block[DX + j], block[DY + j], block[DZ + j]
        leaves, inner = block[LEAVES + j], block[INNER + j] > 0.0
        is_free = leaves == NOWHERE
        reach = abs(ox) + abs(oy) + abs(oz) + abs(cx) + abs(cy) + abs(cz)
        bound = 0.0 if is_free else POINT_ERROR * stretch * reach
        x, y, z = ox - cx, oy - cy, oz - cz
        is_far = is_free & (x * x + y * y + z * z > far_sq)
        foot = -(x * dx + y * dy + z * dz) / block[DD + j]
        shift = foot if is_far & (foot > 0.0) else 0.0
        fx, fy, fz = point_along(ox, oy, oz, dx, dy, dz, shift, cx, cy, cz, ex, ey, ez)
        x, y, z = (fx if is_far else x), (fy if is_far else y), (fz if is_far else z)
        x, y, z = times(a, b, c, d, e, f, g, h, i, x, y, z)
        dx, dy, dz = times(a, b, c, d, e, f, g, h, i, dx, dy, dz)
        near = sphere_root(x, y, z, dx, dy, dz, shift, bound, leaves == who, inner)
        any_ties |= keep_nearer(block, j, who, near)
    renew(block, WORD)
    return any_ties


@inlined
def keep_nearer(block, j, who, near):
    """Whether ray j's hit at `near` with object `who` may tie with what it met before. If not, the
    nearer one is kept; NEAR: this one.

    Elsewhere than they are read from: in place it would be a store by halves, which is slow.
    """
    best, met = block[BEST + j], block[MET + j]
    is_nearer = near < best
    is_close = (met != NOWHERE) & (best - near <= CLOSE * best)
    takes = is_nearer & (not is_close)
    block[NEAR + j] = near
    block[NEW_BEST + j] = near if takes else best
    block[NEW_MET + j] = who if takes else met
    return is_nearer & is_close


@inlined
def renew(block, count):
    """BEST and MET as `keep_nearer` left them."""
    for j in range(count):
        block[BEST + j], block[MET + j] = block[NEW_BEST + j], block[NEW_MET + j]
