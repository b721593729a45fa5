"""raywalk bench: run time against error beside other methods to trace, and what a build costs."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

SEED = 20_260
PARTS = (
    "skips", "floor", "cores", "memory", "many", "triangles", "primitives", "counters", "cluster",
    "look", "rebuild", "sweeps", "mistakes", "check",
)  # fmt: skip
MISTAKES = "mistakes"  # which the page has a section of, measured with the rest or by itself


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("bench", help="measure run time against error, beside peers")
    parser.add_argument("--quick", action="store_true", help="fewer rays, rounds and scenes")
    parser.add_argument(
        "--only", choices=PARTS, help="one part of what is measured; only mistakes get on the page"
    )
    parser.add_argument(
        "--full", action="store_true",
        help="all mistakes in students' pictures, of 1155 x 1155 too: hours; else every third",
    )  # fmt: skip
    parser.add_argument(
        "--meshes", type=Path, nargs="+", default=[], metavar="FILE",
        help="one mesh in several finenesses, coarsest first: in place of the subdivided dragon",
    )  # fmt: skip
    parser.add_argument("--seed", type=int, default=SEED, help="of all random rays")
    parser.add_argument("--work", type=Path, default=Path(".work"), help="where reports are kept")
    parser.add_argument("--out", type=Path, default=Path("dist"), help="the site the page goes to")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """Tells what is measured. Raises BrokenBounds at the end if a bound of ours is broken."""
    from raywalk.bench.cases import Case, refuse_broken
    from raywalk.bench.report import keep_bench, keep_mistakes, publish_page
    from raywalk.bench.speed import part

    cases: list[Case] = []
    if chosen.only:
        measurement = part(chosen.only, chosen, cases)
        yield from [*measurement["lines"], *(case.as_line() for case in cases)]
        if chosen.only == MISTAKES:
            keep_mistakes(chosen.work, measurement, cases, _asked_with(chosen))
            yield from publish_page(chosen.work, chosen.out)
        refuse_broken(cases)
        return
    yield f"seed {chosen.seed}"
    measured: dict[str, Any] = {"seed": chosen.seed, "tasks": []}
    yield from _tracing(chosen, measured, cases)
    measured["cases"] = [case.as_dict() for case in cases]
    measured["builds"] = []
    for key in PARTS:
        own: list[Case] = []
        measurement = part(key, chosen, own)
        yield from [measurement["title"], *measurement["lines"], *(case.as_line() for case in own)]
        if key == MISTAKES:
            keep_mistakes(chosen.work, measurement, own, _asked_with(chosen))
        else:
            measured["builds"].append({**measurement, "cases": [case.as_dict() for case in own]})
        cases += own
    keep_bench(chosen.work, measured)
    yield from publish_page(chosen.work, chosen.out)
    refuse_broken(cases)


def _tracing(chosen: Namespace, measured: dict[str, Any], cases: list[Any]) -> Iterator[str]:
    """Time against error on the same rays, then of whole pictures."""
    from raywalk.bench import bench
    from raywalk.bench.picture_error import picture_cases, pictures, resolution
    from raywalk.bench.quantisation import quantisation
    from raywalk.scene.read import read_own_scenes

    side, rounds = (128, 3) if chosen.quick else (bench.SIDE, bench.ROUNDS)
    for task in bench.tasks(side, rounds, chosen.seed):
        measured["tasks"].append(task)
        cases += bench.bounds(task, chosen.seed)
        if not chosen.quick:  # so few rays say little about time
            cases += bench.time_bounds(task, chosen.seed, side * side)
        yield f"{task['title']} (time by {task['floor']})"
        yield from map(bench.as_line, task["methods"])
    measured["says"] = list(bench.says(measured["tasks"]))
    yield "Whole pictures"
    measured["picture"] = pictures(rounds, chosen.seed, 200 if chosen.quick else 400)
    cases += picture_cases(measured["picture"], chosen.seed)
    for method in measured["picture"]["methods"]:
        yield (
            f"  {method['name']}: {method['seconds']:.2f} s, {100 * method['wrong']:.1f} % of "
            f"8-bit pixels wrong, mean error {method['mean']:.1e}"
        )
    measured["resolution"] = resolution(chosen.seed, 231 if chosen.quick else 1155)
    cases += quantisation(read_own_scenes(chosen.scenes))
    yield from measured["says"]
    yield from (case.as_line() for case in cases)


def _asked_with(chosen: Namespace) -> str:
    """The command that asks the same pictures again."""
    size = " --quick" if chosen.quick else " --full" if chosen.full else ""
    return f"raywalk bench --only {MISTAKES}{size} --seed {chosen.seed}"
