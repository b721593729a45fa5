"""How large a residual is likely to be, told by its neighbours', and so which text it stands in.

Where a ray's neighbours were predicted well, so is the ray, mostly. A residual's class is how many
binary digits four times the mean size of its neighbours' residuals has, and each class is a text:
deflate packs alike beside alike. In the larger classes the last digits are noise. These are kept
apart, six to a character, so that what is left fits one character again.
"""

from __future__ import annotations

import numpy as np

from raywalk.trace_file.symbols import LETTERS, write_numbers

CLASSES = 17
KEPT = 5  # digits that a class's own text keeps; those below are noise
MOST = 2**14 - 1  # sizes are no larger here
BITS = 6  # of noise in a character
SHARES = np.array([0, 256, 128, 85, 64])  # 256 by how many neighbours count
LETTER = "abcdefghijklmnopq"  # of each class, in its text's name
NOISE = np.maximum(np.arange(CLASSES) - KEPT, 0)  # digits of noise, by class


class NumberTexts:
    """Gathers residuals class by class, column after column: a reader must ask in this order."""

    def __init__(self) -> None:
        self._kept: list[list[np.ndarray]] = [[] for _ in range(CLASSES)]
        self._noise: list[np.ndarray] = []

    def add(self, codes: np.ndarray, classes: np.ndarray) -> None:
        """codes: (m,) whole numbers >= 0; classes: (m,) of each."""
        low = NOISE[classes]
        for k, kept in enumerate(self._kept):
            kept.append((codes >> low)[classes == k])
        self._noise.append(_digits(codes, low))

    def texts(self) -> dict[str, str]:
        """By name, also those that nothing stands in."""
        columns = {
            f"numbers{LETTER[k]}": write_numbers(np.concatenate([np.empty(0, np.int64), *kept]))
            for k, kept in enumerate(self._kept)
        }
        columns["noise"] = _six_each(np.concatenate([np.empty(0, np.int64), *self._noise]))
        return columns


def _digits(codes: np.ndarray, low: np.ndarray) -> np.ndarray:
    """The last low[k] binary digits of each code, highest first, one code after another."""
    end = np.cumsum(low)
    of = np.repeat(np.arange(len(codes)), low)
    return np.asarray((codes[of] >> (end[of] - 1 - np.arange(len(of)))) & 1)


def _six_each(digits: np.ndarray) -> str:
    rows = np.concatenate([digits, np.zeros(-len(digits) % BITS, np.int64)]).reshape(-1, BITS)
    return LETTERS[rows @ (1 << np.arange(BITS)[::-1])].tobytes().decode("ascii")
