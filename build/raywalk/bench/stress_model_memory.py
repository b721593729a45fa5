"""Large models: reading one takes no more memory than four times its file and 200 MB."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator

from raywalk.bench.cases import Case
from raywalk.bench.model_memory import BYTES

MEGABYTES = 20.0  # of a file, at a million rays a case
TIMES, MORE = 4.0, 200.0  # the file's size, and megabytes beyond


def cases(count: int, seed: int) -> Iterator[Case]:
    """A file of each format, read, cleaned and reported in a process of its own."""
    for name in BYTES:
        asked = max(1.0, MEGABYTES * count / 1_000_000)
        command = [sys.executable, "-m", "raywalk.bench.model_memory", name, str(asked)]
        figures = json.loads(
            subprocess.run(command, check=True, capture_output=True, text=True).stdout
        )
        size = figures["bytes"] / 1e6
        yield Case(
            "large models", f"{name}, {size:.0f} MB, {figures['triangles']:,} triangles",
            "memory, MB", TIMES * size + MORE, figures["grown"] / 1e6, figures["triangles"], seed,
        )  # fmt: skip
