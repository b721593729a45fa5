"""Whether a step shows what it names: objects and lights by the rays that it draws or from where
its observer stands, boxes by being drawn."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from raywalk.geometry.coincide import samples_of
from raywalk.scene.camera import camera_frame
from raywalk.scene.model import Scene
from raywalk.trace.observer_view import hidden_points
from raywalk.trace.wavefront import Tracer

# Half of what a person sees across a wide stage (40 degrees high) to its corners.
HALF_VIEW = np.cos(np.radians(33.0))
ACROSS = 40  # sight lines along each edge of the view
SAMPLES = 60  # points of an object's surface
BOXES = {
    "en": r"\b(bounding (box|volume|sphere)s?|boxes)\b",
    "de": r"\b(Hüll(quader|körper|kugel)n?|Quadern?)\b",
}


def unseen(
    text: str, view: Mapping[str, Any], scene: Scene, tracer: Tracer, language: str
) -> list[str]:
    """What a text names that its step does not show; scene: in the text's language, the tracer's
    in its own, of the same objects and lights."""
    objects = [(obj.name, k) for k, obj in enumerate(scene.objects)]
    lights = [(light.name, k) for k, light in enumerate(scene.lights)]
    named = dict(_named(text, [name for name, _ in (*objects, *lights)]))
    if not named and language not in BOXES:
        return []
    eyes = _Eyes(view, tracer)
    missing = [name for name, k in objects if name in named and not eyes.shows_object(k)]
    missing += [name for name, k in lights if name in named and not eyes.shows_light(k)]
    missing = [name for name in missing if name not in (view.get("highlight") or ())]
    found = [f'"{name}" is named, but neither met by the rays shown nor seen' for name in missing]
    boxes = re.search(BOXES.get(language, "(?!)"), text)
    drawn = view.get("boxes") or view.get("colours") == "tests" or view.get("works") == "tree"
    if boxes and scene.has_mesh and not drawn:
        found.append(f'"{boxes[0]}" are named, but no boxes are drawn: boxes = true')
    return found


def _named(text: str, names: list[str]) -> Iterator[tuple[str, bool]]:
    """The names in a text, the longest first, whatever their endings: rote Kugel, roten Kugel."""
    rest = text
    for name in sorted(set(names), key=len, reverse=True):
        stems = [re.sub(r"(?<=\w{3})(e|en|er|es|s)$", "", word) for word in name.split()]
        pattern = r"\s+".join(rf"{re.escape(stem)}\w{{0,2}}" for stem in stems)
        if re.search(rf"(?<!\w){pattern}(?!\w)", rest, re.IGNORECASE):
            yield name, True
            rest = re.sub(rf"(?<!\w){pattern}(?!\w)", " ", rest, flags=re.IGNORECASE)


class _Eyes:
    """What a step's view shows: found when it is asked for."""

    def __init__(self, view: Mapping[str, Any], tracer: Tracer):
        self.view, self.tracer = view, tracer
        self._met: set[int] | None = None
        self._asks = False
        self.eye: np.ndarray | None
        observer = view.get("observer", "start")
        if observer == "camera" or view.get("look") == "traced":
            self.eye = np.array(tracer.scene.camera.eye, float)
            self.ahead = camera_frame(tracer.scene.camera)[2]
        elif isinstance(observer, str):
            self.eye = None  # the start view shows every object and lamp
            self.ahead = np.zeros(3)
        else:
            self.eye = np.array(observer["eye"], float)
            ahead = np.array(observer["target"], float) - self.eye
            self.ahead = ahead / np.linalg.norm(ahead)

    def shows_object(self, k: int) -> bool:
        return self.eye is None or k in self.met or self._sees(k)

    def shows_light(self, k: int) -> bool:
        at = np.array([self.tracer.scene.lights[k].position], float)
        return self.eye is None or (bool(self.met) and self._asks) or bool(self._in_view(at).any())

    @property
    def met(self) -> set[int]:
        """Objects that rays shown meet, or that stop their shadow rays."""
        if self._met is None:
            self._met = set()
            for wave in self.tracer.waves(*self._pixels()) if self.view.get("rays") else ():
                for of in (wave.hits.object, wave.lighting.blocker):
                    self._met |= set(np.unique(of[of >= 0]).tolist())
                self._asks |= bool((wave.lighting.local_weight > 0).any())
        return self._met

    def _pixels(self) -> tuple[np.ndarray, int, int]:
        n = self.view.get("resolution", 0)
        column, row = self.view.get("pixel", (0, 0))
        places = {
            "pixel": [row * n + column], "row": range(row * n, row * n + n),
            "column": range(column, n * n, max(n, 1)), "all": range(n * n),
        }  # fmt: skip
        chosen = sorted({place for rays in self.view["rays"] for place in places[rays]})
        return np.array(chosen if n else [], int), n, n

    def _in_view(self, points: np.ndarray) -> np.ndarray:
        assert self.eye is not None
        away = points - self.eye
        return (away @ self.ahead) > HALF_VIEW * np.linalg.norm(away, axis=1)

    def _sees(self, k: int) -> bool:
        assert self.eye is not None
        points = samples_of(self.tracer.compiled, k, SAMPLES).point
        if not len(points):
            return self._sees_plane(k)
        points = points[self._in_view(points)]
        return len(points) > 0 and not hidden_points(self.tracer, self.eye, points).all()

    def _sees_plane(self, k: int) -> bool:
        """By lines of sight, which other things may stop."""
        assert self.eye is not None
        side = np.cross(self.ahead, [0.0, 1.0, 0.0])
        side = side / (np.linalg.norm(side) or 1.0)
        up, spread = np.cross(side, self.ahead), np.linspace(-0.36, 0.36, ACROSS)
        x, y = (each.reshape(-1, 1) for each in np.meshgrid(1.5 * spread, spread))
        ways = self.ahead + x * side + y * up
        ways = ways / np.linalg.norm(ways, axis=1, keepdims=True)
        starts = np.tile(self.eye, (len(ways), 1))
        return bool((self.tracer.follow(starts, ways)[0].hits.object == k).any())
