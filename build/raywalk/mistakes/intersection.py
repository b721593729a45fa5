"""Where lines meet bodies: for each kind of body both distances t, the nearer first, of any sign.

All functions take rays as origin and direction, (3, n), and give (near, far), (n,) each, inf where
there is no such hit. A flat body is met once: its `far` is inf. Which of them counts, and whether
it lies ahead, is decided in nearest.py.
"""

from __future__ import annotations

import numpy as np

from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.vectors import dot
from raywalk.mistakes.world import Body, plane_normal

Roots = tuple[np.ndarray, np.ndarray]


def roots(body: Body, origin: np.ndarray, direction: np.ndarray, mistakes: Mistakes) -> Roots:
    """Where rays in the world meet a body."""
    if body.kind == "sphere":
        return sphere_roots(body, origin, direction, mistakes)
    if body.kind == "plane":
        return plane_roots(body, origin, direction)
    o, d = body.own_point(origin), body.own_direction(direction)
    if body.kind in ("disc", "triangle"):
        return flat_roots(body.kind, o, d)
    if body.kind == "tube":
        return tube_roots(body.tip, o, d)
    if body.kind == "ellipsoid":
        enters, leaves = unit_sphere_interval(o, d)
    elif body.kind == "box":
        enters, leaves = box_interval(o, d)
    else:
        enters, leaves = cylinder_interval(body.tip, o, d)
    return only(enters <= leaves, enters, leaves)


def only(met: np.ndarray, near: np.ndarray, far: np.ndarray) -> Roots:
    """The roots of the rays that meet the body at all."""
    return np.where(met, near, np.inf), np.where(met, far, np.inf)


def sphere_roots(
    body: Body, origin: np.ndarray, direction: np.ndarray, mistakes: Mistakes
) -> Roots:
    """|o + t d - c| = r, that is t^2 + 2 b t + q = 0 for |d| = 1: t = -b -+ sqrt(b^2 - q).

    b^2 - q is r^2 - |c - o + b d|^2, how far the chord's middle is from the centre, which does not
    cancel (Haines et al., Ray Tracing Gems, 2019, ch. 7).
    """
    to_centre = body.centre - origin
    middle = dot(to_centre, direction)  # -b
    off = to_centre - middle * direction
    half_sq = body.radius**2 - dot(off, off)
    if "direction-not-unit" in mistakes:  # b^2 - q as a program has it that takes |d| for 1
        half_sq = middle**2 - (dot(to_centre, to_centre) - body.radius**2)
    half = np.sqrt(np.maximum(half_sq, 0))
    return only(half_sq >= 0, middle - half, middle + half)


def unit_sphere_interval(o: np.ndarray, d: np.ndarray) -> Roots:
    """The same of the unit sphere and a direction of any length: a t^2 + 2 b t + q = 0."""
    a = dot(d, d)
    middle = -dot(o, d) / a
    off = o + middle * d
    half = np.sqrt((1 - dot(off, off)) / a)  # NaN where the line passes by
    return middle - half, middle + half


def slab_interval(o: np.ndarray, d: np.ndarray) -> Roots:
    """Where a line is between -1 and 1 along one axis (Kay and Kajiya, SIGGRAPH 1986)."""
    first, second = (-1 - o) / d, (1 - o) / d
    return np.minimum(first, second), np.maximum(first, second)


def box_interval(o: np.ndarray, d: np.ndarray) -> Roots:
    """Where a line is between all three pairs of faces of the cube |x|, |y|, |z| <= 1."""
    x, y, z = (slab_interval(o[k], d[k]) for k in range(3))
    return np.maximum(np.maximum(x[0], y[0]), z[0]), np.minimum(np.minimum(x[1], y[1]), z[1])


def cylinder_interval(tip: float, o: np.ndarray, d: np.ndarray) -> Roots:
    """Where a line is within the side of a cylinder or cone and between its ends, z = -1 and 1."""
    side, ends = side_interval(tip, o, d), slab_interval(o[2], d[2])
    return np.maximum(side[0], ends[0]), np.minimum(side[1], ends[1])


def side_interval(tip: float, o: np.ndarray, d: np.ndarray) -> Roots:
    """Where a line is within x^2 + y^2 <= w^2, w = 1 or, of a cone, rising from tip to 1 with z.

    a t^2 + 2 b t + c <= 0. From the line's middle, so that little cancels. Where a < 0 a line is
    within a cone from one root on, or up to it: the other one is on the cone's mirror image.
    """
    slope = 0.5 * (1 - tip)
    rise = slope * d[2]
    a = d[0] ** 2 + d[1] ** 2 - rise**2
    shift = -(o[0] * d[0] + o[1] * d[1]) / (d[0] ** 2 + d[1] ** 2)
    shift = np.where(np.isfinite(shift), shift, 0)
    x, y, width = o[0] + shift * d[0], o[1] + shift * d[1], tip + slope * (1 + o[2] + shift * d[2])
    b = x * d[0] + y * d[1] - width * rise
    c = x**2 + y**2 - width**2
    root = np.sqrt(b * b - a * c)  # NaN where the line passes by
    near, far = np.minimum(-b - root, -b + root) / a, np.maximum(-b - root, -b + root) / a
    along = (a == 0) & (b == 0)  # the axis' own direction in a cylinder: within, or never
    near = np.where(along, np.nan, near)
    near, far = np.where(along & (c <= 0), -np.inf, near), np.where(along, np.inf, far)
    steep = a < 0  # dividing by a has turned them round
    near, far = np.where(steep, far, near), np.where(steep, near, far)
    upward = rise > 0
    enters = np.where(steep, np.where(upward, far, -np.inf), near)
    leaves = np.where(steep, np.where(upward, np.inf, near), far)
    return shift + enters, shift + leaves


def tube_roots(tip: float, o: np.ndarray, d: np.ndarray) -> Roots:
    """A cylinder's or cone's side alone: open at both ends."""
    enters, leaves = side_interval(tip, o, d)
    near = only(np.abs(o[2] + enters * d[2]) <= 1, enters, enters)[0]
    far = only(np.abs(o[2] + leaves * d[2]) <= 1, leaves, leaves)[0]
    return np.minimum(near, far), np.maximum(near, far)


def plane_roots(body: Body, origin: np.ndarray, direction: np.ndarray) -> Roots:
    """t = (q - o).n / d.n of a plane through q; a ray parallel to it never meets it."""
    normal = plane_normal(body)
    slope = dot(direction, normal)
    t = dot(body.centre - origin, normal) / slope
    return only(slope != 0, t, np.full_like(t, np.inf))


def flat_roots(kind: str, o: np.ndarray, d: np.ndarray) -> Roots:
    """z = 0 within the unit circle, or within the triangle (0, 0), (1, 0), (0, 1)."""
    t = -o[2] / d[2]
    x, y = o[0] + t * d[0], o[1] + t * d[1]
    within = x * x + y * y <= 1 if kind == "disc" else (x >= 0) & (y >= 0) & (x + y <= 1)
    return only(within & (d[2] != 0), t, np.full_like(t, np.inf))
