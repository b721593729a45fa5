"""Triangles and boxes met at their edges: the same verdict as from whoever shares those edges.

Canonical coordinates are fast, but each object's own: rounding puts an edge that two share in two
places, and rays pass between. So near an edge (nearer than rounding, that is) their shared corners
in the world decide.
"""

from __future__ import annotations

import math

import numpy as np

from raywalk.geometry.exact_triangle import exact_hit
from raywalk.geometry.faces import BOX, TRIANGLE
from raywalk.optics.compiled import kernel

# Roundings that a canonical coordinate has behind it at most, counted in its terms' sizes: the
# inverse's entry, the difference, product and sums.
ROUNDINGS = 8.0 * 2.220446049250313e-16
UNKNOWN = (0.0, 0.0, 0.0)
# The faces of a box as triangles; its corner k is at x = -1 or 1 by bit 0 of k, y by 1, z by 2.
BOX_TRIANGLES = np.array(
    [
        [0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
        [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5],
    ]
)  # fmt: skip


@kernel
def is_unsure(code, ox, oy, oz, dx, dy, dz, size, drift, bound):
    """Whether rounding may decide if a line meets a canonical triangle or box.

    o, d: canonical. size, drift: how large the terms of their coordinates' sums can be. bound: a
    ray that starts closer than this leaves the surface, and need not be asked.
    """
    if code == BOX:
        if abs(max(abs(ox), max(abs(oy), abs(oz))) - 1.0) <= 2.0 * bound:
            return False
        return is_box_unsure(ox, oy, oz, dx, dy, dz, size, drift)
    if code != TRIANGLE or (bound > 0.0 and abs(oz) <= bound):
        return False
    if abs(dz) <= ROUNDINGS * drift:
        return True
    t = -oz / dz
    x, y = ox + t * dx, oy + t * dy
    # x and y are off by this over |dz|, together.
    off = 2.0 * ROUNDINGS * (size + abs(t) * drift) * (abs(dx) + abs(dy) + abs(dz))
    inside = min(x, min(y, 1.0 - x - y))
    return not abs(inside * dz) > off


@kernel
def is_box_unsure(ox, oy, oz, dx, dy, dz, size, drift):
    """The same of a box: whether the intervals in its slabs overlap only just, or just not."""
    x_in, x_out, x_off = slab(ox, dx, size, drift)
    y_in, y_out, y_off = slab(oy, dy, size, drift)
    z_in, z_out, z_off = slab(oz, dz, size, drift)
    surely = min(x_out - x_off, min(y_out - y_off, z_out - z_off))
    surely -= max(x_in + x_off, max(y_in + y_off, z_in + z_off))
    perhaps = min(x_out + x_off, min(y_out + y_off, z_out + z_off))
    perhaps -= max(x_in - x_off, max(y_in - y_off, z_in - z_off))
    return not (surely > 0.0 or perhaps < 0.0)


@kernel
def slab(o, d, size, drift):
    """Interval in |x| <= 1 along one axis, and how far its ends may be off."""
    off = ROUNDINGS * (1.0 + size)
    if abs(d) <= ROUNDINGS * drift:
        if d == 0.0 and abs(abs(o) - 1.0) > off:
            return (-math.inf, math.inf, 0.0) if abs(o) < 1.0 else (math.inf, -math.inf, 0.0)
        return -math.inf, math.inf, math.inf
    one, other = (-1.0 - o) / d, (1.0 - o) / d
    late = (off + ROUNDINGS * drift * max(abs(one), abs(other))) / abs(d)
    return min(one, other), max(one, other), late


@kernel
def exact_roots(corner, rest, k, code, o, d):
    """Both parameters, of any sign, at which a line meets the triangle or box of row k; else inf.

    corner, rest: as in Primitives; o, d: world, three numbers each.
    """
    if code != BOX:
        t, _, _ = exact_hit(
            o, d, place(corner, k, 0), place(rest, k, 0), place(corner, k, 1), place(rest, k, 1),
            place(corner, k, 2), place(rest, k, 2), UNKNOWN, math.inf,
        )  # fmt: skip
        return t, math.inf
    near, far = math.inf, -math.inf
    for n in range(BOX_TRIANGLES.shape[0]):
        a, b, c = BOX_TRIANGLES[n, 0], BOX_TRIANGLES[n, 1], BOX_TRIANGLES[n, 2]
        t, _, _ = exact_hit(
            o, d, place(corner, k, a), place(rest, k, a), place(corner, k, b), place(rest, k, b),
            place(corner, k, c), place(rest, k, c), UNKNOWN, math.inf,
        )  # fmt: skip
        if t < math.inf:
            near, far = min(near, t), max(far, t)
    return (near, far) if near <= far else (math.inf, math.inf)


@kernel
def place(corners, k, c):
    """Corner c of row k as three numbers."""
    return corners[k, c, 0], corners[k, c, 1], corners[k, c, 2]
