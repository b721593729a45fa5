"""Scenes built in Python, for tests that need many or odd ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.model import Camera, Light, Material, Render, Scene, SceneObject
from raywalk.scene.shapes import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Ellipsoid,
    Mesh,
    Plane,
    Shape,
    Sphere,
    Triangle,
    Triple,
)

CHALK = Material("chalk", ambient=(0.1, 0.1, 0.1), diffuse=(1.0, 1.0, 1.0))
MIRROR = Material("mirror", reflect=1.0)
CLEAR = Material("BK7 glass", transmit=1.0, ior=1.5168, fresnel=True)


def scene_of(
    objects: Sequence[SceneObject | Shape] = (),
    materials: Sequence[Material] = (CHALK,),
    lights: Sequence[Light] = (),
    background: Triple = (0.0, 0.0, 0.0),
    eye: Triple = (0.0, 0.0, 5.0),
    target: Triple = (0.0, 0.0, 0.0),
    fov: float = 45.0,
    **render: Any,
) -> Scene:
    """A scene of these objects (bare shapes get material 0), seen by an upright camera."""
    named = [
        obj if isinstance(obj, SceneObject) else SceneObject(f"{type(obj).__name__} {k}", obj, 0)
        for k, obj in enumerate(objects)
    ]
    return Scene(
        id="00-by-hand",
        path=Path("scene.toml"),
        key="",
        title="By hand",
        teaches="",
        camera=Camera(eye, target, fov=fov),
        render=replace(Render(size=15, resolutions=(5, 15)), **render),
        background=background,
        materials=tuple(materials),
        objects=tuple(named),
        lights=tuple(lights),
        lesson=(),
    )


def affine(linear: Any, offset: Any = (0.0, 0.0, 0.0)) -> np.ndarray:
    """(4, 4) transform."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = linear, offset
    return matrix


def write_ply(path: Path, vertices: np.ndarray, faces: np.ndarray) -> Path:
    """A float64 PLY file, which keeps every digit, NaN and infinity."""
    head = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(vertices)}\n"
        "property double x\nproperty double y\nproperty double z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.empty(len(faces), np.dtype([("n", "u1"), ("ids", "<i4", 3)]))
    rows["n"], rows["ids"] = 3, faces
    body = np.ascontiguousarray(vertices, "<f8").tobytes() + rows.tobytes()
    path.write_bytes(head.encode() + body)
    return path


def mesh_of(
    path: Path, smooth: bool = False, subdivide: int = 0, weld: float | None = None
) -> Mesh:
    """The mesh in a file."""
    return Mesh(path.stem, path, smooth, subdivide, weld=weld)


def unit(v: np.ndarray) -> np.ndarray:
    """(n, 3) vectors made 1 long."""
    return np.asarray(v / np.linalg.norm(v, axis=-1, keepdims=True))


def random_affine(rng: np.random.Generator, worst: float = 10.0) -> np.ndarray:
    """(4, 4) with shear, uneven scale and perhaps a mirror, of condition at most `worst`."""
    while True:
        linear = rng.normal(size=(3, 3))
        if np.linalg.cond(linear) < worst:
            return affine(linear, rng.normal(size=3))


# One of each kind, placed askew.
SHAPES: dict[str, Shape] = {
    "sphere": Sphere((0.3, -0.2, 0.5), 1.3),
    "ellipsoid": Ellipsoid((0.1, 0.2, -0.3), (0.5, 1.2, 0.8), (20.0, -35.0, 50.0)),
    "plane": Plane((0.1, -0.4, 0.2), (0.3, 1.0, -0.2)),
    "capped cylinder": Cylinder((-0.3, -1.0, 0.2), (0.4, 0.9, -0.1), 0.7),
    "open cylinder": Cylinder((-0.3, -1.0, 0.2), (0.4, 0.9, -0.1), 0.7, capped=False),
    "cone": Cone((-0.3, -1.0, 0.2), (0.4, 0.9, -0.1), 0.9),
    "frustum": Cone((-0.3, -1.0, 0.2), (0.4, 0.9, -0.1), 0.4, 0.8),
    "open cone": Cone((0.4, 0.9, -0.1), (-0.3, -1.0, 0.2), 0.9, 0.2, capped=False),
    "box": Box((-1.0, -0.5, -0.7), (0.8, 0.9, 0.6)),
    "disc": Disc((0.1, 0.2, 0.3), (1.0, 2.0, -0.5), 1.1),
    "triangle": Triangle((-1.0, -0.8, 0.1), (1.2, -0.5, 0.3), (0.1, 1.1, -0.4)),
}
SOLIDS = ("sphere", "ellipsoid", "capped cylinder", "cone", "frustum", "box")


def moved(shape: Shape, scale: float, offset: np.ndarray) -> Shape:
    """The same shape, scale times as large, then moved."""

    def at(point: Triple) -> Triple:
        x, y, z = scale * np.array(point) + offset
        return float(x), float(y), float(z)

    match shape:
        case Sphere():
            return Sphere(at(shape.center), scale * shape.radius)
        case Ellipsoid():
            a, b, c = (scale * r for r in shape.radii)
            return Ellipsoid(at(shape.center), (a, b, c), shape.rotation)
        case Plane():
            return Plane(at(shape.point), shape.normal)
        case Cylinder():
            return Cylinder(at(shape.start), at(shape.end), scale * shape.radius, shape.capped)
        case Cone():
            radii = scale * shape.radius, scale * shape.end_radius
            return Cone(at(shape.start), at(shape.end), *radii, shape.capped)
        case Box():
            return Box(at(shape.minimum), at(shape.maximum))
        case Disc():
            return Disc(at(shape.center), shape.normal, scale * shape.radius)
        case Triangle():
            return Triangle(at(shape.a), at(shape.b), at(shape.c))
    raise TypeError(type(shape).__name__)
