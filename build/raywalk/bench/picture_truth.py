"""Pixels of spheres to 50 digits: the tracer's model, written once more from its equations."""

from __future__ import annotations

from typing import Any

from mpmath import mp, mpf  # type: ignore[import-untyped]

from raywalk.bench.truth import Vector, at, cross, inner, minus, unit, vector
from raywalk.scene.model import Light, Scene
from raywalk.scene.shapes import Sphere


class TruePicture:
    """A scene of spheres with mirrors and shadows, without glass and attenuation."""

    def __init__(self, scene: Scene):
        self.scene = scene
        self.balls = []
        for obj in scene.objects:
            assert isinstance(obj.shape, Sphere)
            self.balls.append((vector(obj.shape.center), mpf(obj.shape.radius)))
        self.lights = [vector(light.position) for light in scene.lights]

    def pixel(self, size: int, column: int, row: int) -> list[float]:
        """Linear colour of one pixel of a size x size picture."""
        camera = self.scene.camera
        eye, target, up = (vector(v) for v in (camera.eye, camera.target, camera.up))
        forward = unit(minus(target, eye))
        right = unit(cross(forward, up))
        upward = cross(right, forward)
        spread = mp.tan(mp.radians(mpf(camera.fov)) / 2)
        x = (2 * (column + mpf("0.5")) / size - 1) * spread
        y = (1 - 2 * (row + mpf("0.5")) / size) * spread
        aim = at(at(forward, right, x), upward, y)
        return [float(c) for c in self.colour(eye, unit(aim), self.scene.render.depth, None)]

    def colour(self, o: Vector, d: Vector, depth: int, leaving: int | None) -> list[Any]:
        """What a ray brings back: (1 - kr) local + kr reflected."""
        who, t = self.nearest(o, d, leaving)
        if who is None:
            return [mpf(c) for c in self.scene.background]
        material = self.scene.materials[self.scene.objects[who].material]
        point = at(o, d, t)
        normal = unit(minus(point, self.balls[who][0]))
        share = mpf(material.reflect)
        local = self.local(material, point, normal, d, who) if share < 1 else [mpf(0)] * 3
        found = [(1 - share) * c for c in local]
        if share > 0 and depth > 0:
            mirror = at(d, normal, -2 * inner(d, normal))
            back = self.colour(point, unit(mirror), depth - 1, who)
            found = [a + share * b for a, b in zip(found, back, strict=True)]
        return found

    def local(self, material: Any, point: Vector, normal: Vector, d: Vector, who: int) -> list[Any]:
        """Ambient, and from every light that is seen diffuse and highlight (Blinn 1977)."""
        total = [mpf(c) for c in material.ambient]
        for light, position in zip(self.scene.lights, self.lights, strict=True):
            away = minus(position, point)
            distance = mp.sqrt(inner(away, away))
            toward = unit(away)
            facing = inner(normal, toward)
            if facing <= 0 or self.blocked(point, toward, distance, who):
                continue
            half = unit(minus(toward, d))
            shine = max(inner(normal, half), mpf(0)) ** mpf(material.shininess)
            for c in range(3):
                lit = facing * mpf(material.diffuse[c]) + shine * mpf(material.specular[c])
                total[c] += lit * mpf(light.colour[c]) * strength(light)
        return total

    def blocked(self, point: Vector, toward: Vector, distance: Any, who: int) -> bool:
        met, t = self.nearest(point, toward, who)
        return met is not None and t < distance

    def nearest(self, o: Vector, d: Vector, leaving: int | None) -> tuple[int | None, Any]:
        """Rays here leave spheres outwards only, and cannot meet the same one again."""
        best: tuple[int | None, Any] = (None, mpf("inf"))
        for k, (centre, radius) in enumerate(self.balls):
            to = minus(centre, o)
            along = inner(to, d)
            if k == leaving or along <= 0:
                continue
            under = radius * radius - inner(to, to) + along * along
            if under >= 0:
                t = along - mp.sqrt(under)
                if 0 < t < best[1]:
                    best = (k, t)
        return best


def strength(light: Light) -> Any:
    assert light.attenuation == (1.0, 0.0, 0.0)
    return mpf(light.intensity)
