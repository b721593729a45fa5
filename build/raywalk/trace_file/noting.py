"""The coder: is given every column's true numbers and notes the residuals."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from raywalk.trace_file import residuals
from raywalk.trace_file.expected import NumberTexts
from raywalk.trace_file.fit_predictor import Predictor, affine_part, fit_predictors, how_and_taps
from raywalk.trace_file.precision import WHOLE
from raywalk.trace_file.symbols import write_numbers, zigzag

Ray = dict[str, np.ndarray]  # columns over rays, as rebuilt so far
ABSENT = -1  # kind and group of rays that store nothing in a column


class Noting:
    """Gathers the columns' texts and the predictors that serve them; gives back the whole numbers
    that a reader will have. Arrays count rays; kind and group are ABSENT where nothing is stored.
    """

    def __init__(self, symbols: dict[str, np.ndarray]):
        self.known = symbols
        self.texts: dict[str, list[str]] = {}  # of symbols
        self.noted = NumberTexts()
        self.predictors: dict[str, dict[str, Any]] = {}
        self.same: dict[str, int] = {}  # columns whose numbers are all the same

    def symbols(
        self, name: str, first: int, group: np.ndarray, kind: np.ndarray, sides: np.ndarray
    ) -> np.ndarray:
        symbol = np.ascontiguousarray(self.known[name][first : first + len(kind)])
        codes = residuals.symbol_codes(symbol, group, kind, sides)[kind != ABSENT]
        self.texts.setdefault(name, []).append(write_numbers(codes))
        return symbol

    def numbers(
        self, name: str, true: np.ndarray, stored: np.ndarray, group: np.ndarray,
        kind: np.ndarray, sides: np.ndarray, features: Sequence[np.ndarray] = (),
    ) -> np.ndarray:  # fmt: skip
        """true: (m,) in steps, not yet rounded; stored: (m,) bool: which rays have one."""
        if not stored.any():
            return np.zeros(len(kind))
        group, kind = np.where(stored, group, ABSENT), np.where(stored, kind, ABSENT)
        # A ray that runs along an endless plane, but for rounding, meets it farther out than
        # numbers go: it is drawn to where they end.
        rounded = np.clip(np.floor(np.asarray(true, float) + 0.5), -WHOLE, WHOLE)
        number = np.where(stored, rounded, 0.0)
        if np.ptp(number[stored]) == 0:
            self.same[name] = int(number[stored][0])
            return number
        near = residuals.near_in(group, kind, sides)
        predictors = fit_predictors(number, kind, near, features)
        left, classes = note_numbers(number, kind, near, predictors, features)
        self.noted.add(zigzag(left[stored]), classes[stored])
        if predictors:
            self.predictors[name] = {str(of): p.header() for of, p in predictors.items()}
        return number

    def columns(self) -> dict[str, str]:
        """Every text of the file, by name."""
        symbols = {name: "".join(parts) for name, parts in self.texts.items()}
        return symbols | self.noted.texts()


def note_numbers(
    number: np.ndarray, kind: np.ndarray, near: np.ndarray,
    predictors: dict[int, Predictor], features: Sequence[np.ndarray],
) -> tuple[np.ndarray, np.ndarray]:  # fmt: skip
    """(m,) int64 residuals of whole numbers (float64, below 2**51), and (m,) the class of each;
    near as in residuals.py."""
    kinds = int(kind.max(initial=0)) + 1
    how, taps = np.full(kinds, residuals.PLANE), np.zeros((kinds, 6))
    for of, predictor in predictors.items():
        how[of], taps[of] = how_and_taps(predictor)
    base = affine_part(kind, predictors, features)
    left, classes = residuals.residuals(number, base, kind, near, how, taps)
    return left, classes
