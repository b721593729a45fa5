"""Camera rays: one through the centre of each pixel."""

from __future__ import annotations

import math

import numpy as np

from raywalk.optics.compiled import kernel
from raywalk.scene.camera import camera_frame, half_width
from raywalk.scene.model import Camera


def camera_directions(camera: Camera, width: int, height: int, pixels: np.ndarray) -> np.ndarray:
    """(n, 3) unit world directions through the centres of pixels.

    pixels: (n,) row * width + column, row 0 on top. In the camera's frame the direction is
    ((2 (i + 0.5) / w - 1) tan(f/2) w/h, -(2 (j + 0.5) / h - 1) tan(f/2), 1), normalised.
    """
    given = np.ascontiguousarray(pixels, np.int64)
    return np.asarray(
        unit_directions(camera_frame(camera), half_width(camera), width, height, given)
    )


@kernel
def unit_directions(frame, spread, width, height, pixels):
    """The same from the camera's frame and tan(f/2)."""
    out = np.empty((pixels.shape[0], 3))
    for i in range(pixels.shape[0]):
        row, column = pixels[i] // width, pixels[i] % width
        x = (2 * (column + 0.5) / width - 1) * spread * (width / height)
        y = -(2 * (row + 0.5) / height - 1) * spread
        dx = x * frame[0, 0] + y * frame[1, 0] + frame[2, 0]
        dy = x * frame[0, 1] + y * frame[1, 1] + frame[2, 1]
        dz = x * frame[0, 2] + y * frame[1, 2] + frame[2, 2]
        length = math.sqrt(dx * dx + dy * dy + dz * dz)
        out[i, 0], out[i, 1], out[i, 2] = dx / length, dy / length, dz / length
    return out
