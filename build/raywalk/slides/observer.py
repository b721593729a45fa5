"""The onlooker: where a step of the lesson is seen from, and what is where in the figure.

The same mathematics as the viewer's state/observer.ts and projection.ts; a test compares the
numbers. Figure frame: points (pt), x to the right, y down from the figure's top left.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from raywalk.slides.frustum import PicturePlane, unit
from raywalk.slides.placing import Placed

FOV = 40.0  # degrees across the figure's shorter side
ELEVATION = 20.0
FILL = 0.86  # of the figure that the scene may take at the start
CAMERA_MARGIN = 1.12  # a little more than the ray-tracing camera sees
NEAR = 1 / 300  # of the scene's radius: lines nearer to the onlooker are cut
WORLD_UP = np.array([0.0, 1.0, 0.0])


@dataclass(frozen=True, eq=False)
class Observer:
    eye: np.ndarray  # (3,)
    target: np.ndarray  # (3,)
    up: np.ndarray  # (3,)
    fov: float  # degrees across the shorter side


class Projection:
    """From the world to a figure of width x height points."""

    def __init__(self, observer: Observer, width: float, height: float):
        self.observer, self.width, self.height = observer, width, height
        self.forward = unit(observer.target - observer.eye)
        self.right = unit(np.cross(self.forward, observer.up))
        self.up = np.cross(self.right, self.forward)
        self.focal = min(width, height) / 2 / np.tan(observer.fov * np.pi / 360)

    def project(self, points: np.ndarray) -> np.ndarray:
        """(..., 3) x, y and depth (world units in front of the onlooker, negative behind)."""
        away = np.asarray(points, float) - self.observer.eye
        w = away @ self.forward
        with np.errstate(divide="ignore", invalid="ignore"):
            x = (self.width / 2 * w + self.focal * (away @ self.right)) / w
            y = (self.height / 2 * w - self.focal * (away @ self.up)) / w
        return np.stack([x, y, w], axis=-1)

    def in_front(self, ends: np.ndarray, near: float) -> np.ndarray | None:
        """The part (2, 3) of a segment before the onlooker's near plane; None if all is behind."""
        depth = (ends - self.observer.eye) @ self.forward
        if (depth < near).all():
            return None
        if (depth >= near).all():
            return ends
        cut = ends[0] + (ends[1] - ends[0]) * ((near - depth[0]) / (depth[1] - depth[0]))
        return np.array([cut, ends[1]] if depth[0] < near else [ends[0], cut])


def observer_of(choice: Any, placed: Placed, plane: PicturePlane, aspect: float) -> Observer:
    """ "start", "camera" or {"eye": .., "target": ..}; aspect: the figure's width over height."""
    if choice == "start":
        return _start(placed, plane, aspect)
    if choice == "camera":
        return _camera(placed)
    eye, target = np.array(choice["eye"], float), np.array(choice["target"], float)
    return Observer(eye, target, WORLD_UP, FOV)


def _start(placed: Placed, plane: PicturePlane, aspect: float) -> Observer:
    """Beside and above the ray-tracing camera, as near as shows every landmark."""
    ahead = unit(np.array([plane.forward[0], 0.0, plane.forward[2] or 1e-9]))
    side = unit(np.cross(ahead, WORLD_UP))
    turn = np.radians(36 + 16 * min(1.0, max(0.0, (aspect - 0.9) / 0.8)))
    tilt = np.radians(ELEVATION)
    flat = side * np.sin(turn) - ahead * np.cos(turn)
    away = flat * np.cos(tilt) + WORLD_UP * np.sin(tilt)
    points = _landmarks(placed, plane)
    target, distance = placed.centre, 2.5 * placed.radius
    # Centre what is seen and step back or forth until it just fits; a few rounds are enough.
    for _ in range(12):
        observer = Observer(target + away * distance, target, WORLD_UP, FOV)
        view = Projection(observer, aspect, 1.0)
        seen = view.project(points)[:, :2]
        low, high = seen.min(axis=0), seen.max(axis=0)
        middle, per_unit = (low + high) / 2, view.focal / distance
        target = target + view.right * ((middle[0] - aspect / 2) / per_unit)
        target = target + view.up * ((0.5 - middle[1]) / per_unit)
        distance *= max((high[0] - low[0]) / aspect, high[1] - low[1]) / FILL
    return Observer(target + away * distance, target, WORLD_UP, FOV)


def _landmarks(placed: Placed, plane: PicturePlane) -> np.ndarray:
    """(n, 3) what the start view must show: camera, picture plane, lights, finite objects."""
    scene = placed.scene
    wide = np.sqrt(plane.across @ plane.across)
    corners = np.concatenate(
        [placed.corners(k) for k in range(len(scene.objects))] or [np.empty((0, 3))]
    )
    away = corners - placed.centre
    near = corners[np.sqrt((away**2).sum(axis=1)) < 1.5 * placed.radius]
    lights = np.array([light.position for light in scene.lights], float).reshape(-1, 3)
    back = plane.eye - 0.2 * wide * plane.forward
    return np.concatenate([[back], plane.corners(), lights, near])


def _camera(placed: Placed) -> Observer:
    """Through the ray-tracing camera: the tiles cover exactly what they show."""
    camera = placed.scene.camera
    eye, target = np.array(camera.eye, float), np.array(camera.target, float)
    ahead = unit(target - eye)
    reach = max(float((placed.centre - eye) @ ahead), 0.1 * placed.radius)
    half = np.tan(np.radians(camera.fov / 2)) * CAMERA_MARGIN
    fov = float(np.arctan(half) * 360 / np.pi)
    return Observer(eye, eye + ahead * reach, np.array(camera.up, float), fov)
