"""A ray tracer as a schoolbook writes it: plain floats, one ray at a time, b^2 - 4ac.

Nothing is shared with the tracer under test but the scenes' numbers, which stand here by
hand as SCENES.md has them: camera at (0, 0, 5) looking along -z, 45 degrees. A ray that
leaves a thing does not ask that thing again: all are convex, and all rays are outside.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

V = tuple[float, float, float]
SIZE = 1155


def add(a: V, b: V, s: float = 1.0) -> V:
    return a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]


def dot(a: V, b: V) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def unit(a: V) -> V:
    length = math.sqrt(dot(a, a))
    return a[0] / length, a[1] / length, a[2] / length


@dataclass(frozen=True)
class Thing:
    """meet: (origin, direction) -> t or inf; normal: point -> outward unit normal."""

    meet: Callable[[V, V], float]
    normal: Callable[[V], V]
    kd: V | None  # None: a mirror
    ks: V = (0.0, 0.0, 0.0)


def ellipsoid(c: V, r: V, kd: V | None) -> Thing:
    """|(p - c) / r| = 1: a t^2 + 2 b t + q = 0. Its normal is the gradient (p - c) / r^2."""

    def meet(o: V, d: V) -> float:
        p = (o[0] - c[0]) / r[0], (o[1] - c[1]) / r[1], (o[2] - c[2]) / r[2]
        e = d[0] / r[0], d[1] / r[1], d[2] / r[2]
        a, b, q = dot(e, e), dot(p, e), dot(p, p) - 1.0
        root = b * b - a * q
        if root < 0.0:
            return math.inf
        near, far = (-b - math.sqrt(root)) / a, (-b + math.sqrt(root)) / a
        return near if near > 0.0 else far if far > 0.0 else math.inf

    def normal(p: V) -> V:
        return unit(
            ((p[0] - c[0]) / r[0] ** 2, (p[1] - c[1]) / r[1] ** 2, (p[2] - c[2]) / r[2] ** 2)
        )

    return Thing(meet, normal, kd, (1.0, 1.0, 0.5))  # "coloured"


def sphere(c: V, r: float, kd: V | None) -> Thing:
    return ellipsoid(c, (r, r, r), kd)


def plane(axis: int, at: float) -> Thing:
    """The white plane whose coordinate `axis` is `at`, facing the positive side."""
    n: V = (float(axis == 0), float(axis == 1), float(axis == 2))

    def meet(o: V, d: V) -> float:
        t = (at - o[axis]) / d[axis] if d[axis] != 0.0 else math.inf
        return t if t > 0.0 else math.inf

    return Thing(meet, lambda p: n, (1.0, 1.0, 1.0))


@dataclass(frozen=True)
class World:
    things: list[Thing]
    lights: list[tuple[V, float]]
    shadows: bool
    depth: int

    def colour(self, column: int, row: int) -> V:
        """What the ray through a pixel's middle brings back."""
        spread = math.tan(math.radians(22.5))
        x = (2 * (column + 0.5) / SIZE - 1) * spread
        y = -(2 * (row + 0.5) / SIZE - 1) * spread
        return self._along((0.0, 0.0, 5.0), unit((x, y, -1.0)), self.depth)

    def _nearest(self, o: V, d: V, left: Thing | None) -> tuple[float, Thing | None]:
        best: tuple[float, Thing | None] = (math.inf, None)
        for thing in self.things:
            t = math.inf if thing is left else thing.meet(o, d)
            if t < best[0]:
                best = t, thing
        return best

    def _along(self, o: V, d: V, bounces: int, left: Thing | None = None) -> V:
        t, thing = self._nearest(o, d, left)
        if thing is None:
            return 0.0, 0.0, 0.0
        p = add(o, d, t)
        n = thing.normal(p)
        if dot(n, d) > 0.0:
            n = -n[0], -n[1], -n[2]
        if thing.kd is None:
            if bounces == 0:
                return 0.0, 0.0, 0.0
            return self._along(p, add(d, n, -2 * dot(d, n)), bounces - 1, thing)
        total = [0.1, 0.1, 0.1]
        for place, intensity in self.lights:
            way = add(place, p, -1.0)
            far, l = math.sqrt(dot(way, way)), unit(way)
            if self.shadows and (dot(l, n) <= 0.0 or self._nearest(p, l, thing)[0] < far):
                continue
            h = unit(add(l, d, -1.0))
            diffuse, shine = max(0.0, dot(n, l)), max(0.0, dot(n, h)) ** 100
            for k in range(3):
                total[k] += intensity * (diffuse * thing.kd[k] + shine * thing.ks[k])
        return total[0], total[1], total[2]


RED, GREEN, BLUE = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
_BALLS = [
    sphere((-0.5, -1.0, 1.0), 1.0, RED),
    sphere((0.5, -1.0, -1.0), 1.0, GREEN),
    sphere((0.0, 1.0, 0.0), 1.0, BLUE),
]
_MIRRORS = [
    sphere((0.5, -0.7, 0.5), 0.3, RED),
    sphere((1.0, -0.7, 0.0), 0.3, BLUE),
    plane(1, -1.0),
    plane(2, -3.0),
    sphere((-0.5, 0.0, -0.5), 1.0, None),
    sphere((1.5, 0.0, -1.5), 1.0, None),
]
_LAMPS = [((-1.0, 2.0, 1.0), 0.5), ((0.5, -0.5, 0.0), 0.5)]
WORLDS = {
    "01-shading": World(_BALLS, [((-2.0, 1.0, 1.0), 1.0)], False, 0),
    "02-shadows": World(_BALLS, [((-2.0, 1.0, 1.0), 1.0)], True, 0),
    "03-two-lights": World(
        [
            ellipsoid((0.5, 0.0, 0.5), (0.5, 0.6, 0.2), RED),
            sphere((-0.5, 0.0, -0.5), 1.0, GREEN),
            plane(1, -1.0),
        ],
        [((1.0, 2.0, 2.0), 0.5), ((-1.0, 2.0, -1.0), 0.5)],
        True,
        0,
    ),
    "04-one-bounce": World(_MIRRORS, _LAMPS, True, 1),
    "05-many-bounces": World(_MIRRORS, _LAMPS, True, 10),
}
