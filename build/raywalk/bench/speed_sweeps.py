"""What a course's sweeps cost: its scenes traced cold with all of their stops, over without."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time
from typing import Any

from raywalk.bench.cases import Case
from raywalk.pipeline.parts import trace_parts
from raywalk.pipeline.sweeps import sweeps_here
from raywalk.pipeline.trace_task import trace_into
from raywalk.scene.model import Scene
from raywalk.sweeps.trace_stop import write_stop
from raywalk.trace.wavefront import Tracer, trace_grids
from raywalk.work.digests import key_of
from raywalk.work.pool import cores
from raywalk.work.progress import say_nothing
from raywalk.work.store import Store

GOAL = 4.0  # times the processor time of the same scenes without sweeps


def sweeps(scenes: Sequence[Scene]) -> list[dict[str, Any]]:
    """Of each scene in which something moves: its stops, and processor seconds of its trace and of
    all that is made of its sweeps, each into an empty store."""
    return [_measured(scene) for scene in scenes if scene.sweeps]


def _measured(scene: Scene) -> dict[str, Any]:
    with TemporaryDirectory() as folder:
        _warm_up(scene, Path(folder))
        store, parts = Store(Path(folder) / "work"), trace_parts(scene)
        begun = process_time()
        trace_into(store, {scene.id: parts}, scene, cores, say_nothing)
        traced = process_time()
        sweeps_here(store, scene, store.get(key_of(parts)))
        return {
            "scene": scene.id, "stops": sum(len(each.stops) for each in scene.sweeps),
            "trace": traced - begun, "sweeps": process_time() - traced,
        }  # fmt: skip


def _warm_up(scene: Scene, folder: Path) -> None:
    """What the first of all scenes would be charged with: kernels are compiled, meshes read."""
    trace_grids(Tracer(scene))
    sweep = scene.sweeps[0]
    write_stop(sweep.stops[0], sweep.resolutions, sweep.picture, folder, 1)


def _times(rows: Sequence[dict[str, Any]]) -> float:
    alone = sum(row["trace"] for row in rows)
    return (alone + sum(row["sweeps"] for row in rows)) / alone


def as_table(rows: Sequence[dict[str, Any]]) -> Iterator[str]:
    """Ratios only: seconds are of one machine."""
    for row in rows:
        yield f"  {row['scene']}: {_times([row]):.2f} times with {row['stops']} stops"


def sweep_cases(rows: Sequence[dict[str, Any]], seed: int) -> Iterator[Case]:
    """All together keep the goal; one small scene with many stops need not."""
    name = f"{len(rows)} scenes with {sum(row['stops'] for row in rows)} stops"
    yield Case("sweeps", name, "times the time without", GOAL, _times(rows), 0, seed)
