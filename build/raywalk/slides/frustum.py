"""The picture plane in space, as the viewer's state/frustum.ts places it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raywalk.scene.shapes import Plane
from raywalk.slides.placing import Placed

SHARE = 0.46  # of the way to the nearest object: well clear of the eye and of the scene
CLOSEST = 0.04  # of the scene's radius


@dataclass(frozen=True, eq=False)
class PicturePlane:
    """World units, each (3,)."""

    eye: np.ndarray
    forward: np.ndarray  # unit
    origin: np.ndarray  # top left corner
    across: np.ndarray  # the whole way to the right
    down: np.ndarray

    def at(self, column: np.ndarray | float, row: np.ndarray | float, n: int) -> np.ndarray:
        """(..., 3) corner of tile (column, row) of n x n, or a point within it for fractions."""
        u, v = np.asarray(column)[..., None] / n, np.asarray(row)[..., None] / n
        return self.origin + u * self.across + v * self.down

    def corners(self) -> np.ndarray:
        """(4, 3) clockwise from the top left."""
        return self.at(np.array([0, 1, 1, 0]), np.array([0, 0, 1, 1]), 1)


def unit(v: np.ndarray) -> np.ndarray:
    return v / np.sqrt(v @ v)


def picture_plane(placed: Placed) -> PicturePlane:
    """Before everything the camera sees, at the same place for every resolution."""
    camera = placed.scene.camera
    eye = np.array(camera.eye, float)
    forward = unit(np.array(camera.target, float) - eye)
    depths = [
        float(((placed.corners(k) - eye) @ forward).min())
        for k, obj in enumerate(placed.scene.objects)
        if not isinstance(obj.shape, Plane)
    ]
    nearest = [depth for depth in depths if depth > CLOSEST * placed.radius]
    distance = SHARE * min([*nearest, placed.radius * 2])
    while distance > CLOSEST * placed.radius and not _is_clear(_plane_at(placed, distance), placed):
        distance *= 0.9
    return _plane_at(placed, distance)


def _plane_at(placed: Placed, distance: float) -> PicturePlane:
    camera = placed.scene.camera
    eye = np.array(camera.eye, float)
    forward = unit(np.array(camera.target, float) - eye)
    right = unit(np.cross(forward, np.array(camera.up, float)))
    up = np.cross(right, forward)
    half = distance * np.tan(camera.fov * np.pi / 360)
    origin = eye + forward * distance - right * half + up * half
    return PicturePlane(eye, forward, origin, right * 2 * half, up * -2 * half)


def _is_clear(plane: PicturePlane, placed: Placed) -> bool:
    """Whether the tiles stay on the eye's side of every wall and floor."""
    for k, obj in enumerate(placed.scene.objects):
        if isinstance(obj.shape, Plane):
            point, normal = placed.plane_of(k)
            side = (plane.eye - point) @ normal
            if not ((plane.corners() - point) @ normal * side > 0).all():
                return False
        elif placed.is_within(k, plane.eye) and not all(
            placed.is_within(k, corner) for corner in plane.corners()
        ):
            return False
    return True
