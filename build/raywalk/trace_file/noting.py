"""The coder that writes: knows every column's true numbers and notes the residuals."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from raywalk.trace_file.fit_predictor import fit_predictors
from raywalk.trace_file.number_column import neighbours_in, note_numbers
from raywalk.trace_file.symbol_column import note_symbols
from raywalk.trace_file.symbols import write_numbers, zigzag
from raywalk.trace_file.walk import ABSENT, Ray

# (column, what is rebuilt so far) -> true values in steps, not yet rounded; one per ray
Truth = Callable[[str, Ray], np.ndarray]


class Noting:
    """Gathers the columns' texts and the predictors that serve them."""

    def __init__(self, symbols: dict[str, np.ndarray], truth: Truth):
        self.known, self.truth = symbols, truth
        self.texts: dict[str, list[str]] = {}
        self.predictors: dict[str, dict[str, Any]] = {}

    def symbols(
        self, name: str, first: int, group: np.ndarray, kind: np.ndarray, sides: np.ndarray
    ) -> np.ndarray:
        symbol = self.known[name][first : first + len(kind)]
        codes = note_symbols(symbol, group, kind, sides)[kind != ABSENT]
        self.texts.setdefault(name, []).append(write_numbers(codes))
        return symbol

    def numbers(
        self, name: str, ray: Ray, group: np.ndarray, kind: np.ndarray, sides: np.ndarray,
        features: list[np.ndarray],
    ) -> np.ndarray:  # fmt: skip
        stored = kind != ABSENT
        exact = self.truth(name, ray) if stored.any() else np.zeros(len(kind))
        number = np.where(stored, np.floor(exact + 0.5), 0.0)
        near = neighbours_in(group, kind, sides)
        predictors = fit_predictors(number, kind, near, features)
        residual = note_numbers(number, kind, near, predictors, features)[stored]
        self.texts[name] = [write_numbers(zigzag(residual.astype(np.int64)))]
        if predictors:
            self.predictors[name] = {str(of): p.header() for of, p in predictors.items()}
        return number

    def columns(self) -> dict[str, str]:
        return {name: "".join(parts) for name, parts in self.texts.items()}
