"""Damaged model files are read or refused in a sentence: some hundred here, 10,000 in stress."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest


@pytest.mark.parametrize("seed", [20261129])
def test_no_damage_makes_a_traceback_a_hang_or_a_heap(seed: int) -> None:
    """660 files of eleven kinds: each within 5 s, together within 200 MB more than good ones."""
    command = [sys.executable, "-m", "raywalk.bench.model_fuzz", "660", str(seed)]
    figures = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    assert figures["files"] == figures["read"] + figures["refused"] == 660
    assert (figures["tracebacks"], figures["hangs"], figures["unclear"]) == ([], [], [])
    assert figures["read"] > 66  # most of it would tell nothing of what is read
    assert figures["megabytes"] < 200
