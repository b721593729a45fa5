"""Rays and a convex polyhedron by clipping (Cyrus and Beck): judges meshes, shares no code.

A convex solid is the intersection of half-spaces, one a face, so that a ray's hit is the
last plane it enters, if it enters all before it leaves any. No edge or vertex is special.
"""

from __future__ import annotations

import numpy as np

from raywalk.bench.families import unit_rows
from raywalk.bench.truth import triangle_meets

CHUNK = 4096  # rays that meet all planes at once


def clip(
    corners: np.ndarray, origin: np.ndarray, direction: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Where each ray's line enters and leaves, (n,) each; it misses if it leaves first.

    corners: (f, 3, 3), wound outwards; origin, direction: (n, 3), relative to the solid.
    """
    normal = unit_rows(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    level = (normal * corners[:, 0]).sum(axis=1)
    enters, leaves = np.empty(len(origin)), np.empty(len(origin))
    for k in range(0, len(origin), CHUNK):
        rows = slice(k, k + CHUNK)
        down, above = direction[rows] @ normal.T, origin[rows] @ normal.T - level
        with np.errstate(divide="ignore", invalid="ignore"):
            t = -above / down
        enters[rows] = np.where(down < 0.0, t, -np.inf).max(axis=1)
        leaves[rows] = np.where(down > 0.0, t, np.inf).min(axis=1)
        leaves[rows][((down == 0.0) & (above > 0.0)).any(axis=1)] = -np.inf
    return enters, leaves


def wrong_verdicts(
    corners: np.ndarray, origin: np.ndarray, direction: np.ndarray, is_hit: np.ndarray
) -> int:
    """Rays from outside whose hit or miss is wrong; the narrow ones are judged in rationals."""
    enters, leaves = clip(corners, origin, direction)
    narrow = np.abs(leaves - enters) < 1e-12
    wrong = int((((enters <= leaves) != is_hit) & ~narrow).sum())
    for k in np.flatnonzero(narrow):
        met = [triangle_meets(corner, origin[k], direction[k]) for corner in corners]
        wrong += any(t is not None and t > 0 for t in met) != bool(is_hit[k])
    return wrong
