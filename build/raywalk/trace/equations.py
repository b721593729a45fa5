"""Where chosen camera rays meet the spheres of a scene, worked out as one does it by hand."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from raywalk.geometry.compiled import rays_from
from raywalk.scene.model import SceneObject
from raywalk.scene.placement import UNMOVED
from raywalk.scene.shapes import Sphere
from raywalk.trace.camera import camera_directions
from raywalk.trace.wavefront import Tracer

Json = dict[str, Any]


def is_plain_sphere(obj: SceneObject) -> bool:
    """Whether its equation is |p - m|^2 = r^2, with the numbers of its file."""
    return isinstance(obj.shape, Sphere) and np.array_equal(obj.transform, UNMOVED)


def equations_of(tracer: Tracer, pixels: Sequence[tuple[int, int, int]]) -> list[Json]:
    """Of each camera ray p(t) = o + t d, |d| = 1, given as (n, column, row): {"n", "pixel",
    "origin", "direction", "spheres": [{"object": index, "centre", "radius", "b", "c",
    "discriminant", "t": the two roots or []}]}, all float64, world units.

    With q = o - m the equation is t^2 + 2 b t + c = 0, b = q.d, c = q.q - r^2. The discriminant
    b^2 - c is taken from the chord's midpoint, r^2 - |q - b d|^2, as geometry/solids.py does: there
    nothing cancels. The roots are those that the tracer found.
    """
    camera = tracer.scene.camera
    origin = np.array(camera.eye, float)
    found = []
    for n, column, row in pixels:
        [direction] = camera_directions(camera, n, n, np.array([row * n + column]))
        rays = rays_from(origin[None], direction[None])
        _, t, met = tracer.compiled.crossings(rays)
        found.append({
            "n": n, "pixel": [column, row],
            "origin": origin.tolist(), "direction": direction.tolist(),
            "spheres": list(_spheres(tracer, origin, direction, t, met)),
        })  # fmt: skip
    return found


def _spheres(
    tracer: Tracer, origin: np.ndarray, direction: np.ndarray, t: np.ndarray, met: np.ndarray
) -> Iterator[Json]:
    for k, obj in enumerate(tracer.scene.objects):
        if not is_plain_sphere(obj) or not isinstance(obj.shape, Sphere):
            continue
        away = origin - np.array(obj.shape.center, float)
        radius_sq = obj.shape.radius**2
        b = float(away @ direction)
        aside = away - b * direction
        yield {
            "object": k, "centre": list(obj.shape.center), "radius": float(obj.shape.radius),
            "b": b, "c": float(away @ away) - radius_sq,
            "discriminant": radius_sq - float(aside @ aside), "t": t[met == k].tolist(),
        }  # fmt: skip
