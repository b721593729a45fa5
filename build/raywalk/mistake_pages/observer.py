"""An observer beside the scene, who sees the rays of two programs, and what stands before them.

Frame of a view: x to the right and y down, 0 to 1 from its top left.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from raywalk.mistake_pages.segments import Segment
from raywalk.mistakes.camera import picture_span
from raywalk.mistakes.rays import NOTHING
from raywalk.mistakes.tracer import Wave, trace
from raywalk.mistakes.world import FLAT, Body, world_of
from raywalk.scene.model import Camera, Light, Material, Render, Scene

FOV = 36.0  # degrees
MARGIN = 1.12  # of the distance at which all that is drawn just fits
# Round the upright from the ray-tracing camera's own direction, and above the horizon; degrees.
TURNS, RISE = (-50, 50, -85, 85), 24
ROUGH = 24  # pixels across of a view that is tried
SAMPLES = 64  # points along a line that are asked whether something stands before them
BEFORE = 0.02  # of the distance: what is nearer by less is the surface that the line ends on
SHARED = 0.15  # what a shared line counts beside one that differs


@dataclass(frozen=True, eq=False)
class View:
    """What an observer sees."""

    camera: Camera
    wave: Wave  # camera rays of a picture of n x n
    n: int

    def project(self, points: np.ndarray) -> np.ndarray:
        """(p, 2) places of points (p, 3)."""
        span = picture_span(self.camera, self.n)
        away = points - np.array(self.camera.eye)
        depth = away @ span.forward
        x = away @ span.right / (depth * (span.right @ span.right))
        y = away @ span.down / (depth * (span.down @ span.down))
        return np.stack([(1 + x) / 2, (1 + y) / 2], axis=1)

    def is_hidden(self, points: np.ndarray) -> np.ndarray:
        """(p,) bool: something stands before each of these points (p, 3)."""
        away = np.linalg.norm(points - np.array(self.camera.eye), axis=1)
        column, row = np.clip((self.project(points) * self.n).astype(int), 0, self.n - 1).T
        return np.asarray(self.wave.hits.t[row * self.n + column] < away * (1 - BEFORE))


def best_view(scene: Scene, segments: Sequence[Segment]) -> Camera:
    """From where most of the lines that differ is seen."""
    ends = [end for each in segments for end in (each.start, each.end)]
    points = np.concatenate([np.array(ends), *extents(scene)])
    stands = [standing(scene.camera, points, turn) for turn in TURNS]
    views = [seen_from(scene, stand, ROUGH) for stand in stands]
    return max(views, key=lambda view: worth(view, segments)).camera


def extents(scene: Scene) -> list[np.ndarray]:
    """(6, 3) of each body that is not endless: the ends of its three axes."""
    bodies = [body for body in world_of(scene).bodies if body.kind not in FLAT]
    return [
        np.concatenate([(body.centre + sign * body.to_world).T for sign in (1, -1)])
        for body in bodies
    ]


def is_between(body: Body, eye: np.ndarray, observer: np.ndarray) -> bool:
    """A wall that the observer looks at from behind, into a room."""
    if body.kind not in FLAT:
        return False
    normal = body.to_own[1 if body.kind == "plane" else 2]
    sides = [float(normal @ (place - body.centre[:, 0])) for place in (eye, observer)]
    return sides[0] * sides[1] < 0


def worth(view: View, segments: Sequence[Segment]) -> float:
    """How much of the lines is seen, by their length in the view."""
    total = 0.0
    for each in segments:
        points = along(each)
        ends = view.project(points[[0, -1]])
        seen = 1 - 0.8 * view.is_hidden(points).mean()
        total += seen * np.linalg.norm(ends[1] - ends[0]) * (SHARED if each.who == "both" else 1)
    return float(total)


def along(segment: Segment) -> np.ndarray:
    """(SAMPLES, 3) points from its start to its end."""
    share = np.linspace(0, 1, SAMPLES)[:, None]
    return np.asarray((1 - share) * segment.start + share * segment.end)


def standing(camera: Camera, points: np.ndarray, turn: float) -> Camera:
    """Looks at the middle of points (p, 3), from as near as shows them all."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle = (low + high) / 2
    back = np.array(camera.eye) - np.array(camera.target)
    angle = np.arctan2(back[0], back[2]) + np.radians(turn)
    rise = np.radians(RISE)
    out = np.array([np.sin(angle) * np.cos(rise), np.sin(rise), np.cos(angle) * np.cos(rise)])
    right = np.array([np.cos(angle), 0, -np.sin(angle)])
    up = np.cross(out, right)
    away = points - middle
    beside = np.maximum(np.abs(away @ right), np.abs(away @ up))
    far = float((away @ out + beside / np.tan(np.radians(FOV / 2))).max())
    far = max(far, 1e-3) * MARGIN
    eye = middle + far * out
    return Camera(_triple(eye), _triple(middle), (0.0, 1.0, 0.0), FOV)


def seen_from(scene: Scene, camera: Camera, n: int) -> View:
    """The bodies in clay, lit from beside the observer: no ray but camera rays. Walls that stand
    between observer and room are left out."""
    eye, inner = np.array(camera.eye), np.array(scene.camera.eye)
    inside = [
        obj for obj, body in zip(scene.objects, world_of(scene).bodies, strict=True)
        if not is_between(body, inner, eye)
    ]  # fmt: skip
    lamp = Light("lamp", _triple(eye + np.array([0.0, 0.6, 0.0]) * np.linalg.norm(eye)))
    plain = replace(
        scene, camera=camera, lights=(lamp,), background=(0.0, 0.0, 0.0), objects=tuple(inside),
        materials=tuple(clay(material) for material in scene.materials),
        render=Render(shadows=False, depth=0),
    )  # fmt: skip
    return View(camera, trace(plain, n, np.arange(n * n))[1][0], n)


def clay(material: Material) -> Material:
    """A dull likeness of it, on which lines are seen."""
    tint = max((material.diffuse, material.specular), key=max)
    grey = [0.24 + 0.26 * part for part in tint]
    ambient, diffuse = (_triple([share * part for part in grey]) for share in (0.35, 0.65))
    return Material(material.name, ambient, diffuse)


def clay_picture(view: View, centre: np.ndarray, reach: float) -> np.ndarray:
    """(n, n, 4) uint8, clear where nothing is; planes fade from `reach` round the centre on."""
    hits, n = view.wave.hits, view.n
    rgb = np.clip(view.wave.colour.T, 0, 1)
    far = np.linalg.norm(np.nan_to_num(hits.point.T, posinf=1e9, neginf=-1e9) - centre, axis=1)
    alpha = np.where(hits.object == NOTHING, 0, np.clip(2 - far / reach, 0, 1))
    shown = np.concatenate([rgb, alpha[:, None]], axis=1)
    return np.asarray(np.round(255 * shown).astype(np.uint8).reshape(n, n, 4))


def _triple(values: Sequence[float] | np.ndarray) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
