"""Which rims coincide, of discs and of cylinders and cones, and the numbers that decide for all who
have one."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal, localcontext
from typing import NamedTuple

import numpy as np

from raywalk.geometry.rims import CENTRE, FRAME, HIGH, LOW
from raywalk.scene.exact import DIGITS
from raywalk.scene.shapes import Cone, Cylinder, Disc, Shape

# Rims are one if no more than the rounding of what they were given as sets them apart: this share
# of their size and of how far out they are, some twenty roundings.
ONE = 4e-15
# Rims are sorted along it, so that few are compared: no axis, and along none of their patterns.
ALONG = np.array([0.613, 0.571, 0.546])
Place = tuple[np.ndarray, np.ndarray]  # (3, 3) linear part, (3,) centre; Decimals


class Rim(NamedTuple):
    """One circle of a canonical shape."""

    row: int
    z: int
    radius: Decimal


def shared_rims(
    shapes: list[Shape],
    placed: list[Place],
    inverse: np.ndarray,
    linear: np.ndarray,
    centre: np.ndarray,
) -> tuple[list[int], np.ndarray]:
    """Rows (s,) with a rim that another has too, and what `rims.py` reads of each: (s, 8, 3)
    Decimals.

    inverse: (p, 3, 3) Decimals, of the linear parts; linear, centre: those rounded.
    """
    rims = [rim for k, shape in enumerate(shapes) for rim in _rims_of(k, shape)]
    first = _first_of_each(rims, linear, centre)
    rows = sorted({rims[k].row for pair in enumerate(first) if pair[0] != pair[1] for k in pair})
    if not rows:
        return [], np.zeros((0, 8, 3), object)
    out, place = np.full((len(rows), 8, 3), Decimal(0), object), {k: n for n, k in enumerate(rows)}
    with localcontext(prec=DIGITS):
        for rim, one in zip(rims, first, strict=True):
            if rim.row in place:
                start, up = HIGH if rim.z == 1 else LOW, placed[rim.row][0][:, 2]
                numbers = _numbers(rims[one], placed, inverse, up)
                out[place[rim.row], start : start + len(numbers)] = numbers
    return rows, out


def _rims_of(row: int, shape: Shape) -> Iterator[Rim]:
    if isinstance(shape, Disc):
        yield Rim(row, 0, Decimal(1))
    elif isinstance(shape, Cylinder | Cone):
        yield Rim(row, 1, Decimal(1))
        small, big = sorted((shape.radius, getattr(shape, "end_radius", shape.radius)))
        if small == big:
            yield Rim(row, -1, Decimal(1))
        elif small > 0.0:
            with localcontext(prec=DIGITS):  # the canonical one's quotient is rounded
                yield Rim(row, -1, Decimal(small) / Decimal(big))


def _numbers(rim: Rim, placed: list[Place], inverse: np.ndarray, up: np.ndarray) -> np.ndarray:
    """(4, 3) Decimals: centre, and rows that make it the unit circle, the last one upwards."""
    linear, centre = placed[rim.row]
    rows, radius = inverse[rim.row], rim.radius
    out = np.empty((4, 3), object)
    out[CENTRE] = centre + rim.z * linear[:, 2]
    out[FRAME : FRAME + 2] = rows[:2] if radius == 1 else rows[:2] / radius
    out[FRAME + 2] = rows[2] if rows[2] @ up > 0 else -rows[2]
    return out


def _first_of_each(rims: list[Rim], linear: np.ndarray, centre: np.ndarray) -> list[int]:
    """(n,) the first of the rims that coincide with each: itself, if no other does.

    linear: (p, 3, 3), centre: (p, 3) float64, of rows.
    """
    first = list(range(len(rims)))
    if len(rims) < 2:
        return first
    row = np.array([rim.row for rim in rims])
    linear = linear[row]
    middle = centre[row] + np.array([rim.z for rim in rims])[:, None] * linear[:, :, 2]
    flat = linear[:, :, :2] * np.array([float(rim.radius) for rim in rims])[:, None, None]
    # The same for all axes that an ellipse can be made of.
    form = flat @ flat.transpose(0, 2, 1)
    size = np.sqrt(np.abs(form).max(axis=(1, 2)))
    off = ONE * (size + np.abs(middle).max(axis=1))
    for one, other in _near_pairs(middle, form, size, off):
        low, high = sorted((_root(first, one), _root(first, other)))
        first[high] = low
    return [_root(first, k) for k in range(len(rims))]


def _near_pairs(
    middle: np.ndarray, form: np.ndarray, size: np.ndarray, off: np.ndarray
) -> Iterator[tuple[int, int]]:
    """Those of n rims that are one. off: (n,) by how much their places may differ."""
    along = middle @ ALONG
    order = np.argsort(along, kind="stable")
    ends = np.searchsorted(along[order], along[order] + 2.0 * off[order], side="right")
    here = np.arange(len(order))
    for step in range(1, len(order)):
        here = here[here + step < ends[here]]
        if not len(here):
            return
        one, other = order[here], order[here + step]
        near = np.abs(middle[other] - middle[one]).max(axis=1) <= off[one]
        apart = np.abs(form[other] - form[one]).max(axis=(1, 2))
        near &= apart <= 2.0 * size[one] * off[one]
        yield from zip(one[near].tolist(), other[near].tolist(), strict=True)


def _root(first: list[int], k: int) -> int:
    while first[k] != k:
        k = first[k]
    return k
