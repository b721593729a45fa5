"""What the rays of some pixels meet, and whether anybody who traces them by hand finds the same."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from raywalk.geometry.roots import NOWHERE
from raywalk.scene.model import Scene
from raywalk.scene.shapes import Plane
from raywalk.trace.sheet_paths import FAR, is_clear
from raywalk.trace.wave import Wave
from raywalk.trace.wavefront import Tracer

# A pixel is well conditioned if rays that pass its centre by 1/21 of a tile find what its own ray
# finds: a direction whose parts are rounded to three decimals is off by less, of up to 90 tiles
# across. So no edge, no nearly double root, no shadow's border is near.
PARTS = 21  # odd: a tile's centre is a part's centre
# n.l below that would change its sign, or a shadow ray graze its own surface, by a third digit.
LEAST_COSINE = 0.05
LEAST_GAP = 0.01  # between two hits along a ray: distances are printed with three decimals


@dataclass(frozen=True, eq=False)
class Sent:
    """A ray that a hit sends on."""

    object: int
    t: float
    point: np.ndarray
    is_clear: bool


@dataclass(frozen=True, eq=False)
class Sight:
    """What one camera ray finds. Distances in world units; boxes: see is_clear."""

    pixel: int  # row * n + column
    object: int  # NOWHERE: it leaves
    t: float
    point: np.ndarray
    colour: np.ndarray
    is_matt: bool  # it has a colour of its own
    listed: tuple[tuple[int, float], ...]  # hits along its line up to the first opaque wall
    cosine: tuple[float, ...]  # n.l, by light
    visibility: tuple[int, ...]
    blocker: tuple[int, ...]
    sent: dict[int, Sent]  # by kind
    eye: np.ndarray
    direction: np.ndarray
    lamps: np.ndarray  # (l, 3)
    boxes: list[np.ndarray]
    is_sure: bool = False

    @property
    def meeting(self) -> dict[str, Any]:
        """As a fact has it."""
        if self.object == NOWHERE:
            return {"object": None}
        return {"object": self.object, "t": self.t, "point": self.point.tolist()}

    @property
    def is_clear_to_hit(self) -> bool:
        far = FAR if self.object == NOWHERE else self.t
        return is_clear(self.eye, far * self.direction, self.boxes)

    @property
    def is_clear_along(self) -> bool:
        return is_clear(self.eye, FAR * self.direction, self.boxes)

    def is_clear_to(self, light: int) -> bool:
        return is_clear(self.point, self.lamps[light] - self.point, self.boxes)

    @property
    def finds(self) -> tuple[Any, ...]:
        """What is the same of a ray beside it, where it is well conditioned."""
        sent = tuple((kind, ray.object) for kind, ray in sorted(self.sent.items()))
        listed = tuple(thing for thing, _ in self.listed)
        return self.object, listed, self.visibility, self.blocker, sent

    @property
    def is_square(self) -> bool:
        """No grazing light, no two hits as good as one."""
        at = [t for _, t in self.listed]
        gaps = [far - near for near, far in pairwise(at)]
        faces = self.object == NOWHERE or all(abs(c) >= LEAST_COSINE for c in self.cosine)
        return faces and all(gap >= LEAST_GAP for gap in gaps)


def sights_of(tracer: Tracer, pixels: list[int], n: int, boxes: list[np.ndarray]) -> list[Sight]:
    """Of pixels (row * n + column) of an n x n grid, in their order."""
    look = partial(_looked, tracer, boxes=boxes)
    sights = look(pixels, pixels, n)
    is_sure = [sight.is_square for sight in sights]
    rows, columns = np.divmod(np.array(pixels), n)
    middle = PARTS // 2
    for down, across in [(-1, -1), (-1, 0), (-1, 1), (0, -1), (0, 1), (1, -1), (1, 0), (1, 1)]:
        parts = (rows * PARTS + middle + down) * n * PARTS + columns * PARTS + middle + across
        for k, beside in enumerate(look(pixels, parts.tolist(), n * PARTS)):
            is_sure[k] &= beside.finds == sights[k].finds
    return [replace(sight, is_sure=sure) for sight, sure in zip(sights, is_sure, strict=True)]


def _looked(
    tracer: Tracer, pixels: list[int], places: list[int], size: int, boxes: list[np.ndarray]
) -> list[Sight]:
    """places: of the pixels in a picture of size x size."""
    waves = tracer.waves(np.array(places), size, size)
    camera, scene = waves[0], tracer.scene
    start, t, met = tracer.compiled.crossings(camera.rays)
    sent = _sent_by(waves[1] if len(waves) > 1 else None, len(pixels), boxes)
    lamps = np.array([light.position for light in scene.lights]).reshape(-1, 3)
    hits, lighting, sights = camera.hits, camera.lighting, []
    for k, pixel in enumerate(pixels):
        along = slice(start[k], start[k + 1])
        to_light = lamps - hits.point[k]
        far = np.sqrt((to_light**2).sum(axis=1))
        sights.append(Sight(
            pixel, int(hits.object[k]), float(hits.t[k]), hits.point[k], camera.colour[k],
            bool(lighting.local_weight[k] > 0),
            _up_to_wall(scene, met[along].tolist(), t[along].tolist()),
            tuple((to_light @ hits.normal[k] / far).tolist()),
            tuple(lighting.visibility[k].tolist()), tuple(lighting.blocker[k].tolist()), sent[k],
            camera.rays.origin[k], camera.rays.direction[k], lamps, boxes,
        ))  # fmt: skip
    return sights


def _up_to_wall(scene: Scene, met: list[int], t: list[float]) -> tuple[tuple[int, float], ...]:
    """What lies behind a wall that lets nothing through nobody looks for."""
    listed = []
    for thing, at in zip(met, t, strict=True):
        listed.append((thing, at))
        obj = scene.objects[thing]
        if isinstance(obj.shape, Plane) and scene.materials[obj.material].transmit == 0:
            break
    return tuple(listed)


def _sent_by(wave: Wave | None, count: int, boxes: list[np.ndarray]) -> list[dict[int, Sent]]:
    """By the camera ray that they come from."""
    sent: list[dict[int, Sent]] = [{} for _ in range(count)]
    if wave is None:
        return sent
    for k, parent in enumerate(wave.parent.tolist()):
        thing, t = int(wave.hits.object[k]), float(wave.hits.t[k])
        way = wave.rays.direction[k] * (FAR if thing == NOWHERE else t)
        clear = is_clear(wave.rays.origin[k], way, boxes)
        sent[parent][int(wave.kind[k])] = Sent(thing, t, wave.hits.point[k], clear)
    return sent
