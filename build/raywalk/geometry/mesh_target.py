"""The nearest triangle of one mesh: Embree proposes, float64 decides.

Embree works on a float32 copy, centred and scaled to unit size, with rays that start
where they enter its box: so neither the scene's scale nor its distance from the origin
matters. What float32 cannot decide (a hit close to an edge, a grazed triangle, surfaces
almost touching, a proposal that float64 refuses) is traced again in the float64 tree
(`mesh_rays.py`).
"""

from __future__ import annotations

import numpy as np

from raywalk.geometry.bvh import Bvh, build_bvh
from raywalk.geometry.float32_copy import GAP, MITRE, covers, trusted_above
from raywalk.geometry.mesh_file import Triangles
from raywalk.geometry.mesh_rays import (
    decide,
    doubtful,
    enter_box,
    every_hit,
    in_any_shell,
    next_leaves,
    redo_in_float64,
    start_close,
    tests_made,
)
from raywalk.geometry.mesh_surface import mesh_surface
from raywalk.geometry.sides import POINT_ERROR

ROOM = 2.0 * MITRE  # round the unit-sized mesh's box: covers and walls do not reach so far
# Error bounds: a ray that starts closer to another face than this is asked where it goes.
DOUBT = 16.0


class MeshTarget:
    """One mesh object, ready for ray queries. Immutable; queries may run in threads."""

    def __init__(self, index: int, triangles: Triangles, glass: bool = False):
        from embreex import rtcore_scene
        from embreex.mesh_construction import TriangleMesh

        self.index = index  # of the object in Scene.objects
        self.triangles = triangles
        self.glass = glass  # rays may be in it
        self.centre = triangles.centre
        self.corners = triangles.corners
        low, high, skip, first, held, order = build_bvh(self.corners)
        self.bvh = Bvh(
            low, high, skip, first, held, order,
            triangles.faces, triangles.world, triangles.world_rest, triangles.off,
        )  # fmt: skip
        self.scale = 1.0 / float(np.abs(triangles.vertices[triangles.faces]).max())
        self.size = 1.0 / self.scale
        self._embree = rtcore_scene.EmbreeScene(robust=True)
        unit, self._stands_for = covers(self.corners * self.scale, triangles.faces)
        # Kept alive by the scene; everything is added before the first query, as Embree needs.
        self._mesh = TriangleMesh(self._embree, unit)
        self._roomy = np.stack(
            [self.bvh.low[:1] - ROOM * self.size, self.bvh.high[:1] + ROOM * self.size]
        )
        self._trusted = trusted_above(self.corners, self.scale, self.bvh)

    def nearest(
        self, origin: np.ndarray, direction: np.ndarray, t_max: np.ndarray, own: np.ndarray,
        on_other: np.ndarray, on_any: bool = False,
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:  # fmt: skip
        """t (n,), triangle (n,) and barycentric (u, v) (n, 2) before t_max; inf and -1 if none.

        origin, direction: (n, 3) float64 world; own: (n,) the triangle a ray starts on, or -1;
        on_other: (n,) bool, it starts on another object, which may touch this one; on_any: or on
        this one, on a triangle that nobody knows.
        """
        count = len(origin)
        t, triangle = np.full(count, np.inf), np.full(count, -1, np.int32)
        uv = np.zeros((count, 2))
        inside = np.empty((count, 3), np.float64)
        starts = np.empty((count, 3), np.float32)
        crossing = enter_box(
            self.bvh, self._roomy, self.corners, self.centre, self.scale, origin, direction,
            t_max, own, inside, starts,
        )  # fmt: skip
        if not len(crossing):
            return t, triangle, uv
        touching = np.zeros(count, np.bool_)
        if self.glass or on_any:
            touching = start_close(
                self.bvh, self.corners, self.centre, origin, on_other & (own < 0), GAP * self.size
            )
        proposed = self._propose(starts[: len(crossing)], direction[crossing])
        redo = decide(
            self.corners, self._trusted, self.triangles.closed, inside, direction, t_max, own,
            touching, crossing, proposed, t, triangle, uv,
        )  # fmt: skip
        redo_in_float64(
            self.bvh, self.corners, self.centre, self.glass, origin, inside, direction, t_max, own,
            touching, redo, t, triangle, uv,
        )  # fmt: skip
        return t, triangle, uv

    def in_doubt(
        self, origin: np.ndarray, direction: np.ndarray, own: np.ndarray, error: np.ndarray
    ) -> np.ndarray:
        """Rays (c,) int of which the face they start on does not tell where they go: they start
        off another object, at an edge, or along the face.

        error: (n,) how far apart surfaces may be that count as one.
        """
        return doubtful(
            self.bvh, self.corners, self.centre, self._trusted, origin, direction, own,
            np.maximum(error, DOUBT * self.bound_at(origin)),
        )  # fmt: skip

    def holds(self, origin: np.ndarray, direction: np.ndarray, own: np.ndarray) -> np.ndarray:
        """(n,) bool: whether rays that start on a surface are in this closed mesh from there on.

        They are if they next come out of it. So what a ray is in and what it will meet agree,
        however rounding has placed surfaces that touch. Where its shells lie in one another, what
        comes next may be an inner one's: all that come are counted.
        """
        count = len(origin)
        if self.triangles.layered:
            return in_any_shell(self.bvh, self.corners, self.centre, origin, direction, own)
        nowhere = np.full(count, np.inf)
        _, triangle, _ = self.nearest(origin, direction, nowhere, own, np.full(count, True))
        return next_leaves(self.corners, triangle, direction)

    def all_hits(self, origin: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Every hit of rays from free space: ray (h,) and t (h,), by ray, nearest first."""
        return every_hit(self.bvh, self.corners, origin, origin - self.centre, direction)

    def count_tests(
        self, origin: np.ndarray, direction: np.ndarray, t_max: np.ndarray, own: np.ndarray
    ) -> np.ndarray:
        """(n,) boxes and triangles that the bounding-volume tree tests for each ray."""
        return tests_made(
            self.bvh, self.corners, origin, origin - self.centre, direction, t_max, own,
            self.bound(origin),
        )  # fmt: skip

    def surface(
        self, direction: np.ndarray, met: np.ndarray, triangle: np.ndarray, uv: np.ndarray,
        point: np.ndarray, normal: np.ndarray, geometric: np.ndarray, inside: np.ndarray,
    ) -> None:  # fmt: skip
        """Fills the last four arguments for the rays that met this mesh."""
        smooth = self.triangles.normals
        mesh_surface(
            self.corners, self.triangles.normal_rows,
            np.zeros((0, 3)) if smooth is None else smooth, self.centre,
            direction, met, self.index, triangle, uv, point, normal, geometric, inside,
        )  # fmt: skip

    def bound_at(self, origin: np.ndarray) -> np.ndarray:
        """(n,) how far each point may be off this mesh, world units."""
        reach = np.abs(origin).sum(axis=1) + np.abs(self.centre).sum() + self.size
        return np.asarray(POINT_ERROR * reach)

    def bound(self, origin: np.ndarray) -> float:
        """How far a point on this mesh may be off it, world units."""
        reach = np.abs(origin).sum(axis=1).max(initial=0.0)
        return float(POINT_ERROR * (reach + np.abs(self.centre).sum() + self.size))

    def _propose(self, starts: np.ndarray, directions: np.ndarray) -> np.ndarray:
        toward = directions.astype(np.float32)
        met = np.asarray(self._embree.run(starts, toward, query="INTERSECT"))
        return np.where(met < 0, np.int32(-1), self._stands_for[met])
