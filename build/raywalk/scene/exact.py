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


def with_rest(exact: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """What `rounded` makes of them, and what it leaves over, in float64."""
    kept = rounded(exact)
    pairs = zip(exact.ravel().tolist(), kept.ravel().tolist(), strict=True)
    rest = [float(one - Decimal(near)) if near else 0.0 for one, near in pairs]
    return kept, np.array(rest).reshape(exact.shape) + 0.0


def exact(values: Any) -> np.ndarray:
    """An array of Decimals that are the given float64 numbers to the last digit."""
    given = np.asarray(values, float)
    return np.array([Decimal(x) for x in given.ravel().tolist()], object).reshape(given.shape)


EYE = exact(np.eye(3))


# Of three numbers the loops are written out: numpy's own take several times as long.


def unit(vector: np.ndarray) -> np.ndarray:
    """(3,) Decimals made 1 long."""
    return np.array(_unit(vector.tolist()), object)


def across(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """(3,) the vector product of two of Decimals."""
    (ax, ay, az), (bx, by, bz) = a.tolist(), b.tolist()
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx], object)


def axis_across(n: np.ndarray) -> np.ndarray:
    """The first unit axis across a unit vector: of the two world axes left when the one of its
    largest component is dropped the first, made perpendicular to it; x of a vector that is
    upright."""
    along = n.tolist()
    first, _ = _axes_left(along)
    if along[first] == 0:  # most are upright
        return EYE[first]
    return np.array(_unit(_perpendicular(EYE[first].tolist(), along)), object)


def axes_across(n: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The two unit axes across a unit vector, the second one made of the second axis left."""
    u, along = axis_across(n), n.tolist()
    second = EYE[_axes_left(along)[1]].tolist()
    return u, np.array(_unit(_perpendicular(_perpendicular(second, along), u.tolist())), object)


def _axes_left(along: list[Decimal]) -> list[int]:
    largest = max(range(3), key=lambda axis: abs(along[axis]))
    return [axis for axis in range(3) if axis != largest]


def _unit(vector: list[Decimal]) -> list[Decimal]:
    x, y, z = vector
    size = (x * x + y * y + z * z).sqrt()
    return [x / size, y / size, z / size]


def _perpendicular(vector: list[Decimal], to: list[Decimal]) -> list[Decimal]:
    (x, y, z), (a, b, c) = vector, to
    share = x * a + y * b + z * c
    return [x - share * a, y - share * b, z - share * c]


def rotation(axis: np.ndarray, degrees: float) -> np.ndarray:
    """(3, 3) right-handed turn about a unit axis through the origin (Rodrigues)."""
    if degrees == 0:
        return EYE
    x, y, z = axis
    none = Decimal(0)
    cross = np.array([[none, -z, y], [z, none, -x], [-y, x, none]])
    return np.asarray(EYE + sine(degrees) * cross + (1 - cosine(degrees)) * (cross @ cross))
