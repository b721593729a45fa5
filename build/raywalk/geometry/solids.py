"""Lines and canonical shapes: where a line is inside of a convex solid, and where it crosses.

A line meets a convex solid in one interval [t_in, t_out]; a ray that starts on the
solid's own surface therefore either never meets it again (it leaves outwards) or
meets it at t_out (it goes inwards). That needs no epsilon, and is why intervals and
not single roots are the currency here.

All arguments are in the solid's canonical space; directions need not be unit, so the
parameter t is the world's own.
"""

from __future__ import annotations

import math

from raywalk.geometry.faces import (
    BOX,
    CYLINDER,
    DISC,
    PLANE,
    SPHERE,
    TUBE,
    face_normal,
    is_at_edge,
    is_flat,
    is_on_cap,
    side_width,
)
from raywalk.optics.compiled import kernel

# Below it, the second root is so far that the step's series ends after two terms: the third
# would be this squared, of the step.
SLIGHT = 1e-4


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
def cone_interval(tip, ox, oy, oz, dx, dy, dz):
    """Interval in the endless cone sqrt(x^2 + y^2) <= w, w = tip + k (1 + z), k = (1 - tip) / 2.

    a t^2 + 2 b t + c <= 0 from the line's point nearest to the middle, where nothing is large. The
    discriminant b^2 - a c is Lagrange's identity with a minus for w: like the sphere's, it does
    not cancel what the rest of the line has in it.
    """
    k = 0.5 * (1.0 - tip)
    shift = -(ox * dx + oy * dy + oz * dz) / (dx * dx + dy * dy + dz * dz)
    x, y, z = ox + shift * dx, oy + shift * dy, oz + shift * dz
    w, rise = tip + k * (1.0 + z), k * dz
    a = dx * dx + dy * dy - rise * rise
    b = x * dx + y * dy - w * rise
    c = x * x + y * y - w * w
    u, v, turn = x * rise - w * dx, y * rise - w * dy, x * dy - y * dx
    under = u * u + v * v - turn * turn
    if not under >= 0.0:
        if not a < 0.0:
            return math.inf, -math.inf
        under = 0.0  # so steep a line always meets it: this one at the tip
    q = -(b + math.copysign(math.sqrt(under), b))
    if q == 0.0 and a == 0.0:  # along a line of the surface, or beside it
        return (-math.inf, math.inf) if c <= 0.0 else (math.inf, -math.inf)
    one, other = q / a, (c / q if q != 0.0 else 0.0)
    near, far = min(one, other), max(one, other)
    if a < 0.0:  # it stays in the half that it rises into, and comes from the mirrored one
        near, far = (far, math.inf) if rise > 0.0 else (-math.inf, near)
    return shift + near, shift + far


@kernel
def side_interval(shape, ox, oy, oz, dx, dy, dz):
    """Interval in the endless cylinder or cone."""
    if shape.tip == 1.0:
        return tube_interval(ox, oy, dx, dy)
    return cone_interval(shape.tip, ox, oy, oz, dx, dy, dz)


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
    """[t_in, t_out] of the line in a sphere, box, cylinder or cone; empty if t_in > t_out."""
    if shape.code == SPHERE:
        return sphere_interval(ox, oy, oz, dx, dy, dz)
    t_in, t_out = slab_interval(oz, dz)
    if shape.code == CYLINDER:
        a, b = side_interval(shape, ox, oy, oz, dx, dy, dz)
        return max(t_in, a), min(t_out, b)
    a, b = slab_interval(ox, dx)
    t_in, t_out = max(t_in, a), min(t_out, b)
    a, b = slab_interval(oy, dy)
    return max(t_in, a), min(t_out, b)


@kernel
def line_roots(shape, ox, oy, oz, dx, dy, dz):
    """Both parameters, of any sign, at which a line meets a round or box shape; else inf."""
    if shape.code == TUBE:
        t_in, t_out = side_interval(shape, ox, oy, oz, dx, dy, dz)
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
    if shape.code == SPHERE:
        return -2.0 * (ox * dx + oy * dy + oz * dz) / (dx * dx + dy * dy + dz * dz)
    if shape.code == BOX:
        return min(slab_exit(ox, dx), min(slab_exit(oy, dy), slab_exit(oz, dz)))
    end = math.inf if shape.code == TUBE else slab_exit(oz, dz)
    if is_on_cap(shape, ox, oy, oz):
        along = shape.tip == 1.0 and dx == 0.0 and dy == 0.0
        return end if along else min(end, side_interval(shape, ox, oy, oz, dx, dy, dz)[1])
    rise = 0.5 * (1.0 - shape.tip) * dz
    dd = dx * dx + dy * dy - rise * rise
    if not dd > 0.0:  # steeper than the side: it rises to the end, or goes down outside at once
        return end if rise >= 0.0 else 0.0
    return min(end, -2.0 * (ox * dx + oy * dy - side_width(shape, oz) * rise) / dd)


@kernel
def slab_exit(o, d):
    """Where a ray that starts in |x| <= 1 leaves it along one axis."""
    return (math.copysign(1.0, d) - o) / d if d != 0.0 else math.inf


@kernel
def flat_root(shape, ox, oy, oz, dx, dy, dz):
    """(t, height of the origin) on a canonical plane, disc or triangle; t = inf if missed."""
    if shape.code == PLANE:
        return (-oy / dy if dy != 0.0 else math.inf), oy
    if dz == 0.0:
        return math.inf, oz
    t = -oz / dz
    x, y = ox + t * dx, oy + t * dy
    if shape.code == DISC:
        return (t if x * x + y * y <= 1.0 else math.inf), oz
    return (t if x >= 0.0 and y >= 0.0 and x + y <= 1.0 else math.inf), oz


@kernel
def step_to_surface(shape, x, y, z, dx, dy, dz):
    """From a canonical point next to a surface, the parameter of the line's crossing with it."""
    if shape.code == PLANE:
        return -y / dy
    if is_flat(shape):
        return -z / dz
    if shape.code == SPHERE:
        a, b, c = dx * dx + dy * dy + dz * dz, x * dx + y * dy + z * dz, x * x + y * y + z * z - 1.0
    elif is_at_edge(shape, x, y, z):
        return nearer_root(shape, x, y, z, dx, dy, dz)
    else:
        nx, ny, nz = face_normal(shape, x, y, z)
        if shape.code == BOX or (nx == 0.0 and ny == 0.0):
            # A face has one coordinate of +-1; the normal, of which the others are 0, picks it.
            away = nx * dx + ny * dy + nz * dz
            return (1.0 - (nx * x + ny * y + nz * z)) / away
        w, rise = side_width(shape, z), 0.5 * (1.0 - shape.tip) * dz
        a, b = dx * dx + dy * dy - rise * rise, x * dx + y * dy - w * rise
        c = x * x + y * y - w * w
    if abs(a * c) < SLIGHT * b * b:
        # a s^2 + 2 b s + c = 0: the small root, s = -c / 2b - a s^2 / 2b and one term more.
        half = 0.5 / b
        first = -c * half
        bend = a * first * half
        return first * (1.0 - bend * (1.0 - 2.0 * bend))
    return nearer_root(shape, x, y, z, dx, dy, dz)


@kernel
def nearer_root(shape, x, y, z, dx, dy, dz):
    """The same by the equation itself: at edges, and where the line is almost tangent."""
    one, other = line_roots(shape, x, y, z, dx, dy, dz)
    return one if abs(one) < abs(other) else other
