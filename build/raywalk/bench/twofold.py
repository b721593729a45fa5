"""Numbers of about 32 digits for whole arrays: truth for a million rays at once.

A value is an unevaluated sum hi + lo of two float64 (Dekker, "A floating-point technique
for extending the available precision", Numerische Mathematik 18, 1971; Hida, Li and Bailey,
"Library for double-double and quad-double arithmetic", 2007). mpmath does the same for one
ray in the time this takes for thousands; the two are compared in tests/bench.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

SPLITTER = 134217729.0  # 2^27 + 1, cuts a float64 into halves whose products are exact


class Twofold:
    """An array of such values; works with ndarrays and numbers, which are taken as exact."""

    __slots__ = ("hi", "lo")
    __array_ufunc__ = None  # so that ndarray * Twofold comes here

    def __init__(self, hi: Any, lo: Any = 0.0):
        self.hi = np.asarray(hi, float)
        self.lo = np.asarray(lo, float)

    def __add__(self, other: Any) -> Twofold:
        other = twofold(other)
        s, e = _sum(self.hi, other.hi)
        t, f = _sum(self.lo, other.lo)
        s, e = _quick_sum(s, e + t)
        return Twofold(*_quick_sum(s, e + f))

    def __neg__(self) -> Twofold:
        return Twofold(-self.hi, -self.lo)

    def __sub__(self, other: Any) -> Twofold:
        return self + (-twofold(other))

    def __rsub__(self, other: Any) -> Twofold:
        return twofold(other) - self

    def __mul__(self, other: Any) -> Twofold:
        other = twofold(other)
        p, e = _product(self.hi, other.hi)
        return Twofold(*_quick_sum(p, e + (self.hi * other.lo + self.lo * other.hi)))

    def __truediv__(self, other: Any) -> Twofold:
        """Long division in three float64 steps."""
        other = twofold(other)
        first = self.hi / other.hi
        rest = self - other * first
        second = rest.hi / other.hi
        third = (rest - other * second).hi / other.hi
        return Twofold(*_quick_sum(first, second)) + third

    def __rtruediv__(self, other: Any) -> Twofold:
        return twofold(other) / self

    __radd__, __rmul__ = __add__, __mul__

    def __getitem__(self, chosen: Any) -> Twofold:
        return Twofold(self.hi[chosen], np.broadcast_to(self.lo, self.hi.shape)[chosen])

    def sqrt(self) -> Twofold:
        """NaN below zero. One Newton step from float64."""
        with np.errstate(divide="ignore", invalid="ignore"):
            start = np.sqrt(self.hi)
            step = (self - Twofold(start) * start).hi / (2.0 * start)
        return Twofold(*_quick_sum(start, np.where(start > 0, step, 0.0)))

    def value(self) -> np.ndarray:
        """Rounded to float64."""
        return np.asarray(self.hi + self.lo)


def twofold(value: Any) -> Twofold:
    """The value itself, or a float64 as an exact one."""
    return value if isinstance(value, Twofold) else Twofold(value)


def dot(a: list[Twofold], b: list[Twofold]) -> Twofold:
    """Sum of products of components."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def columns(rows: np.ndarray) -> list[Twofold]:
    """Components of (n, 3) float64 rows."""
    return [Twofold(rows[..., k]) for k in range(3)]


def _sum(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    s = a + b
    v = s - a
    return s, (a - (s - v)) + (b - v)


def _quick_sum(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    s = a + b
    return s, b - (s - a)


def _split(a: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    t = SPLITTER * a
    high = t - (t - a)
    return high, a - high


def _product(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    p = a * b
    (ah, al), (bh, bl) = _split(a), _split(b)
    return p, ((ah * bh - p) + ah * bl + al * bh) + al * bl


CHUNK = 16_384  # rays at a time: their columns stay in a core's cache


def sphere_roots(
    origin: np.ndarray, direction: np.ndarray, centre: np.ndarray, radius: float
) -> tuple[Twofold, Twofold, np.ndarray]:
    """Both t of each ray's line (NaN where it misses), and by how much it hits.

    The third is 1 - (distance of line and centre / radius)^2: below 0 a miss. origin,
    direction: (n, 3); their float64 values, and centre and radius, are taken as exact.
    """
    parts = [
        _roots(origin[k : k + CHUNK], direction[k : k + CHUNK], centre, radius)
        for k in range(0, len(origin), CHUNK)
    ]
    near, far, depth = zip(*parts, strict=True)
    return joined(near), joined(far), np.concatenate(depth)


def joined(parts: Sequence[Twofold]) -> Twofold:
    return Twofold(np.concatenate([p.hi for p in parts]), np.concatenate([p.lo for p in parts]))


def _roots(
    origin: np.ndarray, direction: np.ndarray, centre: np.ndarray, radius: float
) -> tuple[Twofold, Twofold, np.ndarray]:
    d = columns(direction)
    to = [a - b for a, b in zip(columns(origin), columns(np.asarray(centre, float)), strict=True)]
    a, half_b = dot(d, d), dot(to, d)
    c = dot(to, to) - Twofold(radius) * radius
    under = half_b * half_b - a * c
    root = under.sqrt()
    return (-half_b - root) / a, (-half_b + root) / a, (under / (a * radius * radius)).value()


def nearest_root(near: Twofold, far: Twofold) -> Twofold:
    """The nearer t > 0; inf where there is none."""
    first, second = near.hi > 0, far.hi > 0  # False for NaN
    hi = np.where(first, near.hi, np.where(second, far.hi, np.inf))
    lo = np.where(first, near.lo, np.where(second, far.lo, 0.0))
    return Twofold(hi, lo)


def error_of(t: np.ndarray, true: Twofold) -> np.ndarray:
    """|t - true| (n,) float64, correct to its own leading digits."""
    with np.errstate(invalid="ignore"):  # inf - inf, where both miss
        return np.abs((t - true.hi) - true.lo)
