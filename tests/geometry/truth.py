"""Where a ray meets a shape, to 50 digits, by the shapes' own equations.

Nothing here is shared with the tracer: no canonical space, no intervals, no chord midpoints.
A shape is taken as its author wrote it (its float64 numbers are exact), a transform is
inverted exactly, and each equation is solved as it stands in a schoolbook.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath  # type: ignore[import-untyped]
import numpy as np
from mpmath import mpf

from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Box, Cylinder, Disc, Ellipsoid, Plane, Shape, Sphere, Triangle

DIGITS = 50
mpmath.mp.dps = DIGITS

Vector = tuple[Any, Any, Any]


@dataclass(frozen=True)
class TrueHit:
    """One crossing; t in units of the direction, normal outward (not unit)."""

    t: Any
    normal: Vector


def true_hits(
    obj: SceneObject,
    origin: Sequence[float] | np.ndarray,
    direction: Sequence[float] | np.ndarray,
    grown: float = 0.0,
) -> list[TrueHit]:
    """All hits with t > 0, nearest first; the shape grown about itself by a relative share."""
    linear, offset = _exact(obj.transform[:3, :3]), _vector(obj.transform[:3, 3])
    inverse = _inverse(linear)
    o = _apply(inverse, _sub(_vector(origin), offset))
    d = _apply(inverse, _vector(direction))
    found = [hit for hit in _hits(obj.shape, o, d, 1 + mpf(grown)) if hit.t > 0]
    transposed = tuple(zip(*inverse, strict=True))
    placed = [TrueHit(hit.t, _apply(transposed, hit.normal)) for hit in found]
    return sorted(placed, key=lambda hit: hit.t)


def _hits(shape: Shape, o: Vector, d: Vector, grow: Any) -> list[TrueHit]:
    match shape:
        case Sphere():
            return _ellipsoid(o, d, shape.center, (shape.radius,) * 3, (0.0, 0.0, 0.0), grow)
        case Ellipsoid():
            return _ellipsoid(o, d, shape.center, shape.radii, shape.rotation, grow)
        case Plane():
            return _flat(o, d, shape.point, _vector(shape.normal), lambda p: True)
        case Disc():
            centre, radius = _vector(shape.center), mpf(shape.radius) * grow
            return _flat(
                o, d, shape.center, _vector(shape.normal),
                lambda p: _dot(_sub(p, centre), _sub(p, centre)) <= radius**2,
            )  # fmt: skip
        case Triangle():
            return _triangle(o, d, shape, grow)
        case Box():
            return _box(o, d, shape, grow)
        case Cylinder():
            return _cylinder(o, d, shape, grow)
    raise TypeError(type(shape).__name__)


def _ellipsoid(
    o: Vector, d: Vector, center: Sequence[float], radii: Sequence[float],
    rotation: Sequence[float], grow: Any,
) -> list[TrueHit]:  # fmt: skip
    """x^T M x = 1 with M = R diag(1 / r^2) R^T, R = Rz Ry Rx."""
    turn = _product(
        _product(_about(2, rotation[2]), _about(1, rotation[1])), _about(0, rotation[0])
    )
    back = tuple(zip(*turn, strict=True))
    scale = [1 / (mpf(r) * grow) ** 2 for r in radii]
    from_centre = _sub(o, _vector(center))
    a, b = _apply(back, from_centre), _apply(back, d)
    roots = _quadratic(
        sum(s * y * y for s, y in zip(scale, b, strict=True)),
        2 * sum(s * x * y for s, x, y in zip(scale, a, b, strict=True)),
        sum(s * x * x for s, x in zip(scale, a, strict=True)) - 1,
    )
    hits = []
    for t in roots:
        p = _along(a, b, t)
        hits.append(TrueHit(t, _apply(turn, tuple(s * x for s, x in zip(scale, p, strict=True)))))
    return hits


def _flat(
    o: Vector, d: Vector, point: Sequence[float], normal: Vector, holds: Callable[[Vector], bool]
) -> list[TrueHit]:
    down = _dot(normal, d)
    if down == 0:
        return []
    t = _dot(normal, _sub(_vector(point), o)) / down
    return [TrueHit(t, normal)] if holds(_along(o, d, t)) else []


def _triangle(o: Vector, d: Vector, shape: Triangle, grow: Any) -> list[TrueHit]:
    """Barycentric coordinates by Cramer's rule; grown about its centroid."""
    a, b, c = (_vector(corner) for corner in (shape.a, shape.b, shape.c))
    middle = tuple((x + y + z) / 3 for x, y, z in zip(a, b, c, strict=True))
    a, b, c = (_along(middle, _sub(corner, middle), grow) for corner in (a, b, c))
    one, other = _sub(b, a), _sub(c, a)
    normal = _cross(one, other)
    size = _dot(normal, normal)

    def holds(p: Vector) -> bool:
        at = _sub(p, a)
        u = _dot(_cross(at, other), normal) / size
        v = _dot(_cross(one, at), normal) / size
        return bool(u >= 0 and v >= 0 and u + v <= 1)

    return _flat(o, d, a, normal, holds)


def _box(o: Vector, d: Vector, shape: Box, grow: Any) -> list[TrueHit]:
    """Each of the six faces is a plane, of which a rectangle counts."""
    low, high = _vector(shape.minimum), _vector(shape.maximum)
    middle = tuple((a + b) / 2 for a, b in zip(low, high, strict=True))
    low, high = (_along(middle, _sub(end, middle), grow) for end in (low, high))
    hits = []
    for k in range(3):
        if d[k] == 0:
            continue
        for end, sign in ((low, -1), (high, 1)):
            t = (end[k] - o[k]) / d[k]
            p = _along(o, d, t)
            if all(low[j] <= p[j] <= high[j] for j in range(3) if j != k):
                hits.append(TrueHit(t, tuple(mpf(sign if j == k else 0) for j in range(3))))
    return _without_doubles(hits)


def _cylinder(o: Vector, d: Vector, shape: Cylinder, grow: Any) -> list[TrueHit]:
    start, end = _vector(shape.start), _vector(shape.end)
    middle = tuple((a + b) / 2 for a, b in zip(start, end, strict=True))
    half = tuple(x * grow for x in _sub(end, middle))
    length = mpmath.sqrt(_dot(half, half))
    axis = tuple(x / length for x in half)
    radius = mpf(shape.radius) * grow
    from_middle = _sub(o, middle)
    across = _off_axis(from_middle, axis)
    slope = _off_axis(d, axis)
    hits = []
    for t in _quadratic(
        _dot(slope, slope), 2 * _dot(across, slope), _dot(across, across) - radius**2
    ):
        if abs(_dot(_along(from_middle, d, t), axis)) <= length:
            hits.append(TrueHit(t, _along(across, slope, t)))
    if shape.capped:
        for sign in (-1, 1):
            outward = tuple(sign * x for x in axis)
            cap = _along(middle, half, sign)

            def holds(p: Vector, cap: Vector = cap) -> bool:
                off = _sub(p, cap)
                return bool(_dot(off, off) <= radius**2)

            hits += _flat(o, d, cap, outward, holds)
    return _without_doubles(hits)


def _without_doubles(hits: list[TrueHit]) -> list[TrueHit]:
    """A ray through an edge crosses both of its faces at one t."""
    kept: list[TrueHit] = []
    for hit in sorted(hits, key=lambda hit: hit.t):
        if not kept or hit.t != kept[-1].t:
            kept.append(hit)
    return kept


def _quadratic(a: Any, b: Any, c: Any) -> list[Any]:
    discriminant = b * b - 4 * a * c
    if a == 0 or discriminant < 0:
        return []
    root = mpmath.sqrt(discriminant)
    return [(-b - root) / (2 * a), (-b + root) / (2 * a)]


def _about(axis: int, degrees: float) -> tuple[Vector, ...]:
    angle = mpf(degrees) * mpmath.pi / 180
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    rows = [[mpf(int(r == k)) for k in range(3)] for r in range(3)]
    rows[i][i], rows[i][j], rows[j][i], rows[j][j] = c, -s, s, c
    return tuple((row[0], row[1], row[2]) for row in rows)


def _exact(matrix: np.ndarray) -> tuple[Vector, ...]:
    return tuple(_vector(row) for row in matrix)


def _inverse(m: Sequence[Vector]) -> tuple[Vector, ...]:
    a, b, c = m
    columns = (_cross(b, c), _cross(c, a), _cross(a, b))
    volume = _dot(a, columns[0])
    return tuple((r[0] / volume, r[1] / volume, r[2] / volume) for r in zip(*columns, strict=True))


def _product(a: Sequence[Vector], b: Sequence[Vector]) -> tuple[Vector, ...]:
    columns = [_apply(a, column) for column in zip(*b, strict=True)]
    return tuple((r[0], r[1], r[2]) for r in zip(*columns, strict=True))


def _apply(m: Sequence[Sequence[Any]], v: Sequence[Any]) -> Vector:
    return _dot(m[0], v), _dot(m[1], v), _dot(m[2], v)


def _vector(values: Any) -> Vector:
    x, y, z = (mpf(float(value)) for value in values)
    return x, y, z


def _dot(a: Sequence[Any], b: Sequence[Any]) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Sequence[Any], b: Sequence[Any]) -> Vector:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def _sub(a: Sequence[Any], b: Sequence[Any]) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _along(o: Sequence[Any], d: Sequence[Any], t: Any) -> Vector:
    return o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]


def _off_axis(v: Sequence[Any], axis: Sequence[Any]) -> Vector:
    return _along(v, axis, -_dot(v, axis))
