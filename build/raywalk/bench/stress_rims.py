"""Round rims that two objects share: no ray passes between them."""

from __future__ import annotations

from decimal import Decimal, localcontext
from fractions import Fraction

import numpy as np

from raywalk.bench.families import directions, unit_rows
from raywalk.bench.made_scenes import scene_of
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.shapes import Cone, Cylinder, Disc, Shape

RIMS = (
    "tube, disc",
    "open cone, disc",
    "tube, tube",
    "tube, open cone",
    "cylinder, tube",
    "cone, open cone",
    "open cone, open cone",
)
WHOLE = 2.0**-20  # what places are multiples of: their differences are exact, so that rims are one


def lost_at_rims(kind: str, count: int, pairs: int, seed: int) -> int:
    """Rays aimed at the rim that two objects share, from within and without, that meet neither
    though exact numbers have them meet one."""
    rng, lost = np.random.default_rng(seed), 0
    for _ in range(pairs):
        shapes, middle, axis, radius = _pair(kind, rng)
        origin, direction = rays_at_rim(rng, middle, axis, radius, max(1, count // pairs))
        t = CompiledScene(scene_of(shapes)).nearest(rays_from(origin, direction))[0]
        lost += sum(
            any(meets(shape, origin[k], direction[k]) for shape in shapes)
            for k in np.flatnonzero(np.isinf(t))
        )
    return lost


def rays_at_rim(
    rng: np.random.Generator, middle: np.ndarray, axis: np.ndarray, radius: float, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Rays aimed at places of a circle, to rounding, from anywhere round it; every eighth lies
    almost in its plane."""
    n = axis / np.linalg.norm(axis)
    out = unit_rows(np.cross(n, directions(rng, count)))
    target = middle + radius * out
    from_it = directions(rng, count) * radius * rng.uniform(0.1, 4.0, (count, 1))
    from_it[::8] -= (from_it[::8] @ n)[:, None] * n * (1.0 - 10.0 ** rng.uniform(-16, -2))
    return target + from_it, unit_rows(-from_it)


def _pair(kind: str, rng: np.random.Generator) -> tuple[list[Shape], np.ndarray, np.ndarray, float]:
    """Two shapes, and centre, axis and radius of the rim that they share."""
    far = rng.choice([0.0, 100.0])
    low = WHOLE * np.round((rng.normal(size=3) + far * rng.normal(size=3)) / WHOLE)
    along = WHOLE * np.round(rng.normal(size=3) / WHOLE)
    middle, radius = low + along, float(rng.uniform(0.2, 2.0))
    beyond = along * 2.0 ** rng.integers(-2, 2)
    one, other = (each.strip() for each in kind.split(","))
    first, second = radius * rng.uniform(0.1, 3.0, 2)
    start, end, top = (_triple(each) for each in (low, middle, middle + beyond))
    shapes = {
        "tube": Cylinder(start, end, radius, capped=False),
        "cylinder": Cylinder(start, end, radius),
        "open cone": Cone(start, end, float(first), radius, capped=False),
        "cone": Cone(start, end, float(first), radius),
    }
    others = {
        "disc": Disc(end, _triple(along * rng.choice([-1.0, 1.0])), radius),
        "tube": Cylinder(end, top, radius, capped=False),
        "open cone": Cone(end, top, radius, float(second), capped=False),
    }
    return [shapes[one], others[other]], middle, along, radius


def meets(shape: Shape, origin: np.ndarray, direction: np.ndarray) -> bool:
    """Whether a ray meets a disc, cylinder or cone that is open or not, to a hundred digits."""
    if isinstance(shape, Disc):
        return _meets_disc(shape.center, shape.normal, shape.radius, origin, direction)
    assert isinstance(shape, Cylinder | Cone)
    ends = [(shape.start, shape.radius), (shape.end, getattr(shape, "end_radius", shape.radius))]
    way = [Fraction(b) - Fraction(a) for a, b in zip(shape.start, shape.end, strict=True)]
    if shape.capped and any(_meets_disc(at, way, r, origin, direction) for at, r in ends):
        return True
    start, (first, last) = list(map(Fraction, shape.start)), (Fraction(r) for _, r in ends)
    o, d = ([Fraction(float(x)) for x in row] for row in (origin, direction))
    o = [x - y for x, y in zip(o, start, strict=True)]
    whole = _dot(way, way)
    # (x - s w)^2 = r(s)^2 with s = x.w / w.w, all of them linear in t.
    height, rise = _dot(o, way) / whole, _dot(d, way) / whole
    wide, widens = first + (last - first) * height, (last - first) * rise
    a = _dot(d, d) - rise * rise * whole - widens * widens
    b = _dot(o, d) - height * rise * whole - wide * widens
    c = _dot(o, o) - height * height * whole - wide * wide
    with localcontext(prec=100):
        under = _decimal(b * b - a * c)
        if under < 0 or a == 0:
            return False
        for sign in (-1, 1):
            t = (-_decimal(b) + sign * under.sqrt()) / _decimal(a)
            if t > 0 and 0 <= _decimal(height) + t * _decimal(rise) <= 1:
                return True
    return False


def _meets_disc(center, normal, radius, origin, direction) -> bool:  # type: ignore[no-untyped-def]
    """|d (n.(c - o)) - (c - o)(n.d)|^2 <= r^2 (n.d)^2, in rationals."""
    o, d = ([Fraction(float(x)) for x in row] for row in (origin, direction))
    n = [Fraction(x) for x in normal]
    to = [Fraction(x) - y for x, y in zip(center, o, strict=True)]
    along, away = _dot(n, d), _dot(n, to)
    off = [x * away - y * along for x, y in zip(d, to, strict=True)]
    ahead = along != 0 and away / along > 0
    return ahead and _dot(off, off) <= Fraction(radius) ** 2 * along * along


def _dot(a: list[Fraction], b: list[Fraction]) -> Fraction:
    return sum((x * y for x, y in zip(a, b, strict=True)), Fraction(0))


def _decimal(x: Fraction) -> Decimal:
    return Decimal(x.numerator) / Decimal(x.denominator)


def _triple(v: np.ndarray) -> tuple[float, float, float]:
    x, y, z = map(float, v)
    return x, y, z
