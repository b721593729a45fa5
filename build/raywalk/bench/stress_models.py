"""Damaged model files: no traceback, no hang, no memory that the file does not explain."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator

from raywalk.bench.cases import Case
from raywalk.bench.model_fuzz import PATIENCE

FILES = 10_000  # at a million rays a case
MEMORY = 200.0  # megabytes beyond four times the file, which is small here


def cases(count: int, seed: int) -> Iterator[Case]:
    """A hundredth of the rays in files."""
    files = max(11, count * FILES // 1_000_000)
    command = [sys.executable, "-m", "raywalk.bench.model_fuzz", str(files), str(seed)]
    figures = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    name = f"{figures['files']:,} damaged, {figures['read']:,} read, {figures['refused']:,} refused"
    first = {key: (figures[key] or [""])[0] for key in ("tracebacks", "hangs", "unclear")}
    for metric, key in (
        ("tracebacks", "tracebacks"), (f"hangs over {PATIENCE} s", "hangs"),
        ("refusals that do not name the file", "unclear"),
    ):  # fmt: skip
        yield Case(
            "model files", name, metric, 0.0, float(len(figures[key])), files, seed, note=first[key]
        )
    yield Case("model files", name, "memory, MB", MEMORY, figures["megabytes"], files, seed)
