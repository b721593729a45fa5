"""Meshes for the rasterised stage: the file's own triangles, without the tracer's subdivision."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raywalk.geometry.corners import joined
from raywalk.geometry.mesh_file import Triangles, load_triangles
from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Mesh


def display_triangles(scene: Scene, obj: SceneObject) -> Triangles:
    """Triangles of a mesh object as its file has them, placed in the world."""
    assert isinstance(obj.shape, Mesh)
    return load_triangles(scene, replace(obj, shape=replace(obj.shape, subdivide=0)))


def one_normal_each(triangles: Triangles) -> tuple[np.ndarray, np.ndarray, np.ndarray | None]:
    """Vertices (v, 3), faces (f, 3) and a normal of each vertex, (v, 3), None of a flat mesh: a
    corner at which normals differ, as a file's own do at an edge, becomes a vertex for each."""
    vertices, faces, normals = triangles.vertices, triangles.faces, triangles.normals
    rows = triangles.normal_rows
    if normals is None or (len(normals) == len(vertices) and (rows == faces).all()):
        return vertices, faces, normals
    points, held = vertices[faces].reshape(-1, 3), normals[rows].reshape(-1, 3)
    kept, split = joined(points, held)
    return points[kept], split, held[kept]
