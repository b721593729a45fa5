"""How columns of whole numbers are predicted from neighbours and features.

prediction = floor(l + sum of taps * (neighbour's number - neighbour's l) / 256 + 0.5)
where l is an affine function of features already known (pixel, point, normal), or 0.
Taps and affine coefficients are fitted per kind of ray and written into the header, where that
makes the file smaller. They model nothing: any would decode.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

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
