"""What a build costs, part by part: `make bench` measures all, `raywalk bench --only PART` one."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Callable
from typing import Any

from raywalk.bench import (
    speed_cores,
    speed_floor,
    speed_many,
    speed_memory,
    speed_rebuild,
    speed_skips,
    speed_triangles,
)
from raywalk.bench.cases import Case
from raywalk.scene.read import read_scenes

Lines = list[str]
Measure = Callable[[Namespace, list[Case]], Lines]


def part(key: str, chosen: Namespace, cases: list[Case]) -> dict[str, Any]:
    """Measures one part: its title and what it tells; its cases are added to `cases`."""
    title, measure = PARTS[key]
    return {"key": key, "title": title, "lines": measure(chosen, cases)}


def _skips(chosen: Namespace, cases: list[Case]) -> Lines:
    rows = list(speed_skips.skips(read_scenes(chosen.scenes), 3 if chosen.quick else 9))
    cases += speed_skips.skip_cases(rows, chosen.seed)
    return list(speed_skips.as_table(rows))


def _floor(chosen: Namespace, cases: list[Case]) -> Lines:
    scenes = read_scenes(chosen.scenes)
    scenes, rounds = (scenes[:1], 1) if chosen.quick else (scenes, 3)
    rows = list(speed_floor.floors(scenes, rounds))
    cases += speed_floor.floor_cases(rows, chosen.seed)
    return list(speed_floor.as_table(rows))


def _cores(chosen: Namespace, cases: list[Case]) -> Lines:
    scenes = read_scenes(chosen.scenes)
    row = speed_cores.cores(scenes, 1 if chosen.quick else speed_cores.ROUNDS)
    cases += speed_cores.core_cases(row, chosen.seed)
    return list(speed_cores.as_table(row))


def _memory(chosen: Namespace, cases: list[Case]) -> Lines:
    scenes = read_scenes(chosen.scenes)
    peaks = [speed_memory.memory(scene.path) for scene in (scenes[2:3] if chosen.quick else scenes)]
    cases += speed_memory.memory_cases(peaks, chosen.seed)
    return []


def _many(chosen: Namespace, cases: list[Case]) -> Lines:
    cases += speed_many.many_cases(speed_many.many(), chosen.seed)
    return []


def _triangles(chosen: Namespace, cases: list[Case]) -> Lines:
    finest, rounds = (1, 3) if chosen.quick else (speed_triangles.FINEST, 5)
    meshes = [speed_triangles.Fineness(path) for path in chosen.meshes]
    rows = speed_triangles.triangles(meshes or speed_triangles.dragons(finest), rounds)
    cases += speed_triangles.triangle_cases(rows, chosen.seed)
    return list(speed_triangles.as_table(rows))


def _rebuild(chosen: Namespace, cases: list[Case]) -> Lines:
    row = speed_rebuild.rebuild(chosen.scenes, chosen.work)
    cases += speed_rebuild.rebuild_cases(row, chosen.seed)
    return list(speed_rebuild.as_table(row))


PARTS: dict[str, tuple[str, Measure]] = {
    "skips": ("Skips: time without the skip over time with it", _skips),
    "floor": (
        "Making a scene, over meeting its rays with surfaces and deflating",
        _floor,
    ),
    "cores": ("All scenes on two cores beside one", _cores),
    "memory": ("Peak memory of making a scene", _memory),
    "many": ("Many scenes beside few", _many),
    "triangles": ("Time a ray over the triangles of a mesh", _triangles),
    "rebuild": ("Building again after a change", _rebuild),
}
