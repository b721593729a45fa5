"""What slots in a lesson's words are filled from (scene/slots.py): the trees of pixels as `raywalk
pixel` prints them, triangles of meshes; and over the whole picture how far its rays bounce."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.scene.shapes import Mesh
from raywalk.trace.pixel_tree import tree_at
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.tree import level_pixels
from raywalk.trace.wavefront import STRIP, Tracer

FIGURES = "figures.json"


def write_figures(scene: Scene, pixels: Sequence[tuple[int, int, int]], folder: Path) -> None:
    """FIGURES: {"pixels": [[[n, column, row], camera ray], ...], "meshes": by object}. A grid's
    pixel is the picture's at the same centre."""
    tracer, size = Tracer(scene), scene.render.size
    trees = []
    for n, column, row in pixels:
        place = int(level_pixels(size, n)[row * n + column])
        trees.append([[n, column, row], _pruned(tree_at(tracer, place, size, size)["tree"], 1.0)])
    found = {"pixels": trees, "meshes": _meshes(tracer)}
    (folder / FIGURES).write_text(json.dumps(found, allow_nan=False), encoding="utf-8")


def _pruned(ray: dict[str, Any], share: float) -> dict[str, Any]:
    """Without rays that pictures do not follow, as the card has it; colours are of all rays."""
    share *= ray["weight"]
    sent = [child for child in ray["children"] if share * child["weight"] >= LEAST_SHARE]
    return {**ray, "children": [_pruned(child, share) for child in sent]}


def _meshes(tracer: Tracer) -> dict[str, dict[str, int]]:
    """Triangles: each round of subdivision makes four of one."""
    found = {}
    for mesh in tracer.compiled.meshes:
        obj, traced = tracer.scene.objects[mesh.index], len(mesh.triangles.faces)
        assert isinstance(obj.shape, Mesh)
        found[obj.name] = {"traced": traced, "filed": traced // 4**obj.shape.subdivide}
    return found


def write_bounces(scene: Scene, folder: Path) -> None:
    """FIGURES: of the picture's camera rays how many lead to 0, 1, 2 ... bounces or more."""
    tracer, size = Tracer(scene, least_share=LEAST_SHARE), scene.render.size
    counts = np.zeros(scene.render.depth + 1, int)
    for first in range(0, size * size, STRIP):
        pixels = np.arange(first, min(first + STRIP, size * size))
        who = np.arange(len(pixels))
        rays = tracer.camera_rays(pixels, size, size)
        for bounces, met in enumerate(tracer.each_met(rays, tracer.eye_media)):
            who = who[met.shot.parent] if bounces else who
            counts[bounces] += len(np.unique(who))
    reached = counts[: np.flatnonzero(counts)[-1] + 1].tolist()
    (folder / FIGURES).write_text(json.dumps(reached), encoding="utf-8")
