"""What float32 gives: Embree on triangles as they are, and the schoolbook sphere in float32."""

from __future__ import annotations

from typing import Any

import numpy as np

NOTHING = 1e36  # embreex reports a miss as 1e37


class Embree32:
    """Float32 Embree on triangles (f, 3, 3), in the coordinates they come in."""

    def __init__(self, corners: np.ndarray, robust: bool = True):
        from embreex import rtcore_scene
        from embreex.mesh_construction import TriangleMesh

        self._scene = rtcore_scene.EmbreeScene(robust=robust)
        self._mesh = TriangleMesh(self._scene, corners.astype(np.float32))

    def nearest(
        self, origin: np.ndarray, direction: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """t (n,) float32, inf for a miss; triangle (n,), -1 for a miss; its normal (n, 3), of any
        length."""
        start, toward = origin.astype(np.float32), direction.astype(np.float32)
        found = self._scene.run(start, toward, query="INTERSECT", output=True)
        t = found["tfar"]
        return np.where(t < NOTHING, t, np.float32(np.inf)), found["primID"], found["Ng"]

    def proposed(self, origin: np.ndarray, direction: np.ndarray) -> np.ndarray:
        """Triangle (n,) only, -1 for a miss: the query that costs least."""
        toward = direction.astype(np.float32)
        return np.asarray(self._scene.run(origin.astype(np.float32), toward, query="INTERSECT"))

    def occluded(
        self, origin: np.ndarray, direction: np.ndarray, reach: np.ndarray | float
    ) -> np.ndarray:
        """(n,) bool: something stands nearer than `reach`."""
        limit = np.broadcast_to(np.asarray(reach, np.float32), (len(origin),)).copy()
        start, toward = origin.astype(np.float32), direction.astype(np.float32)
        return np.asarray(self._scene.run(start, toward, dists=limit, query="OCCLUDED")) != -1


def sphere_t(
    origin: np.ndarray, direction: np.ndarray, centre: np.ndarray, radius: np.ndarray | float,
    kind: Any = np.float32,
) -> np.ndarray:  # fmt: skip
    """Nearest t > 0 (n,) of the schoolbook formula b^2 - 4ac, all of it in numbers of this kind;
    inf for a miss. centre, radius: of one sphere, or each ray's own."""
    o, d, r = origin.astype(kind), direction.astype(kind), np.asarray(radius, kind)
    to = o - np.asarray(centre, kind)
    a, half_b, c = (d * d).sum(axis=1), (to * d).sum(axis=1), (to * to).sum(axis=1) - r * r
    with np.errstate(invalid="ignore"):
        root = np.sqrt(half_b * half_b - a * c)
        near, far = (-half_b - root) / a, (-half_b + root) / a
    return np.where(near > 0, near, np.where(far > 0, far, np.inf)).astype(float)
