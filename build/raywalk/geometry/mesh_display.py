"""Meshes for the rasterised stage: the file's own triangles, without the tracer's subdivision."""

from __future__ import annotations

from dataclasses import replace

from raywalk.geometry.mesh_file import Triangles, load_triangles
from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Mesh


def display_triangles(scene: Scene, obj: SceneObject) -> Triangles:
    """Triangles of a mesh object as its file has them, placed in the world."""
    assert isinstance(obj.shape, Mesh)
    return load_triangles(scene, replace(obj, shape=replace(obj.shape, subdivide=0)))
