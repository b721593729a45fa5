"""Ways to find hits, each behind the same two methods: ours, its parts, and its peers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from raywalk.bench.embree32 import NOTHING, Embree32
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


class Method(Protocol):
    """A method to find hits."""

    name: str
    ours: bool

    def hits(self, origin: np.ndarray, direction: np.ndarray) -> Met: ...


class Ours:
    """The tracer's own door, in its own strips."""

    ours = True

    def __init__(self, compiled: CompiledScene, name: str = "ours, float64"):
        self.name, self.compiled = name, compiled

    def hits(self, origin: np.ndarray, direction: np.ndarray) -> Met:
        parts = [
            self.compiled.hits(rays_from(origin[k : k + STRIP], direction[k : k + STRIP]))
            for k in range(0, len(origin), STRIP)
        ]
        return Met(
            np.concatenate([part.t for part in parts]),
            np.concatenate([part.point for part in parts]),
            np.concatenate([part.geometric for part in parts]),
        )


class Embree:
    """Float32 Embree alone, on triangles as they are."""

    ours = False

    def __init__(self, name: str, corners: np.ndarray):
        self.name, self.scene = name, Embree32(corners)

    def hits(self, origin: np.ndarray, direction: np.ndarray) -> Met:
        o, d = origin.astype(np.float32), direction.astype(np.float32)
        found = self.scene._scene.run(o, d, query="INTERSECT", output=True)
        t = found["tfar"]
        point = o + t[:, None] * d
        return Met(np.where(t < NOTHING, t, np.inf).astype(float), point, found["Ng"])


class EmbreeThenPlanes:
    """Embree's triangle, then its plane in float64 numpy: hits are never questioned."""

    ours = False
    name = "Embree candidates, float64 numpy"

    def __init__(self, corners: np.ndarray):
        self.scene, self.corner = Embree32(corners), corners[:, 0].copy()
        self.normal = unit_rows(
            np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        )

    def hits(self, origin: np.ndarray, direction: np.ndarray) -> Met:
        who = self.scene.proposed(origin, direction)
        normal = self.normal[who]
        height = (normal * (self.corner[who] - origin)).sum(axis=1)
        t = np.where(who >= 0, height / (normal * direction).sum(axis=1), np.inf)
        with np.errstate(invalid="ignore"):
            return Met(t, origin + t[:, None] * direction, normal)


class EmbreeThenSpheres:
    """Embree's facet of a tessellated sphere, then that sphere in float64 numpy."""

    ours = False

    def __init__(self, spheres: Sequence[Sphere], level: int):
        self.name = f"Embree candidates (level {level}), float64 numpy"
        corners = tessellated(spheres, level)
        self.facets, self.scene = len(corners) // len(spheres), Embree32(corners)
        self.centre = np.array([s.center for s in spheres])
        self.radius = np.array([s.radius for s in spheres])

    def hits(self, origin: np.ndarray, direction: np.ndarray) -> Met:
        who = self.scene.proposed(origin, direction)
        ball_of = np.where(who >= 0, who // self.facets, 0)
        t = sphere_t(origin, direction, self.centre[ball_of], self.radius[ball_of])
        t = np.where(who >= 0, t, np.inf)
        with np.errstate(invalid="ignore"):
            point = origin + t[:, None] * direction
        return Met(t, point, point - self.centre[ball_of])


class NumpySpheres:
    """Every sphere for every ray, by the schoolbook's b^2 - 4ac in float64 numpy."""

    ours = False
    name = "numpy, schoolbook formula, float64"

    def __init__(self, spheres: Sequence[Sphere]):
        self.spheres = spheres

    def hits(self, origin: np.ndarray, direction: np.ndarray) -> Met:
        t, centre = np.full(len(origin), np.inf), np.zeros((len(origin), 3))
        for sphere in self.spheres:
            found = sphere_t(origin, direction, np.array(sphere.center), sphere.radius)
            closer = found < t
            t, centre[closer] = np.where(closer, found, t), sphere.center
        with np.errstate(invalid="ignore"):
            point = origin + t[:, None] * direction
        return Met(t, point, point - centre)


class TrimeshRay:
    """trimesh.ray with its Embree backend: first hits and their places."""

    ours = False
    name = "trimesh.ray"

    def __init__(self, corners: np.ndarray):
        import trimesh
        from trimesh.ray.ray_pyembree import RayMeshIntersector

        vertices, faces = corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3)
        self.mesh = trimesh.Trimesh(vertices, faces, process=False)
        self.intersector = RayMeshIntersector(self.mesh)

    def hits(self, origin: np.ndarray, direction: np.ndarray) -> Met:
        places, ray, triangle = self.intersector.intersects_location(
            origin, direction, multiple_hits=False
        )
        t, point = np.full(len(origin), np.inf), np.zeros((len(origin), 3))
        normal = np.zeros((len(origin), 3))
        t[ray] = ((places - origin[ray]) * direction[ray]).sum(axis=1)
        point[ray], normal[ray] = places, self.mesh.face_normals[triangle]
        return Met(t, point, normal)


class Open3D:
    """Open3D's RaycastingScene: float32, Embree inside."""

    ours = False
    name = "Open3D RaycastingScene"

    def __init__(self, corners: np.ndarray):
        import open3d

        self.core, self.scene = open3d.core, open3d.t.geometry.RaycastingScene(nthreads=1)
        vertices = self.core.Tensor(corners.reshape(-1, 3).astype(np.float32))
        faces = np.arange(3 * len(corners), dtype=np.uint32).reshape(-1, 3)
        self.scene.add_triangles(vertices, self.core.Tensor(faces))

    def hits(self, origin: np.ndarray, direction: np.ndarray) -> Met:
        rays = np.concatenate([origin, direction], axis=1).astype(np.float32)
        found = self.scene.cast_rays(self.core.Tensor(rays), nthreads=1)
        t = found["t_hit"].numpy().astype(float)
        with np.errstate(invalid="ignore"):
            point = origin + t[:, None] * direction
        return Met(t, point, found["primitive_normals"].numpy())


class Mitsuba:
    """Mitsuba 3, variant llvm_ad_rgb (float32), one thread."""

    ours = False
    name = "Mitsuba 3, llvm"

    def __init__(self, corners: np.ndarray | None = None, spheres: Sequence[Sphere] = ()):
        import drjit
        import mitsuba

        mitsuba.set_variant("llvm_ad_rgb")
        drjit.set_thread_count(1)
        self.dr, self.mi = drjit, mitsuba
        parts: dict[str, Any] = {"type": "scene"}
        for k, sphere in enumerate(spheres):
            parts[f"s{k}"] = {
                "type": "sphere", "center": list(sphere.center), "radius": sphere.radius
            }  # fmt: skip
        if corners is not None:
            mesh = mitsuba.Mesh("mesh", 3 * len(corners), len(corners))
            values = mitsuba.traverse(mesh)
            values["vertex_positions"] = corners.reshape(-1).astype(np.float32)
            values["faces"] = np.arange(3 * len(corners), dtype=np.uint32)
            values.update()
            parts["mesh"] = mesh
        self.scene = mitsuba.load_dict(parts)

    def hits(self, origin: np.ndarray, direction: np.ndarray) -> Met:
        o, d = (self.mi.Point3f(x.T.astype(np.float32)) for x in (origin, direction))
        found = self.scene.ray_intersect(self.mi.Ray3f(o, self.mi.Vector3f(d)))
        self.dr.eval(found.t, found.p, found.n)
        t = np.array(found.t).astype(float)
        return Met(t, np.array(found.p).T, np.array(found.n).T)


def sphere_t(
    origin: np.ndarray, direction: np.ndarray, centre: np.ndarray, radius: np.ndarray | float
) -> np.ndarray:
    """Nearest t > 0 (n,) by the schoolbook; inf for a miss."""
    to = origin - centre
    a, b = (direction * direction).sum(axis=1), (to * direction).sum(axis=1)
    c = (to * to).sum(axis=1) - np.square(radius)
    with np.errstate(invalid="ignore"):
        root = np.sqrt(b * b - a * c)
        near, far = (-b - root) / a, (-b + root) / a
    return np.where(near > 0, near, np.where(far > 0, far, np.inf))


def tessellated(spheres: Sequence[Sphere], level: int) -> np.ndarray:
    """(f, 3, 3) triangles of all spheres, each cut into `level` rings."""
    unit = ball(level)
    return np.concatenate([np.array(s.center) + s.radius * unit for s in spheres])


def for_spheres(spheres: Sequence[Sphere]) -> tuple[list[Method], list[str]]:
    """All methods for spheres, ours first; and which peers are not installed."""
    methods: list[Method] = [Ours(CompiledScene(scene_of(spheres)))]
    methods += [
        Embree(f"Embree float32, level {level}", tessellated(spheres, level)) for level in LEVELS
    ]
    methods += [EmbreeThenSpheres(spheres, 64), NumpySpheres(spheres)]
    corners = tessellated(spheres, 64)
    peers = {
        "trimesh.ray (level 64)": lambda: TrimeshRay(corners),
        "Open3D (level 64)": lambda: Open3D(corners),
        "Mitsuba 3, llvm (its own spheres)": lambda: Mitsuba(spheres=spheres),
    }
    return _with_peers(methods, peers)


def for_mesh(corners: np.ndarray) -> tuple[list[Method], list[str]]:
    """All methods for a mesh, ours first; and which peers are not installed."""
    methods: list[Method] = [
        Ours(compiled_mesh(corners)),
        Embree("Embree float32, as is", corners),
        EmbreeThenPlanes(corners),
    ]
    peers = {
        "trimesh.ray": lambda: TrimeshRay(corners),
        "Open3D": lambda: Open3D(corners),
        "Mitsuba 3, llvm": lambda: Mitsuba(corners),
    }
    return _with_peers(methods, peers)


def _with_peers(methods: list[Method], peers: dict[str, Any]) -> tuple[list[Method], list[str]]:
    missing = []
    for name, make in peers.items():
        try:
            method = make()
        except (ImportError, RuntimeError):  # Mitsuba is there, but its LLVM is not
            missing.append(name)
            continue
        method.name = name
        methods.append(method)
    return methods, missing
