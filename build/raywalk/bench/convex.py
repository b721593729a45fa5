"""Rays and a convex polyhedron by clipping (Cyrus and Beck): judges meshes, shares no code.

A convex solid is the intersection of half-spaces, one a face, so that a ray's hit is the
last plane it enters, if it enters all before it leaves any. No edge or vertex is special.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.bench.truth import triangle_meets
from raywalk.optics.compiled import kernel


@kernel
def clip(corners: np.ndarray, origin: np.ndarray, direction: np.ndarray) -> Any:
    """Where each ray's line enters and leaves, (n,) each; it misses if it leaves first.

    corners: (f, 3, 3), wound outwards; origin, direction: (n, 3), relative to the solid.
    """
    faces, count = corners.shape[0], origin.shape[0]
    normal, level = np.empty((faces, 3)), np.empty(faces)
    for f in range(faces):
        normal[f] = np.cross(corners[f, 1] - corners[f, 0], corners[f, 2] - corners[f, 0])
        normal[f] /= np.sqrt((normal[f] ** 2).sum())
        level[f] = (normal[f] * corners[f, 0]).sum()
    enters, leaves = np.full(count, -np.inf), np.full(count, np.inf)
    for i in range(count):
        for f in range(faces):
            down = (
                normal[f, 0] * direction[i, 0]
                + normal[f, 1] * direction[i, 1]
                + normal[f, 2] * direction[i, 2]
            )
            above = (
                normal[f, 0] * origin[i, 0]
                + normal[f, 1] * origin[i, 1]
                + normal[f, 2] * origin[i, 2]
                - level[f]
            )
            if down < 0.0:
                enters[i] = max(enters[i], -above / down)
            elif down > 0.0:
                leaves[i] = min(leaves[i], -above / down)
            elif above > 0.0:
                leaves[i] = -np.inf
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
