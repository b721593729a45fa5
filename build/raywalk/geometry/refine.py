"""Roots found again from their own hit points: the last digits of t.

Seen from the ray's start, a far or turned shape costs t a dozen roundings of the way. Seen
from the hit point, exact but for its own last digit (`along_ray`), the root is a step as
small as that error, and whatever is rounded on the way to it does not matter.
"""

from __future__ import annotations

from raywalk.geometry.along_ray import point_along, sharp_product
from raywalk.geometry.roots import CLOSE, NOWHERE
from raywalk.geometry.solids import step_to_surface
from raywalk.optics.compiled import inlined, kernel


@kernel
def refine_roots(primitives, ray, origin, direction, leaving, t, met):
    """Moves roots t (n,) onto their surfaces, in place.

    ray: (n,) each root's row of origin, direction and leaving; met: (n,) object; what is
    NOWHERE or a mesh stays. So does the way out of the surface that a ray starts on: it is
    known by its chord, and the height of its start is rounding, in which short chords drown.
    """
    # Its columns are taken out once: handed over in the loop it costs small scenes 20 to 60 %.
    table = primitives
    centre, centre_rest, to_local = table.centre, table.centre_rest, table.to_local
    local_rest, is_skewed = table.to_local_rest, table.is_skewed
    shape, row_of = table.shape, table.row_of
    for n in range(t.shape[0]):
        i = ray[n]
        if met[n] == NOWHERE or met[n] == leaving[i] or row_of[met[n]] < 0:
            continue
        k = row_of[met[n]]
        x, y, z, dx, dy, dz = from_close_up(
            centre, centre_rest, to_local, local_rest, is_skewed, k,
            origin[i, 0], origin[i, 1], origin[i, 2],
            direction[i, 0], direction[i, 1], direction[i, 2], t[n],
        )  # fmt: skip
        t[n] = refined(t[n], shape[k], x, y, z, dx, dy, dz)


@inlined
def from_close_up(
    centre, centre_rest, to_local, local_rest, is_skewed, k, ox, oy, oz, dx, dy, dz, t
):  # fmt: skip
    """Canonical coordinates of row k's hit point o + t d, and the canonical direction."""
    x, y, z = point_along(
        ox, oy, oz, dx, dy, dz, t, centre[k, 0], centre[k, 1], centre[k, 2],
        centre_rest[k, 0], centre_rest[k, 1], centre_rest[k, 2],
    )  # fmt: skip
    lx = to_local[k, 0, 0] * x + to_local[k, 0, 1] * y + to_local[k, 0, 2] * z
    ly = to_local[k, 1, 0] * x + to_local[k, 1, 1] * y + to_local[k, 1, 2] * z
    lz = to_local[k, 2, 0] * x + to_local[k, 2, 1] * y + to_local[k, 2, 2] * z
    if is_skewed[k]:
        lx, ly, lz = sharp_product(to_local, local_rest, k, x, y, z)
    rx = to_local[k, 0, 0] * dx + to_local[k, 0, 1] * dy + to_local[k, 0, 2] * dz
    ry = to_local[k, 1, 0] * dx + to_local[k, 1, 1] * dy + to_local[k, 1, 2] * dz
    rz = to_local[k, 2, 0] * dx + to_local[k, 2, 1] * dy + to_local[k, 2, 2] * dz
    return lx, ly, lz, rx, ry, rz


@kernel
def refined(t, shape, x, y, z, dx, dy, dz):
    """The root t, given its canonical hit point and the canonical direction."""
    step = step_to_surface(shape, x, y, z, dx, dy, dz)
    # Along a face the step is the point's rounding over a slope of rounding, and could end beside
    # the face: the root that the solid's interval gave stays in it.
    return t + step if abs(step) < CLOSE * t else t
