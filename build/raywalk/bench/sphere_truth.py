"""Rays and spheres to 32 digits, a million at a time."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raywalk.bench.twofold import Twofold, columns, dot

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
