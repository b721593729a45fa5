"""Picks the rays of kept pixels out of each strip and puts them together as one RayTree."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from raywalk.geometry.compiled import Rays
from raywalk.geometry.roots import NOWHERE
from raywalk.trace.kinds import BRANCH_OF, BRANCHES
from raywalk.trace.tally import Tally, tally_tests
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


def record(
    tracer: Tracer, waves: list[Wave], pixels: np.ndarray, kept: np.ndarray, tally: Tally
) -> Recorded:
    """The kept part of a strip's waves, which is counted in the tally."""
    chosen = np.flatnonzero(kept[pixels])
    tally.kept_pixels += len(chosen)
    recorded: list[dict[str, np.ndarray]] = []
    hits = tracer.compiled.crossings(waves[0].rays.take(chosen))
    before = np.empty(0, np.int64)
    for depth, wave in enumerate(waves):
        if depth:
            place = np.full(len(waves[depth - 1].parent), -1)
            place[before] = np.arange(len(before))
            chosen = np.flatnonzero(place[wave.parent] >= 0)
            parent = place[wave.parent[chosen]]
        else:
            parent = np.full(len(chosen), -1)
        if not len(chosen):
            break
        tally.add(tally_tests(tracer.compiled, wave.rays.take(chosen), wave.hits.t[chosen]))
        columns = _columns(tracer, wave, chosen, depth, parent)
        columns["pixel"] = pixels[chosen] if depth == 0 else recorded[-1]["pixel"][parent]
        recorded.append(columns)
        before = chosen
    return Recorded(recorded, hits)


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
        "colour": wave.colour[chosen],
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
        levels.append({key: column[order] for key, column in level.items()})
    return _tree(tracer, levels, records, size)


def _join(records: list[Recorded], depth: int) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """All strips' rays of one depth, and for each where its strip's parents start."""
    parts, starts, start = [], [], 0
    for recorded in records:
        if depth < len(recorded.waves):
            parts.append(recorded.waves[depth])
            starts.append(np.full(len(parts[-1]["parent"]), start))
        if 0 < depth <= len(recorded.waves):
            start += len(recorded.waves[depth - 1]["parent"])
    joined = {key: np.concatenate([part[key] for part in parts]) for key in parts[0]}
    return joined, np.concatenate(starts)


def _tree(
    tracer: Tracer, levels: list[dict[str, np.ndarray]], records: list[Recorded], size: int
) -> RayTree:
    names = [key for key in RayTree.__dataclass_fields__ if key in levels[0]]
    columns = {key: np.concatenate([level[key] for level in levels]) for key in names}
    counts = np.concatenate([np.diff(r.hits[0]) for r in records])
    return RayTree(
        size=size,
        **{**columns, "pixel": columns["pixel"].astype(np.int32)},
        hits_start=np.concatenate([[0], np.cumsum(counts)]).astype(np.int32),
        hits_t=np.concatenate([r.hits[1] for r in records]),
        hits_object=np.concatenate([r.hits[2] for r in records]).astype(np.int32),
    )
