"""Runs every check and test, one step more at once than there are cores; the last line counts them.

Each file of the viewer's tests is a step, and steps often wait: for a browser, a server, a clock.
What fails beside others is tried once more by itself, and told as unsteady if it passes then; with
--once it is not. Each law is asked of few cases, with --every of all of them (`make stress`).
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from tests.causes import causes
from tests.lean_sites import build_lean_sites

PYTHON = sys.executable
SOURCES = ["build/raywalk", "tests"]
VIEWER = Path("tests/viewer")
#: What --every asks more: tests/viewer/cases.mjs reads it, and these files are there for it alone.
EVERY_CASE = "RAYWALK_EVERY_CASE"
SLOW_OF_VIEWER = VIEWER / "slow"
#: A path, for steps of tests run in folders of their own.
REAPING = Path(__file__).with_name("reaping.py")
#: A quarter of an hour for a file is ten times what the longest takes: what needs more hangs, on a
#: busy machine too.
NODE = ["node", "--test", "--test-reporter=tap", "--test-timeout=900000"]
PYTEST_COUNTS = (r"(\d+) passed", r"(\d+) (?:failed|errors?)\b")
NODE_COUNTS = (r"^# pass (\d+)", r"^# fail (\d+)")
#: Steps that may fail by chance in one run. More have a cause: to try all would take as long again.
BY_CHANCE = 4


@dataclass(frozen=True)
class Step:
    """A command; `counts` are the patterns of its closing counts (passed, failed), if any."""

    name: str
    command: list[str]
    counts: tuple[str, str] | None = None
    #: More words of the command when it is tried once more: only what failed, where it knows.
    again: tuple[str, ...] = ()


#: Python's tests are two steps of about as much work: one would end last, with a core idle beside.
WHAT_IS_BUILT = [f"tests/{room}" for room in ("commands", "site", "slides", "work")]


def steps(every: bool = False) -> list[Step]:
    """All there is, what takes longest first."""
    slow = set(SLOW_OF_VIEWER.glob("*"))
    files = sorted(path for path in VIEWER.rglob("*.test.mjs") if every or path not in slow)
    return [
        python("python: what is built", WHAT_IS_BUILT, every),
        python("python: all else", [f"--ignore={room}" for room in WHAT_IS_BUILT], every),
        Step("types", [PYTHON, "-m", "mypy"]),
        *(Step(path.name.partition(".")[0], [*NODE, str(path)], NODE_COUNTS) for path in files),
        Step("viewer's types", ["npm", "run", "--silent", "typecheck"]),
        Step("style", [PYTHON, "-m", "ruff", "check", *SOURCES]),
        Step("format", [PYTHON, "-m", "ruff", "format", "--check", *SOURCES]),
    ]


def python(name: str, which: list[str], every: bool) -> Step:
    """Tests of Python, which remember by themselves what failed."""
    cases = ["-m", ""] if every else []
    kept = ["-o", f"cache_dir=.pytest_cache/{name.rpartition(' ')[2]}"]
    command = [PYTHON, "-m", "pytest", *kept, *cases, *which]
    return Step(name, command, PYTEST_COUNTS, again=("--last-failed",))


@dataclass(frozen=True)
class Result:
    """What one step came to."""

    step: Step
    seconds: float
    #: Its processor time and that of all it started, s: what it costs beside others.
    worked: float
    broken: bool
    passed: int = 0
    failed: int = 0
    #: Each failure's name and what it said first.
    causes: tuple[str, ...] = ()
    #: What failed the first time and passed alone.
    unsteady: tuple[str, ...] = ()

    @property
    def word(self) -> str:
        return "FAILED" if self.broken else "unsteady" if self.unsteady else "ok"


def main(steps: Sequence[Step], once: bool) -> int:
    """Every step runs, even after a failure: one run tells all that is wrong."""
    build_lean_sites()
    with ThreadPoolExecutor(1 + (os.cpu_count() or 1)) as threads:
        results = list(threads.map(run, steps))
    if not once:
        results = try_again(results)
    print()
    for result in sorted(
        results, key=lambda result: (result.word != "ok", result.broken, result.seconds)
    ):
        took = f"{result.seconds:.0f} s, {result.worked:.0f} s of work"
        print(f"{result.word:8} {result.step.name}, {took}")
    print(f"{sum(result.worked for result in results):.0f} s of work in all")
    for result in results:
        for cause in result.unsteady:
            print(f"{result.step.name}: failed beside others, passed alone: {cause}")
    for result in results:
        for cause in result.causes:
            print(f"{result.step.name}: FAILED: {cause}")
    passed = sum(result.passed for result in results)
    failed = sum(result.failed for result in results)
    unsteady = sum(len(result.unsteady) for result in results)
    print(f"\n{passed} passed, {failed} failed" + (f", {unsteady} unsteady" if unsteady else ""))
    return 1 if failed or not passed or any(result.broken for result in results) else 0


def try_again(results: list[Result]) -> list[Result]:
    """With nothing beside them. A check has no chance in it."""
    broken = [result for result in results if result.broken and result.step.counts]
    if len(broken) > BY_CHANCE:
        return results
    return [second(result) if result in broken else result for result in results]


def second(first: Result) -> Result:
    """What a step came to that failed and was tried once more."""
    step = first.step
    print(f"== {step.name} failed beside others and is tried alone", flush=True)
    alone = run(replace(step, command=[*step.command, *step.again]))
    before = first.passed if step.again else 0
    both = replace(
        alone,
        step=step,
        seconds=first.seconds + alone.seconds,
        worked=first.worked + alone.worked,
        passed=before + alone.passed,
    )
    if not alone.broken:
        return replace(both, unsteady=first.causes)
    others = (cause for cause in first.causes if cause not in alone.causes)
    return replace(both, causes=(*alone.causes, *(f"{cause} (the first time)" for cause in others)))


def run(step: Step) -> Result:
    """Runs a command and shows what it prints as it comes, behind its name.

    A step that should count tests and counts none is broken.
    """
    print(f"== {step.name}", flush=True)
    started = time.monotonic()
    lines = []
    command = [PYTHON, str(REAPING), *step.command]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
    ) as process:
        assert process.stdout
        for line in process.stdout:
            # One write a line: several steps write to one terminal.
            sys.stdout.write(f"{step.name}: {line}")
            sys.stdout.flush()
            lines.append(line)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    output = "".join(lines)
    passed, failed = (count(pattern, output) for pattern in step.counts) if step.counts else (0, 0)
    broken = process.returncode != 0 or (step.counts is not None and not passed)
    said = causes(output) if broken else ()
    worked = used.ru_utime + used.ru_stime
    return Result(step, time.monotonic() - started, worked, broken, passed, failed, said)


def count(pattern: str, output: str) -> int:
    """The last number a runner printed for this, 0 if it printed none."""
    found = re.findall(pattern, output, re.MULTILINE)
    return int(found[-1]) if found else 0


if __name__ == "__main__":
    every = "--every" in sys.argv[1:]
    if every:
        os.environ[EVERY_CASE] = "1"
    sys.exit(main(steps(every), once="--once" in sys.argv[1:]))
