"""Kernels that several processes want at once: compiled by one of them, and never mixed up."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

# Compiles what the words on its command line say, as soon as a line asks it to on its input;
# prints how many of these kernels it compiled itself, and what they gave.
WANTS = """
import json, sys
import numpy as np
from numba.core import event
from raywalk.optics.compiled import kernel

@kernel
def inner(values):
    return values.sum() + 1

@kernel
def outer(values):
    return 2 * inner(values)

compiled = []

class Listener(event.Listener):
    def on_start(self, what):
        if what.data["dispatcher"] in (inner, outer):
            compiled.append(str(what.data["args"]))

    def on_end(self, what):
        pass

event.register("numba:compile", Listener())
print("ready", flush=True)
sys.stdin.readline()
given = [float(outer(np.ones(3, kind))) for kind in sys.argv[1:]]
print(json.dumps([len(compiled), given]))
"""


def together(folder: Path, *wanted: list[str]) -> list[list]:
    """What processes with one cache report that each compile for these types, at the same time."""
    script = folder / "wants.py"
    script.write_text(WANTS, encoding="utf-8")
    settings = {**os.environ, "NUMBA_CACHE_DIR": str(folder / "cache")}
    running = [
        subprocess.Popen(
            [sys.executable, str(script), *types], env=settings, text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        )
        for types in wanted
    ]  # fmt: skip
    for each in running:
        assert each.stdout
        assert each.stdout.readline() == "ready\n"
    counts = []
    for each in running:
        assert each.stdin
        each.stdin.write("\n")
        each.stdin.flush()
    for each in running:
        counts.append(json.loads(each.communicate()[0]))
        assert each.returncode == 0
    return counts


def test_processes_share_what_one_of_them_compiles(tmp_path):
    """Two that want the same kernel at the same moment compile it once, and both can run it."""
    counts = together(tmp_path, ["float64"], ["float64"])
    assert sum(count for count, _ in counts) == 2  # outer and inner, each by one of the two
    assert [given for _, given in counts] == [[8.0], [8.0]]


def test_no_signature_gets_the_code_of_another(tmp_path):
    """Numba numbers the code of a function's signatures: two processes that save at once would take
    the same number, and the next one would run int64's code on float64's bits."""
    together(tmp_path, ["float64"], ["int64"], ["float32"])
    [[compiled, given]] = together(tmp_path, ["int64", "float32", "float64"])
    assert compiled == 0, "all three were kept"
    assert given == [8.0, 8.0, 8.0]


def test_a_kernel_whose_cache_cannot_be_written_is_compiled_all_the_same(tmp_path):
    """A read-only installation: nothing to keep apart, nothing kept."""
    (tmp_path / "cache").write_text("a file where the folder should be", encoding="utf-8")
    script = "import raywalk.optics.compiling as c\nwith c._turn('kernel'): print('done')"
    settings = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path / "cache")}
    done = subprocess.run(
        [sys.executable, "-c", script], env=settings, check=True, capture_output=True, text=True
    )
    assert done.stdout == "done\n"


def test_where_nothing_is_to_be_compiled_a_kernel_is_the_function_itself():
    """`make mutants` judges most mutants so: a changed kernel need not be compiled to fail."""
    script = "from raywalk.optics.compiled import kernel, lean\n"
    script += "print(type(kernel(lambda x: 2 * x)).__name__, lean(lambda x: 2 * x)(4))"
    settings = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    done = subprocess.run(
        [sys.executable, "-c", script], env=settings, check=True, capture_output=True, text=True
    )
    assert done.stdout == "function 8\n"
