"""Runs every check and test, and ends on one line that counts the tests.

Python's and the viewer's run side by side: one waits for a core, the other mostly for a browser.
"""

from __future__ import annotations

import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

PYTHON = sys.executable
SOURCES = ["build/raywalk", "tests"]


@dataclass(frozen=True)
class Step:
    """A command; `counts` are the patterns of its closing counts (passed, failed), if any."""

    name: str
    command: list[str]
    counts: tuple[str, str] | None = None


LANES = {
    "python": [
        Step("style", [PYTHON, "-m", "ruff", "check", *SOURCES]),
        Step("format", [PYTHON, "-m", "ruff", "format", "--check", *SOURCES]),
        Step("types", [PYTHON, "-m", "mypy"]),
        Step("tests", [PYTHON, "-m", "pytest"], (r"(\d+) passed", r"(\d+) (?:failed|errors?)\b")),
    ],
    "viewer": [
        Step("types", ["npm", "run", "--silent", "typecheck"]),
        Step("tests", ["npm", "test", "--silent"], (r"^# pass (\d+)", r"^# fail (\d+)")),
    ],
}


@dataclass(frozen=True)
class Result:
    """What one step came to."""

    name: str
    seconds: float
    broken: bool
    passed: int = 0
    failed: int = 0


def main() -> int:
    """Every step runs, even after a failure: one run tells all that is wrong."""
    with ThreadPoolExecutor(len(LANES)) as threads:
        lanes = threads.map(run_lane, LANES, LANES.values())
        results = [result for lane in lanes for result in lane]
    print()
    for result in results:
        print(f"{'FAILED' if result.broken else 'ok':6} {result.name}, {result.seconds:.0f} s")
    passed = sum(result.passed for result in results)
    failed = sum(result.failed for result in results)
    print(f"\n{passed} passed, {failed} failed", flush=True)
    return 1 if failed or not passed or any(result.broken for result in results) else 0


def run_lane(lane: str, steps: list[Step]) -> list[Result]:
    """One step after the other; a step that should count tests and counts none is broken."""
    return [run(lane, step) for step in steps]


def run(lane: str, step: Step) -> Result:
    """Runs a command and shows what it prints as it comes, behind its lane's name."""
    name = f"{step.name}, {lane}"
    print(f"== {name}", flush=True)
    started = time.monotonic()
    lines = []
    with subprocess.Popen(
        step.command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
    ) as process:
        assert process.stdout
        for line in process.stdout:
            # One write a line: two lanes write to one terminal.
            sys.stdout.write(f"{lane}: {line}")
            sys.stdout.flush()
            lines.append(line)
    output = "".join(lines)
    passed, failed = (count(pattern, output) for pattern in step.counts) if step.counts else (0, 0)
    broken = process.returncode != 0 or (step.counts is not None and not passed)
    return Result(name, time.monotonic() - started, broken, passed, failed)


def count(pattern: str, output: str) -> int:
    """The last number a runner printed for this, 0 if it printed none."""
    found = re.findall(pattern, output, re.MULTILINE)
    return int(found[-1]) if found else 0


if __name__ == "__main__":
    sys.exit(main())
