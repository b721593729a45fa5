"""How what slots ask for is found in a ray's numbers, and in a scene's.

A ray is a node of trace/pixel_tree.py, as `raywalk pixel --json` prints it: full float64. Nothing
here traces. Lengths are in world units, angles in degrees.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import asin, atan2, degrees, hypot, nan, radians
from math import sin as sine_of
from typing import Any

import numpy as np

from raywalk.scene.model import Light, Material, Scene
from raywalk.scene.shapes import Sphere
from raywalk.scene.wording import did_you_mean, joined, quoted

Ray = dict[str, Any]
AXES = ("x", "y", "z")
CHANNELS = ("red", "green", "blue")


class SlotFault(ValueError):
    """What is wrong with a slot; with what is allowed and a hint, as errors have them."""

    def __init__(self, message: str, allowed: str = "", hint: str = ""):
        self.message, self.allowed, self.hint = message, allowed, hint
        super().__init__(message)


@dataclass(frozen=True)
class Facts:
    """What is known of a scene besides its file."""

    meshes: Mapping[str, Mapping[str, int]]  # by object: triangles "traced", and "filed"
    bounces: Sequence[int] | None  # camera rays that lead to 0, 1, 2 ... bounces or more


@dataclass(frozen=True)
class Asked:
    """Of what a quantity is asked."""

    scene: Scene
    facts: Facts
    path: tuple[Ray, ...]  # from the camera ray to the ray that is meant; () if it is of no pixel
    of: str  # light, object, material, part or number; "" if none is named
    inside: tuple[Ray, ...] = ()  # of a mean: the camera rays that it is over

    @property
    def ray(self) -> Ray:
        return self.path[-1]

    @property
    def hit(self) -> Ray:
        """The ray, which hits something. Raises SlotFault."""
        if self.ray["object"] is None:
            raise SlotFault(f"the {self.ray['kind']} ray leaves the scene: it hits nothing")
        return self.ray


def distance_run(asked: Asked) -> float:
    """From the ray's start to its hit."""
    return float(asked.hit["t"])


def angle(asked: Asked) -> float:
    """Between the ray and the normal; of a light, between the normal and the way to it."""
    if asked.of:
        return _between(_way(asked), asked.hit["normal"])
    return _between([-part for part in asked.hit["direction"]], asked.hit["normal"])


def sine(asked: Asked) -> float:
    """Of the angle between the ray and the normal."""
    return sine_of(radians(angle(asked)))


def departure(asked: Asked) -> float:
    """Between a ray and the normal of the surface that sends it on."""
    if len(asked.path) < 2:
        raise SlotFault("a camera ray starts at the eye, not at a surface", hint="name a ray")
    found = _between(asked.ray["direction"], asked.path[-2]["normal"])
    return min(found, 180 - found)


def cosine(asked: Asked) -> float:
    """n.l: of the angle between the normal and the way to a light; below 0 behind the surface."""
    way = _way(asked)
    along = sum(a * b for a, b in zip(way, asked.hit["normal"], strict=True))
    return along / hypot(*way) / hypot(*asked.hit["normal"])


def distance_to_light(asked: Asked) -> float:
    return hypot(*_way(asked))


def of_light(key: str) -> Callable[[Asked], float]:
    """A light's factor at the hit."""

    def value(asked: Asked) -> float:
        k, _ = _light(asked)
        if not asked.hit["lights"]:
            raise SlotFault(f"{quoted(asked.hit['object'])} has no own colour and asks no light")
        return float(asked.hit["lights"][k][key])

    return value


def share(asked: Asked) -> float:
    """In the pixel."""
    product = 1.0
    for ray in asked.path:
        product *= ray["weight"]
    return product


def buried(asked: Asked) -> float:
    """How far below its surface a program in single precision finds the hit, as o + t d."""
    hit = asked.hit
    single = (np.array(hit[key], np.float32) for key in ("origin", "t", "direction"))
    origin, t, direction = single
    off = np.array(hit["point"]) - (origin + t * direction).astype(float)
    return float(off @ np.array(hit["normal"]))


def weight(asked: Asked) -> float:
    """In what the ray before brings back."""
    return float(asked.ray["weight"])


def own(asked: Asked) -> float:
    """In the pixel, of the hit surface's own colour."""
    return share(asked) * float(asked.hit["local_weight"])


def part_of(key: str, names: tuple[str, ...]) -> Callable[[Asked], float]:
    """One of three numbers; a ray that leaves the scene has no point and no normal."""

    def value(asked: Asked) -> float:
        ray = asked.hit if key in ("point", "normal") else asked.ray
        return float(ray[key][names.index(asked.of)])

    return value


def tests(asked: Asked) -> float:
    return float(asked.ray["tests"])


def byte(asked: Asked) -> float:
    """8 bits of the pixel's colour, as the picture has it: trace/wavefront.py, eight_bit."""
    return _eight_bit(asked.path[0], asked.of)


def mean(asked: Asked) -> float:
    """Of the bytes of the rays in a tile."""
    channel = asked.of.partition(".")[0]
    return sum(_eight_bit(ray, channel) for ray in asked.inside) / len(asked.inside)


def _eight_bit(camera: Ray, channel: str) -> float:
    bright = camera["colour"][CHANNELS.index(channel)]
    return float(int(255.0 * min(max(bright, 0.0), 1.0) + 0.5))


def rays(asked: Asked) -> float:
    def count(ray: Ray) -> int:
        return 1 + sum(count(child) for child in ray["children"])

    return float(count(asked.path[0]))


def bounces(asked: Asked) -> float:
    def deepest(ray: Ray) -> int:
        return max((1 + deepest(child) for child in ray["children"]), default=0)

    return float(deepest(asked.path[0]))


def crossing(asked: Asked) -> float:
    """Where the camera ray's line meets its first, second ... surface."""
    hits = asked.path[0]["hits"]
    if not asked.of.isdigit() or not 1 <= int(asked.of) <= len(hits):
        message = f"the camera ray's line meets no surface number {asked.of}"
        raise SlotFault(message, allowed=f"allowed: 1 to {len(hits)}" if hits else "it meets none")
    return float(hits[int(asked.of) - 1]["t"])


def discriminant(asked: Asked) -> float:
    """D of t^2 + 2 b t + c = 0 for the ray and a sphere, from the chord's midpoint; below 0 the ray
    passes the sphere by."""
    spheres = {obj.name: obj.shape for obj in asked.scene.objects if isinstance(obj.shape, Sphere)}
    if asked.of not in spheres:
        raise _no("sphere", asked.of, list(spheres))
    sphere, along = spheres[asked.of], asked.ray["direction"]
    away = [o - m for o, m in zip(asked.ray["origin"], sphere.center, strict=True)]
    b = sum(q * d for q, d in zip(away, along, strict=True))
    aside = [q - b * d for q, d in zip(away, along, strict=True)]
    return sphere.radius**2 - sum(part * part for part in aside)


def lit(asked: Asked) -> float:
    """How many point lights reach the hit."""
    return float(sum(bool(light["visible"]) for light in asked.hit["lights"]))


def lights(asked: Asked) -> float:
    """How many point lights there are for the hit to ask."""
    if not (of := asked.hit["lights"]):
        raise SlotFault(f"{quoted(asked.hit['object'])} has no own colour and asks no light")
    return float(len(of))


def triangles(key: str) -> Callable[[Asked], float]:
    """Of a mesh: as "traced", or as "filed"."""

    def value(asked: Asked) -> float:
        if asked.of not in asked.facts.meshes:
            raise _no("mesh", asked.of, list(asked.facts.meshes))
        return float(asked.facts.meshes[asked.of][key])

    return value


def index(asked: Asked) -> float:
    """Of refraction."""
    material = _material(asked.scene, asked.of)
    if not material.transmit:
        raise SlotFault(f"{quoted(material.name)} lets no light through: it has no index")
    return material.ior


def critical(asked: Asked) -> float:
    """Beyond it, a ray inside is totally reflected; outside is air."""
    if (inside := index(asked)) <= 1:
        raise SlotFault("at an index of at most 1 nothing is totally reflected inside")
    return degrees(asin(1 / inside))


def head_on(asked: Asked) -> float:
    """Fresnel's reflectance at normal incidence."""
    inside = index(asked)
    return ((inside - 1) / (inside + 1)) ** 2


def reflect(asked: Asked) -> float:
    return _material(asked.scene, asked.of).reflect


def paint_of(key: str) -> Callable[[Asked], float]:
    """Red, green or blue of one of a material's colours."""

    def value(asked: Asked) -> float:
        name, _, channel = asked.of.rpartition(".")
        material = _material(asked.scene, name)
        if channel not in CHANNELS:
            raise _no("part of a colour", channel, CHANNELS)
        return float(getattr(material, key)[CHANNELS.index(channel)])

    return value


def camera_rays(asked: Asked) -> float:
    """One a pixel."""
    side = asked.of or str(asked.scene.render.size)
    if not side.isdigit():
        raise SlotFault(f"{quoted(side)} is no grid", allowed="allowed: a number, camera-rays.15")
    return float(int(side) ** 2)


def bouncing(asked: Asked) -> float:
    """Share of the picture's camera rays that lead to so many bounces; nan while nobody knows."""
    if not asked.of.isdigit():
        raise SlotFault(f"{quoted(asked.of)} is no number of bounces", allowed="write bouncing.1")
    if not (counts := asked.facts.bounces):
        return nan
    return counts[int(asked.of)] / counts[0] if int(asked.of) < len(counts) else 0.0


def _light(asked: Asked) -> tuple[int, Light]:
    """The light that is named, by its name or as light1, light2 ...; or the only one."""
    lights = asked.scene.lights
    if not asked.of and len(lights) == 1:
        return 0, lights[0]
    for k, light in enumerate(lights):
        if asked.of in (light.name, f"light{k + 1}"):
            return k, light
    raise _no("light", asked.of, [light.name for light in lights])


def _way(asked: Asked) -> list[float]:
    """From the hit to a light."""
    _, light = _light(asked)
    return [to - at for to, at in zip(light.position, asked.hit["point"], strict=True)]


def _material(scene: Scene, name: str) -> Material:
    for material in scene.materials:
        if material.name == name:
            return material
    raise _no("material", name, [material.name for material in scene.materials])


def _no(what: str, name: str, known: Sequence[str]) -> SlotFault:
    message = f"there is no {what} {quoted(name)}" if name else f"of which {what}?"
    allowed = f"known: {joined(known)}" if known else "the scene has none"
    return SlotFault(message, allowed, did_you_mean(name, known) if name else "")


def _between(a: Sequence[float], b: Sequence[float]) -> float:
    """Degrees between two directions, as exact where they are nearly one (W. Kahan, 2006,
    "How Futile are Mindless Assessments of Roundoff", sec. 12)."""
    one, other = ([part / hypot(*vector) for part in vector] for vector in (a, b))
    apart = hypot(*(x - y for x, y in zip(one, other, strict=True)))
    together = hypot(*(x + y for x, y in zip(one, other, strict=True)))
    return degrees(2 * atan2(apart, together))
