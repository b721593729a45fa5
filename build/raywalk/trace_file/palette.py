"""Pictures of few colours as a palette, found strip by strip: no array of all pixels is sorted."""

from __future__ import annotations

import numpy as np

MOST = 256  # colours of a PNG's palette
ROWS = 64  # of the picture looked at together


def palette_of(rgb8: np.ndarray) -> tuple[np.ndarray, np.ndarray] | None:
    """The colours (k, 3) uint8 in ascending order and each pixel's index (height, width) uint8;
    None if there are more than MOST. rgb8: (height, width, 3) uint8."""
    colours = np.empty(0, np.uint32)
    for top in range(0, len(rgb8), ROWS):
        colours = np.union1d(colours, _packed(rgb8[top : top + ROWS]))
        if len(colours) > MOST:
            return None
    index = np.empty(rgb8.shape[:2], np.uint8)
    for top in range(0, len(rgb8), ROWS):
        index[top : top + ROWS] = np.searchsorted(colours, _packed(rgb8[top : top + ROWS]))
    parts = [colours >> 16, colours >> 8 & 255, colours & 255]
    return np.stack(parts, axis=1).astype(np.uint8), index


def _packed(rows: np.ndarray) -> np.ndarray:
    """(height, width) uint32: red, green, blue in one number."""
    wide = rows.astype(np.uint32)
    return np.asarray(wide[..., 0] << 16 | wide[..., 1] << 8 | wide[..., 2])
