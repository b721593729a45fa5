"""Bounding volumes at work: which boxes of a mesh each camera ray tests. FORMAT of boxes.js."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from raywalk.geometry.compiled import rays_from
from raywalk.geometry.mesh_target import MeshTarget
from raywalk.geometry.shallow_boxes import boxes_entered, crosses_sphere, shallow_boxes
from raywalk.trace.camera import camera_directions
from raywalk.trace.wavefront import Tracer

Json = dict[str, Any]
DIGITS = 5  # of a box's corners: they are only drawn


def boxes_of(tracer: Tracer) -> Json:
    """For each mesh its bounding sphere, boxes, and by level which camera rays enter which.

    {"primitives": number of other shapes, "meshes": [{"object", "triangles", "sphere": [x, y, z,
    radius], "boxes": [[6 numbers: low, high]], "parents": [places, -1 first],
    "levels": {n: [runs of the sphere, runs of box 0, ...]}}]}. Runs are lengths in raster order
    over the n x n rays: first of rays that miss, then of rays that enter, and so on. A box is
    tested by the rays that enter its parent, the first by all that cross the sphere.
    """
    scene = tracer.scene
    levels: dict[int, tuple[np.ndarray, np.ndarray]] = {}
    for n in sorted(scene.render.resolutions):
        # An n x n picture's rays are the same: pixel centres are shared.
        direction = camera_directions(scene.camera, n, n, np.arange(n * n))
        levels[n] = np.tile(np.array(scene.camera.eye, float), (n * n, 1)), direction
    reach = {n: _lengths(tracer, *rays) for n, rays in levels.items()}
    return {
        "format": 1,
        "scene": scene.id,
        "primitives": len(tracer.compiled.primitives.shape),
        "meshes": [_mesh(mesh, levels, reach) for mesh in tracer.compiled.meshes],
    }


def _lengths(tracer: Tracer, origin: np.ndarray, direction: np.ndarray) -> np.ndarray:
    return np.asarray(tracer.compiled.nearest(rays_from(origin, direction))[0])


def _mesh(
    mesh: MeshTarget, levels: dict[int, tuple[np.ndarray, np.ndarray]], reach: dict[int, np.ndarray]
) -> Json:
    boxes = shallow_boxes(mesh)
    found = {}
    for n, rays in levels.items():
        inside = boxes_entered(mesh, boxes, *rays, reach[n])
        columns = [crosses_sphere(boxes, *rays), *inside.T]
        found[str(n)] = [_runs(column) for column in columns]
    return {
        "object": mesh.index,
        "triangles": len(mesh.triangles.faces),
        "sphere": [_short(v) for v in (*boxes.centre, boxes.radius)],
        "boxes": [
            [_short(v) for v in (*low, *high)]
            for low, high in zip(boxes.low, boxes.high, strict=True)
        ],
        "parents": boxes.parent.tolist(),
        "levels": found,
    }


def _runs(inside: np.ndarray) -> list[int]:
    """Lengths of stretches that are out, in, out, in ... and begin with out."""
    edges = np.flatnonzero(np.diff(inside.astype(np.int8), prepend=0)).tolist()
    return [b - a for a, b in pairwise([0, *edges, len(inside)])] if edges else []


def _short(value: float) -> float:
    return float(format(value, f".{DIGITS}g"))
