"""Picks the rays of kept pixels out of each strip and puts them together as one RayTree."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from raywalk.geometry.compiled import Rays
from raywalk.geometry.roots import NOWHERE
from raywalk.trace.kinds import BRANCH_OF, BRANCHES
from raywalk.trace.tally import Tally, tally_tests, tally_wave
from raywalk.trace.tree import RayTree, dense, level_pixels
from raywalk.trace.wave import Wave

if TYPE_CHECKING:
    from raywalk.trace.wavefront import Tracer

# A ray that leaves the scene is drawn a little beyond the sphere round everything finite.
BEYOND = 1.25

LIGHT_COLUMNS = ("visibility", "blocker", "blocked_at", "passed", "diffuse", "specular")


class Recorded(NamedTuple):
    """Kept rays of one strip: columns per depth, parents as rows of the kept wave before."""

    waves: list[dict[str, np.ndarray]]
    hits: tuple[np.ndarray, np.ndarray, np.ndarray]  # start, t, object along camera rays


def kept_pixels(size: int, resolutions: tuple[int, ...]) -> np.ndarray:
    """(size * size,) bool: pixels whose ray some frustum resolution uses."""
    kept = np.zeros(size * size, bool)
    for n in resolutions:
        kept[level_pixels(size, n)] = True
    return kept


def record(tracer: Tracer, waves: Sequence[Wave], pixels: np.ndarray, kept: np.ndarray) -> Recorded:
    """The kept part of waves whose colours are gathered."""
    recording = Recording(tracer, pixels, kept)
    for wave in waves:
        recording.add(wave)
    return recording.finished([wave.colour for wave in waves])


class Recording:
    """Notes the kept part of a strip's waves as they come, and counts them: once a wave has sent
    its rays on and is noted, all but what it brings back may go."""

    def __init__(self, tracer: Tracer, pixels: np.ndarray, kept: np.ndarray | None):
        """kept: None if waves are only counted."""
        self.tally = Tally(pixels=len(pixels))
        self._tracer, self._pixels = tracer, pixels
        # (rays,) bool, of the wave that came last, or is to come first.
        self._kept = None if kept is None else kept[pixels]
        self._waves: list[dict[str, np.ndarray]] = []
        self._rows: list[np.ndarray] = []  # of each wave, those that are kept
        self._hits = (np.zeros(1, np.int32), np.empty(0), np.empty(0, np.int32))

    def add(self, wave: Wave) -> None:
        """The next wave; the first is of camera rays."""
        tracer, depth = self._tracer, len(self._rows)
        self.tally.add(tally_wave(tracer.scene, tracer.plan.asked, wave))
        if self._kept is None:
            return
        if depth:
            place = np.cumsum(self._kept) - 1
            self._kept = self._kept[wave.parent]
        rows = np.flatnonzero(self._kept)
        self._rows.append(rows)
        if not depth:
            self.tally.kept_pixels = len(rows)
            self._hits = tracer.compiled.crossings(wave.rays.take(rows))
        if not len(rows):
            return
        parent = place[wave.parent[rows]] if depth else np.full(len(rows), -1)
        tests = tally_tests(tracer.compiled, wave.rays.take(rows), wave.hits.t[rows])
        self.tally.add(tests)
        columns = _columns(tracer, wave, rows, depth, parent)
        columns["pixel"] = self._waves[-1]["pixel"][parent] if depth else self._pixels[rows]
        self._waves.append(columns)

    def finished(self, colours: Sequence[np.ndarray]) -> Recorded:
        """All of it, with the gathered colours (n, 3) of each wave."""
        for columns, rows, colour in zip(self._waves, self._rows, colours, strict=False):
            columns["colour"] = colour[rows]
        return Recorded(self._waves, self._hits)


def _columns(
    tracer: Tracer, wave: Wave, chosen: np.ndarray, depth: int, parent: np.ndarray
) -> dict[str, np.ndarray]:
    hits, lighting = wave.hits, wave.lighting
    rays, t = wave.rays.take(chosen), hits.t[chosen]
    gone = hits.object[chosen] == NOWHERE
    point, normal = hits.point[chosen], hits.normal[chosen]
    point[gone] = where_drawn_lines_end(tracer, rays.take(gone))
    return {
        "parent": parent.astype(np.int32),
        "kind": wave.kind[chosen],
        "depth": np.full(len(chosen), min(depth, 255), np.uint8),
        "object": hits.object[chosen].astype(np.int32),
        "material": hits.material[chosen].astype(np.int32),
        "inside": hits.inside[chosen],
        "t": t,
        "point": point,
        "normal": normal,
        "weight": wave.weight[chosen],
        "tests": tracer.compiled.count_tests(rays, np.where(gone, np.inf, t)),
        **{key: getattr(lighting, key)[chosen] for key in LIGHT_COLUMNS},
        "local": lighting.local[chosen],
        "local_weight": lighting.local_weight[chosen],
        **({} if lighting.base is None else {"base": lighting.base[chosen]}),
    }


def where_drawn_lines_end(tracer: Tracer, rays: Rays) -> np.ndarray:
    """(n, 3) where rays that leave the scene cross a sphere round everything finite in it.

    A ray that starts beyond the sphere, far out on a plane, is drawn by its radius.
    """
    centre, radius = tracer.scene_sphere
    offset = rays.origin - centre
    along = (offset * rays.direction).sum(axis=1)
    reach = (BEYOND * radius) ** 2 - (offset**2).sum(axis=1) + along**2
    length = np.where(reach > 0, np.sqrt(np.maximum(reach, 0)) - along, radius)
    return np.asarray(rays.origin + np.where(length > 0, length, radius)[:, None] * rays.direction)


def assemble(tracer: Tracer, records: list[Recorded], size: int) -> RayTree:
    """One tree from all strips, path-major: depth by depth, path by path, raster order."""
    depths = max((len(r.waves) for r in records), default=0)
    levels: list[dict[str, np.ndarray]] = []
    offset, path = 0, np.zeros(1, np.int64)
    place = np.empty(0, np.int64)  # where the rays of the depth before went
    for depth in range(depths):
        level, strip_starts = _join(records, depth)
        if depth:
            parent = level["parent"] + strip_starts
            # Small again: the numbers of 1000 bounces would overflow.
            path = dense(BRANCHES * path[parent] + BRANCH_OF[level["kind"]])
            order = np.lexsort([place[parent], path])
            level["parent"] = (place[parent] + offset - len(place)).astype(np.int32)
        else:
            path = np.zeros(len(level["parent"]), np.int64)
            order = np.argsort(level["pixel"], kind="stable")
        place = np.empty(len(order), np.int64)
        place[order] = np.arange(len(order))
        offset += len(order)
        levels.append({key: level.pop(key)[order] for key in list(level)})
    return _tree(tracer, levels, records, size)


def _join(records: list[Recorded], depth: int) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """All strips' rays of one depth, and for each where its strip's parents start. They are taken
    out of the strips: held twice, they would be the most that a scene's memory holds."""
    parts, starts, start = [], [], 0
    for recorded in records:
        if depth < len(recorded.waves):
            parts.append(recorded.waves[depth])
            starts.append(np.full(len(parts[-1]["parent"]), start))
        if 0 < depth <= len(recorded.waves):
            start += len(recorded.waves[depth - 1]["parent"])
    joined = {"parent": np.concatenate([part["parent"] for part in parts])}
    for key in [key for key in parts[0] if key != "parent"]:
        joined[key] = np.concatenate([part.pop(key) for part in parts])
    return joined, np.concatenate(starts)


def _tree(
    tracer: Tracer, levels: list[dict[str, np.ndarray]], records: list[Recorded], size: int
) -> RayTree:
    names = [key for key in RayTree.__dataclass_fields__ if key in levels[0]]
    columns = {key: np.concatenate([level.pop(key) for level in levels]) for key in names}
    counts = np.concatenate([np.diff(r.hits[0]) for r in records])
    return RayTree(
        size=size,
        **{**columns, "pixel": columns["pixel"].astype(np.int32)},
        hits_start=np.concatenate([[0], np.cumsum(counts)]).astype(np.int32),
        hits_t=np.concatenate([r.hits[1] for r in records]),
        hits_object=np.concatenate([r.hits[2] for r in records]).astype(np.int32),
    )
