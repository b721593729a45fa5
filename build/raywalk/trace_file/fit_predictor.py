"""Finds, per column and kind of ray, the predictor that leaves the smallest file.

Any predictor decodes to the same numbers, so this is free to try and to be replaced.
"""

from __future__ import annotations

import numpy as np

from raywalk.trace_file.neighbours import follow
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
    for of in np.unique(kind).tolist():
        rows = np.flatnonzero(kind == of)
        if len(rows) < FEW:
            continue
        choices = _choices(number, rows, near, features)
        costs = [_cost(number, kind, near, features, of, rows, choice) for choice in choices]
        best = choices[int(np.argmin(costs))]
        if best != Predictor():
            found[of] = best
    return found


def _choices(
    number: np.ndarray, rows: np.ndarray, near: np.ndarray, features: list[np.ndarray]
) -> list[Predictor]:
    choices = [Predictor(), Predictor(taps=_fit_taps(number, rows, near))]
    if features:
        exact = _solve([f[rows] for f in features], number[rows])
        choices.append(Predictor(tuple(exact), None))
        short = _fit_differences(number, rows, near, features)
        if short:
            choices.append(Predictor(short))
            zeros = np.zeros(len(number), np.int64)
            off = number - affine_part(zeros, {0: Predictor(short)}, features)
            choices.append(Predictor(short, _fit_taps(off, rows, near)))
    return choices


def _solve(columns: list[np.ndarray], target: np.ndarray) -> list[float]:
    """Least squares: constant and coefficients, centred for precision."""
    table = np.stack(columns, axis=1)
    middle, mean = table.mean(axis=0), target.mean()
    found = np.linalg.lstsq(table - middle, target - mean, rcond=None)[0]
    return [float(mean - found @ middle), *found.tolist()]


def _fit_taps(off: np.ndarray, rows: np.ndarray, near: np.ndarray) -> tuple[int, ...]:
    """Six taps in whole 256ths; the rest to a sum of 256 goes to the first."""
    full = rows[(near[:6, rows] >= 0).all(axis=0)]
    if len(full) < FEW:
        return FLAT
    sides = [follow(off, near[k, full]) for k in range(6)]
    start = sides[0] + sides[1] - sides[2]
    rest = np.stack([side - start for side in sides], axis=1)
    target = off[full] - start
    usual = np.abs(target) <= np.quantile(np.abs(target), 0.95)  # edges must not set the taps
    found = np.linalg.lstsq(rest[usual], target[usual], rcond=1e-9)[0]
    taps = np.clip(np.round((np.array(FLAT) / UNIT * (1 - found.sum()) + found) * UNIT), -999, 999)
    return tuple(int(tap) for tap in taps)


def _fit_differences(
    number: np.ndarray, rows: np.ndarray, near: np.ndarray, features: list[np.ndarray]
) -> tuple[float, ...]:
    """Affine coefficients under which neighbours differ least from left + up - up-left."""
    full = rows[(near[:3, rows] >= 0).all(axis=0)]
    if len(full) < FEW:
        return ()
    bend = [_bend(column, full, near) for column in [number, *features]]
    found = np.linalg.lstsq(np.stack(bend[1:], axis=1), bend[0], rcond=1e-6)[0]
    return (0.0, *(float(format(value, SHORT)) for value in found))


def _bend(column: np.ndarray, rows: np.ndarray, near: np.ndarray) -> np.ndarray:
    left, up, up_left = (column[near[k, rows]] for k in range(3))
    return np.asarray(column[rows] - (left + up - up_left))


def _cost(
    number: np.ndarray, kind: np.ndarray, near: np.ndarray, features: list[np.ndarray],
    of: int, rows: np.ndarray, predictor: Predictor,
) -> float:  # fmt: skip
    """Bits this kind's residuals and the predictor take, about."""
    base = affine_part(kind, {of: predictor}, features)
    guess = base[rows]
    if predictor.taps:
        guess = guess + predict(number - base, near[:, rows], predictor.taps)
    residual = number[rows] - np.floor(guess + 0.5)
    size = np.abs(residual)
    counts = np.unique(np.minimum(size, 40), return_counts=True)[1]
    entropy = float(-(counts * np.log2(counts / len(rows))).sum())
    large = float(np.log2(np.maximum(size / 40, 1)).sum() + (size > 0).sum())
    return entropy + large + _header_bits(predictor)


def _header_bits(predictor: Predictor) -> float:
    digits = "exact" if predictor.taps is None else "short"
    bits = BITS_PER_NUMBER[digits] * len(predictor.affine)
    return bits + (0 if predictor.taps in (None, FLAT) else 6 * BITS_PER_NUMBER["tap"])
