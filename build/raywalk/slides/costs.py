"""What tiles can show besides the picture: work, or what their camera rays met; as costs.ts."""

from __future__ import annotations

import numpy as np

from raywalk.trace_file import DecodedTrace, Visibility

# Anchors of the cividis map: the same order of lightness for every kind of colour vision
# (Nunez, Anderton, Renslow 2018).
CIVIDIS = np.array([
    [0x00, 0x22, 0x4E], [0x12, 0x35, 0x70], [0x3B, 0x49, 0x6C], [0x57, 0x5D, 0x6D],
    [0x70, 0x71, 0x73], [0x8A, 0x86, 0x78], [0xA5, 0x9C, 0x74], [0xC3, 0xB3, 0x69],
    [0xE1, 0xCC, 0x55], [0xFE, 0xE8, 0x38],
], float)  # fmt: skip
NOTHING = (17, 20, 25)  # a tile whose ray leaves the scene


def tile_colours(trace: DecodedTrace, view: str) -> np.ndarray:
    """(n * n, 3) 8-bit. view: "picture", "normal", or what is counted."""
    if view == "picture":
        return np.asarray(trace.tiles.reshape(-1, 3), np.uint8)
    pixels = trace.n**2
    if view == "normal":
        colours = _halves_up(255 * (trace.normal[:pixels] + 1) / 2)
        colours[trace.object[:pixels] < 0] = NOTHING
        return colours
    values = _values(trace, view)
    known = values[~np.isnan(values)]
    spread = float(known.max() - known.min()) if len(known) else 0.0
    share = (values - known.min()) / spread if spread else np.zeros(pixels)
    colours = _on_scale(np.nan_to_num(share))
    colours[np.isnan(values)] = NOTHING
    return colours


def _values(trace: DecodedTrace, view: str) -> np.ndarray:
    """(n * n,) float, NaN where a tile has none."""
    there = trace.pixel >= 0
    pixel = trace.pixel[there]
    values = np.zeros(trace.n**2)
    if view == "distance":
        first = trace.t[: trace.n**2].astype(float)
        return np.where(np.isfinite(first), first, np.nan)
    if view == "depth":
        np.maximum.at(values, pixel, trace.depth[there].astype(float))
    elif view == "tests":
        np.add.at(values, pixel, trace.tests[there].astype(float))
    else:
        shot = np.isin(trace.visibility, (Visibility.REACHED, Visibility.BLOCKED)).sum(axis=1)
        np.add.at(values, pixel, 1.0 + shot[there])
    return values


def _on_scale(share: np.ndarray) -> np.ndarray:
    at = np.clip(share, 0, 1) * (len(CIVIDIS) - 1)
    k = np.minimum(len(CIVIDIS) - 2, np.floor(at).astype(int))
    low, high = CIVIDIS[k], CIVIDIS[k + 1]
    return _halves_up(low + (at - k)[:, None] * (high - low))


def _halves_up(values: np.ndarray) -> np.ndarray:
    return np.asarray(np.floor(values + 0.5), np.uint8)
