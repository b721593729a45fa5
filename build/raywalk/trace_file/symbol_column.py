"""Columns of symbols (which surface, which blocker): guessed from neighbours, 0 if right.

The guess continues the edge that two neighbours show: if up-left equals left, the
edge runs down between the columns, so take up; else take left.
"""

from __future__ import annotations

import numpy as np

from raywalk.trace_file.neighbours import alike
from raywalk.trace_file.symbols import Reader


def read_symbols(
    reader: Reader, group: np.ndarray, kind: np.ndarray, sides: np.ndarray
) -> np.ndarray:
    """The symbols that were noted (residuals.py); rows of a negative kind store none.

    Neighbours count if they are of the ray's group; without any, the last ray of the
    same kind serves; without that, symbol 0.
    """
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
