"""Snell and Fresnel against 50 digits, at all angles and close to the critical one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from mpmath import mp, mpf  # type: ignore[import-untyped]

from raywalk.bench.cases import Case, none_of
from raywalk.bench.families import directions, perpendicular
from raywalk.bench.truth import at, cross, inner, minus, unit, vector
from raywalk.optics.scatter import glass_shares, mirror_directions, refracted_directions

CLOSEST = 14  # critical angle, up to 1 - 10^-14 of its sine
SAMPLE = 2000
AWAY = 0.01  # of the sine from the critical one: away from it, rounding is not magnified
SNELL_BOUND = 1e-14
INDICES = ((1.0, 1.5168), (1.5168, 1.0), (1.333, 1.5168), (2.417, 1.0))


def cases(count: int, seed: int) -> Iterator[Case]:
    """Reflection, refraction and reflectance; then total reflection near its border."""
    for place, (n_from, n_to) in enumerate(INDICES):
        yield from away_from_critical(n_from, n_to, min(count, SAMPLE), seed + place)
    yield wrong_total(count, seed)
    yield error_near_critical(min(count, SAMPLE), seed)


def away_from_critical(n_from: float, n_to: float, count: int, seed: int) -> Iterator[Case]:
    """Directions and shares, largest component of the error."""
    rng = np.random.default_rng(seed)
    normal = directions(rng, count)
    least = np.sqrt(max(0.0, 1.0 - ((1.0 - AWAY) * n_to / n_from) ** 2)) if n_from > n_to else 1e-3
    cosine = rng.uniform(least, 1.0, count)
    incoming = at_angle(rng, normal, np.sqrt(1.0 - cosine**2), cosine)
    share, _, total, refracted = split(incoming, normal, n_from, n_to)
    mirrored = mirror_directions(incoming, normal, normal)
    errors = np.zeros((count, 3))
    for k in range(count):
        bent, mirror, reflectance, _ = true_split(incoming[k], normal[k], n_from, n_to)
        errors[k] = (
            apart(refracted[k], bent), apart(mirrored[k], mirror), abs(share[k] - reflectance)
        )  # fmt: skip
    worst = errors.max(axis=0) if not total.any() else np.full(3, np.inf)
    for name, error in zip(("Snell", "mirror", "Fresnel"), worst, strict=True):
        yield Case(
            "optics", f"{name}, index {n_from:g} to {n_to:g}", "error, max",
            SNELL_BOUND, float(error), count, seed,
        )  # fmt: skip


def wrong_total(count: int, seed: int) -> Case:
    """Sines at critical (1 -+ 10^-k): is the reflection total?"""
    rng = np.random.default_rng(seed)
    incoming, normal, expected, n_from, n_to = near_critical(rng, count)
    _, _, total, _ = split(incoming, normal, n_from, n_to)
    single = np.cross(incoming.astype(np.float32), normal.astype(np.float32))
    ratio = np.float32(n_from) / np.float32(n_to)
    total32 = ratio**2 * (single**2).sum(axis=1) > 1.0
    return none_of(
        count, total != expected, seed, "near-critical refraction",
        f"sine x (1 -+ 10^-k), k to {CLOSEST}", "total reflection decided wrongly",
        total32 != expected, "same formula",
    )  # fmt: skip


def error_near_critical(count: int, seed: int) -> Case:
    """Error of the refracted direction times sqrt(delta): what the inputs allow near it."""
    rng = np.random.default_rng(seed)
    incoming, normal, total, n_from, n_to = near_critical(rng, count)
    _, _, _, refracted = split(incoming, normal, n_from, n_to)
    worst = 0.0
    for k in np.flatnonzero(~total):
        bent, _, _, cosine = true_split(incoming[k], normal[k], n_from, n_to)
        worst = max(worst, apart(refracted[k], bent) * float(cosine))
    return Case(
        "near-critical refraction", f"direction, k to {CLOSEST}",
        "error x cosine of refraction, max", 1e-15, worst, int((~total).sum()), seed,
        note="an input rounded by e moves the direction by e / cosine",
    )  # fmt: skip


def near_critical(
    rng: np.random.Generator, count: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray, float, float]:
    """Incoming directions, normals, whether total, and both indices."""
    n_from, n_to = 1.5, 1.0
    normal = directions(rng, count)
    total = rng.random(count) < 0.5
    delta = 10.0 ** -rng.uniform(1.0, CLOSEST, count)
    sine = n_to / n_from * (1.0 + np.where(total, delta, -delta))
    return at_angle(rng, normal, sine, np.sqrt(1.0 - sine**2)), normal, total, n_from, n_to


def at_angle(
    rng: np.random.Generator, normal: np.ndarray, sine: np.ndarray, cosine: np.ndarray
) -> np.ndarray:
    """(n, 3) directions that come in at these angles to the normals."""
    along = perpendicular(rng, normal)
    # Square to the normal beyond rounding, which would blur the angle asked for.
    along -= (along * normal).sum(axis=1, keepdims=True) * normal
    along /= np.sqrt((along**2).sum(axis=1, keepdims=True))
    return np.asarray(sine[:, None] * along - cosine[:, None] * normal)


def split(
    incoming: np.ndarray, normal: np.ndarray, n_from: float, n_to: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """What the tracer does at clear glass: reflected, refracted share, total, direction."""
    count = len(incoming)
    before, after = np.full(count, n_from), np.full(count, n_to)
    shares = glass_shares(
        incoming, normal, before, after, np.zeros(count), np.ones(count), np.ones(count, bool)
    )
    return *shares, refracted_directions(incoming, normal, normal, before, after)


def true_split(
    incoming: np.ndarray, normal: np.ndarray, n_from: float, n_to: float
) -> tuple[Any, Any, Any, Any]:
    """Refracted and reflected direction, reflectance, cosine of refraction, 50 digits.

    From angles and tangents, not from the vector formula: sin(t - i) / sin(t + i) and the
    tangents of the same (Born and Wolf, 7th ed., sec. 1.5.2, equations (21a) and (21b)).
    """
    d, n = unit(vector(incoming)), unit(vector(normal))
    cosine = -inner(d, n)
    tangent = at(d, n, cosine)
    sine = mp.sqrt(inner(cross(d, n), cross(d, n)))
    sine_beyond = sine * mpf(n_from) / mpf(n_to)
    mirror = minus(d, tuple(-2 * cosine * x for x in n))
    if sine_beyond >= 1:
        return None, mirror, mpf(1), mpf(0)
    a, b = mp.asin(sine), mp.asin(sine_beyond)
    bent = tuple(sine_beyond * x / sine - mp.cos(b) * y for x, y in zip(tangent, n, strict=True))
    across, along = mp.sin(b - a) / mp.sin(b + a), mp.tan(a - b) / mp.tan(a + b)
    return bent, mirror, (across**2 + along**2) / 2, mp.cos(b)


def apart(got: np.ndarray, true: Any) -> float:
    """Largest difference of components."""
    return max(float(abs(x - mpf(float(y)))) for x, y in zip(true, got, strict=True))
