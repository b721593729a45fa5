"""Where a ray meets shapes, to 50 digits, from the equations in a geometry book.

Nothing is shared with the tracer: no canonical space, no chord midpoint. The numbers of a
scene file are taken as exact; a transform is inverted exactly. Triangles are also decided in
rationals (`triangle_meets`), where not even the fiftieth digit is in doubt.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from mpmath import mp, mpf  # type: ignore[import-untyped]

from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Box, Cone, Cylinder, Disc, Ellipsoid, Plane, Sphere, Triangle

mp.dps = 50
Vector = tuple[Any, Any, Any]


class TrueHit(NamedTuple):
    """t in units of the direction; normal outward, not unit."""

    t: Any
    normal: Vector
    object: int = 0


def nearest_hit(
    scene: Scene, origin: np.ndarray, direction: np.ndarray, grown: float = 0.0
) -> TrueHit | None:
    """The nearest hit of a ray from free space; ties go to the lowest object.

    grown: every shape is larger by this share of itself. A hit or miss that is the same at
    +grown and -grown is certain; others lie within that margin of an edge.
    """
    best: TrueHit | None = None
    for k, obj in enumerate(scene.objects):
        for hit in all_hits(obj, origin, direction, grown):
            if hit.t > 0 and (best is None or hit.t < best.t):
                best = TrueHit(hit.t, hit.normal, k)
    return best


def all_hits(
    obj: SceneObject, origin: np.ndarray, direction: np.ndarray, grown: float = 0.0
) -> list[TrueHit]:
    """Every crossing of the ray's line with one object, before its start too."""
    inverse, offset = inverse_of(obj.transform)
    o = times(inverse, minus(vector(origin), offset))
    d = times(inverse, vector(direction))
    solver = SOLVERS[type(obj.shape)]
    back = tuple(zip(*inverse, strict=True))
    return [
        TrueHit(hit.t, times(back, hit.normal)) for hit in solver(obj.shape, o, d, 1 + mpf(grown))
    ]


def true_hits(
    obj: SceneObject, origin: np.ndarray, direction: np.ndarray, grown: float = 0.0
) -> list[TrueHit]:
    """What a ray meets of one object, nearest first; an edge, which is of two faces, once."""
    kept: list[TrueHit] = []
    for hit in sorted(all_hits(obj, origin, direction, grown), key=lambda hit: hit.t):
        if hit.t > 0 and not (kept and kept[-1].t == hit.t):
            kept.append(hit)
    return kept


def triangle_meets(
    corners: np.ndarray, origin: np.ndarray, direction: np.ndarray
) -> Fraction | None:
    """t of the ray's line on the closed triangle, in rationals; None where it misses.

    Cramer's rule on o + t d = a + u (b - a) + v (c - a). corners: (3, 3).
    """
    a, b, c = ([Fraction(float(x)) for x in corner] for corner in corners)
    o, d = ([Fraction(float(x)) for x in row] for row in (origin, direction))
    one, other, start = minus(b, a), minus(c, a), minus(o, a)
    volume = inner(one, cross(d, other))
    if volume == 0:
        return None
    u = inner(start, cross(d, other)) / volume
    v = inner(d, cross(start, one)) / volume
    if u < 0 or v < 0 or u + v > 1:
        return None
    return inner(other, cross(start, one)) / volume


def _sphere(shape: Sphere, o: Vector, d: Vector, grow: Any) -> list[TrueHit]:
    return _ellipsoid(Ellipsoid(shape.center, (shape.radius,) * 3), o, d, grow)


def _ellipsoid(shape: Ellipsoid, o: Vector, d: Vector, grow: Any) -> list[TrueHit]:
    """Turned back about z, then y, then x, it stands on its axes: sum (x_k / r_k)^2 = 1."""
    a, b = minus(o, vector(shape.center)), d
    for axis in (2, 1, 0):
        a, b = (turned(v, axis, -shape.rotation[axis]) for v in (a, b))
    radii = [mpf(r) * grow for r in shape.radii]
    p, q = (tuple(x / r for x, r in zip(v, radii, strict=True)) for v in (a, b))
    found = []
    for t in roots(inner(q, q), inner(p, q), inner(p, p) - 1):
        gradient: Any = tuple(x / r for x, r in zip(at(p, q, t), radii, strict=True))
        for axis in (0, 1, 2):
            gradient = turned(gradient, axis, shape.rotation[axis])
        found.append(TrueHit(t, gradient))
    return found


def _plane(shape: Plane, o: Vector, d: Vector, grow: Any) -> list[TrueHit]:
    return _flat(o, d, vector(shape.point), vector(shape.normal), lambda p: True)


def _disc(shape: Disc, o: Vector, d: Vector, grow: Any) -> list[TrueHit]:
    centre, radius = vector(shape.center), mpf(shape.radius) * grow
    return _flat(o, d, centre, vector(shape.normal), lambda p: within(p, centre, radius))


def _triangle(shape: Triangle, o: Vector, d: Vector, grow: Any) -> list[TrueHit]:
    a, b, c = (vector(corner) for corner in (shape.a, shape.b, shape.c))
    middle: Any = tuple((x + y + z) / 3 for x, y, z in zip(a, b, c, strict=True))
    a, b, c = (at(middle, minus(corner, middle), grow) for corner in (a, b, c))
    normal = cross(minus(b, a), minus(c, a))

    def holds(p: Vector) -> bool:
        sides = ((a, b), (b, c), (c, a))
        return all(inner(normal, cross(minus(y, x), minus(p, x))) >= 0 for x, y in sides)

    return _flat(o, d, a, normal, holds)


def _box(shape: Box, o: Vector, d: Vector, grow: Any) -> list[TrueHit]:
    found = []
    ends = []
    for low, high in zip(vector(shape.minimum), vector(shape.maximum), strict=True):
        middle, half = (low + high) / 2, (high - low) / 2 * grow
        ends.append((middle - half, middle + half))
    for k in range(3):
        for end, sign in zip(ends[k], (-1, 1), strict=True):
            if d[k] == 0:
                continue
            t = (end - o[k]) / d[k]
            p = at(o, d, t)
            if all(ends[j][0] <= p[j] <= ends[j][1] for j in range(3) if j != k):
                normal: Any = tuple(mpf(sign * (j == k)) for j in range(3))
                found.append(TrueHit(t, normal))
    return found


def _cylinder(shape: Cylinder, o: Vector, d: Vector, grow: Any) -> list[TrueHit]:
    whole = Cone(shape.start, shape.end, shape.radius, shape.radius, shape.capped)
    return _cone(whole, o, d, grow)


def _cone(shape: Cone, o: Vector, d: Vector, grow: Any) -> list[TrueHit]:
    """At height h over its middle, in shares of half its length, its radius is m + s h."""
    start, end = vector(shape.start), vector(shape.end)
    first, last = mpf(shape.radius) * grow, mpf(shape.end_radius) * grow
    m, s = (first + last) / 2, (last - first) / 2
    middle: Any = tuple((x + y) / 2 for x, y in zip(start, end, strict=True))
    half: Any = tuple(grow * (y - x) / 2 for x, y in zip(start, end, strict=True))
    long_sq = inner(half, half)
    from_middle = minus(o, middle)
    h, rise = inner(from_middle, half) / long_sq, inner(d, half) / long_sq
    p, q, w, wider = at(from_middle, half, -h), at(d, half, -rise), m + s * h, s * rise
    found = []
    a, b, c = (inner(one, two) for one, two in ((q, q), (p, q), (p, p)))
    for t in roots(a - wider**2, b - w * wider, c - w**2):
        if abs(h + t * rise) <= 1:
            slant = -s * (w + t * wider) / long_sq
            found.append(TrueHit(t, at(at(p, q, t), half, slant)))
    for sign, radius in ((-1, first), (1, last)) if shape.capped else ():
        cap = at(middle, half, sign)
        outward: Any = tuple(sign * x for x in half)
        found += _flat(o, d, cap, outward, partial(within, centre=cap, radius=radius))
    return found


def _flat(
    o: Vector, d: Vector, point: Vector, normal: Vector, holds: Callable[[Vector], bool]
) -> list[TrueHit]:
    down = inner(normal, d)
    if down == 0:
        return []
    t = inner(normal, minus(point, o)) / down
    return [TrueHit(t, normal)] if holds(at(o, d, t)) else []


SOLVERS: dict[type, Callable[[Any, Vector, Vector, Any], list[TrueHit]]] = {
    Sphere: _sphere,
    Ellipsoid: _ellipsoid,
    Plane: _plane,
    Disc: _disc,
    Triangle: _triangle,
    Box: _box,
    Cylinder: _cylinder,
    Cone: _cone,
}


def roots(a: Any, half_b: Any, c: Any) -> list[Any]:
    """Both roots of a t^2 + 2 half_b t + c, the smaller first; none if they are not real."""
    under = half_b * half_b - a * c
    if a == 0:
        return [-c / (2 * half_b)] if half_b else []
    if under < 0:
        return []
    root = mp.sqrt(under)
    return [(-half_b - root) / a, (-half_b + root) / a]


def within(p: Vector, centre: Vector, radius: Any) -> bool:
    off = minus(p, centre)
    return bool(inner(off, off) <= radius * radius)


def turned(v: Vector, axis: int, degrees: float) -> Vector:
    """Rotated about a coordinate axis, right-handed."""
    if degrees == 0:
        return v
    c, s = mp.cos(mp.radians(mpf(degrees))), mp.sin(mp.radians(mpf(degrees)))
    i, j = (axis + 1) % 3, (axis + 2) % 3
    out = list(v)
    out[i], out[j] = c * v[i] - s * v[j], s * v[i] + c * v[j]
    return out[0], out[1], out[2]


def inverse_of(transform: np.ndarray) -> tuple[tuple[Vector, ...], Vector]:
    """Exact inverse of the linear part by cofactors, and the offset."""
    a, b, c = (vector(row) for row in transform[:3, :3])
    columns = (cross(b, c), cross(c, a), cross(a, b))
    volume = inner(a, columns[0])
    rows: Any = tuple(tuple(x / volume for x in row) for row in zip(*columns, strict=True))
    return rows, vector(transform[:3, 3])


def unit(v: Vector) -> Vector:
    length = mp.sqrt(inner(v, v))
    return v[0] / length, v[1] / length, v[2] / length


def vector(values: Any) -> Vector:
    x, y, z = values
    return mpf(float(x)), mpf(float(y)), mpf(float(z))


def times(matrix: Sequence[Any], v: Vector) -> Vector:
    return inner(matrix[0], v), inner(matrix[1], v), inner(matrix[2], v)


def inner(a: Any, b: Any) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Any, b: Any) -> Vector:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def minus(a: Any, b: Any) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def at(o: Any, d: Any, t: Any) -> Vector:
    return o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]
