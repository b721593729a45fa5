"""What `make test` tells at its end: each failure's cause, and what failed beside others only."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from tests.causes import ENOUGH, causes
from tests.run_all import NODE, NODE_COUNTS, PYTEST_COUNTS, Step, main, run

TESTS_OF_VIEWER = """
import assert from "node:assert/strict";
import { existsSync, writeFileSync } from "node:fs";
import { describe, test } from "node:test";
test("holds", () => {});
describe("in a group", () => {
  test("waits for a sheet", () => {
    if (existsSync("been here")) return;
    if (process.env.UNSTEADY) writeFileSync("been here", "");
    throw new Error("locator.waitFor: Timeout 180000ms exceeded.\\nCall log:\\n  - dialog[open]");
  });
});
"""
TESTS_OF_PYTHON = """
from pathlib import Path

import os
import pytest

class TestSum:
    @pytest.mark.parametrize("n", [1, 2])
    def test_is_two(self, n):
        been = Path(f"been {n}").exists()
        if "UNSTEADY" in os.environ:
            Path(f"been {n}").touch()
        assert been or n + 1 == 2, "the sum is wrong"

def test_holds():
    assert not Path("been there").exists(), "tried once only"
    Path("been there").touch()
"""
VIEWERS = "waits for a sheet: locator.waitFor: Timeout 180000ms exceeded. Call log: - dialog[open]"
PYTHONS = "test_sum.py::TestSum::test_is_two[2]: AssertionError: the sum is wrong"


@pytest.fixture
def steps(tmp_path, monkeypatch):
    """A step of each runner, in a folder of their own."""
    monkeypatch.chdir(tmp_path)
    Path("sheet.test.mjs").write_text(TESTS_OF_VIEWER)
    Path("test_sum.py").write_text(TESTS_OF_PYTHON)
    pytest_here = [sys.executable, "-m", "pytest", "-q", "--rootdir=."]
    return [
        Step("python", pytest_here, PYTEST_COUNTS, again=("--last-failed",)),
        Step("sheet", [*NODE, "sheet.test.mjs"], NODE_COUNTS),
    ]


def closing(capsys) -> list[str]:
    """What is told once all steps have run."""
    return capsys.readouterr().out.rpartition("s of work in all\n")[2].splitlines()


def test_what_fails_twice_is_a_failure_told_with_its_cause(steps, capsys):
    """The end of a log tells why: the group around a test and its file add nothing."""
    assert main(steps, once=False) == 1
    python, sheet, _, last = closing(capsys)
    assert python.startswith(f"python: FAILED: {PYTHONS}")
    assert sheet == f"sheet: FAILED: {VIEWERS} (sheet.test.mjs:10)"
    assert last == "3 passed, 2 failed"


def test_what_passes_alone_counts_as_passed_and_is_named(steps, capsys, monkeypatch):
    """Python's runner tries what failed and nothing else."""
    monkeypatch.setenv("UNSTEADY", "1")
    assert main(steps, once=False) == 0
    python, sheet, _, last = closing(capsys)
    assert python.startswith(f"python: failed beside others, passed alone: {PYTHONS}")
    assert sheet.startswith(f"sheet: failed beside others, passed alone: {VIEWERS}")
    assert last == "5 passed, 0 failed, 2 unsteady"


def test_where_unsteadiness_is_looked_for_nothing_is_tried_again(steps, capsys, monkeypatch):
    """As `make test-busy` runs them."""
    monkeypatch.setenv("UNSTEADY", "1")
    assert main(steps, once=True) == 1
    assert closing(capsys)[-1] == "3 passed, 2 failed"


def test_checks_and_a_run_in_which_most_fails_are_not_tried_again(tmp_path, capsys):
    """What fails by chance is little."""
    count = tmp_path / "count"
    fails = [
        sys.executable,
        "-c",
        f"open({str(count)!r}, 'a').write('x'); print('1 failed'); 1 / 0",
    ]
    check, test = Step("check", fails), Step("test", fails, PYTEST_COUNTS)
    assert main([check], once=False) == 1 and count.read_text() == "x"
    assert main([test], once=False) == 1 and count.read_text() == "xxx"
    assert main([test] * 5, once=False) == 1 and count.read_text() == 8 * "x"
    assert closing(capsys)[-3] == "test: FAILED: ZeroDivisionError: division by zero"


@pytest.mark.skipif(sys.platform != "linux", reason="processes are left to the first one there")
def test_what_is_left_behind_counts_as_work_too():
    """As a browser's processes are: ended, and waited for by nobody."""
    busy = "import time; end = time.process_time() + 0.5\nwhile time.process_time() < end: pass"
    leaves = f"import subprocess; subprocess.Popen([{sys.executable!r}, '-c', {busy!r}])"
    assert run(Step("leaves", [sys.executable, "-c", leaves])).worked > 0.5


def test_a_cause_is_found_where_no_test_is_named(tmp_path):
    """A file that cannot be read, a check's lines, a runner of another kind; a long one is cut."""
    (tmp_path / "a.test.mjs").write_text('import "./not-there.mjs";')
    done = subprocess.run(
        [*NODE, "a.test.mjs"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    [cause] = causes(done.stdout)
    assert "Cannot find module" in cause and "not-there.mjs" in cause
    assert causes("a.py:1: error: no\nb.ts(1,2): error TS1: nor\nfine\n") == (
        "a.py:1: error: no",
        "b.ts(1,2): error TS1: nor",
    )
    assert causes("it ended\n\n") == ("it ended",)
    assert causes("") == ()
    assert len(causes("x" * 1000)[0]) < ENOUGH + 5
