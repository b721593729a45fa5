"""Where a scene's objects stand, for the observer's view; the same numbers as the viewer's
state/placing.ts, which a test compares."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raywalk.scene.model import Scene
from raywalk.scene.placement import placement
from raywalk.scene.shapes import Box, Cylinder, Disc, Ellipsoid, Mesh, Plane, Sphere, Triangle

UNIT_BOX = np.array([[-1.0, -1, -1], [1, 1, 1]])
FLAT_BOX = np.array([[-1.0, -1, 0], [1, 1, 0]])
CORNER_BOX = np.array([[0.0, 0, 0], [1, 1, 0]])


@dataclass(frozen=True, eq=False)
class Placed:
    """A scene and what only its geometry knows. World units."""

    scene: Scene
    centre: np.ndarray  # (3,) of a sphere round everything finite
    radius: float
    mesh_boxes: dict[str, np.ndarray]  # by object name: (2, 3) low and high, from its centre
    mesh_centres: dict[str, np.ndarray]  # by object name: (3,)

    def corners(self, index: int) -> np.ndarray:
        """(8, 3) corners of an object's own box in the world; (0, 3) for a plane."""
        obj = self.scene.objects[index]
        box = self._own_box(index)
        if box is None:
            return np.empty((0, 3))
        linear, centre = placement(obj)
        if isinstance(obj.shape, Mesh):
            linear, centre = np.eye(3), self.mesh_centres[obj.name]
        bits = np.array([[k & 1, (k >> 1) & 1, (k >> 2) & 1] for k in range(8)])
        return np.take_along_axis(box, bits, axis=0) @ linear.T + centre

    def _own_box(self, index: int) -> np.ndarray | None:
        obj = self.scene.objects[index]
        match obj.shape:
            case Plane():
                return None
            case Disc():
                return FLAT_BOX
            case Triangle():
                return CORNER_BOX
            case Mesh():
                return self.mesh_boxes[obj.name]
        return UNIT_BOX

    def is_within(self, index: int, point: np.ndarray) -> bool:
        """Whether a box, ball or cylinder has the point inside."""
        obj = self.scene.objects[index]
        if not isinstance(obj.shape, Box | Sphere | Ellipsoid | Cylinder):
            return False
        linear, centre = placement(obj)
        own = np.linalg.solve(linear, point - centre)
        if isinstance(obj.shape, Box):
            return bool((np.abs(own) < 1).all())
        if isinstance(obj.shape, Cylinder):
            return bool(own[0] ** 2 + own[1] ** 2 < 1 and abs(own[2]) < 1)
        return bool(own @ own < 1)

    def plane_of(self, index: int) -> tuple[np.ndarray, np.ndarray]:
        """A plane's point and unit normal, each (3,)."""
        linear, centre = placement(self.scene.objects[index])
        normal = np.cross(linear[:, 2], linear[:, 0])  # also right when it was stretched
        return centre, normal / np.sqrt(normal @ normal)


def read_placed(scene: Scene, display: Path) -> Placed:
    """From display.npz, which the trace stage hands on."""
    arrays = np.load(display)
    boxes, centres = {}, {}
    for k, obj in enumerate(scene.objects):
        if isinstance(obj.shape, Mesh):
            used = arrays[f"{k}.vertices"][np.unique(arrays[f"{k}.faces"])]
            low, high = used.min(axis=0), used.max(axis=0)
            boxes[obj.name] = np.array([low, low + np.where(high > low, high - low, 1.0)])
            centres[obj.name] = arrays[f"{k}.centre"]
    return Placed(scene, arrays["centre"], float(arrays["radius"]), boxes, centres)
