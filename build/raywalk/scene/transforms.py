"""Transform steps as one affine matrix."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from raywalk.scene.placement import UNMOVED, rotation_matrix
from raywalk.scene.schema_transforms import RotateTable, TransformTable

# Below it, the smallest volume a matrix makes of its columns is rounding error.
SINGULAR = 1e-12

_AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def product(steps: Sequence[TransformTable]) -> np.ndarray:
    """(4, 4) float64 product of the steps as written: the leftmost is applied last. UNMOVED itself
    without any."""
    if not steps:
        return UNMOVED
    matrix = np.eye(4)
    for step in steps:
        matrix = matrix @ step_matrix(step)
    matrix.flags.writeable = False
    return matrix


def step_matrix(step: TransformTable) -> np.ndarray:
    """(4, 4) matrix of the one key that the step has."""
    matrix = np.eye(4)
    if step.translate is not None:
        matrix[:3, 3] = step.translate
    elif step.rotate is not None:
        matrix[:3, :3] = rotation_matrix(np.array(axis_vector(step.rotate)), step.rotate.degrees)
    elif step.scale is not None:
        matrix[:3, :3] = np.diag(np.broadcast_to(step.scale, 3))
    elif step.matrix is not None:
        matrix[: len(step.matrix)] = step.matrix
    return matrix


def axis_vector(rotate: RotateTable) -> tuple[float, float, float]:
    """The axis as three numbers, of any length."""
    return _AXES[rotate.axis] if isinstance(rotate.axis, str) else rotate.axis


def is_singular(matrix: np.ndarray) -> bool:
    """Whether the matrix flattens space, judged against its own scale.

    |det| / (product of the columns' lengths) is 1 for any scaling along the axes,
    however uneven, and 0 where the columns lie in one plane (Hadamard).
    """
    if matrix is UNMOVED:  # as most are
        return False
    linear = matrix[:3, :3]
    largest = np.abs(linear).max(axis=0)
    if not np.isfinite(matrix).all() or not largest.all():
        return True
    columns = linear / largest  # first: squares of 1e-200 would vanish
    columns /= np.linalg.norm(columns, axis=0)
    return bool(abs(np.linalg.det(columns)) < SINGULAR)
