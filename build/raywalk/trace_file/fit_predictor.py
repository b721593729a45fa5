"""Finds, per column and kind of ray, the predictor that leaves the smallest file.

Any predictor decodes to the same numbers, so this is free to try and to be replaced.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from raywalk.trace_file import residuals

UNIT = 256  # of taps
FLAT = (UNIT, UNIT, -UNIT, 0, 0, 0)  # left + up - up-left: right on any plane


@dataclass(frozen=True)
class Predictor:
    """Of one kind of ray in one column. taps None: the affine part stands alone."""

    affine: tuple[float, ...] = ()  # constant, then one coefficient per feature
    taps: tuple[int, ...] | None = FLAT

    def header(self) -> dict[str, list]:
        written: dict[str, list] = {}
        if self.affine:
            written["affine"] = list(self.affine)
        if self.taps != FLAT:
            written["taps"] = list(self.taps or ())
        return written


def affine_part(
    kind: np.ndarray, predictors: dict[int, Predictor], features: Sequence[np.ndarray]
) -> np.ndarray:
    """l of every row. One product and one sum at a time, as the viewer does it."""
    part = np.zeros(len(kind))
    for of, predictor in predictors.items():
        if predictor.affine:
            rows = np.flatnonzero(kind == of)
            value = np.full(len(rows), float(predictor.affine[0]))
            for coefficient, feature in zip(predictor.affine[1:], features, strict=True):
                value = value + coefficient * feature[rows]
            part[rows] = value
    return part


FEW = 24  # below so many rays no fit repays its place in the header
BITS_PER_NUMBER = {"exact": 100.0, "short": 40.0, "tap": 22.0}  # gzipped JSON, about
SHORT = ".5g"  # digits of coefficients that only have to be nearly right
USUAL = 0.95  # of the rays set the taps; the others stand at edges
# Squares of singular values below this share of the largest are taken for rounding.
RANK = 1e-12


def fit_predictors(
    number: np.ndarray, kind: np.ndarray, near: np.ndarray, features: Sequence[np.ndarray]
) -> dict[int, Predictor]:
    """The cheapest predictor of each kind; kinds served best by the usual one are left out.

    near: (m, 7), see residuals.near_in.
    """
    found = {}
    known = np.stack(features) if features else np.empty((0, len(number)))
    order, start = residuals.rows_by_kind(kind)
    for of in np.flatnonzero(np.diff(start) >= FEW).tolist():
        column = _Column(number, order[start[of] : start[of + 1]], near, known)
        usual, best = column.cost(Predictor()), Predictor()
        for choice in _choices(column, usual):
            if (cost := column.cost(choice)) < usual:
                usual, best = cost, choice
        if best != Predictor():
            found[of] = best
    return found


@dataclass(frozen=True, eq=False)
class _Column:
    """One kind's part of a column."""

    number: np.ndarray  # (m,)
    rows: np.ndarray  # (r,) of the kind; their neighbours are of the same kind
    near: np.ndarray  # (m, 7)
    features: np.ndarray  # (f, m)

    def off(self, predictor: Predictor) -> np.ndarray:
        """(m,) what the affine part leaves, in this kind's rows."""
        if not predictor.affine:
            return self.number
        off = np.empty(len(self.number))
        affine = np.array(predictor.affine)
        residuals.off_affine(self.number, self.rows, self.features, affine, off)
        return off

    def cost(self, predictor: Predictor) -> float:
        """Bits this kind's residuals and the predictor take, about."""
        how, taps = how_and_taps(predictor)
        off = self.off(predictor)
        bits = residuals.residual_bits(self.number, off, self.rows, self.near, how, taps)
        return float(bits) + _header_bits(predictor)


def how_and_taps(predictor: Predictor) -> tuple[int, np.ndarray]:
    """As the kernels want them."""
    if predictor.taps is None:
        return residuals.ALONE, np.zeros(6)
    how = residuals.PLANE if predictor.taps == FLAT else residuals.TAPS
    return how, np.array(predictor.taps, float)


def _choices(column: _Column, usual: float) -> Iterator[Predictor]:
    """Fitted predictors whose own place in the header may pay: usual: bits without any."""
    count = len(column.features) + 1
    if 6 * BITS_PER_NUMBER["tap"] < usual:
        yield Predictor(taps=_fit_taps(column, column.number))
    if count == 1:
        return
    if count * BITS_PER_NUMBER["exact"] < usual:
        yield Predictor(_fit_exactly(column), None)
    if count * BITS_PER_NUMBER["short"] < usual and (short := _fit_differences(column)):
        yield Predictor(short)
        yield Predictor(short, _fit_taps(column, column.off(Predictor(short))))


def _fit_exactly(column: _Column) -> tuple[float, ...]:
    """Least squares: constant and coefficients, to the last digits."""
    table, mean = residuals.centred(column.number, column.features, column.rows)
    found = _solved(residuals.products(table))
    # Once more for what the first solution leaves: sums of squares lose half the digits.
    for k, coefficient in enumerate(found.tolist()):
        table[-1] -= coefficient * table[k]
    found = found + _solved(residuals.products(table))
    middle = sum(c * m for c, m in zip(found.tolist(), mean[:-1].tolist(), strict=True))
    return (float(mean[-1]) - middle, *found.tolist())


def _fit_taps(column: _Column, off: np.ndarray) -> tuple[int, ...]:
    """Six taps in whole 256ths; the rest to a sum of 256 is shared as in FLAT."""
    full = residuals.surrounded(column.rows, column.near, residuals.FULL)
    if len(full) < FEW:
        return FLAT
    target = residuals.bends(off, full, column.near)
    place = int(USUAL * (len(full) - 1))
    most = float(np.partition(np.abs(target), place)[place])
    table = residuals.tap_columns(off, full, column.near, target, most)
    found = _solved(residuals.products(table))
    taps = np.round((np.array(FLAT) / UNIT * (1 - found.sum()) + found) * UNIT)
    return tuple(int(tap) for tap in np.clip(taps, -999, 999))


def _fit_differences(column: _Column) -> tuple[float, ...]:
    """Affine coefficients under which neighbours differ least from left + up - up-left."""
    full = residuals.surrounded(column.rows, column.near, residuals.CORNER)
    if len(full) < FEW:
        return ()
    values = [*column.features, column.number]
    bend = np.stack([residuals.bends(value, full, column.near) for value in values])
    found = _solved(residuals.products(bend))
    return (0.0, *(float(format(value, SHORT)) for value in found))


def _solved(products: np.ndarray) -> np.ndarray:
    """Least squares for the last column by the others, from all their products; of smallest
    length where columns depend on one another."""
    return np.asarray(np.linalg.lstsq(products[:-1, :-1], products[:-1, -1], rcond=RANK)[0])


def _header_bits(predictor: Predictor) -> float:
    digits = "exact" if predictor.taps is None else "short"
    bits = BITS_PER_NUMBER[digits] * len(predictor.affine)
    return bits + (0 if predictor.taps in (None, FLAT) else 6 * BITS_PER_NUMBER["tap"])
