"""What a build costs, part by part: `make bench` measures all, `raywalk bench --only PART` one."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from raywalk.bench import (
    check_work,
    look,
    recognition,
    speed_cluster,
    speed_cores,
    speed_counters,
    speed_floor,
    speed_many,
    speed_memory,
    speed_primitives,
    speed_rebuild,
    speed_skips,
    speed_sweeps,
    speed_triangles,
)
from raywalk.bench.cases import Case
from raywalk.scene.model import Scene
from raywalk.scene.read import read_own_scenes


class Part(NamedTuple):
    """One thing to measure, and what is made of the figures."""

    title: str
    measured: Callable[[Namespace], Any]
    cases: Callable[[Any, int], Iterable[Case]]  # of the figures and the seed
    lines: Callable[[Any], Iterable[str]] = lambda figures: ()
    table: Callable[[Any], dict[str, Any] | None] = lambda figures: None


def part(key: str, chosen: Namespace, cases: list[Case]) -> dict[str, Any]:
    """Measures one part: its title and what it tells; its cases are added to `cases`."""
    which = PARTS[key]
    figures = which.measured(chosen)
    cases += which.cases(figures, chosen.seed)
    return {
        "key": key, "title": which.title, "lines": list(which.lines(figures)),
        "table": which.table(figures),
    }  # fmt: skip


def _floor(chosen: Namespace) -> list[dict[str, Any]]:
    scenes = read_own_scenes(chosen.scenes)
    return list(speed_floor.floors(*((scenes[:1], 1) if chosen.quick else (scenes, 3))))


def _memory(chosen: Namespace) -> list[dict[str, Any]]:
    scenes = read_own_scenes(chosen.scenes)
    rows = [speed_memory.memory(each.path) for each in (scenes[2:3] if chosen.quick else scenes)]
    return [*rows, speed_memory.many_objects(1_000 if chosen.quick else 10_000)]


def _mistakes(chosen: Namespace) -> dict[str, recognition.Tally]:
    scenes = read_own_scenes(chosen.scenes)
    fine = recognition.shown_in(scenes, recognition.FINE_SCENES)
    other = recognition.at_other_sizes(fine[:1] if chosen.quick else fine, chosen.out)
    return _recognised(recognition.shown_in(scenes), chosen) | {"other sizes": other}


def _recognised(scenes: list[Scene], chosen: Namespace) -> dict[str, recognition.Tally]:
    if chosen.quick:
        return recognition.recognised(scenes[:3], (105,), 12, chosen.seed, 4)
    if chosen.full:
        sizes = (*recognition.SIZES, recognition.FINE)
        return recognition.recognised(scenes, sizes, seed=chosen.seed)
    return recognition.recognised(scenes, seed=chosen.seed, every=recognition.SAMPLE)


def _triangles(chosen: Namespace) -> list[dict[str, Any]]:
    finest, rounds = (1, 3) if chosen.quick else (speed_triangles.FINEST, 5)
    meshes = [speed_triangles.Fineness(path) for path in chosen.meshes]
    return speed_triangles.triangles(meshes or speed_triangles.dragons(finest), rounds)


PARTS = {
    "skips": Part(
        "Skips: time without the skip over time with it",
        lambda c: list(speed_skips.skips(read_own_scenes(c.scenes), 3 if c.quick else 9)),
        speed_skips.skip_cases, speed_skips.as_table,
    ),
    "floor": Part(
        "Making a scene, over meeting its rays with surfaces, shading and deflating",
        _floor, speed_floor.floor_cases, speed_floor.as_table,
    ),
    "cores": Part(
        "All scenes on two cores beside one",
        lambda c: speed_cores.cores(
            read_own_scenes(c.scenes), 1 if c.quick else speed_cores.ROUNDS
        ),
        speed_cores.core_cases, speed_cores.as_table,
    ),
    "memory": Part("Peak memory of making a scene", _memory, speed_memory.memory_cases),
    "many": Part(
        "Many scenes beside few", lambda c: speed_many.many(), speed_many.many_cases
    ),
    "sweeps": Part(
        "Scenes with all stops of their sweeps, over the same scenes without",
        lambda c: speed_sweeps.sweeps(read_own_scenes(c.scenes)[: 2 if c.quick else None]),
        speed_sweeps.sweep_cases, speed_sweeps.as_table,
    ),
    "triangles": Part(
        "Time a ray over the triangles of a mesh",
        _triangles, speed_triangles.triangle_cases, speed_triangles.as_table,
    ),
    "primitives": Part(
        "Time a ray over the number of spheres",
        lambda c: speed_primitives.primitives(3 if c.quick else 9, c.seed),
        speed_primitives.primitive_cases, speed_primitives.as_table,
    ),
    "counters": Part(
        "Each stage beside what the processor could do",
        lambda c: speed_counters.counters(c.scenes, c.quick, c.seed),
        lambda figures, seed: (), speed_counters.as_table, speed_counters.rows_of,
    ),
    "look": Part(
        "The approximate look of mirrors and glass beside the traced picture",
        lambda c: look.looks(), look.look_cases, look.as_table,
    ),
    "cluster": Part(
        "A cluster: one large picture, many scenes, a worker killed",
        lambda c: speed_cluster.cluster(c.scenes, c.quick),
        speed_cluster.cluster_cases, speed_cluster.as_table,
    ),
    "rebuild": Part(
        "Building again after a change",
        lambda c: speed_rebuild.rebuild(c.scenes, c.work),
        speed_rebuild.rebuild_cases, speed_rebuild.as_table,
    ),
    "mistakes": Part(
        "Mistakes in students' pictures, named", _mistakes, recognition.cases,
        recognition.lines, recognition.as_table,
    ),
    "check": Part(
        "Checking a student's picture in the page, over reading it",
        lambda c: check_work.checks(), check_work.check_cases, check_work.as_lines,
    ),
}  # fmt: skip
