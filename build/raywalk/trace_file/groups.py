"""Rows that share a value, found for all values at once."""

from __future__ import annotations

import numpy as np


def rows_of_each(value: np.ndarray, count: int) -> list[np.ndarray]:
    """For each of the values 0 .. count - 1 the rows (ascending) that have it; value: (m,) int.

    Asked for one value after the other, each would look at all rows: with thousands of objects
    in a picture that took minutes.
    """
    order = np.argsort(value, kind="stable")
    ends = np.searchsorted(value[order], np.arange(count + 1))
    return [order[a:b] for a, b in zip(ends[:-1].tolist(), ends[1:].tolist(), strict=True)]
