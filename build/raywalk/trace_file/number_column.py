"""Columns of whole numbers: residuals against a prediction from neighbours and features.

prediction = floor(l + sum of taps * (neighbour's number - neighbour's l) / 256 + 0.5)
where l is an affine function of features already known (pixel, point, normal), or 0.
Taps and affine coefficients are fitted by the encoder per kind of ray and written into
the header, where that makes the file smaller. They model nothing: any would decode.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raywalk.trace_file.neighbours import alike, last_alike, six
from raywalk.trace_file.symbols import Reader

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

    @staticmethod
    def from_header(written: dict[str, list]) -> Predictor:
        taps = tuple(written.get("taps", FLAT)) or None
        return Predictor(tuple(written.get("affine", ())), taps)


def affine_part(
    kind: np.ndarray, predictors: dict[int, Predictor], features: list[np.ndarray]
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


def neighbours_in(group: np.ndarray, kind: np.ndarray, sides: np.ndarray) -> np.ndarray:
    """(7, m) the six neighbours and the last of the kind, -1 where not of the group."""
    return np.concatenate([[alike(side, group) for side in six(sides)], [last_alike(kind)]])


def read_numbers(
    reader: Reader, stored: np.ndarray, kind: np.ndarray, near: np.ndarray,
    predictors: dict[int, Predictor], features: list[np.ndarray],
) -> np.ndarray:  # fmt: skip
    """The numbers that were noted (residuals.py), one after the other; 0 where none is stored."""
    base = affine_part(kind, predictors, features).tolist()
    usual = Predictor()
    taps_of = {of: predictors.get(of, usual).taps for of in np.unique(kind).tolist()}
    off = [0.0] * len(kind)
    number = np.zeros(len(kind))
    rows = np.flatnonzero(stored)
    for row, of, sides in zip(
        rows.tolist(), kind[rows].tolist(), near.T[rows].tolist(), strict=True
    ):
        taps = taps_of[of]
        guess = base[row] + _predict_one(off, sides, taps) if taps else base[row]
        value = float(np.floor(guess + 0.5)) + reader.signed()
        number[row], off[row] = value, value - base[row]
    return number


def _predict_one(off: list[float], sides: list[int], taps: tuple[int, ...]) -> float:
    left, up, up_left, up_right, left2, up2, last = sides
    if left >= 0:
        if up >= 0 and up_left >= 0:
            if up_right < 0 or left2 < 0 or up2 < 0:
                return off[left] + off[up] - off[up_left]
            whole = off[left] * taps[0] + off[up] * taps[1] + off[up_left] * taps[2]
            whole = whole + off[up_right] * taps[3] + off[left2] * taps[4]
            return (whole + off[up2] * taps[5]) / UNIT
        if left2 >= 0:
            return 2 * off[left] - off[left2]
    if up >= 0 and up2 >= 0:
        return 2 * off[up] - off[up2]
    return next((off[row] for row in (left, up, up_left, up_right, last) if row >= 0), 0.0)
