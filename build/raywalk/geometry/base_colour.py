"""The base colour where a ray meets an object: what its ambient and diffuse are multiplied by."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from raywalk.scene.model import BASE_STEPS, Scene

if TYPE_CHECKING:
    from raywalk.geometry.compiled import Hits
    from raywalk.geometry.mesh_target import MeshTarget


def based_objects(scene: Scene) -> list[int]:
    """Indices of the objects that have a base colour of their own."""
    return [k for k, obj in enumerate(scene.objects) if obj.base]


def base_colours(scene: Scene, meshes: list[MeshTarget], hits: Hits) -> np.ndarray:
    """(n, 3) linear, in steps of 1/BASE_STEPS, halves up; 1 where nothing was met, or an object
    without one."""
    colour = np.ones((len(hits.t), 3))
    targets = {mesh.index: mesh for mesh in meshes}
    for k in based_objects(scene):
        rows = np.flatnonzero(hits.object == k)
        if len(rows) and k in targets:
            colour[rows] = _of_mesh(targets[k], hits.triangle[rows], hits.point[rows])
    return np.floor(BASE_STEPS * colour + 0.5) / BASE_STEPS


def _of_mesh(mesh: MeshTarget, triangle: np.ndarray, point: np.ndarray) -> np.ndarray:
    """Of the file's colours at these points of a mesh's triangles."""
    from raywalk.geometry.mesh_corners import interpolated

    told = mesh.triangles.colours
    if told is None:
        return np.ones((len(point), 3))
    found = interpolated(mesh.corners, told, triangle, point - mesh.centre)
    return np.where(np.isfinite(found), found, 1.0)
