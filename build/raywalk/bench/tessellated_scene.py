"""The tracer on float32 Embree instead: tessellated spheres, rays lifted by a fixed offset."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from raywalk.bench.contenders import tessellated
from raywalk.bench.embree32 import NOTHING, Embree32
from raywalk.geometry.compiled import Hits, Rays
from raywalk.geometry.nearest import NOWHERE
from raywalk.scene.shapes import Sphere

LIFT = np.float32(1e-4)  # a usual choice; smaller brings acne, larger brings gaps


class TessellatedScene:
    """Answers as a CompiledScene does, so that the same wavefront shades its hits."""

    def __init__(self, spheres: Sequence[Sphere], level: int, material: np.ndarray):
        corners = tessellated(spheres, level)
        self.facets, self.material = len(corners) // len(spheres), material
        self.embree = Embree32(corners)

    def nearest(self, rays: Rays, t_max: np.ndarray | None = None) -> tuple[np.ndarray, ...]:
        found, met = self._met(rays)
        t = np.where(met != NOWHERE, found["tfar"], np.inf).astype(float)
        if t_max is not None:
            met = np.where(t < t_max, met, NOWHERE).astype(np.int32)
            t = np.where(t < t_max, t, np.inf)
        return t, met, np.full(len(t), -1, np.int32), np.zeros((len(t), 2))

    def beyond(self, *_: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Nothing: these scenes have no glass."""
        return np.zeros(0, np.int32), np.zeros(0, np.int32), np.zeros(0, bool)

    def hits(self, rays: Rays) -> Hits:
        found, met = self._met(rays)
        t = np.where(met != NOWHERE, found["tfar"], np.inf).astype(float)
        normal = found["Ng"].astype(float)
        length = np.linalg.norm(normal, axis=1, keepdims=True)
        normal /= np.where(length > 0, length, 1.0)
        inside = (normal * rays.direction).sum(axis=1) > 0
        normal[inside] *= -1.0
        with np.errstate(invalid="ignore"):
            point = rays.origin + t[:, None] * rays.direction
        point[met == NOWHERE] = 0.0
        material = np.where(met != NOWHERE, self.material[met], -1).astype(np.int32)
        nothing = np.full(len(t), -1, np.int32)
        return Hits(t, met, nothing, point, normal, normal, inside, material)

    def _met(self, rays: Rays) -> tuple[dict[str, Any], np.ndarray]:
        start = rays.origin.astype(np.float32)
        toward = rays.direction.astype(np.float32)
        lifted = np.where((rays.leaving != NOWHERE)[:, None], start + LIFT * toward, start)
        found = self.embree._scene.run(lifted, toward, query="INTERSECT", output=True)
        hit = found["tfar"] < NOTHING
        met = np.where(hit, found["primID"] // self.facets, NOWHERE).astype(np.int32)
        return found, met
