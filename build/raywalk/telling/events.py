"""A pixel's ray tree as what happens one after the other: viewer/state/events.ts in Python.

All numbers are the trace's: stored factors times stored colours, measured lengths and angles;
nothing is traced. The operations are those of events.ts in their order, so that both tell the
same digits (tests/viewer/telling.test.mjs compares them).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from raywalk.telling.scene import ToldScene, Vector
from raywalk.telling.why import why_of
from raywalk.trace.tree import Kind, Visibility
from raywalk.trace_file.decode import DecodedTrace

OFF = 4  # visibility of a light that a switch has put out; it stands in no file
SEEN = {
    int(Visibility.BLOCKED): "blocked",
    int(Visibility.REACHED): "reached",
    int(Visibility.BEHIND): "away",
    int(Visibility.UNTESTED): "unasked",
    OFF: "off",
}
# Of the scene's radius: the file rounds points, so over shorter ways an angle would be off by
# more than 0.1 degrees.
MEASURABLE = 1 / 30
DEGREES = 180 / math.pi

Media = tuple[int, ...]  # objects a ray has gone into and not yet out of, the last one on top


@dataclass(frozen=True)
class LightShare:
    """What one light gives at a hit; factors for the material's colours times the light's."""

    name: str
    seen: str
    diffuse: float
    specular: float
    colour: Vector


@dataclass(frozen=True)
class Term:
    """One term of a colour: share x colour. of: local, background or a ray kind."""

    of: str
    share: float
    colour: Vector


@dataclass(frozen=True)
class RayEvent:
    """One thing that happens. facts: the numbers of its sentence, by events.ts's names."""

    what: str
    ray: int  # row of the trace; of a shadow ray: the ray whose hit it leaves
    light: int = -1  # of a light's event
    line: str | None = None  # the kind of ray whose colour it has
    long: float = 0.0  # world units of line that grow
    facts: Mapping[str, Any] = field(default_factory=dict)


def events_of(trace: DecodedTrace, scene: ToldScene, pixel: tuple[int, int]) -> list[RayEvent]:
    """One pixel's events (column, row from the top left) in true order: each ray with all it
    leads to before the next."""
    telling = _Telling(trace, scene, pixel)
    telling.walk(telling.camera, (), ())
    return telling.events


class _Telling:
    """The walk through one pixel's tree."""

    def __init__(self, trace: DecodedTrace, scene: ToldScene, pixel: tuple[int, int]):
        self.trace, self.scene, self.pixel = trace, scene, pixel
        self.camera = pixel[1] * trace.n + pixel[0]
        self.children: dict[int, list[int]] = {}
        for ray in np.flatnonzero(trace.pixel == self.camera).tolist():
            self.children.setdefault(int(trace.parent[ray]), []).append(ray)
        self.events: list[RayEvent] = []

    def walk(self, ray: int, media: Media, before: Media) -> None:
        """media: what the ray travels in; before: what its parent came through."""
        trace, line = self.trace, kind_of(self.trace, ray)
        sent = self.children.get(ray, [])
        what, facts = self._departure(ray, before, media)
        self._put(what, ray, facts, line=line, long=length(self._way(ray)))
        what, facts = self._arrival(ray)
        self._put(what, ray, facts, line=line)
        thing = int(trace.object[ray])
        if thing >= 0:
            self._surface(ray, line, sends_on=bool(sent))
        for child in sent:
            is_through = kind_of(trace, child) == "refracted"
            enters = not trace.inside[ray]
            self.walk(child, crossed(media, thing, enters) if is_through else media, media)
        facts = {"terms": self._terms(ray), "colour": triple(trace.colour[ray])}
        if trace.parent[ray] < 0:
            tile = trace.tiles[3 * self.camera : 3 * self.camera + 3].tolist()
            facts |= {"bytes": tile, "why": why_of(trace, self.events, tile)}
            self._put("pixel", ray, {"pixel": self.pixel, **facts})
        elif sent:
            self._put("gather", ray, {"name": self._name(thing), **facts}, line=line)

    def _put(
        self, what: str, ray: int, facts: Mapping[str, Any],
        light: int = -1, line: str | None = None, long: float = 0.0,
    ) -> None:  # fmt: skip
        self.events.append(RayEvent(what, ray, light, line, long, facts))

    def _name(self, thing: int) -> str:
        return self.scene.objects[thing][0] if thing >= 0 else "?"

    def _way(self, ray: int) -> Vector:
        parent = int(self.trace.parent[ray])
        origin = self.scene.eye if parent < 0 else triple(self.trace.point[parent])
        return sub(triple(self.trace.point[ray]), origin)

    def _angle(self, ray: int, normal: Vector) -> float | None:
        """Degrees between a ray and the line along a normal; None where it cannot be measured."""
        way = self._way(ray)
        long = length(way)
        if long < MEASURABLE * self.scene.radius:
            return None
        return DEGREES * math.acos(min(1.0, abs(dot(scale(way, 1 / long), normal))))

    def _departure(self, ray: int, media: Media, after: Media) -> tuple[str, dict[str, Any]]:
        trace, scene = self.trace, self.scene
        parent, kind = int(trace.parent[ray]), kind_of(trace, ray)
        if parent < 0:
            return "camera", {"pixel": self.pixel, "eye": scene.eye}
        material = scene.materials[int(trace.material[parent])]
        normal, thing = triple(trace.normal[parent]), int(trace.object[parent])
        facts = {
            "name": self._name(thing),
            "share": float(trace.weight[ray]),
            "angle": self._angle(parent, normal),
        }
        leaves = bool(trace.inside[parent])
        index = material.ior if leaves and not media else index_in(media, scene)
        if kind == "refracted":
            facts |= {"enters": not leaves, "from": index, "to": index_in(after, scene)}
            return kind, facts | {"bent": self._angle(ray, normal)}
        if kind == "total":
            beyond = index_in(crossed(media, thing, not leaves), scene)
            return kind, facts | {"from": index, "to": beyond}
        keeps = float(trace.localWeight[parent])
        return "reflected", facts | {"keeps": keeps, "clear": material.transmit > 0}

    def _arrival(self, ray: int) -> tuple[str, dict[str, Any]]:
        trace, thing = self.trace, int(self.trace.object[ray])
        if thing < 0:
            return "background", {"colour": self.scene.background}
        hits = []
        if trace.parent[ray] < 0:
            among = slice(int(trace.hitsStart[ray]), int(trace.hitsStart[ray + 1]))
            met = zip(trace.hitsObject[among].tolist(), trace.hitsT[among].tolist(), strict=True)
            hits = [{"name": self._name(each), "t": t} for each, t in met]
        return "meets", {
            "name": self._name(thing), "t": float(trace.t[ray]),
            "point": triple(trace.point[ray]), "hits": hits,
        }  # fmt: skip

    def _surface(self, ray: int, line: str, sends_on: bool) -> None:
        """The lights asked, the own colour, or that no ray is sent on though one would be."""
        trace, thing = self.trace, int(self.trace.object[ray])
        if trace.localWeight[ray] > 0:
            self._lighting(ray)
        material = self.scene.materials[int(trace.material[ray])]
        if not sends_on and (material.reflect > 0 or material.transmit > 0):
            depth = self.scene.depth
            at_limit = bool(trace.depth[ray] >= depth)
            facts = {"name": self._name(thing), "limit": depth, "atLimit": at_limit}
            self._put("stops", ray, facts, line=line)

    def _lighting(self, ray: int) -> None:
        trace, point = self.trace, triple(self.trace.point[ray])
        lights = self._light_shares(ray)
        for light, share in enumerate(lights):
            far = length(sub(self.scene.lights[light].position, point))
            facts: dict[str, Any] = {"name": share.name}
            if share.seen == "reached":
                self._put("reached", ray, facts, light, "reached", far)
            elif share.seen == "blocked":
                stopped = far * float(trace.blockedAt[ray, light])
                facts |= {"by": self._name(int(trace.blocker[ray, light])), "at": stopped}
                self._put("blocked", ray, facts, light, "blocked", stopped)
            else:
                self._put(share.seen, ray, facts, light)
        material = self.scene.materials[int(trace.material[ray])]
        facts = {
            "ambient": material.ambient, "diffuse": material.diffuse,
            "specular": material.specular, "lights": lights,
            "share": float(trace.localWeight[ray]), "colour": self._local_colour(ray),
        }  # fmt: skip
        self._put("local", ray, facts)

    def _light_shares(self, ray: int) -> list[LightShare]:
        trace = self.trace
        return [
            LightShare(
                light.name,
                SEEN[int(trace.visibility[ray, k])],
                float(trace.diffuse[ray, k]),
                float(trace.specular[ray, k]),
                light.colour,
            )
            for k, light in enumerate(self.scene.lights)
        ]

    def _local_colour(self, ray: int) -> Vector:
        """The stored terms put together as the file format says, before the share it keeps."""
        material = self.scene.materials[int(self.trace.material[ray])]
        colour = material.ambient
        for light in self._light_shares(ray):
            if light.seen in ("reached", "unasked"):
                gives = add(
                    scale(material.diffuse, light.diffuse), scale(material.specular, light.specular)
                )
                colour = add(colour, times(gives, light.colour))
        return colour

    def _terms(self, ray: int) -> list[Term]:
        trace = self.trace
        if trace.object[ray] < 0:
            return [Term("background", 1.0, self.scene.background)]
        sent = [
            Term(kind_of(trace, child), float(trace.weight[child]), triple(trace.colour[child]))
            for child in self.children.get(ray, [])
        ]
        share = float(trace.localWeight[ray])
        return [Term("local", share, self._local_colour(ray)), *sent] if share != 0 else sent


def kind_of(trace: DecodedTrace, ray: int) -> str:
    """camera, reflected, refracted or total."""
    return Kind(int(trace.kind[ray])).name.lower()


def index_in(media: Media, scene: ToldScene) -> float:
    """Index of refraction where a ray travels; outside of everything it is 1."""
    return scene.materials[scene.objects[media[-1]][1]].ior if media else 1.0


def crossed(media: Media, thing: int, enters: bool) -> Media:
    """The media after a border of an object."""
    if enters:
        return (*media, thing)
    if thing not in media:
        return media
    last = len(media) - 1 - media[::-1].index(thing)
    return (*media[:last], *media[last + 1 :])


def triple(values: Iterable[float]) -> Vector:
    x, y, z = (float(value) for value in values)
    return (x, y, z)


def add(a: Vector, b: Vector) -> Vector:
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def sub(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a: Vector, by: float) -> Vector:
    return (a[0] * by, a[1] * by, a[2] * by)


def times(a: Vector, b: Vector) -> Vector:
    return (a[0] * b[0], a[1] * b[1], a[2] * b[2])


def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def length(a: Vector) -> float:
    return math.hypot(*a)
