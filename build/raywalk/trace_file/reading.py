"""The coder that takes columns out of a file."""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.trace_file.errors import TraceFileError
from raywalk.trace_file.number_column import Predictor, neighbours_in, read_numbers
from raywalk.trace_file.symbol_column import read_symbols
from raywalk.trace_file.symbols import Reader
from raywalk.trace_file.walk import ABSENT, Ray


class Reading:
    """Columns of one file; every one must be asked for and read to its end."""

    def __init__(self, header: dict[str, Any]):
        self.columns, self.predictors = header["columns"], header["predictors"]
        self.readers: dict[str, Reader] = {}

    def _reader(self, name: str) -> Reader:
        if name not in self.columns:
            raise TraceFileError("damaged", f"column {name} is missing")
        return self.readers.setdefault(name, Reader(name, self.columns[name]))

    def symbols(
        self, name: str, first: int, group: np.ndarray, kind: np.ndarray, sides: np.ndarray
    ) -> np.ndarray:
        return read_symbols(self._reader(name), group, kind, sides)

    def numbers(
        self, name: str, ray: Ray, group: np.ndarray, kind: np.ndarray, sides: np.ndarray,
        features: list[np.ndarray],
    ) -> np.ndarray:  # fmt: skip
        written = self.predictors.get(name, {})
        predictors = {int(of): Predictor.from_header(p) for of, p in written.items()}
        stored = kind != ABSENT
        near = neighbours_in(group, kind, sides)
        return read_numbers(self._reader(name), stored, kind, near, predictors, features)

    def finish(self) -> None:
        for reader in self.readers.values():
            reader.finish()
