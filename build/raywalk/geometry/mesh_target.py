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
from raywalk.geometry.embree import EmbreeScene
from raywalk.geometry.float32_copy import MITRE, covers, trusted_above
from raywalk.geometry.mesh_file import Triangles
from raywalk.geometry.mesh_nearest import meet_mesh
from raywalk.geometry.mesh_rays import (
    doubtful,
    every_hit,
    in_any_shell,
    next_leaves,
    tests_made,
)
from raywalk.geometry.mesh_star import star_of
from raywalk.geometry.mesh_surface import mesh_surface
from raywalk.geometry.mesh_tables import MeshTables
from raywalk.geometry.roots import NOWHERE, SOMEWHERE
from raywalk.geometry.sides import POINT_ERROR

ROOM = 2.0 * MITRE  # round the unit-sized mesh's box: covers and walls do not reach so far
# Rays whose starts and directions spread by less than this many sides of a typical triangle (1 over
# the root of their number) share most of their way down Embree's tree: 2 to 4 times as fast, and
# up to 3 times as slow where they spread by more (measured at 3,700 and 256,000 triangles).
BUNDLE = 20.0
# Error bounds: a ray that starts closer to another face than this is asked where it goes.
DOUBT = 16.0


class MeshTarget:
    """One mesh object, ready for ray queries. Immutable; queries may run in threads."""

    def __init__(self, index: int, triangles: Triangles, glass: bool = False):
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
        unit, stands_for = covers(self.corners * self.scale, triangles.faces)
        self._embree = EmbreeScene(unit)
        self.tables = MeshTables(
            object=index, corners=self.corners,
            trusted=trusted_above(self.corners, self.scale, self.bvh),
            star=star_of(self.bvh, self.corners, self.scale),
            stands_for=stands_for, closed=triangles.closed, glass=glass,
            centre=tuple(self.centre), scale=self.scale,
            low=tuple(low[0] - ROOM * self.size), high=tuple(high[0] + ROOM * self.size),
            bundle=BUNDLE / len(self.corners) ** 0.5, bvh=self.bvh, query=self._embree.query,
        )  # fmt: skip
        self._unranked = np.zeros(index + 1, int)

    def meet(
        self, origin: np.ndarray, direction: np.ndarray, leaving: np.ndarray, on: np.ndarray,
        limit: np.ndarray, rank: np.ndarray,
        t: np.ndarray, met: np.ndarray, triangle: np.ndarray, uv: np.ndarray,
    ) -> None:  # fmt: skip
        """Enters this mesh's hits before `limit` (n,) where they come first, in place.

        origin, direction: (n, 3) float64 world; leaving, on: (n,) the object and the triangle that
        rays start on; rank: (objects,) of surfaces that tie the lowest is met. t (n,), met (n,),
        triangle (n,) and uv (n, 2) hold what rays meet elsewhere, inf and NOWHERE if nothing.
        """
        meet_mesh(self.tables, origin, direction, leaving, on, limit, rank, t, met, triangle, uv)

    def in_doubt(
        self, origin: np.ndarray, direction: np.ndarray, own: np.ndarray, error: np.ndarray
    ) -> np.ndarray:
        """Rays (c,) int of which the face they start on does not tell where they go: they start
        off another object, at an edge, or along the face.

        error: (n,) how far apart surfaces may be that count as one.
        """
        return doubtful(
            self.bvh, self.corners, self.centre, self.tables.trusted, origin, direction, own,
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
        leaving = np.where(own >= 0, self.index, SOMEWHERE).astype(np.int32)
        nothing, triangle = np.full(count, NOWHERE, np.int32), np.full(count, -1, np.int32)
        self.meet(
            origin, direction, leaving, own, np.full(count, np.inf), self._unranked,
            np.full(count, np.inf), nothing, triangle, np.empty((count, 2)),
        )  # fmt: skip
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
