"""Where a ray that somebody names starts on a surface: of which side, and on which triangle."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.faces import goes_in, is_near
from raywalk.geometry.roots import to_local

# A named start may be this share of the coordinates' sizes off its surface: a thousand times what
# printing twelve digits loses.
NAMED = 1e-9


class Start(NamedTuple):
    """How a ray leaves a surface."""

    inner: bool  # to the surface's inner side
    triangle: int  # of a mesh, else -1


def start_on(
    compiled: CompiledScene, k: int, origin: np.ndarray, direction: np.ndarray
) -> Start | None:
    """How a ray leaves object k; None if it does not start on its surface. Both (3,), world."""
    for mesh in compiled.meshes:
        if mesh.index == k:
            # Only here: a scene without a mesh runs none of it.
            from raywalk.geometry.mesh_sides import closest_triangle, leaves

            x, y, z = (origin - mesh.centre).tolist()
            triangle, square = closest_triangle(mesh.corners, (x, y, z))
            if not square <= (NAMED * (np.abs(origin).sum() + mesh.size)) ** 2:
                return None
            dx, dy, dz = direction.tolist()
            return Start(not leaves(mesh.corners, triangle, (dx, dy, dz)), int(triangle))
    table, row = compiled.primitives, compiled.primitives.row_of[k]
    matrix, centre = table.to_local[row], table.centre[row]
    local, way = to_local(matrix, *(origin - centre)), to_local(matrix, *direction)
    bound = NAMED * table.stretch[row] * (np.abs(origin).sum() + np.abs(centre).sum())
    if not is_near(table.shape[row], *local, max(bound, NAMED)):
        return None
    return Start(bool(goes_in(table.shape[row], *local, *way, bound)), -1)
