"""Convex solids in canonical form: where a line is inside, and what side a point is on.

A line meets a convex solid in one interval [t_in, t_out]; a ray that starts on the
solid's own surface therefore either never meets it again (it leaves outwards) or
meets it at t_out (it goes inwards). That needs no epsilon, and is why intervals and
not single roots are the currency here.

All arguments are in the solid's canonical space; directions need not be unit, so the
parameter t is the world's own.
"""

from __future__ import annotations

import math

from raywalk.optics.compiled import kernel

SPHERE, BOX, CYLINDER, TUBE, PLANE, DISC, TRIANGLE = range(7)
# Canonical coordinates above this belong to an edge's neighbourhood, also for a far camera
# (1e7 away, a hit point is off by 1e-9).
EDGE = 1.0 - 1e-6


@kernel
def sphere_interval(ox, oy, oz, dx, dy, dz):
    """Interval in the unit sphere.

    The discriminant comes from the chord's midpoint, where b^2 - 4ac cancels when the
    sphere is small and far (Haines et al., Ray Tracing Gems, 2019, ch. 7); the nearer
    root from the product of both (Press et al., Numerical Recipes, 3rd ed., eq. 5.6.4).
    """
    dd = dx * dx + dy * dy + dz * dz
    middle = -(ox * dx + oy * dy + oz * dz) / dd
    mx, my, mz = ox + middle * dx, oy + middle * dy, oz + middle * dz
    half_sq = 1.0 - (mx * mx + my * my + mz * mz)
    if not half_sq >= 0.0:
        return math.inf, -math.inf
    half = math.sqrt(half_sq / dd)
    start = (ox * ox + oy * oy + oz * oz - 1.0) / dd
    return ordered_roots(middle, half, start)


@kernel
def tube_interval(ox, oy, dx, dy):
    """Interval in the endless cylinder x^2 + y^2 <= 1: the sphere's formula without z."""
    dd = dx * dx + dy * dy
    if dd == 0.0:
        return (-math.inf, math.inf) if ox * ox + oy * oy <= 1.0 else (math.inf, -math.inf)
    middle = -(ox * dx + oy * dy) / dd
    mx, my = ox + middle * dx, oy + middle * dy
    half_sq = 1.0 - (mx * mx + my * my)
    if not half_sq >= 0.0:
        return math.inf, -math.inf
    half = math.sqrt(half_sq / dd)
    return ordered_roots(middle, half, (ox * ox + oy * oy - 1.0) / dd)


@kernel
def ordered_roots(middle, half, product):
    """Both roots middle -+ half in order; the one that cancels is product / other."""
    if middle > 0.0:
        far = middle + half
        return min(product / far, far), far
    near = middle - half
    return near, (max(product / near, near) if near < 0.0 else near)


@kernel
def slab_interval(o, d):
    """Interval in |x| <= 1 along one axis."""
    if d == 0.0:
        return (-math.inf, math.inf) if -1.0 <= o <= 1.0 else (math.inf, -math.inf)
    first, second = (-1.0 - o) / d, (1.0 - o) / d
    return (first, second) if first <= second else (second, first)


@kernel
def solid_interval(shape, ox, oy, oz, dx, dy, dz):
    """[t_in, t_out] of the line in a sphere, box or capped cylinder; empty if t_in > t_out."""
    if shape == SPHERE:
        return sphere_interval(ox, oy, oz, dx, dy, dz)
    t_in, t_out = slab_interval(oz, dz)
    if shape == CYLINDER:
        a, b = tube_interval(ox, oy, dx, dy)
        return max(t_in, a), min(t_out, b)
    a, b = slab_interval(ox, dx)
    t_in, t_out = max(t_in, a), min(t_out, b)
    a, b = slab_interval(oy, dy)
    return max(t_in, a), min(t_out, b)


@kernel
def line_roots(shape, ox, oy, oz, dx, dy, dz):
    """Both parameters, of any sign, at which a line meets a round or box shape; else inf."""
    if shape == TUBE:
        t_in, t_out = tube_interval(ox, oy, dx, dy)
        if not abs(oz + t_in * dz) <= 1.0:
            t_in = math.inf
        if not abs(oz + t_out * dz) <= 1.0:
            t_out = math.inf
        return t_in, t_out
    t_in, t_out = solid_interval(shape, ox, oy, oz, dx, dy, dz)
    return (t_in, t_out) if t_in <= t_out else (math.inf, math.inf)


@kernel
def chord_exit(shape, ox, oy, oz, dx, dy, dz):
    """Where a ray that starts on a solid's own surface, inwards, comes out again.

    The height of the start over the surface is rounding, so it is left out: the chord of a
    circle is -2 o.d / d.d. With it, short chords would drown (at grazing angles of 1e-8 every
    fifth ray would find no way out).
    """
    if shape == SPHERE:
        return -2.0 * (ox * dx + oy * dy + oz * dz) / (dx * dx + dy * dy + dz * dz)
    if shape == BOX:
        return min(slab_exit(ox, dx), min(slab_exit(oy, dy), slab_exit(oz, dz)))
    end = math.inf if shape == TUBE else slab_exit(oz, dz)
    dd = dx * dx + dy * dy
    if dd == 0.0:
        return end
    on_cap = shape == CYLINDER and face_normal(shape, ox, oy, oz)[2] != 0.0
    if on_cap:
        return min(end, tube_interval(ox, oy, dx, dy)[1])
    return min(end, -2.0 * (ox * dx + oy * dy) / dd)


@kernel
def slab_exit(o, d):
    """Where a ray that starts in |x| <= 1 leaves it along one axis."""
    return (math.copysign(1.0, d) - o) / d if d != 0.0 else math.inf


@kernel
def face_normal(shape, x, y, z):
    """Canonical outward gradient at (or near) a point of the surface, not unit.

    Where faces meet, the face whose equation is closest to holding.
    """
    if shape == SPHERE:
        return x, y, z
    if shape == TUBE:
        return x, y, 0.0
    if shape == CYLINDER:
        if 1.0 - abs(z) < 1.0 - math.sqrt(x * x + y * y):
            return 0.0, 0.0, math.copysign(1.0, z)
        return x, y, 0.0
    ax, ay, az = abs(x), abs(y), abs(z)
    if ax >= ay and ax >= az:
        return math.copysign(1.0, x), 0.0, 0.0
    if ay >= az:
        return 0.0, math.copysign(1.0, y), 0.0
    return 0.0, 0.0, math.copysign(1.0, z)


@kernel
def height(shape, x, y, z):
    """How far outside the surface a canonical point is: > 0 outside, 0 on it, < 0 inside."""
    if shape == SPHERE:
        return x * x + y * y + z * z - 1.0
    if shape == TUBE:
        return x * x + y * y - 1.0
    if shape == CYLINDER:
        return max(x * x + y * y - 1.0, abs(z) - 1.0)
    return max(abs(x), max(abs(y), abs(z))) - 1.0


@kernel
def passed_face(shape, x, y, z, dx, dy, dz, leaves):
    """face_normal where faces of a box or capped cylinder meet: of those a ray can pass.

    leaves: the ray comes out of the solid. At an edge rounding may put the neighbour first,
    and a ray that enters would be told that it leaves.
    """
    sense = 1.0 if leaves else -1.0
    if shape == CYLINDER:
        side, cap = sense * (x * dx + y * dy), sense * z * dz
        if side > 0.0 and cap > 0.0:
            return face_normal(shape, x, y, z)
        return (x, y, 0.0) if side > cap else (0.0, 0.0, math.copysign(1.0, z))
    kx = x if sense * x * dx > 0.0 else 0.0
    ky = y if sense * y * dy > 0.0 else 0.0
    kz = z if sense * z * dz > 0.0 else 0.0
    if kx == 0.0 and ky == 0.0 and kz == 0.0:
        return face_normal(shape, x, y, z)
    return face_normal(shape, kx, ky, kz)


@kernel
def is_at_edge(shape, x, y, z):
    """Whether a surface point is so close to an edge that rounding decides between its faces."""
    if shape == CYLINDER:
        return min(math.sqrt(x * x + y * y), abs(z)) > EDGE
    if shape == BOX:
        ax, ay, az = abs(x), abs(y), abs(z)
        return max(min(ax, ay), min(max(ax, ay), az)) > EDGE  # the middle one of the three
    return False


@kernel
def onto_surface(shape, x, y, z, nx, ny, nz):
    """The nearest-by-scaling point of the face with this normal: takes out the rounding left
    by o + t d."""
    if shape == SPHERE:
        length = math.sqrt(x * x + y * y + z * z)
        return x / length, y / length, z / length
    if nz == 0.0 and (shape == TUBE or shape == CYLINDER):
        length = math.sqrt(x * x + y * y)
        return x / length, y / length, z
    return (nx if nx != 0.0 else x), (ny if ny != 0.0 else y), (nz if nz != 0.0 else z)
