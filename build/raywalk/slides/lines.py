"""A pixel's rays as straight lines, from the trace file; as the viewer's state/lines.ts."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from raywalk.scene.model import Scene
from raywalk.slides.views import View
from raywalk.trace_file import DecodedTrace, Kind, Visibility

KINDS = ("camera", "reflected", "refracted", "total", "reached", "blocked")


@dataclass(frozen=True, eq=False)
class RayLine:
    """A ray, or a shadow ray, from where it starts to where it ends. World units."""

    kind: str  # one of KINDS
    ends: np.ndarray  # (2, 3)
    ray: int  # row of the trace; of a shadow ray: the ray whose hit it leaves
    light: int  # of a shadow ray, else -1
    leaves: bool  # it leaves the scene and ends nowhere


def pixel_lines(trace: DecodedTrace, scene: Scene, pixels: Iterable[int]) -> list[RayLine]:
    """Every line of these pixels, in the trace's order: a parent before its children."""
    lines = []
    for ray in np.flatnonzero(np.isin(trace.pixel, np.fromiter(pixels, int))).tolist():
        parent = int(trace.parent[ray])
        start = np.array(scene.camera.eye, float) if parent < 0 else trace.point[parent]
        kind = Kind(int(trace.kind[ray])).name.lower()
        ends = np.array([start, trace.point[ray]])
        lines.append(RayLine(kind, ends, ray, -1, bool(trace.object[ray] < 0)))
        lines += _shadow_lines(trace, scene, ray)
    return lines


def _shadow_lines(trace: DecodedTrace, scene: Scene, ray: int) -> Iterable[RayLine]:
    point = trace.point[ray]
    for k, light in enumerate(scene.lights):
        seen = int(trace.visibility[ray, k])
        if trace.object[ray] < 0 or seen not in (Visibility.REACHED, Visibility.BLOCKED):
            continue
        end = np.array(light.position, float)
        if seen == Visibility.BLOCKED:
            end = point + (end - point) * trace.blockedAt[ray, k]
        kind = "reached" if seen == Visibility.REACHED else "blocked"
        yield RayLine(kind, np.array([point, end]), ray, k, False)


def tree_rows(trace: DecodedTrace, pixel: int) -> list[int]:
    """The rays of a pixel, each followed by what it led to (depth first)."""
    children: dict[int, list[int]] = {}
    for ray in np.flatnonzero(trace.pixel == pixel).tolist():
        children.setdefault(int(trace.parent[ray]), []).append(ray)
    order: list[int] = []
    waiting = children.get(-1, [])[::-1]
    while waiting:
        ray = waiting.pop()
        order.append(ray)
        waiting += children.get(ray, [])[::-1]
    return order


def thin_pixels(view: View) -> list[int]:
    """Pixels of the selected row, of the column, or all: those drawn thin, not the chosen one."""
    n, (column, row) = view.n, view.pixel
    wanted: set[int] = set()
    if "all" in view.rays:
        wanted |= set(range(n * n))
    if "row" in view.rays:
        wanted |= {row * n + k for k in range(n)}
    if "column" in view.rays:
        wanted |= {k * n + column for k in range(n)}
    if "pixel" in view.rays:
        wanted.discard(view.index)
    return sorted(wanted)
