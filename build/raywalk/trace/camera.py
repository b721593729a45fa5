"""Camera rays: one through the centre of each pixel."""

from __future__ import annotations

import numpy as np

from raywalk.scene.model import Camera


def camera_frame(camera: Camera) -> np.ndarray:
    """(3, 3) rows right, up, forward: unit world vectors."""
    eye, target, up = (np.array(v, float) for v in (camera.eye, camera.target, camera.up))
    forward = _unit(target - eye)
    right = _unit(np.cross(forward, up))
    return np.array([right, np.cross(right, forward), forward])


def camera_directions(camera: Camera, width: int, height: int, pixels: np.ndarray) -> np.ndarray:
    """(n, 3) unit world directions through the centres of pixels.

    pixels: (n,) row * width + column, row 0 on top. In the camera's frame the direction is
    ((2 (i + 0.5) / w - 1) tan(f/2) w/h, -(2 (j + 0.5) / h - 1) tan(f/2), 1), normalised.
    """
    row, column = np.divmod(np.asarray(pixels), width)
    spread = np.tan(np.radians(camera.fov) / 2)
    x = (2 * (column + 0.5) / width - 1) * spread * (width / height)
    y = -(2 * (row + 0.5) / height - 1) * spread
    right, up, forward = camera_frame(camera)
    direction = x[:, None] * right + y[:, None] * up + forward
    return np.asarray(direction / np.sqrt((direction**2).sum(axis=1, keepdims=True)))


def _unit(vector: np.ndarray) -> np.ndarray:
    return np.asarray(vector / np.sqrt(vector @ vector))
