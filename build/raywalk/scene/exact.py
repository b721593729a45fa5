"""Vectors and angles to 50 digits, for numbers of a scene that are worked out once.

Decimal comes with Python; it has roots, but no sines.
"""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np

DIGITS = 50
# pi to 60 digits (Abramowitz and Stegun, Handbook of Mathematical Functions, table 1.1, and on).
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494")


def sine(degrees: float) -> Decimal:
    """Its Taylor series, after a whole number of quarter turns is taken out exactly."""
    quarters = round(Fraction(degrees) / 90)
    rest = Fraction(degrees) - 90 * quarters
    angle = Decimal(rest.numerator) / Decimal(rest.denominator) * PI / 180
    sign = -1 if quarters % 4 >= 2 else 1
    return sign * _series(angle, first=quarters % 2 == 0)


def cosine(degrees: float) -> Decimal:
    """sin(90 - x), of which the difference is taken exactly."""
    quarters = round(Fraction(degrees) / 90)
    rest = Fraction(degrees) - 90 * quarters
    angle = Decimal(rest.numerator) / Decimal(rest.denominator) * PI / 180
    sign = -1 if quarters % 4 in (1, 2) else 1
    return sign * _series(angle, first=quarters % 2 == 1)


def _series(angle: Decimal, first: bool) -> Decimal:
    """x - x^3/3! + x^5/5! .. if `first`, else 1 - x^2/2! + x^4/4! ..; |x| up to pi / 4."""
    power, term = (1, angle) if first else (0, Decimal(1))
    total = term
    while abs(term) > Decimal(10) ** -(DIGITS + 2):
        power += 2
        term *= -angle * angle / (power * (power - 1))
        total += term
    return total


def rounded(exact: np.ndarray) -> np.ndarray:
    """Float64 of an array of Decimals, each the nearest one; zeros without a sign."""
    return np.asarray(exact, dtype=np.float64) + 0.0


def rest_of(exact: np.ndarray) -> np.ndarray:
    """What `rounded` leaves over, in float64."""
    kept, flat = rounded(exact).ravel(), exact.ravel()
    out, some = np.zeros(len(kept)), np.flatnonzero(kept)
    out[some] = [float(flat[k] - Decimal(kept[k])) for k in some.tolist()]
    return out.reshape(exact.shape) + 0.0


def exact(values: Any) -> np.ndarray:
    """An array of Decimals that are the given float64 numbers to the last digit."""
    given = np.asarray(values, float)
    return np.array([Decimal(x) for x in given.ravel().tolist()], object).reshape(given.shape)


EYE = exact(np.eye(3))


def unit(vector: np.ndarray) -> np.ndarray:
    """(3,) Decimals made 1 long."""
    return np.asarray(vector / (vector @ vector).sqrt())


def across(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(3,) the vector product of two of Decimals; numpy's own takes several times as long."""
    (ax, ay, az), (bx, by, bz) = a.tolist(), b.tolist()
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], object)


def axes_across(n: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The two unit axes across a unit vector: the world axes left when its largest component is
    dropped, made perpendicular to it; x and z of a vector that is upright."""
    first, second = (axis for axis in range(3) if axis != int(np.argmax(np.abs(n))))
    if n[first] == n[second] == 0:  # most are upright
        return EYE[first], EYE[second]
    u = unit(_perpendicular(EYE[first], n))
    return u, unit(_perpendicular(_perpendicular(EYE[second], n), u))


def _perpendicular(vector: np.ndarray, to: np.ndarray) -> np.ndarray:
    return np.asarray(vector - (vector @ to) * to)


def rotation(axis: np.ndarray, degrees: float) -> np.ndarray:
    """(3, 3) right-handed turn about a unit axis through the origin (Rodrigues)."""
    x, y, z = axis
    none = Decimal(0)
    cross = np.array([[none, -z, y], [z, none, -x], [-y, x, none]])
    return np.asarray(EYE + sine(degrees) * cross + (1 - cosine(degrees)) * (cross @ cross))
