"""What the trace file loses: decoded columns against the ray tree they came from."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.bench.cases import Case
from raywalk.scene.model import Scene
from raywalk.stops.decoded import DecodedTrace, read_trace
from raywalk.stops.process import Stops
from raywalk.trace.tree import RayTree
from raywalk.trace.wavefront import trace_scene
from raywalk.trace_file.encode import write_level
from raywalk.trace_file.level import level_of
from raywalk.trace_file.precision import COLOUR

SIZE, LEVEL = 165, 55
# Column of the file's header: the bound it must keep whatever it states, and its unit.
COLUMNS = {
    "point": (5e-4, "world units"),
    "normal": (2.2e-4, "difference of unit vectors"),
    "colour": (COLOUR, "of full brightness"),
    "weight": (7e-5, "share"),
}
EXACT = ("kind", "parent", "object", "material", "inside", "depth")


def losses(scene: Scene, stops: Stops) -> tuple[dict[str, float], dict[str, float], int, int]:
    """Measured and stated largest errors, exact columns that differ, and rays."""
    small = replace(scene, render=replace(scene.render, size=SIZE, resolutions=(LEVEL,)))
    traced = trace_scene(small)
    level = level_of(traced.tree, LEVEL)
    with tempfile.TemporaryDirectory() as folder:
        write_level(Path(folder), level, LEVEL, small, traced.picture)
        decoded = read_trace(Path(folder) / f"{LEVEL}.js", stops, scene.id, LEVEL)
    differing = sum(not same(getattr(level, name), getattr(decoded, name)) for name in EXACT)
    return measured(level, decoded), decoded.header["errors"], differing, decoded.count


def measured(tree: RayTree, decoded: DecodedTrace) -> dict[str, float]:
    """Largest difference of each column, points where a ray hits."""
    hit = tree.object >= 0
    return {
        "point": longest(decoded.point[hit] - tree.point[hit]),
        "normal": longest(decoded.normal[hit] - tree.normal[hit]),
        "colour": float(np.abs(decoded.colour - tree.colour).max()),
        "weight": float(np.abs(decoded.weight - tree.weight).max()),
    }


def quantisation(scenes: Iterable[Scene]) -> Iterator[Case]:
    """Each column's largest error over all scenes, and whether the headers tell the truth."""
    most: dict[str, float] = dict.fromkeys(COLUMNS, 0.0)
    beyond, differing, rays = 0.0, 0, 0
    with Stops() as stops:
        for scene in scenes:
            found, stated, unlike, count = losses(scene, stops)
            differing, rays = differing + unlike, rays + count
            for name, error in found.items():
                most[name] = max(most[name], error)
                beyond = max(beyond, error / stated[name] if error else 0.0)
    where = f"all scenes, {LEVEL} x {LEVEL}"
    for name, (bound, unit) in COLUMNS.items():
        yield Case("trace file", where, f"error of {name}, {unit}, max", bound, most[name], rays, 0)
    yield Case("trace file", where, "error by the one its header states, max", 1.0, beyond, rays, 0)
    yield Case(
        "trace file", where, "columns of kinds, objects, parents that differ",
        0.0, float(differing), rays, 0,
    )  # fmt: skip


def longest(rows: np.ndarray) -> float:
    return float(np.sqrt((rows**2).sum(axis=1)).max(initial=0.0))


def same(one: Any, other: Any) -> bool:
    return bool((np.asarray(one).astype(np.int64) == np.asarray(other).astype(np.int64)).all())
