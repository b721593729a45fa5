"""The sphere round everything finite in a scene: how far to draw, and what to look at."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.faces import PLANE
from raywalk.scene.model import Scene


def finite_sphere(scene: Scene, compiled: CompiledScene) -> tuple[np.ndarray, float]:
    """Centre (3,) and radius of a sphere round objects (not planes), lights, eye and target."""
    points = [np.array([scene.camera.eye, scene.camera.target], float)]
    points += [np.array([light.position], float) for light in scene.lights]
    table = compiled.primitives
    finite = table.shape["code"] != PLANE
    half = np.abs(table.to_world[finite]).sum(axis=2)
    points += [table.centre[finite] - half, table.centre[finite] + half]
    for mesh in compiled.meshes:
        points += [mesh.centre + mesh.bvh.low[:1], mesh.centre + mesh.bvh.high[:1]]
    everything = np.concatenate(points)
    low, high = everything.min(axis=0), everything.max(axis=0)
    return (low + high) / 2, float(np.linalg.norm(high - low) / 2)
