"""What slots may ask for: each quantity by its name, what it means, how it is written."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from raywalk.scene import measures as found
from raywalk.scene.measures import AXES, CHANNELS, Asked

KINDS = ("reflected", "refracted", "total")
MEANS = tuple(f"{channel}.{rays}" for channel in CHANNELS for rays in (9, 25, 49))


@dataclass(frozen=True)
class Quantity:
    name: str
    meaning: str
    value: Callable[[Asked], float]
    digits: int = 2  # decimals, where the slot does not say how many
    is_percent: bool = False
    of: str = "ray"  # "ray": of one of a pixel's rays, "pixel": of them all, "scene"
    takes: str = ""  # what follows its name: light, object, material, part, number
    may_be_alone: bool = False  # without that
    choices: tuple[str, ...] = ()  # of what follows, where they are the same in every scene
    is_mean: bool = False  # over the rays of a finer grid in the tile
    needs_picture: bool = False  # all of its rays are counted


def _light(name: str, meaning: str, value: Callable[[Asked], float], digits: int) -> Quantity:
    """Of a hit and a light; the light need not be named where it is the only one."""
    return Quantity(name, meaning, value, digits, takes="light", may_be_alone=True)


def _part(key: str, meaning: str, names: tuple[str, ...], digits: int) -> Quantity:
    value = found.part_of(key, names)
    return Quantity(key, meaning, value, digits, takes="part", choices=names)


def _share(name: str, meaning: str, value: Callable[[Asked], float]) -> Quantity:
    return Quantity(name, meaning, value, 1, is_percent=True)


def _whole(
    name: str, meaning: str, value: Callable[[Asked], float], of: str, takes: str = "",
    may_be_alone: bool = False, choices: tuple[str, ...] = (),
) -> Quantity:  # fmt: skip
    return Quantity(name, meaning, value, 0, False, of, takes, may_be_alone, choices)


def _scene(
    name: str, meaning: str, value: Callable[[Asked], float], digits: int, is_percent: bool = False
) -> Quantity:
    return Quantity(name, meaning, value, digits, is_percent, "scene", "material")


ALL = (
    Quantity("t", "distance from the ray's start to its hit", found.distance_run),
    _light("angle", "degrees between ray and normal at the hit; of a light, between the normal "
           "and the way to it", found.angle, 1),
    Quantity("departure", "degrees between the ray and the normal of the surface that sends it on",
             found.departure, 1),
    Quantity("sine", "of the angle between ray and normal at the hit", found.sine, 3),
    _light("n.l", "cosine between the normal and the way to the light; below 0 the surface faces "
           "away", found.cosine, 3),
    _light("distance", "from the hit to the light", found.distance_to_light, 2),
    _light("diffuse", "the light's factor of the diffuse colour, whether it is blocked or not",
           found.of_light("diffuse"), 3),
    _light("specular", "the same of the specular colour", found.of_light("specular"), 3),
    _share("share", "the ray's share in the pixel", found.share),
    _share("weight", "the ray's share in what the ray before it brings back", found.weight),
    _share("own", "the share in the pixel of the hit surface's own colour", found.own),
    _part("colour", "what the ray brings back, linear", CHANNELS, 3),
    _part("point", "where the ray hits", AXES, 2),
    _part("normal", "of the surface there, of length 1, towards where the ray comes from", AXES, 2),
    _part("origin", "where the ray starts", AXES, 2),
    _part("direction", "of the ray, of length 1", AXES, 3),
    Quantity("buried", "how far below its surface the hit comes out as o + t d in single "
             "precision; below 0 it lies above it", found.buried, 8),
    _whole("tests", "intersection tests made for the ray", found.tests, "ray"),
    Quantity("discriminant", "of the quadratic equation for the ray and a sphere; below 0 it "
             "misses", found.discriminant, 2, takes="object"),
    _whole("lit", "lights, or points of area lights, that reach the hit", found.lit, "ray"),
    _whole("lights", "lights of the scene, points of area lights each, that the hit may ask",
           found.lights, "ray"),
    _whole("byte", "what the pixel shows, 0 to 255", found.byte, "pixel", "part",
           choices=CHANNELS),
    Quantity("mean", "of what a finer grid's rays in the tile show, 0 to 255, as in mean.red.9",
             found.mean, 0, of="pixel", takes="part", choices=MEANS, is_mean=True),
    _whole("rays", "of the pixel, shadow rays not among them", found.rays, "pixel"),
    _whole("bounces", "most bounces on the way of one of the pixel's rays", found.bounces, "pixel"),
    Quantity("crossing", "distance of the first (.1), second (.2) ... surface on the camera ray's "
             "line", found.crossing, of="pixel", takes="number"),
    _whole("triangles", "of a mesh, as it is traced", found.triangles("traced"), "scene", "object"),
    _whole("file-triangles", "of the mesh in its file, before it is subdivided",
           found.triangles("filed"), "scene", "object"),
    _scene("ior", "index of refraction", found.index, 3),
    _scene("critical", "degrees beyond which a ray in it is totally reflected, with air outside",
           found.critical, 1),
    _scene("head-on", "share that it mirrors of a ray that meets it head-on, from or into air",
           found.head_on, 1, True),
    _scene("reflect", "share of the mirror image", found.reflect, 1, True),
    _scene("ka", "a part of the ambient colour, as in ka.white.red", found.paint_of("ambient"), 1),
    _scene("kd", "the same of the diffuse colour", found.paint_of("diffuse"), 1, True),
    _whole("camera-rays", "of the picture, or of a grid, as in camera-rays.15", found.camera_rays,
           "scene", "number", may_be_alone=True),
    Quantity("bouncing", "share of the picture's camera rays that lead to so many bounces or more",
             found.bouncing, 1, True, "scene", "number", needs_picture=True),
)  # fmt: skip
QUANTITIES = {each.name: each for each in ALL}
