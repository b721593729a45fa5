"""Points on and near canonical surfaces: which face, its normal, and on which side a ray goes on.

The table of shapes is a closed set of numbers that the kernels branch on; what each one is, is
said in scene/shapes.py. Codes that come first are of solids, those that come last are flat.
"""

from __future__ import annotations

import math

import numpy as np

from raywalk.optics.compiled import kernel
from raywalk.scene import shapes

NAMES = ("sphere", "box", "cylinder", "tube", "plane", "disc", "triangle")
SPHERE, BOX, CYLINDER, TUBE, PLANE, DISC, TRIANGLE = range(len(NAMES))
# What a kernel knows of a shape.
SHAPE = np.dtype([("code", np.int64), ("tip", np.float64)])
# Canonical coordinates above this belong to an edge's neighbourhood, also for a far camera
# (1e7 away, a hit point is off by 1e-9).
EDGE = 1.0 - 1e-6
# Nearer to its axis than this a cone is its tip: which side a point is on is rounding there.
TIP = 1e-14

sphere_height, box_height = kernel(shapes.sphere_height), kernel(shapes.box_height)
side_height, between_caps = kernel(shapes.side_height), kernel(shapes.between_caps)


def shape_record(canonical: shapes.Canonical) -> tuple[int, float]:
    """A row of SHAPE. tip: radius at z = -1 of what is turned about z, as that at z = 1 is 1."""
    return NAMES.index(canonical.name), (canonical.ends or (1.0, 1.0))[0]


@kernel
def is_solid(shape):
    """Whether it is closed and finite."""
    return shape.code < TUBE


@kernel
def is_flat(shape):
    """Whether a line crosses it once."""
    return shape.code >= PLANE


@kernel
def height(shape, x, y, z):
    """How far outside of a round or box shape's surface a point is, about twice over: > 0 outside,
    0 on it, < 0 inside."""
    if shape.code == SPHERE:
        return sphere_height(x, y, z)
    if shape.code == TUBE:
        return side_height(x, y, z, shape.tip)
    if shape.code == CYLINDER:
        return between_caps(side_height(x, y, z, shape.tip), z)
    return box_height(x, y, z)


@kernel
def is_near(shape, x, y, z, bound):
    """Whether a point is within `bound` of the surface, or of a flat shape's plane."""
    if shape.code == PLANE:
        return abs(y) <= bound
    if is_flat(shape):
        return abs(z) <= bound
    return abs(height(shape, x, y, z)) <= 2.0 * bound


@kernel
def holds(shape, x, y, z):
    """Whether a point is strictly inside of a solid, or behind a plane."""
    if shape.code == PLANE:
        return y < 0.0
    return is_solid(shape) and height(shape, x, y, z) < 0.0


@kernel
def side_width(shape, z):
    """Radius of a cylinder's or cone's side at a height."""
    return shape.tip + 0.5 * (1.0 - shape.tip) * (1.0 + z)


@kernel
def side_normal(shape, x, y):
    """Outward gradient of a cylinder's or cone's side; of a tip, which has none, along the axis."""
    if shape.tip == 1.0:
        return x, y, 0.0
    radius = math.sqrt(x * x + y * y)
    if radius < TIP:
        return 0.0, 0.0, -1.0
    return x, y, -0.5 * (1.0 - shape.tip) * radius


@kernel
def is_on_cap(shape, x, y, z):
    """Whether a surface point is closer to a cap than to the side."""
    to_side = side_width(shape, z) - math.sqrt(x * x + y * y)
    return shape.code == CYLINDER and 1.0 - abs(z) < to_side


@kernel
def goes_in(shape, x, y, z, dx, dy, dz, bound):
    """Whether a ray goes into a solid from a canonical point within `bound` of its surface.

    At an edge it must go inwards from every face there: a convex solid is on one side of each.
    """
    if shape.code == PLANE:
        return dy < 0.0
    if shape.code == BOX:
        edge = 1.0 - 2.0 * bound
        into_x, into_y, into_z = x * dx < 0.0, y * dy < 0.0, z * dz < 0.0
        return (abs(x) < edge or into_x) and (abs(y) < edge or into_y) and (abs(z) < edge or into_z)
    if shape.code == SPHERE:
        return x * dx + y * dy + z * dz < 0.0
    if side_height(x, y, z, shape.tip) >= -2.0 * bound:
        if z < 0.0 and side_width(shape, z) <= bound:  # at the tip: into the cone
            return dz > 0.0 and dx * dx + dy * dy < 0.25 * dz * dz
        nx, ny, nz = side_normal(shape, x, y)
        if nx * dx + ny * dy + nz * dz >= 0.0:
            return False
    return not (shape.code == CYLINDER and abs(z) >= 1.0 - 2.0 * bound and z * dz >= 0.0)


@kernel
def face_normal(shape, x, y, z):
    """Canonical outward gradient at (or near) a point of the surface, not unit.

    Where faces meet, the face whose equation is closest to holding.
    """
    if shape.code == SPHERE:
        return x, y, z
    if is_on_cap(shape, x, y, z):
        return 0.0, 0.0, math.copysign(1.0, z)
    if shape.code == TUBE or shape.code == CYLINDER:
        return side_normal(shape, x, y)
    ax, ay, az = abs(x), abs(y), abs(z)
    if ax >= ay and ax >= az:
        return math.copysign(1.0, x), 0.0, 0.0
    if ay >= az:
        return 0.0, math.copysign(1.0, y), 0.0
    return 0.0, 0.0, math.copysign(1.0, z)


@kernel
def passed_face(shape, x, y, z, dx, dy, dz, leaves):
    """face_normal where faces of a box or capped cylinder meet: of those a ray can pass.

    leaves: the ray comes out of the solid. At an edge rounding may put the neighbour first,
    and a ray that enters would be taken to leave.
    """
    sense = 1.0 if leaves else -1.0
    if shape.code == CYLINDER:
        nx, ny, nz = side_normal(shape, x, y)
        side, cap = sense * (nx * dx + ny * dy + nz * dz), sense * z * dz
        if side > 0.0 and cap > 0.0:
            return face_normal(shape, x, y, z)
        return (nx, ny, nz) if side > cap else (0.0, 0.0, math.copysign(1.0, z))
    kx = x if sense * x * dx > 0.0 else 0.0
    ky = y if sense * y * dy > 0.0 else 0.0
    kz = z if sense * z * dz > 0.0 else 0.0
    if kx == 0.0 and ky == 0.0 and kz == 0.0:
        return face_normal(shape, x, y, z)
    return face_normal(shape, kx, ky, kz)


@kernel
def is_at_edge(shape, x, y, z):
    """Whether a surface point is so close to an edge that rounding decides between its faces."""
    if shape.code == CYLINDER:
        if shape.tip == 0.0 and z < 0.0:
            return False
        return min(math.sqrt(x * x + y * y) - side_width(shape, z) + 1.0, abs(z)) > EDGE
    if shape.code == BOX:
        ax, ay, az = abs(x), abs(y), abs(z)
        return max(min(ax, ay), min(max(ax, ay), az)) > EDGE  # the middle one of the three
    return False


@kernel
def onto_surface(shape, x, y, z, nx, ny, nz):
    """The nearest-by-scaling point of the face with this normal: takes out the rounding left
    by o + t d."""
    if shape.code == SPHERE:
        length = math.sqrt(x * x + y * y + z * z)
        return x / length, y / length, z / length
    if (nx != 0.0 or ny != 0.0) and (shape.code == TUBE or shape.code == CYLINDER):
        length, width = math.sqrt(x * x + y * y), max(0.0, side_width(shape, z))
        return width * (x / length), width * (y / length), z
    return (nx if nx != 0.0 else x), (ny if ny != 0.0 else y), (nz if nz != 0.0 else z)


@kernel
def on_surface(shape, x, y, z, dx, dy, dz, leaves):
    """A canonical hit point moved onto the surface, and the outward gradient there.

    leaves: whether the ray comes out of the primitive there, if it is a solid.
    """
    if shape.code == PLANE:
        return x, 0.0, z, 0.0, 1.0, 0.0
    if shape.code == DISC or shape.code == TRIANGLE:
        return x, y, 0.0, 0.0, 0.0, 1.0
    if is_at_edge(shape, x, y, z):
        gx, gy, gz = passed_face(shape, x, y, z, dx, dy, dz, leaves)
    else:
        gx, gy, gz = face_normal(shape, x, y, z)
    x, y, z = onto_surface(shape, x, y, z, gx, gy, gz)
    if shape.code == SPHERE:
        gx, gy, gz = x, y, z
    return x, y, z, gx, gy, gz
