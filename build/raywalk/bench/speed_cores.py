"""Whether a second core is of use: all scenes traced cold, as whole processes, on one and two."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from statistics import median
from typing import Any

from raywalk.bench.cases import Case
from raywalk.scene.model import Scene

GOAL = 1.7  # times as fast on two cores
ROUNDS = 3

PROGRAM = """
import os, sys
from pathlib import Path
os.sched_setaffinity(0, {int(core) for core in sys.argv[1].split(",")})
import raywalk.__main__  # as every command does, before numpy is loaded
from raywalk.bench.speed_cores import traced
if __name__ == "__main__":
    traced(Path(sys.argv[2]), sys.argv[3:])
"""


def traced(work: Path, folders: Sequence[str]) -> None:
    """Traces the scenes of these folders into an empty store, as a build does."""
    from raywalk.pipeline.parts import trace_parts
    from raywalk.pipeline.tracing import trace_all
    from raywalk.scene.read import read_scene
    from raywalk.work.store import Store

    scenes = [read_scene(Path(folder)) for folder in folders]
    parts = {scene.id: trace_parts(scene) for scene in scenes}
    for _ in trace_all(scenes, Store(work), parts):
        pass


def cores(scenes: Sequence[Scene], rounds: int = ROUNDS) -> dict[str, Any] | None:
    """Seconds on one core and on two, medians; None where this machine cannot tell."""
    if not hasattr(os, "sched_getaffinity") or len(os.sched_getaffinity(0)) < 2:
        return None
    two = sorted(os.sched_getaffinity(0))[:2]
    _seconds(two, scenes)  # compiles what these scenes need
    runs = [(_seconds(two[:1], scenes), _seconds(two, scenes)) for _ in range(rounds)]
    one, both = (median(times) for times in zip(*runs, strict=True))
    return {"scenes": len(scenes), "one": one, "two": both}


def _seconds(allowed: Sequence[int], scenes: Sequence[Scene]) -> float:
    """From the start of a process that may use these cores to its end."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program.py"  # a file: its processes import it again
        program.write_text(PROGRAM, encoding="utf-8")
        places = [str(scene.path.parent) for scene in scenes]
        command = [sys.executable, str(program), ",".join(map(str, allowed)), folder, *places]
        start = time.perf_counter()
        subprocess.run(command, check=True, capture_output=True)
        return time.perf_counter() - start


def as_table(row: dict[str, Any] | None) -> Iterator[str]:
    """A ratio only: seconds are of one machine."""
    if not row:
        yield "  not measured: this needs two cores, and a system that gives a program one of them"
        return
    yield f"  {row['scenes']} scenes: {row['one'] / row['two']:.2f} times as fast on two cores"


def core_cases(row: dict[str, Any] | None, seed: int) -> Iterator[Case]:
    """Two cores keep the goal."""
    if row:
        name = f"{row['scenes']} scenes on two cores"
        share = row["two"] / row["one"]
        yield Case("cores", name, "of the time on one", 1 / GOAL, share, 0, seed)
