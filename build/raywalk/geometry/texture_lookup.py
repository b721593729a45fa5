"""The colour of a texture's picture at a place."""

from __future__ import annotations

import numpy as np

BESIDE = {"nearest": (0,), "bilinear": (0, 1)}  # pixels that count, along an axis


def looked_up(
    pixels: np.ndarray, places: np.ndarray, filter: str, repeat: tuple[float, float],
    ends: tuple[bool, bool] = (False, False),
) -> np.ndarray:  # fmt: skip
    """(n, 3) linear, 1 is full, at places (n, 2) u, v; pixels: (height, width, 3) uint8.

    The picture stands `repeat` times in a unit of u and v, from 0 on, and goes on beyond its edges;
    ends: along this axis nothing does below 0 and above 1 of the places, as at the poles of a
    sphere, and the last pixels go on instead. Of w x h pixels, column i from the left and row j
    from below, the centre lies at ((i + 1/2) / w, (j + 1/2) / h) of a picture. "nearest": the
    pixel whose square holds the place. "bilinear": at a centre that pixel's own colour, between
    four of them (1-s)(1-t) a + s (1-t) b + (1-s) t c + s t d, s and t the shares of the way.
    """
    height, width = pixels.shape[:2]
    columns, s = _along(places[:, 0], width, repeat[0], ends[0], filter)
    rows, t = _along(places[:, 1], height, repeat[1], ends[1], filter)
    corners = [[pixels[height - 1 - row, column] / 255.0 for column in columns] for row in rows]
    across = [line[0] + s[:, None] * (line[-1] - line[0]) for line in corners]
    return np.asarray(across[0] + t[:, None] * (across[-1] - across[0]))


def _along(
    place: np.ndarray, count: int, repeat: float, ends: bool, filter: str
) -> tuple[list[np.ndarray], np.ndarray]:
    """Of one axis the pixels (n,) int that count, and the share of the way to the last of them."""
    pictures = place * repeat
    if not ends:  # whole pictures go first: far out on a plane the share keeps its digits
        pictures = pictures - np.floor(pictures)
    at = pictures * count
    at = at - 0.5 if filter == "bilinear" else at
    first = np.floor(at)
    beside = [first + k for k in BESIDE[filter]]
    if ends:
        last = np.ceil(repeat * count) - 1.0
        beside = [np.clip(each, 0.0, last) for each in beside]
    return [each.astype(int) % count for each in beside], at - first
