"""Camera rays: one through the centre of each pixel.

Frame: right-handed, +y up; rows are counted from the top, columns from the left.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.mistakes.habits import EXACT, Habits
from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.vectors import column, cross, unit
from raywalk.scene.model import Camera

WIDE = 4 / 3  # of a screen that the program was first written for


class Span(NamedTuple):
    """What spans the picture: the ray at (x, y) goes along forward + x right + y down, with x and y
    from -1 to 1. World vectors (3,)."""

    forward: np.ndarray
    right: np.ndarray
    down: np.ndarray


def picture_span(camera: Camera, n: int, mistakes: Mistakes = frozenset()) -> Span:
    """Of a picture of n x n pixels.

    Shirley and Morley, Realistic Ray Tracing, 2nd ed., 2003, ch. 3: an orthonormal frame from the
    view and up directions; half the picture is tan(fov / 2) wide at distance 1.
    """
    eye, target, up = (np.array(v, float) for v in (camera.eye, camera.target, camera.up))
    forward = unit(target - eye)
    right = unit(cross(forward, up))
    down = -cross(right, forward)

    angle = np.radians(camera.fov)
    if "fov-in-radians" in mistakes:
        angle = camera.fov
    half_width = np.tan(angle / 2)
    if "fov-not-halved" in mistakes:
        half_width = np.tan(angle)
    right, down = half_width * right, half_width * down

    if "aspect" in mistakes:
        right = WIDE * right
    if "mirrored" in mistakes:
        right = -right
    if "upside-down" in mistakes:
        down = -down
    if "rows-and-columns-swapped" in mistakes:
        right, down = down, right
    if "pixel-corner" in mistakes:
        forward = forward - (right + down) / n
    return Span(forward, right, down)


def camera_directions(
    camera: Camera, n: int, pixels: np.ndarray, mistakes: Mistakes = frozenset(),
    habits: Habits = EXACT,
) -> np.ndarray:  # fmt: skip
    """(3, p) directions through the centres of pixels (p,), row * n + column; of length 1."""
    span = (column(vector) for vector in picture_span(camera, n, mistakes))
    forward, right, down = (np.asarray(vector, habits.precision) for vector in span)
    row, across = np.divmod(pixels, n)
    x = np.asarray(2 * (across + 0.5) / n - 1, habits.precision)
    y = np.asarray(2 * (row + 0.5) / n - 1, habits.precision)
    direction = forward + x * right + y * down
    return direction if "direction-not-unit" in mistakes else unit(direction)


def drawn_in(camera: Camera, mistake: str) -> list[float] | None:
    """How much nearer to the picture's middle than they belong, across and down, things are seen
    by a wrong camera: negative, if also on the other side. None where they are as far from it,
    or turned."""
    span, wrong = picture_span(camera, 1), picture_span(camera, 1, frozenset([mistake]))
    factors = [
        float(own @ other / (other @ other))
        for own, other in ((span.right, wrong.right), (span.down, wrong.down))
    ]
    is_turned = np.allclose(factors, 0)  # what lay across lies down
    return None if is_turned or np.allclose(np.abs(factors), 1) else factors
