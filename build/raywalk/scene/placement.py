"""Where an object's canonical shape stands in the world: the tracer and the viewer place the same
shapes by the same numbers."""

from __future__ import annotations

from decimal import localcontext

import numpy as np

from raywalk.scene.exact import DIGITS, axes_across, exact, rotation, rounded, unit
from raywalk.scene.model import SceneObject

UNMOVED = np.eye(4)  # the transform of what has none
UNMOVED.flags.writeable = False


def placement(obj: SceneObject) -> tuple[np.ndarray, np.ndarray]:
    """(3, 3) linear part and (3,) centre with world = linear @ canonical + centre.

    The two are kept apart so that a ray can be moved next to the shape by one
    subtraction before anything else is rounded, however far out the scene lies.
    """
    linear, centre = exact_placement(obj)
    return rounded(linear), rounded(centre)


def exact_placement(obj: SceneObject) -> tuple[np.ndarray, np.ndarray]:
    """The same as Decimals of 50 digits: the numbers of the scene are taken as exact, so that
    what is made of them (an inverse, an axis, a sum) is rounded once and not at every step."""
    with localcontext(prec=DIGITS):
        linear, centre = obj.shape.placement()
        # Most are: two products of Decimals less.
        if is_unmoved(obj):
            return +linear, +centre
        outer = exact(obj.transform)
        return outer[:3, :3] @ linear, outer[:3, :3] @ centre + outer[:3, 3]


def is_unmoved(obj: SceneObject) -> bool:
    """Whether it stands where its shape says."""
    return obj.transform is UNMOVED or np.array_equal(obj.transform, UNMOVED)


def checker_axes(normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The two unit axes along which a plane's checker is measured; x and z on a floor."""
    with localcontext(prec=DIGITS):
        u, v = axes_across(unit(exact(normal)))
    return rounded(u), rounded(v)


def rotation_matrix(axis: np.ndarray, degrees: float) -> np.ndarray:
    """(3, 3) right-handed rotation about an axis through the origin."""
    with localcontext(prec=DIGITS):
        return rounded(rotation(unit(exact(axis)), degrees))
