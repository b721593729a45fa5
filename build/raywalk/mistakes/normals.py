"""Which way a surface faces at a point."""

from __future__ import annotations

import numpy as np

from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.vectors import turned, unit
from raywalk.mistakes.world import Body


def gradient(body: Body, point: np.ndarray) -> np.ndarray:
    """(3, n) outward, in the body's own coordinates, not unit; point: (3, n) in the world."""
    own = body.own_point(point)
    flat = {"plane": (0.0, 1.0, 0.0), "disc": (0.0, 0.0, 1.0), "triangle": (0.0, 0.0, 1.0)}
    if body.kind in flat:
        return np.asarray(np.zeros_like(own) + np.array(flat[body.kind], own.dtype)[:, None])
    if body.kind in ("sphere", "ellipsoid"):
        return own
    if body.kind == "box":
        return box_gradient(own)
    return side_or_cap_gradient(own, body.tip, is_capped=body.kind == "cylinder")


def box_gradient(own: np.ndarray) -> np.ndarray:
    """Of the face that the point is on: the coordinate that is largest is 1 there."""
    axis = np.abs(own).argmax(axis=0)
    is_it = np.arange(3)[:, None] == axis
    return np.where(is_it, np.copysign(1, own), 0).astype(own.dtype)


def side_or_cap_gradient(own: np.ndarray, tip: float, is_capped: bool) -> np.ndarray:
    """Of a cylinder's or cone's side, or of the end that the point is nearer to."""
    x, y, z = own
    across, slope = np.sqrt(x * x + y * y), 0.5 * (1 - tip)
    side = np.stack([x, y, -slope * across])
    if not is_capped:
        return side
    cap = np.stack([np.zeros_like(x), np.zeros_like(x), np.copysign(1, z)]).astype(own.dtype)
    is_cap = 1 - np.abs(z) < tip + slope * (1 + z) - across
    return np.where(is_cap, cap, side)


def outward_normal(body: Body, point: np.ndarray) -> np.ndarray:
    """(3, n) unit, in the world: the gradient by the inverse transpose of what takes the body into
    the world (Turkowski, "Transformations of surface normal vectors", 1990)."""
    return unit(turned(body.to_own.T, gradient(body, point)))


def programs_normal(
    body: Body, point: np.ndarray, outward: np.ndarray, mistakes: Mistakes
) -> np.ndarray:
    """The same as a program has it; outward: the true one, which most have."""
    is_kept_long = "normal-not-unit" in mistakes and body.kind in ("sphere", "ellipsoid")
    if "normal-not-by-inverse-transpose" in mistakes:
        normal = turned(body.to_world, gradient(body, point))
    elif body.kind == "sphere":
        normal = point - body.centre
    elif is_kept_long:
        normal = turned(body.to_own.T, gradient(body, point))
    else:
        return outward
    return normal if is_kept_long else unit(normal)
