"""raywalk bench: run time against error, beside other ways to trace."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

SEED = 20_260
PARTS = ("skips", "memory", "many", "floor")


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("bench", help="measure run time against error, beside peers")
    parser.add_argument("--quick", action="store_true", help="fewer rays and rounds")
    parser.add_argument("--only", choices=PARTS, help="one part of what has no page of its own")
    parser.add_argument("--seed", type=int, default=SEED, help="of all random rays")
    parser.add_argument("--work", type=Path, default=Path(".work"), help="where reports are kept")
    parser.add_argument("--out", type=Path, default=Path("dist"), help="the site the page goes to")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """Tells what is measured. Raises BrokenBounds at the end if a bound of ours is broken."""
    from raywalk.bench import bench
    from raywalk.bench.cases import Case, refuse_broken
    from raywalk.bench.picture_error import picture_cases, pictures, resolution
    from raywalk.bench.quantisation import quantisation
    from raywalk.bench.report import keep_bench, publish_page
    from raywalk.scene import read_scenes

    if chosen.only:
        yield from run_part(chosen)
        return
    yield f"seed {chosen.seed}"
    side, rounds = (128, 3) if chosen.quick else (bench.SIDE, bench.ROUNDS)
    measured: dict[str, Any] = {"seed": chosen.seed, "tasks": []}
    cases: list[Case] = []
    for task in bench.tasks(side, rounds, chosen.seed):
        measured["tasks"].append(task)
        cases += bench.bounds(task, chosen.seed)
        yield f"{task['title']} (time by {task['floor']})"
        yield from map(bench.as_line, task["ways"])
    measured["says"] = list(bench.says(measured["tasks"]))
    yield "Whole pictures"
    measured["picture"] = pictures(rounds, chosen.seed, 200 if chosen.quick else 400)
    cases += picture_cases(measured["picture"], chosen.seed)
    for way in measured["picture"]["ways"]:
        yield (
            f"  {way['name']}: {way['seconds']:.2f} s, {100 * way['wrong']:.1f} % of 8-bit pixels "
            f"wrong, mean error {way['mean']:.1e}"
        )
    measured["resolution"] = resolution(chosen.seed, 231 if chosen.quick else 1155)
    cases += quantisation(read_scenes(chosen.scenes))
    measured["cases"] = [case.as_dict() for case in cases]
    yield from measured["says"]
    yield from (case.as_line() for case in cases)
    keep_bench(chosen.work, measured)
    yield from publish_page(chosen.work, chosen.out)
    refuse_broken(cases)


def run_part(chosen: Namespace) -> Iterator[str]:
    """One part: what skips bring, times over the floor, peak memory, or many scenes beside few."""
    from raywalk.bench import speed_floor, speed_many, speed_memory, speed_skips
    from raywalk.bench.cases import refuse_broken
    from raywalk.scene import read_scenes

    scenes = read_scenes(chosen.scenes)
    if chosen.only == "skips":
        rows = list(speed_skips.skips(scenes, 3 if chosen.quick else 9))
        yield "Time without the skip over time with it"
        yield from speed_skips.as_table(rows)
        cases = list(speed_skips.skip_cases(rows, chosen.seed))
    elif chosen.only == "floor":
        chosen_scenes = scenes[:1] if chosen.quick else scenes
        rows = list(speed_floor.floors(chosen_scenes, 1 if chosen.quick else 3))
        yield from speed_floor.as_table(rows)
        cases = list(speed_floor.floor_cases(rows, chosen.seed))
    elif chosen.only == "memory":
        chosen_scenes = scenes[2:3] if chosen.quick else scenes
        peaks = [speed_memory.memory(scene.path) for scene in chosen_scenes]
        cases = list(speed_memory.memory_cases(peaks, chosen.seed))
    else:
        cases = list(speed_many.many_cases(speed_many.many(), chosen.seed))
    yield from (case.as_line() for case in cases)
    refuse_broken(cases)
