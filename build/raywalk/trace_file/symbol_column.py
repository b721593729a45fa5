"""Columns of symbols (which surface, which blocker): guessed from neighbours, 0 if right.

The guess continues the edge that two neighbours show: if up-left equals left, the
edge runs down between the columns, so take up; else take left.
"""

from __future__ import annotations

import numpy as np

from raywalk.trace_file.neighbours import alike, follow, last_alike
from raywalk.trace_file.symbols import Reader


def note_symbols(
    symbol: np.ndarray, group: np.ndarray, kind: np.ndarray, sides: np.ndarray
) -> np.ndarray:
    """(m,) codes: 0 where the guess is right, else 1 + symbol.

    Neighbours count if they are of the ray's group; without any, the last ray of the
    same kind serves; without that, symbol 0. Rows of a negative kind are not to be written.
    """
    left, up, up_left = (alike(side, group) for side in sides[:3])
    last = last_alike(kind)
    edge = (up >= 0) & (up_left >= 0) & (follow(symbol, up_left) == follow(symbol, left))
    take = np.where(left < 0, up, np.where(edge, up, left))
    take = np.where(take < 0, last, take)
    guess = np.where(take < 0, 0, follow(symbol, take))
    return np.asarray(np.where(symbol == guess, 0, 1 + symbol))


def read_symbols(
    reader: Reader, group: np.ndarray, kind: np.ndarray, sides: np.ndarray
) -> np.ndarray:
    """The symbols that note_symbols was given; rows of a negative kind store none."""
    left, up, up_left = (alike(side, group).tolist() for side in sides[:3])
    last: dict[int, int] = {}
    symbol: list[int] = []
    for row, of in enumerate(kind.tolist()):
        code = reader() if of >= 0 else 1
        if code:
            symbol.append(code - 1)
        else:
            take = left[row]
            if take < 0 or (
                up[row] >= 0 and up_left[row] >= 0 and symbol[up_left[row]] == symbol[take]
            ):
                take = up[row]
            symbol.append(symbol[take] if take >= 0 else last.get(of, 0))
        last[of] = symbol[row]
    return np.array(symbol, np.int64)
