"""Ways to find hits, all called alike: ours, its parts, and its peers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raywalk.bench.embree32 import Embree32, sphere_t
from raywalk.bench.families import unit_rows
from raywalk.bench.made_scenes import ball, compiled_mesh, scene_of
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.shapes import Sphere
from raywalk.trace.wavefront import STRIP

LEVELS = (16, 32, 64, 128)


@dataclass(frozen=True)
class Met:
    """What n rays hit; t is inf, and the rest unused, where they hit nothing."""

    t: np.ndarray  # (n,) float64
    point: np.ndarray  # (n, 3)
    normal: np.ndarray  # (n, 3) of any length and sign


@dataclass(frozen=True)
class Method:
    """A method to find hits of rays, their origins and directions (n, 3)."""

    name: str
    hits: Callable[[np.ndarray, np.ndarray], Met]
    ours: bool = False


def met_at(
    t: np.ndarray, origin: np.ndarray, direction: np.ndarray, normal: np.ndarray
) -> Met:  # fmt: skip
    """Hits whose points follow from t."""
    with np.errstate(invalid="ignore"):
        return Met(t, origin + t[:, None] * direction, normal)


def ours(compiled: CompiledScene) -> Method:
    """The tracer's own door, in its own strips."""

    def hits(origin: np.ndarray, direction: np.ndarray) -> Met:
        met = Met(np.empty(len(origin)), np.empty(origin.shape), np.empty(origin.shape))
        for start in range(0, len(origin), STRIP):
            strip = slice(start, start + STRIP)
            hits = compiled.hits(rays_from(origin[strip], direction[strip]))
            met.t[strip], met.point[strip], met.normal[strip] = hits.t, hits.point, hits.geometric
        return met

    return Method("ours, float64", hits, ours=True)


def embree(name: str, corners: np.ndarray) -> Method:
    """Float32 Embree alone, on triangles as they are."""
    scene = Embree32(corners)

    def hits(origin: np.ndarray, direction: np.ndarray) -> Met:
        t, _, normal = scene.nearest(origin, direction)
        o, d = origin.astype(np.float32), direction.astype(np.float32)
        return replace(met_at(t, o, d, normal), t=t.astype(float))

    return Method(name, hits)


def embree_then_planes(corners: np.ndarray) -> Method:
    """Embree's triangle, then its plane in float64 numpy: hits are never questioned."""
    scene, corner = Embree32(corners), corners[:, 0].copy()
    normals = unit_rows(np.cross(corners[:, 1] - corner, corners[:, 2] - corner))

    def hits(origin: np.ndarray, direction: np.ndarray) -> Met:
        who = scene.proposed(origin, direction)
        normal = normals[who]
        height = (normal * (corner[who] - origin)).sum(axis=1)
        t = np.where(who >= 0, height / (normal * direction).sum(axis=1), np.inf)
        return met_at(t, origin, direction, normal)

    return Method("Embree candidates, float64 numpy", hits)


def embree_then_spheres(spheres: Sequence[Sphere], level: int) -> Method:
    """Embree's facet of a tessellated sphere, then that sphere in float64 numpy."""
    corners = tessellated(spheres, level)
    facets, scene = len(corners) // len(spheres), Embree32(corners)
    centres, radii = np.array([s.center for s in spheres]), np.array([s.radius for s in spheres])

    def hits(origin: np.ndarray, direction: np.ndarray) -> Met:
        who = scene.proposed(origin, direction)
        of = np.where(who >= 0, who // facets, 0)
        t = sphere_t(origin, direction, centres[of], radii[of], float)
        met = met_at(np.where(who >= 0, t, np.inf), origin, direction, origin)
        return replace(met, normal=met.point - centres[of])

    return Method(f"Embree candidates (level {level}), float64 numpy", hits)


def numpy_spheres(spheres: Sequence[Sphere]) -> Method:
    """Every sphere for every ray, by the schoolbook's b^2 - 4ac in float64 numpy."""

    def hits(origin: np.ndarray, direction: np.ndarray) -> Met:
        t, centre = np.full(len(origin), np.inf), np.zeros((len(origin), 3))
        for sphere in spheres:
            found = sphere_t(origin, direction, np.array(sphere.center), sphere.radius, float)
            closer = found < t
            t, centre[closer] = np.where(closer, found, t), sphere.center
        met = met_at(t, origin, direction, centre)
        return replace(met, normal=met.point - centre)

    return Method("numpy, schoolbook formula, float64", hits)


def trimesh_ray(name: str, corners: np.ndarray) -> Method:
    """trimesh.ray with its Embree backend: first hits and their places."""
    import trimesh
    from trimesh.ray.ray_pyembree import RayMeshIntersector

    faces = np.arange(3 * len(corners)).reshape(-1, 3)
    mesh = trimesh.Trimesh(corners.reshape(-1, 3), faces, process=False)
    intersector = RayMeshIntersector(mesh)

    def hits(origin: np.ndarray, direction: np.ndarray) -> Met:
        places, ray, triangle = intersector.intersects_location(
            origin, direction, multiple_hits=False
        )
        t, point = np.full(len(origin), np.inf), np.zeros((len(origin), 3))
        normal = np.zeros((len(origin), 3))
        t[ray] = ((places - origin[ray]) * direction[ray]).sum(axis=1)
        point[ray], normal[ray] = places, mesh.face_normals[triangle]
        return Met(t, point, normal)

    return Method(name, hits)


def open3d(name: str, corners: np.ndarray) -> Method:
    """Open3D's RaycastingScene: float32, Embree inside."""
    import open3d

    scene = open3d.t.geometry.RaycastingScene(nthreads=1)
    faces = np.arange(3 * len(corners), dtype=np.uint32).reshape(-1, 3)
    vertices = open3d.core.Tensor(corners.reshape(-1, 3).astype(np.float32))
    scene.add_triangles(vertices, open3d.core.Tensor(faces))

    def hits(origin: np.ndarray, direction: np.ndarray) -> Met:
        rays = np.concatenate([origin, direction], axis=1).astype(np.float32)
        found = scene.cast_rays(open3d.core.Tensor(rays), nthreads=1)
        t = found["t_hit"].numpy().astype(float)
        return met_at(t, origin, direction, found["primitive_normals"].numpy())

    return Method(name, hits)


def mitsuba(
    name: str, corners: np.ndarray | None = None, spheres: Sequence[Sphere] = ()
) -> Method:  # fmt: skip
    """Mitsuba 3, variant llvm_ad_rgb (float32), one thread."""
    import drjit
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    drjit.set_thread_count(1)
    parts: dict[str, Any] = {"type": "scene"}
    for k, sphere in enumerate(spheres):
        parts[f"s{k}"] = {"type": "sphere", "center": list(sphere.center), "radius": sphere.radius}
    if corners is not None:
        mesh = mi.Mesh("mesh", 3 * len(corners), len(corners))
        values = mi.traverse(mesh)
        values["vertex_positions"] = corners.reshape(-1).astype(np.float32)
        values["faces"] = np.arange(3 * len(corners), dtype=np.uint32)
        values.update()
        parts["mesh"] = mesh
    scene = mi.load_dict(parts)

    def hits(origin: np.ndarray, direction: np.ndarray) -> Met:
        o, d = (mi.Point3f(x.T.astype(np.float32)) for x in (origin, direction))
        found = scene.ray_intersect(mi.Ray3f(o, mi.Vector3f(d)))
        drjit.eval(found.t, found.p, found.n)
        return Met(np.array(found.t).astype(float), np.array(found.p).T, np.array(found.n).T)

    return Method(name, hits)


def tessellated(spheres: Sequence[Sphere], level: int) -> np.ndarray:
    """(f, 3, 3) triangles of all spheres, each cut into `level` rings."""
    unit = ball(level)
    return np.concatenate([np.array(s.center) + s.radius * unit for s in spheres])


def for_spheres(spheres: Sequence[Sphere]) -> tuple[list[Method], list[str]]:
    """All methods for spheres, ours first; and which peers are not installed."""
    methods = [ours(CompiledScene(scene_of(spheres)))]
    methods += [
        embree(f"Embree float32, level {level}", tessellated(spheres, level)) for level in LEVELS
    ]
    corners = tessellated(spheres, 64)
    return _with_peers([*methods, embree_then_spheres(spheres, 64), numpy_spheres(spheres)], {
        "trimesh.ray (level 64)": lambda name: trimesh_ray(name, corners),
        "Open3D (level 64)": lambda name: open3d(name, corners),
        "Mitsuba 3, llvm (its own spheres)": lambda name: mitsuba(name, spheres=spheres),
    })  # fmt: skip


def for_mesh(corners: np.ndarray) -> tuple[list[Method], list[str]]:
    """All methods for a mesh, ours first; and which peers are not installed."""
    methods = [
        ours(compiled_mesh(corners)), embree("Embree float32, as is", corners),
        embree_then_planes(corners),
    ]  # fmt: skip
    return _with_peers(methods, {
        "trimesh.ray": lambda name: trimesh_ray(name, corners),
        "Open3D": lambda name: open3d(name, corners),
        "Mitsuba 3, llvm": lambda name: mitsuba(name, corners),
    })  # fmt: skip


def _with_peers(
    methods: list[Method], peers: dict[str, Callable[[str], Method]]
) -> tuple[list[Method], list[str]]:
    missing = []
    for name, make in peers.items():
        try:
            methods.append(make(name))
        except (ImportError, RuntimeError):  # Mitsuba is there, but its LLVM is not
            missing.append(name)
    return methods, missing
