"""Triangles as corners by themselves, (f, 3, k) or in a row (3 f, k), whoever shares them."""

from __future__ import annotations

import numpy as np


def of_quarters(values: np.ndarray) -> np.ndarray:
    """(4 f, 3, k) of the four triangles that a round of subdivision makes of each: linear between
    the corners (f, 3, k). In the order of Loop's scheme: the three corners', then the middle one.
    """
    a, b, c = values.transpose(1, 0, 2)
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    four = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    made = np.stack([np.stack(each, axis=1) for each in four], axis=1)
    return made.reshape(-1, 3, values.shape[2])


def joined(*columns: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rows (v,) of the corners that differ in one of these columns (3 f, k), to 12 decimals, and
    the triangles (f, 3) in their numbers."""
    rows = np.concatenate([np.round(part.astype(float), 12) + 0.0 for part in columns], axis=1)
    _, kept, place = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    return kept, place.reshape(-1, 3)
