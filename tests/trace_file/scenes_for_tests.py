"""Scenes for the codec's tests: three course scenes, glass, and random ones."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from tiny_tracer import make_scene

from raywalk.scene.model import Checker, Light, Material, Scene
from raywalk.scene.shapes import Ellipsoid, Plane, Sphere

GREY = (0.1, 0.1, 0.1)


def coloured(name: str, r: float, g: float, b: float) -> Material:
    return Material(name, GREY, (r, g, b), (1.0, 1.0, 0.5), 100.0)


RED = coloured("red", 1, 0, 0)
GREEN = coloured("green", 0, 1, 0)
BLUE = coloured("blue", 0, 0, 1)
WHITE = Material("white", GREY, (1.0, 1.0, 1.0))
MIRROR = Material("mirror", reflect=1.0)
GLASS = Material("glass", reflect=0.05, transmit=0.9, ior=1.5, fresnel=True)
BLACK = Material("black", diffuse=(0.05, 0.05, 0.05))


def shading(size: int) -> Scene:
    balls = [Sphere((-0.5, -1, 1), 1), Sphere((0.5, -1, -1), 1), Sphere((0, 1, 0), 1)]
    objects = [(ball, k) for k, ball in enumerate(balls)]
    lights = [Light("lamp", (-2, 1, 1))]
    return make_scene(objects, [RED, GREEN, BLUE], lights, shadows=False, size=size)


def two_lights(size: int) -> Scene:
    objects = [
        (Ellipsoid((0.5, 0, 0.5), (0.5, 0.6, 0.2)), 0),
        (Sphere((-0.5, 0, -0.5), 1), 1),
        (Plane((0, -1, 0), (0, 1, 0)), 2),
    ]
    lights = [Light("left", (1, 2, 2), intensity=0.5), Light("right", (-1, 2, -1), intensity=0.5)]
    return make_scene(objects, [RED, GREEN, WHITE], lights, size=size)


def mirrors(size: int) -> Scene:
    objects = [
        (Sphere((0.5, -0.7, 0.5), 0.3), 0),
        (Sphere((1, -0.7, 0), 0.3), 1),
        (Plane((0, -1, 0), (0, 1, 0)), 2),
        (Plane((0, 0, -3), (0, 0, 1)), 2),
        (Sphere((-0.5, 0, -0.5), 1), 3),
        (Sphere((1.5, 0, -1.5), 1), 3),
    ]
    lights = [Light("a", (-1, 2, 1), intensity=0.5), Light("b", (0.5, -0.5, 0), intensity=0.5)]
    return make_scene(objects, [RED, BLUE, WHITE, MIRROR], lights, size=size)


def glass(size: int) -> Scene:
    objects = [
        (Sphere((-0.4, 0, 1), 0.7), 3),
        (Ellipsoid((0.9, 0, 0.5), (0.5, 0.6, 0.3)), 3),
        (Plane((0, -1, 0), (0, 1, 0)), 2),
        (Plane((0, 0, -3), (0, 0, 1)), 2),
        (Plane((-2, 0, 0), (1, 0, 0)), 0),
        (Plane((2, 0, 0), (-1, 0, 0)), 1),
        (Sphere((0.2, -0.5, -1.5), 0.5), 4),
    ]
    lights = [Light("a", (-1, 1.8, 1), intensity=0.6), Light("b", (1, 1.5, 2), (1, 0.8, 0.6), 0.5)]
    return make_scene(objects, [RED, GREEN, WHITE, GLASS, BLUE], lights, depth=6, size=size)


def random_scene(seed: int, size: int) -> Scene:
    """Up to five balls of any material over a floor, checkered every other time."""
    rng = np.random.default_rng(seed)
    materials = [RED, GREEN, WHITE, MIRROR, GLASS, BLACK]
    objects: list[tuple[object, int]] = [(Plane((0, -1.2, 0), (0, 1, 0.1)), 2)]
    for _ in range(rng.integers(1, 6)):
        center = tuple(rng.uniform(-1.2, 1.2, 3))
        radii = tuple(rng.uniform(0.2, 0.8, 3))
        shape = Sphere(center, radii[0]) if rng.random() < 0.5 else Ellipsoid(center, radii)
        objects.append((shape, int(rng.integers(len(materials)))))
    lights = [
        Light(f"lamp {k}", tuple(rng.uniform((-2, 1, 0), (2, 3, 3))), intensity=0.6)
        for k in range(rng.integers(0, 4))
    ]
    shadows = bool(rng.random() < 0.8)
    sky = tuple(rng.uniform(0, 0.5, 3))
    scene = make_scene(objects, materials, lights, int(rng.integers(0, 6)), shadows, sky, size)
    if seed % 2:
        floor = replace(scene.objects[0], checker=Checker(0.5, 5))
        scene = replace(scene, objects=(floor, *scene.objects[1:]))
    return scene
