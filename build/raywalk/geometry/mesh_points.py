"""Which points lie on a mesh: for warnings, which ask few of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from raywalk.geometry.mesh_target import MeshTarget


def closest_on_mesh(
    mesh: MeshTarget, point: np.ndarray, close: float
) -> tuple[np.ndarray, np.ndarray]:
    """Which of (n, 3) world points lie on the mesh, (n,) bool, and its unit normal there (n, 3).

    close: how far off they may be, as a share of the coordinates' sizes.
    """
    from raywalk.geometry.mesh_sides import closest_triangle
    from raywalk.geometry.triangle import triangle_normal

    on, normal = np.zeros(len(point), bool), np.zeros((len(point), 3))
    bound = close * (np.abs(point).sum(axis=1) + np.abs(mesh.centre).sum() + mesh.size)
    local = point - mesh.centre
    low, high = mesh.bvh.low[0], mesh.bvh.high[0]
    near = ((local >= low - bound[:, None]) & (local <= high + bound[:, None])).all(axis=1)
    for i in np.flatnonzero(near):
        x, y, z = local[i].tolist()
        triangle, square = closest_triangle(mesh.corners, (x, y, z))
        on[i] = square <= bound[i] ** 2
        if on[i]:
            normal[i] = triangle_normal(mesh.corners, triangle)
    return on, normal
