"""Runs every check and test, and ends on one line that counts the tests."""

from __future__ import annotations

import re
import subprocess
import sys
import time

PYTHON = sys.executable
SOURCES = ["build/raywalk", "tests"]
# name, command, patterns of its closing counts (passed, failed), if it counts tests
STEPS: list[tuple[str, list[str], tuple[str, str] | None]] = [
    ("style", [PYTHON, "-m", "ruff", "check", *SOURCES], None),
    ("format", [PYTHON, "-m", "ruff", "format", "--check", *SOURCES], None),
    ("types, Python", [PYTHON, "-m", "mypy"], None),
    ("types, viewer", ["npm", "run", "--silent", "typecheck"], None),
    ("tests, Python", [PYTHON, "-m", "pytest"], (r"(\d+) passed", r"(\d+) (?:failed|errors?)\b")),
    ("tests, viewer", ["npm", "test", "--silent"], (r"^# pass (\d+)", r"^# fail (\d+)")),
]


def main() -> int:
    """Every step runs, even after a failure: one run tells all that is wrong."""
    passed = failed = 0
    broken = []
    for name, command, counts in STEPS:
        print(f"\n== {name}", flush=True)
        started = time.monotonic()
        code, output = run(command)
        if counts:
            passed += count(counts[0], output)
            failed += count(counts[1], output)
        if code:
            broken.append(name)
        print(f"== {name}: {'FAILED' if code else 'ok'}, {time.monotonic() - started:.0f} s")
    if broken:
        print("\nnot in order: " + ", ".join(broken))
    print(f"\n{passed} passed, {failed} failed", flush=True)
    return 1 if broken or failed or not passed else 0


def run(command: list[str]) -> tuple[int, str]:
    """Exit code and output, which is shown as it comes."""
    lines = []
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
    ) as process:
        assert process.stdout
        for line in process.stdout:
            sys.stdout.write(line)
            sys.stdout.flush()
            lines.append(line)
    return process.returncode, "".join(lines)


def count(pattern: str, output: str) -> int:
    """The last number a runner printed for this, 0 if it printed none."""
    found = re.findall(pattern, output, re.MULTILINE)
    return int(found[-1]) if found else 0


if __name__ == "__main__":
    sys.exit(main())
