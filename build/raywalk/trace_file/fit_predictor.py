"""Finds, per column and kind of ray, the predictor that leaves the smallest file.

Any predictor decodes to the same numbers, so this is free to try and to be replaced.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.trace_file.neighbours import NONE
from raywalk.trace_file.number_column import (
    FLAT,
    UNIT,
    Predictor,
    affine_part,
    predict,
)

FEW = 24  # below so many rays no fit repays its place in the header
BITS_PER_NUMBER = {"exact": 100.0, "short": 40.0, "tap": 22.0}  # gzipped JSON, about
SHORT = ".5g"  # digits of coefficients that only have to be nearly right


def fit_predictors(
    number: np.ndarray, kind: np.ndarray, near: np.ndarray, features: list[np.ndarray]
) -> dict[int, Predictor]:
    """The cheapest predictor of each kind; kinds served best by the usual one are left out."""
    found = {}
    place = np.full(len(number) + 1, NONE)  # the last serves neighbour -1
    for of in np.unique(kind[kind != NONE]).tolist():
        rows = np.flatnonzero(kind == of)
        if len(rows) < FEW:
            continue
        place[rows] = np.arange(len(rows))  # neighbours are of the same kind
        column = _Column(number[rows], place[near[:, rows]], [f[rows] for f in features])
        choices = _choices(column)
        best = choices[int(np.argmin([_cost(column, choice) for choice in choices]))]
        if best != Predictor():
            found[of] = best
    return found


class _Column(NamedTuple):
    """One kind's part of a column, rows counted in it."""

    number: np.ndarray
    near: np.ndarray
    features: list[np.ndarray]

    def off(self, predictor: Predictor) -> np.ndarray:
        """What the affine part leaves."""
        alone = np.zeros(len(self.number), np.int64)
        return self.number - affine_part(alone, {0: predictor}, self.features)


def _choices(column: _Column) -> list[Predictor]:
    choices = [Predictor(), Predictor(taps=_fit_taps(column.number, column.near))]
    if column.features:
        exact = _solve(column.features, column.number)
        choices.append(Predictor(tuple(exact), None))
        short = _fit_differences(column)
        if short:
            rest = column.off(Predictor(short))
            choices += [Predictor(short), Predictor(short, _fit_taps(rest, column.near))]
    return choices


def _solve(columns: list[np.ndarray], target: np.ndarray) -> list[float]:
    """Least squares: constant and coefficients, centred for precision."""
    table = np.stack(columns, axis=1)
    middle, mean = table.mean(axis=0), target.mean()
    found = np.linalg.lstsq(table - middle, target - mean, rcond=None)[0]
    return [float(mean - found @ middle), *found.tolist()]


def _fit_taps(off: np.ndarray, near: np.ndarray) -> tuple[int, ...]:
    """Six taps in whole 256ths; the rest to a sum of 256 is shared as in FLAT."""
    full = np.flatnonzero((near[:6] >= 0).all(axis=0))
    if len(full) < FEW:
        return FLAT
    sides = [off[near[k, full]] for k in range(6)]
    start = sides[0] + sides[1] - sides[2]
    rest = np.stack([side - start for side in sides], axis=1)
    target = off[full] - start
    usual = np.abs(target) <= np.quantile(np.abs(target), 0.95)  # edges must not set the taps
    found = np.linalg.lstsq(rest[usual], target[usual], rcond=1e-9)[0]
    taps = np.round((np.array(FLAT) / UNIT * (1 - found.sum()) + found) * UNIT)
    return tuple(int(tap) for tap in np.clip(taps, -999, 999))


def _fit_differences(column: _Column) -> tuple[float, ...]:
    """Affine coefficients under which neighbours differ least from left + up - up-left."""
    full = np.flatnonzero((column.near[:3] >= 0).all(axis=0))
    if len(full) < FEW:
        return ()
    left, up, up_left = column.near[:3, full]
    bend = [
        values[full] - (values[left] + values[up] - values[up_left])
        for values in (column.number, *column.features)
    ]
    found = np.linalg.lstsq(np.stack(bend[1:], axis=1), bend[0], rcond=1e-6)[0]
    return (0.0, *(float(format(value, SHORT)) for value in found))


def _cost(column: _Column, predictor: Predictor) -> float:
    """Bits this kind's residuals and the predictor take, about."""
    off = column.off(predictor)
    guess = column.number - off
    if predictor.taps:
        guess = guess + predict(off, column.near, predictor.taps)
    size = np.abs(column.number - np.floor(guess + 0.5))
    counts = np.unique(np.minimum(size, 40), return_counts=True)[1]
    entropy = float(-(counts * np.log2(counts / len(size))).sum())
    large = float(np.log2(np.maximum(size / 40, 1)).sum() + (size > 0).sum())
    return entropy + large + _header_bits(predictor)


def _header_bits(predictor: Predictor) -> float:
    digits = "exact" if predictor.taps is None else "short"
    bits = BITS_PER_NUMBER[digits] * len(predictor.affine)
    return bits + (0 if predictor.taps in (None, FLAT) else 6 * BITS_PER_NUMBER["tap"])
