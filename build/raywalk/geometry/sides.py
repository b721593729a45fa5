"""On which side of a body a ray goes on from a point: of its surface, or of another's.

Nothing is remembered and nothing counted: where surfaces touch, rounding may tell that one is
met a little before or behind the other, or not at all. But where a ray goes on from a point is
decided by that point and the direction alone, and by the rules that `roots` finds the next hit
with. So no ray keeps a medium that it has left.
"""

from __future__ import annotations

import numpy as np

from raywalk.geometry.faces import goes_in, holds, is_near
from raywalk.optics.compiled import kernel

# A computed hit point is off its surface by at most this share of |p| + |centre|:
# about a dozen roundings of 1.1e-16; measured 0 self-hits in 802,000 at 16 eps.
POINT_ERROR = 16.0 * 2.220446049250313e-16
# A mesh and something else tie where their distances differ by this share, 500 roundings.
TIE = 1e-13


@kernel
def is_within(shape, x, y, z, dx, dy, dz, bound):
    """Whether a ray is in a closed body just beyond a canonical point; of a plane, behind it.

    bound: how far, in canonical units, the point may be off a surface that it lies on.
    """
    if is_near(shape, x, y, z, bound):
        return goes_in(shape, x, y, z, dx, dy, dz, bound)
    return holds(shape, x, y, z)


@kernel
def primitives_beyond(primitives, is_clear, near_start, near, origin, direction, leaving, inner):
    """In which glass of the table rays are just beyond their origins: ray (c,), object (c,) and
    within (c,) bool, for the object that a ray leaves and its neighbours.

    is_clear: (objects,) bool; near_start, near: `Neighbours`. What a ray leaves it leaves to the
    side that it says.
    """
    size = 0
    for i in range(origin.shape[0]):
        size += 1 + near_start[leaving[i] + 1] - near_start[leaving[i]]
    ray, met, within = np.empty(size, np.int32), np.empty(size, np.int32), np.empty(size, np.bool_)
    filled = 0
    for i in range(origin.shape[0]):
        ox, oy, oz = origin[i, 0], origin[i, 1], origin[i, 2]
        dx, dy, dz = direction[i, 0], direction[i, 1], direction[i, 2]
        own = leaving[i]
        if is_clear[own] and primitives.row_of[own] >= 0:
            ray[filled], met[filled], within[filled] = i, own, inner[i]
            filled += 1
        for who in near[near_start[own] : near_start[own + 1]]:
            k = primitives.row_of[who]
            if k < 0:
                continue
            m, c = primitives.to_local, primitives.centre
            reach = abs(ox) + abs(oy) + abs(oz) + abs(c[k, 0]) + abs(c[k, 1]) + abs(c[k, 2])
            x, y, z = ox - c[k, 0], oy - c[k, 1], oz - c[k, 2]
            ray[filled], met[filled] = i, who
            within[filled] = is_within(
                primitives.shape[k],
                m[k, 0, 0] * x + m[k, 0, 1] * y + m[k, 0, 2] * z,
                m[k, 1, 0] * x + m[k, 1, 1] * y + m[k, 1, 2] * z,
                m[k, 2, 0] * x + m[k, 2, 1] * y + m[k, 2, 2] * z,
                m[k, 0, 0] * dx + m[k, 0, 1] * dy + m[k, 0, 2] * dz,
                m[k, 1, 0] * dx + m[k, 1, 1] * dy + m[k, 1, 2] * dz,
                m[k, 2, 0] * dx + m[k, 2, 1] * dy + m[k, 2, 2] * dz,
                POINT_ERROR * primitives.stretch[k] * reach,
            )
            filled += 1
    return ray[:filled], met[:filled], within[:filled]
