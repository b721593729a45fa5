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
# Of what the page itself makes; the engine's compiled code is counted apart, it levels off.
OBJECTS_KB = 100.0
STRINGS_KB = 300.0  # the text that was unpacked last is still held, or not
HEAP_MEGABYTES = 4.0  # with compiled code
RISING_MEGABYTES = 0.5  # the last quarter's average above the one before: code levels off
COUNTED = {
    "nodes": ("nodes of the document", 10.0),
    "listeners": ("listeners", 0.0),
    "Buffer": ("buffers on the graphics card", 80.0),  # by which stops of 4 scenes were drawn
    "Texture": ("textures on the graphics card", 0.0),
    "Program": ("programs on the graphics card", 0.0),
}


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
    """What the page holds after the second round of all lessons and after the last one.

    Unattended, a kiosk loads its page anew after six hours: at its own pace at most 310 lessons.
    """
    lessons = max(LEAST, count // RAYS_A_LESSON)
    minutes = max(3.0, count / RAYS_A_MINUTE)
    settings = {"RAYWALK_SOAK_CYCLES": str(lessons), "RAYWALK_SOAK_MINUTES": f"{minutes:.1f}"}
    failed, said = run_in_browser("slow/soak", settings)
    found = re.search(r"soak (\{.*\})", said)
    report: dict[str, Any] = json.loads(found[1]) if found else {}
    shown = int(report.get("cycles", 0))
    name = f"a kiosk untouched, {shown:,} lessons in {report.get('seconds', 0) / 60:.0f} minutes"
    heaps = report.get("heaps") or [math.nan]
    gone = (0, math.nan)

    def case(
        metric: str, bound: float, pair: tuple[float, float], unit: float, note: str = ""
    ) -> Case:
        return Case(
            "the page", name, metric, bound, (pair[1] - pair[0]) / unit, shown, seed, note=note
        )

    yield case("JS objects grown, kB", OBJECTS_KB, report.get("objects", gone), 1e3)
    yield case("JS strings grown, kB", STRINGS_KB, report.get("strings", gone), 1e3)
    series = "MB: " + " ".join(f"{heap / 1e6:.1f}" for heap in tenths(heaps))
    yield case(
        "JS heap with compiled code grown, MB", HEAP_MEGABYTES, (heaps[0], heaps[-1]), 1e6, series
    )
    rising = (0, report.get("rising", math.nan))
    yield case("JS heap, last quarter above the one before, MB", RISING_MEGABYTES, rising, 1e6)
    for what, (words, bound) in COUNTED.items():
        yield case(f"more {words}", bound, report.get("counts", {}).get(what, gone), 1)
    yield case("errors", 0.0, (0, report.get("faults", math.nan) + bool(failed and not report)), 1)


def tenths(series: list[float]) -> list[float]:
    """Ten of them, the first and the last among these, evenly spaced."""
    last = len(series) - 1
    return [series[round(k * last / 9)] for k in range(10)] if last > 9 else series


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
