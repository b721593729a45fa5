"""Scenes and meshes built in Python for measuring."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.model import Camera, Light, Material, Render, Scene, SceneObject
from raywalk.scene.shapes import Mesh, Shape, Sphere

CHALK = Material("chalk", ambient=(0.1, 0.1, 0.1), diffuse=(0.8, 0.7, 0.6))
PLAIN_RENDER = Render(size=15, resolutions=(5, 15))


def scene_of(
    objects: Sequence[SceneObject | Shape],
    lights: Sequence[Light] = (),
    materials: Sequence[Material] = (CHALK,),
    camera: Camera | None = None,
    **render: Any,
) -> Scene:
    """A scene of these objects; bare shapes get material 0."""
    named = tuple(
        obj if isinstance(obj, SceneObject) else SceneObject(f"object {k}", obj, 0)
        for k, obj in enumerate(objects)
    )
    return Scene(
        id="bench", path=Path("bench"), key="", title="", teaches="",
        camera=camera or Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0)),
        render=replace(PLAIN_RENDER, **render), background=(0.0, 0.0, 0.0),
        materials=tuple(materials), objects=named, lights=tuple(lights), lesson=(),
    )  # fmt: skip


def nearest_t(
    objects: Sequence[SceneObject | Shape], origin: np.ndarray, direction: np.ndarray
) -> np.ndarray:
    """(n,) where rays meet these first, by the tracer's own door."""
    return CompiledScene(scene_of(objects)).nearest(rays_from(origin, direction))[0]


def placed(linear: Any = 1.0, offset: Any = (0.0, 0.0, 0.0)) -> np.ndarray:
    """(4, 4) transform from a number or a (3, 3) matrix, and an offset."""
    matrix = np.eye(4)
    matrix[:3, :3] = np.asarray(linear) * (np.eye(3) if np.ndim(linear) == 0 else 1.0)
    matrix[:3, 3] = offset
    return matrix


def compiled_mesh(
    corners: np.ndarray, transform: np.ndarray | None = None, others: Sequence[Shape] = ()
) -> CompiledScene:
    """A flat mesh of these (f, 3, 3) triangles, as object 0 of a compiled scene."""
    with tempfile.TemporaryDirectory() as folder:
        mesh = mesh_object(Path(folder) / "mesh.ply", corners, transform)
        return CompiledScene(scene_of([mesh, *others]))


def mesh_object(
    path: Path, corners: np.ndarray, transform: np.ndarray | None = None
) -> SceneObject:
    """A flat mesh written to a file, float64 digit for digit."""
    write_ply(path, corners)
    matrix = np.eye(4) if transform is None else transform
    return SceneObject("mesh", Mesh("mesh", path, smooth=False), 0, matrix)


def write_ply(path: Path, corners: np.ndarray) -> None:
    """Binary PLY with float64 vertices: three a triangle, equal ones are joined on reading."""
    count = len(corners)
    head = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {3 * count}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {count}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    faces = np.empty(count, np.dtype([("n", "u1"), ("ids", "<i4", 3)]))
    faces["n"], faces["ids"] = 3, np.arange(3 * count).reshape(-1, 3)
    body = np.ascontiguousarray(corners, "<f8").tobytes() + faces.tobytes()
    path.write_bytes(head.encode() + body)


def icosphere(level: int) -> np.ndarray:
    """(20 * 4^level, 3, 3) triangles of a convex polyhedron with vertices on the unit sphere."""
    import trimesh

    return np.asarray(trimesh.creation.icosphere(level).triangles, float)


def ball(level: int) -> np.ndarray:
    """(f, 3, 3) triangles of a unit sphere cut into `level` rings and 2 `level` sectors."""
    import trimesh

    return np.asarray(trimesh.creation.uv_sphere(count=[level, 2 * level]).triangles, float)


def bunny() -> np.ndarray:
    """(3674, 3, 3) triangles of the model that the project ships."""
    import trimesh

    path = Path("models/bunny.ply")
    return np.asarray(trimesh.load_mesh(path, process=False).triangles, float)


def twenty_spheres(seed: int) -> list[Sphere]:
    """Spheres of radius 0.2 to 0.6 in a cube of side 5, apart from each other."""
    rng = np.random.default_rng(seed)
    kept: list[Sphere] = []
    while len(kept) < 20:
        centre, radius = rng.uniform(-2.5, 2.5, 3), float(rng.uniform(0.2, 0.6))
        gaps = [np.linalg.norm(centre - s.center) - s.radius - radius for s in kept]
        if min(gaps, default=1.0) > 0.01:
            kept.append(Sphere((centre[0], centre[1], centre[2]), radius))
    return kept
