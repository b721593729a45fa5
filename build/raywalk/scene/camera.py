"""The camera's frame: what rays, sections and trace files span the picture with."""

from __future__ import annotations

import numpy as np

from raywalk.scene.model import Camera


def camera_frame(camera: Camera) -> np.ndarray:
    """(3, 3) rows right, up, forward: unit world vectors."""
    eye, target, up = (np.array(v, float) for v in (camera.eye, camera.target, camera.up))
    forward = _unit(target - eye)
    right = _unit(np.cross(forward, up))
    return np.array([right, np.cross(right, forward), forward])


def half_width(camera: Camera) -> float:
    """tan(f / 2): how far the picture reaches to each side at distance 1."""
    return float(np.tan(np.radians(camera.fov) / 2))


def _unit(vector: np.ndarray) -> np.ndarray:
    return np.asarray(vector / np.sqrt(vector @ vector))
