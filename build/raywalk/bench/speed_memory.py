"""Peak memory of making one scene, and how it grows with the picture: in processes of their own."""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.bench.cases import Case
from raywalk.scene.read import read_scene

MOST = 430.0  # MiB at 1155 x 1155: the dragon takes 411, glass 314
# Bytes a pixel by which the peak may grow: picture 3, mask of kept pixels 1, and while the PNG is
# made its rows under two filters and copies of them for zlib, 3 each.
A_PIXEL = 16.0
# MiB of a scene of many objects, and bytes an object beyond.
MANY, A_THING = 400.0, 4096.0
TIMES = 3  # the larger picture is so many times as wide: the same rays of the same grids
MIB = 2.0**20

PROGRAM = """
import sys
from pathlib import Path
from raywalk.bench.speed_memory import make, peak_of_this_process
make(Path(sys.argv[1]), int(sys.argv[2]))
print(peak_of_this_process())
"""


def make(path: Path, times: int) -> None:
    """All files of a scene with a picture so many times as wide, into a folder that goes."""
    from raywalk.pipeline.trace_products import write_products

    scene = read_scene(path)
    wide = replace(scene.render, size=times * scene.render.size)
    with tempfile.TemporaryDirectory() as folder:
        write_products(replace(scene, render=wide), Path(folder), 1)


def peak_of_this_process() -> int:
    """Bytes; on Linux without what the process that started it held, which getrusage counts too."""
    status = Path("/proc/self/status")
    if status.exists():
        found = re.search(r"^VmHWM:\s*(\d+) kB", status.read_text(), re.MULTILINE)
        if found:
            return int(found[1]) * 1024
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def peak(path: Path, times: int) -> float:
    """Bytes that a process needed at most to make a scene."""
    command = [sys.executable, "-c", PROGRAM, str(path), str(times)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return float(done.stdout)


def memory(path: Path) -> dict[str, Any]:
    """Peaks of one scene at its own size and at TIMES of it."""
    scene = read_scene(path)
    own, wide = peak(path, 1), peak(path, TIMES)
    pixels = scene.render.size**2 * (TIMES**2 - 1)
    return {
        "scene": scene.id, "size": scene.render.size, "peak": own / MIB,
        "wide": wide / MIB, "a_pixel": (wide - own) / pixels,
    }  # fmt: skip


def many_objects(count: int) -> dict[str, Any]:
    """The peak of a scene of so many small spheres."""
    rng = np.random.default_rng(20261129)
    radius = 0.6 / count ** (1 / 3)
    balls = "".join(
        f'[[objects]]\ntype = "sphere"\ncenter = {place}\nradius = {radius}\nmaterial = "white"\n'
        for place in rng.uniform(-1.0, 1.0, (count, 3)).tolist()
    )
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        path.write_text(
            'version = 1\ntitle = "many"\nteaches = "many"\n[camera]\neye = [0, 0, 5]\n'
            f"target = [0, 0, 0]\n[[lights]]\nposition = [5, 5, 5]\n{balls}",
            encoding="utf-8",
        )
        own = peak(path, 1)
    return {"scene": f"{count:,} spheres", "size": 1155, "peak": own / MIB, "objects": count}


def memory_cases(rows: list[dict[str, Any]], seed: int) -> Iterator[Case]:
    """No more than MOST, and beyond that the picture alone grows."""
    for row in rows:
        if "objects" in row:
            most = MANY + A_THING * row["objects"] / MIB
            yield Case("memory", row["scene"], "peak, MiB", most, row["peak"], 0, seed)
            continue
        yield Case("memory", row["scene"], "peak, MiB", MOST, row["peak"], 0, seed)
        yield Case(
            "memory", row["scene"], f"bytes a pixel more at {TIMES} x {row['size']}",
            A_PIXEL, row["a_pixel"], 0, seed,
        )  # fmt: skip
