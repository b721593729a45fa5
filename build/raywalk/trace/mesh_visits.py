"""How rays go through a mesh's tree of boxes: which they visit in which order, and what that costs
for a tree that is cut off at some depth."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from raywalk.geometry.bvh import box_entry
from raywalk.geometry.compiled import rays_from
from raywalk.geometry.mesh_target import MeshTarget
from raywalk.geometry.shallow_boxes import crosses_sphere, shallow_boxes
from raywalk.trace.camera import camera_directions
from raywalk.trace.wavefront import Tracer

Json = dict[str, Any]
CUTS = (1, 2, 4, 8)  # levels of boxes; besides no tree at all, the sphere alone, and all levels
MISSED, ENTERED, CUT_OFF = 0, 1, 2  # a box: beside it; into it; it begins beyond the hit
DIGITS = 5  # of boxes and distances: they are only drawn and read


class Levels(NamedTuple):
    """Of each node of a Bvh."""

    level: np.ndarray  # (nodes,) 1 for the root
    under: np.ndarray  # (nodes,) triangles in it and in all below it


class Visit(NamedTuple):
    node: int
    t: float  # where the ray comes to the box; inf where it misses it
    what: int  # MISSED, ENTERED, CUT_OFF


def tree_of(tracer: Tracer, n: int) -> Json:
    """The first mesh's tree as the camera rays of an n x n picture use it: {"object", "n",
    "triangles", "sphere": [x, y, z, radius], "boxes": [[low, high, level, triangles in it]],
    "visits": [by ray, raster order: [box, what, t, ...]], "tests": {cut: [by ray]}}.

    A cut at level k makes leaves of that level's boxes. Every cut is of the one tree that
    `MeshTarget.count_tests` counts in, with the ray's length to its hit as the limit.
    """
    mesh = tracer.compiled.meshes[0]
    origin, direction, limit = _rays(tracer, n)
    levels = levels_of(mesh)
    walks = [_walk(mesh, levels, *ray) for ray in zip(origin, direction, limit, strict=True)]
    shown = sorted(
        set(np.flatnonzero(levels.level <= max(CUTS)).tolist())
        | {visit.node for walk in walks for visit in walk}
    )
    place = {node: k for k, node in enumerate(shown)}
    sphere = shallow_boxes(mesh)
    crosses = crosses_sphere(sphere, origin, direction)
    triangles = len(mesh.triangles.faces)
    tests = {
        "none": [triangles] * len(walks),
        "sphere": [1 + triangles * int(hit) for hit in crosses],
        **{str(cut): [cost(walk, levels, cut) for walk in walks] for cut in CUTS},
        "all": [cost(walk, levels) for walk in walks],
    }
    return {
        "object": mesh.index, "n": n, "triangles": triangles,
        "sphere": [_short(v) for v in (*sphere.centre, sphere.radius)],
        "boxes": [_box(mesh, levels, node) for node in shown],
        "visits": [
            [v for each in walk for v in (place[each.node], each.what, _distance(each.t))]
            for walk in walks
        ],
        "tests": tests,
    }  # fmt: skip


def levels_of(mesh: MeshTarget) -> Levels:
    """Parents stand before their children: one pass down, one up."""
    bvh, nodes = mesh.bvh, len(mesh.bvh.skip)
    level, under = np.ones(nodes, int), bvh.held.astype(int)
    inner = [node for node in range(nodes) if bvh.held[node] == 0]
    for node in inner:
        level[[node + 1, bvh.skip[node + 1]]] = level[node] + 1
    for node in reversed(inner):
        under[node] = under[node + 1] + under[bvh.skip[node + 1]]
    return Levels(level, under)


def _rays(tracer: Tracer, n: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Origins, directions, and how far each ray gets; inf where it leaves the scene."""
    camera = tracer.scene.camera
    direction = camera_directions(camera, n, n, np.arange(n * n))
    origin = np.tile(np.array(camera.eye, float), (n * n, 1))
    return origin, direction, tracer.compiled.nearest(rays_from(origin, direction))[0]


def _walk(
    mesh: MeshTarget, levels: Levels, origin: np.ndarray, direction: np.ndarray, limit: float
) -> list[Visit]:
    """Every box that the ray asks, in the order of `bvh_nearest`."""
    bvh, local = mesh.bvh, tuple((origin - mesh.centre).tolist())
    along, node, visits = tuple(direction.tolist()), 0, []
    while node < len(bvh.skip):
        t = box_entry(bvh.low, bvh.high, node, local, along, limit)
        if t < np.inf:
            visits.append(Visit(node, t, ENTERED))
            node += 1
            continue
        beyond = box_entry(bvh.low, bvh.high, node, local, along, np.inf)
        visits.append(Visit(node, beyond, CUT_OFF if beyond < np.inf else MISSED))
        node = int(bvh.skip[node])
    return visits


def cost(walk: list[Visit], levels: Levels, cut: int | None = None) -> int:
    """Tests of boxes and triangles, with the boxes of level `cut` as leaves; None: as it is."""
    tests = 0
    for node, _, what in walk:
        level, under = levels.level[node], levels.under[node]
        if cut is not None and level > cut:
            continue
        is_leaf = level == cut or _is_leaf(levels, node)
        tests += 1 + (int(under) if what == ENTERED and is_leaf else 0)
    return tests


def _is_leaf(levels: Levels, node: int) -> bool:
    """No deeper node follows it."""
    return node + 1 == len(levels.level) or bool(levels.level[node + 1] <= levels.level[node])


def _box(mesh: MeshTarget, levels: Levels, node: int) -> list[float]:
    corners = (*(mesh.bvh.low[node] + mesh.centre), *(mesh.bvh.high[node] + mesh.centre))
    return [*map(_short, corners), int(levels.level[node]), int(levels.under[node])]


def _distance(t: float) -> float:
    return _short(t) if t < np.inf else 0.0


def _short(value: float) -> float:
    return float(format(value, f".{DIGITS}g"))
