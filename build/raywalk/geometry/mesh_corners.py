"""What a mesh's file says of each corner of its triangles, for the triangles that are traced."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.corners import of_quarters
from raywalk.models.clean import Cleaned
from raywalk.models.model import PerCorner


def at_corners(
    cleaned: Cleaned, rounds: int, chosen: np.ndarray, mirrored: bool, given: PerCorner | None
) -> np.ndarray | None:
    """(f, 3, k) float64 of the corners of these triangles; NaN where the file says nothing.

    rounds: of subdivision; chosen: (f,) int which of the subdivided triangles; mirrored: their
    corners run the other way round than the cleaned ones'.
    """
    if given is None:
        return None
    rows = given.row[cleaned.source]
    rows = np.where(cleaned.turned[:, None], rows[:, ::-1], rows)
    values = np.where((rows >= 0)[:, :, None], given.table[rows], np.nan)
    for _ in range(rounds):
        values = of_quarters(values)
    values = values[chosen]
    return np.ascontiguousarray(values[:, ::-1] if mirrored else values)


def interpolated(
    corners: np.ndarray, values: np.ndarray, triangle: np.ndarray, point: np.ndarray
) -> np.ndarray:
    """(n, k) what the corners say, linearly between them, at points on their triangles.

    corners: (f, 3, 3) a, b, c; values: (f, 3, k); triangle: (n,); point: (n, 3), as the corners.
    With e = b - a, g = c - a, q = p - a and N = e x g the weights of b and c are areas over areas,
    (q x g) . N / N . N and (e x q) . N / N . N; a point that rounding puts outside is moved onto
    the nearest edge. Where all three corners have one value it is that one, exactly.
    """
    a, b, c = corners[triangle].transpose(1, 0, 2)
    e, g, q = b - a, c - a, point - a
    # In units of the longest side, as squares of areas would leave float64's range.
    scale = np.abs(np.concatenate([e, g], axis=1)).max(axis=1, keepdims=True)
    e, g, q = e / scale, g / scale, q / scale
    normal = np.cross(e, g)
    whole = (normal**2).sum(axis=1)
    u = np.clip((np.cross(q, g) * normal).sum(axis=1) / whole, 0.0, 1.0)[:, None]
    v = np.clip((np.cross(e, q) * normal).sum(axis=1) / whole, 0.0, 1.0)[:, None]
    beyond = np.maximum(u + v, 1.0)
    at_a, at_b, at_c = values[triangle].transpose(1, 0, 2)
    return np.asarray(at_a + u / beyond * (at_b - at_a) + v / beyond * (at_c - at_a))
