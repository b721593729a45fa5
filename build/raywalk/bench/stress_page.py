"""The built site in a real browser: a monkey's random inputs, and a kiosk nobody touches."""

from __future__ import annotations

import json
import math
import os
import re
import shutil
import subprocess
from collections.abc import Iterator
from typing import Any

from raywalk.bench.cases import Case

# Of the rays that a case asks for: with a million, 20,000 inputs and 2,000 lessons or half an hour.
RAYS_AN_INPUT = 50
RAYS_A_LESSON = 500
RAYS_A_MINUTE = 33_334
LEAST = 100
HEAP_MEGABYTES = 1.5  # what the engine compiles and the page keeps of its last scenes
GPU_PERCENT = 5.0  # the lines of a lesson's stop more or less
DOM_PERCENT = 10.0


def monkey_cases(count: int, seed: int) -> Iterator[Case]:
    """Random keys, taps, drags, resizes and links: no error, no senseless state, and a way back."""
    inputs = max(LEAST, count // RAYS_AN_INPUT)
    settings = {"RAYWALK_MONKEY_INPUTS": str(inputs), "RAYWALK_SEED": str(seed)}
    failed, said = run_in_browser("monkey", settings)
    yield Case(
        "the page", f"{inputs:,} random inputs", "parts with an error or a senseless state",
        0.0, failed, inputs, seed, note=first_error(said) if failed else "",
    )  # fmt: skip


def soak_cases(count: int, seed: int) -> Iterator[Case]:
    """What the page holds after the second round of all lessons and after the last one."""
    lessons = max(LEAST, count // RAYS_A_LESSON)
    minutes = max(3.0, count / RAYS_A_MINUTE)
    settings = {"RAYWALK_SOAK_CYCLES": str(lessons), "RAYWALK_SOAK_MINUTES": f"{minutes:.1f}"}
    failed, said = run_in_browser("soak", settings)
    found = re.search(r"soak (\{.*\})", said)
    told: dict[str, Any] = json.loads(found[1]) if found else {}
    shown = int(told.get("cycles", 0))
    name = f"a kiosk untouched, {shown:,} lessons in {told.get('seconds', 0) / 60:.0f} minutes"
    heap, gpu = told.get("heap", (math.nan, math.nan)), told.get("gpu", ({}, {}))

    def case(metric: str, bound: float, measured: float) -> Case:
        return Case("the page", name, metric, bound, measured, shown, seed)

    yield case("JS heap grown, MB", HEAP_MEGABYTES, (heap[1] - heap[0]) / 1e6)
    for kind in ("Buffer", "Texture", "Program"):
        grown = percent_grown(gpu[0].get(kind, 0), gpu[1].get(kind, math.nan))
        yield case(f"{kind.lower()}s on the graphics card grown, %", GPU_PERCENT, grown)
    for what in ("nodes", "listeners"):
        grown = percent_grown(*told.get(what, (0, math.nan)))
        yield case(f"{what} of the document grown, %", DOM_PERCENT, grown)
    yield case("errors", 0.0, float(told.get("faults", math.nan)) + (failed and not told))


def percent_grown(before: float, after: float) -> float:
    return 100 * (after - before) / before if before else math.nan


def run_in_browser(name: str, settings: dict[str, str]) -> tuple[float, str]:
    """Failed tests of that file, and all it said. NaN, which breaks bounds, if it could not run."""
    node = shutil.which("node")
    if node is None:
        return math.nan, "error: no node here"
    command = [node, "--test", "--test-reporter=tap", f"tests/viewer/{name}.test.mjs"]
    done = subprocess.run(
        command, env=os.environ | settings, capture_output=True, text=True, check=False
    )
    counted = re.search(r"^# fail (\d+)", done.stdout, re.MULTILINE)
    return float(counted[1]) if counted else math.nan, done.stdout + done.stderr


def first_error(said: str) -> str:
    """The first failed test's message, on one line."""
    found = re.search(r"error: (?:\|-)?\s*(.+?)\n\s+code:", said, re.DOTALL)
    return " ".join((found[1] if found else said[-300:]).split())[:300]
