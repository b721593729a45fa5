"""Whether a scene costs more the more scenes there are: builds of few and of many, on one core."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from raywalk.bench.cases import Case

FEW, MANY = 4, 16
# Of a scene's processor time among many, beside the same among few: pages name all scenes.
GROWTH = 1.15

SCENE = """
version = 1
title = "Ball {k}"
teaches = "A ball."
camera = {{ eye = [0, 0, 5], target = [0, 0, 0] }}
render = {{ size = 315, resolutions = [7, 21, 63], depth = 3 }}
lights = [{{ position = [1, 2, 3] }}]
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = {radius}
material = {{ like = "coloured", reflect = 0.5 }}
[[objects]]
name = "floor"
type = "plane"
point = [0, -1, 0]
normal = [0, 1, 0]
material = "white"
"""

PROGRAM = """
import os, sys, tempfile, time
from pathlib import Path
from raywalk.__main__ import main
from raywalk.bench.speed_many import write_scenes
if hasattr(os, "sched_setaffinity"):
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
for count in map(int, sys.argv[1:]):
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        write_scenes(place / "scenes", count)
        start = time.process_time()
        code = main(["site", "--scenes", str(place / "scenes"), "--out", str(place / "dist"),
                     "--work", str(place / "work")])
        assert code == 0
        print("seconds", count, time.process_time() - start)
"""


def write_scenes(folder: Path, count: int) -> None:
    """So many scenes of two objects, all of them different."""
    for k in range(count):
        place = folder / f"{k:03}-ball"
        place.mkdir(parents=True)
        text = SCENE.format(k=k, radius=0.5 + 0.01 * k)
        (place / "scene.toml").write_text(text, encoding="utf-8")


def many(few: int = FEW, more: int = MANY) -> dict[str, Any]:
    """Processor seconds a scene, among few and among many, after a build that loads everything."""
    command = [sys.executable, "-c", PROGRAM, "1", str(few), str(more)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    lines = [line.split() for line in done.stdout.splitlines() if line.startswith("seconds ")]
    a_scene = {int(count): float(seconds) / int(count) for _, count, seconds in lines}
    return {"few": few, "many": more, "growth": a_scene[more] / a_scene[few]}


def many_cases(row: dict[str, Any], seed: int) -> Iterator[Case]:
    """A scene's time does not grow with their number."""
    name = f"{row['many']} scenes instead of {row['few']}"
    yield Case("many scenes", name, "times as long a scene", GROWTH, row["growth"], 0, seed)
