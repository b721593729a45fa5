"""Which rims coincide, of discs and of cylinders and cones, and the numbers that decide for all who
have one."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal, localcontext
from typing import NamedTuple

import numpy as np

from raywalk.geometry.rims import CENTRE, FRAME, HIGH, LOW
from raywalk.scene.exact import DIGITS, rounded
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
    shapes: list[Shape], placed: list[Place], inverse: np.ndarray
) -> tuple[list[int], np.ndarray]:
    """Rows (s,) with a rim that another has too, and what `rims.py` reads of each: (s, 8, 3)
    Decimals.

    inverse: (p, 3, 3) Decimals, of the linear parts.
    """
    rims = [rim for k, shape in enumerate(shapes) for rim in _rims_of(k, shape)]
    first = _first_of_each(rims, placed)
    rows = sorted({rims[k].row for pair in enumerate(first) if pair[0] != pair[1] for k in pair})
    out = np.full((len(rows), 8, 3), Decimal(0), object)
    with localcontext(prec=DIGITS):
        for rim, one in zip(rims, first, strict=True):
            if rim.row in rows:
                linear = placed[rim.row][0]
                start = HIGH if rim.z == 1 else LOW
                numbers = _numbers(rims[one], placed, inverse, linear[:, 2])
                out[rows.index(rim.row), start : start + len(numbers)] = numbers
    return rows, out


def _rims_of(row: int, shape: Shape) -> Iterator[Rim]:
    if isinstance(shape, Disc):
        yield Rim(row, 0, Decimal(1))
    elif isinstance(shape, Cylinder | Cone):
        yield Rim(row, 1, Decimal(1))
        small, big = sorted((shape.radius, getattr(shape, "end_radius", shape.radius)))
        if small > 0.0:
            with localcontext(prec=DIGITS):  # the canonical one's quotient is rounded
                yield Rim(row, -1, Decimal(small) / Decimal(big))


def _numbers(rim: Rim, placed: list[Place], inverse: np.ndarray, up: np.ndarray) -> np.ndarray:
    """(4, 3) Decimals: centre, and rows that make it the unit circle, the last one upwards."""
    linear, centre = placed[rim.row]
    rows, radius = inverse[rim.row], rim.radius
    out = np.empty((4, 3), object)
    out[CENTRE] = centre + rim.z * linear[:, 2]
    out[FRAME], out[FRAME + 1] = rows[0] / radius, rows[1] / radius
    out[FRAME + 2] = rows[2] if rows[2] @ up > 0 else -rows[2]
    return out


def _first_of_each(rims: list[Rim], placed: list[Place]) -> list[int]:
    """(n,) the first of the rims that coincide with each: itself, if no other does."""
    first = list(range(len(rims)))
    if len(rims) < 2:
        return first
    linear = np.array([rounded(placed[rim.row][0]) for rim in rims])
    middle = np.array([rounded(placed[rim.row][1]) for rim in rims])
    middle += np.array([rim.z for rim in rims])[:, None] * linear[:, :, 2]
    flat = linear[:, :, :2] * np.array([float(rim.radius) for rim in rims])[:, None, None]
    # The same for all axes that an ellipse can be made of.
    form = flat @ flat.transpose(0, 2, 1)
    size = np.sqrt(np.abs(form).max(axis=(1, 2)))
    off = ONE * (size + np.abs(middle).max(axis=1))
    along = middle @ ALONG
    order = np.argsort(along, kind="stable")
    ends = np.searchsorted(along[order], along[order] + 2.0 * off[order], side="right")
    for place, end in enumerate(ends.tolist()):
        k, others = order[place], order[place + 1 : end]
        near = (np.abs(middle[others] - middle[k]).max(axis=1) <= off[k]) & (
            np.abs(form[others] - form[k]).max(axis=(1, 2)) <= 2.0 * size[k] * off[k]
        )
        for other in others[near]:
            one, two = sorted((_root(first, int(k)), _root(first, int(other))))
            first[two] = one
    return [_root(first, k) for k in range(len(rims))]


def _root(first: list[int], k: int) -> int:
    while first[k] != k:
        k = first[k]
    return k
