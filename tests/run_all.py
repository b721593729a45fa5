"""Runs every check and test, as many steps at a time as there are cores; the last line counts them.

Python's tests are one step, each file of the viewer's is one: cores that are done take the next.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

PYTHON = sys.executable
SOURCES = ["build/raywalk", "tests"]
VIEWER = Path("tests/viewer")
#: Half an hour for a file: what takes longer hangs, on a busy machine too.
NODE = ["node", "--test", "--test-reporter=tap", "--test-timeout=1800000"]
#: Lines that name what failed: TAP's, of a test and not of its file; pytest's; a check's.
NAMED = (r"not ok \d+ - (?!.*\.test\.mjs$)", "FAILED ", "ERROR ", r".*: error: ")
FAILURE = re.compile(rf"^ *((?:{'|'.join(NAMED)}).*)$", re.MULTILINE)
PYTEST_COUNTS = (r"(\d+) passed", r"(\d+) (?:failed|errors?)\b")
NODE_COUNTS = (r"^# pass (\d+)", r"^# fail (\d+)")


@dataclass(frozen=True)
class Step:
    """A command; `counts` are the patterns of its closing counts (passed, failed), if any."""

    name: str
    command: list[str]
    counts: tuple[str, str] | None = None


def steps() -> list[Step]:
    """All there is, what takes longest first."""
    files = sorted(VIEWER.rglob("*.test.mjs"))
    return [
        Step("python", [PYTHON, "-m", "pytest"], PYTEST_COUNTS),
        Step("types", [PYTHON, "-m", "mypy"]),
        *(Step(path.name.partition(".")[0], [*NODE, str(path)], NODE_COUNTS) for path in files),
        Step("viewer's types", ["npm", "run", "--silent", "typecheck"]),
        Step("style", [PYTHON, "-m", "ruff", "check", *SOURCES]),
        Step("format", [PYTHON, "-m", "ruff", "format", "--check", *SOURCES]),
    ]


@dataclass(frozen=True)
class Result:
    """What one step came to."""

    name: str
    seconds: float
    broken: bool
    passed: int = 0
    failed: int = 0
    #: What each failed test or check said first.
    failures: tuple[str, ...] = ()


def main() -> int:
    """Every step runs, even after a failure: one run tells all that is wrong."""
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        results = list(threads.map(run, steps()))
    print()
    for result in sorted(results, key=lambda result: (result.broken, result.seconds)):
        print(f"{'FAILED' if result.broken else 'ok':6} {result.name}, {result.seconds:.0f} s")
    for result in results:
        for failure in result.failures:
            print(f"{result.name}: {failure}")
    passed = sum(result.passed for result in results)
    failed = sum(result.failed for result in results)
    print(f"\n{passed} passed, {failed} failed", flush=True)
    return 1 if failed or not passed or any(result.broken for result in results) else 0


def run(step: Step) -> Result:
    """Runs a command and shows what it prints as it comes, behind its name.

    A step that should count tests and counts none is broken.
    """
    print(f"== {step.name}", flush=True)
    started = time.monotonic()
    lines = []
    with subprocess.Popen(
        step.command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
    ) as process:
        assert process.stdout
        for line in process.stdout:
            # One write a line: several steps write to one terminal.
            sys.stdout.write(f"{step.name}: {line}")
            sys.stdout.flush()
            lines.append(line)
    output = "".join(lines)
    passed, failed = (count(pattern, output) for pattern in step.counts) if step.counts else (0, 0)
    broken = process.returncode != 0 or (step.counts is not None and not passed)
    failures = tuple(FAILURE.findall(output)) if broken else ()
    return Result(step.name, time.monotonic() - started, broken, passed, failed, failures)


def count(pattern: str, output: str) -> int:
    """The last number a runner printed for this, 0 if it printed none."""
    found = re.findall(pattern, output, re.MULTILINE)
    return int(found[-1]) if found else 0


if __name__ == "__main__":
    sys.exit(main())
