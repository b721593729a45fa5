"""Log-log plots of what the bench measured; templates/plot.svg draws them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from jinja2 import Environment

WIDTH, HEIGHT = 720, 440
LEFT, TOP, BOTTOM = 84, 46, 62
RIGHT = 20  # of the plot; with a legend beside it:
LEGEND = 290
# Shape alone tells them apart; the greys only help.
MARKERS = (
    "circle", "square", "triangle", "diamond", "cross", "plus", "star", "ring", "wedge", "bow",
)  # fmt: skip


@dataclass(frozen=True)
class Point:
    x: float
    y: float
    label: str
    marker: str = "circle"
    front: bool = True  # on the Pareto front: nothing is better in both


@dataclass(frozen=True)
class Plot:
    """says: for those who do not see it; head, rows: the same as a table."""

    name: str  # of the file, without .svg
    title: str
    x_title: str
    y_title: str
    points: list[Point]
    says: str
    is_line: bool = False  # through the points, with their names beside them; else with a legend
    head: list[str] = field(default_factory=list)
    rows: list[list[str]] = field(default_factory=list)

    def svg(self, environment: Environment) -> str:
        """Of methods the front is a stepped line."""
        points, right = self.points, RIGHT if self.is_line else LEGEND
        front = sorted((p for p in points if p.front), key=lambda p: p.x)
        return environment.get_template("plot.svg").render(
            title=self.title, width=WIDTH, height=HEIGHT, points=points, is_line=self.is_line,
            chain=points if self.is_line else front,
            exponent=lambda value: round(math.log10(value)),
            x=scale_of(self.x_title, [p.x for p in points], LEFT, WIDTH - right),
            y=scale_of(self.y_title, [p.y for p in points], HEIGHT - BOTTOM, TOP),
        )  # fmt: skip


@dataclass(frozen=True)
class Scale:
    """Logarithmic, from value to pixel."""

    title: str
    low: float
    high: float
    start: int
    end: int

    def at(self, value: float) -> float:
        share = (math.log10(value) - self.low) / (self.high - self.low)
        return self.start + share * (self.end - self.start)

    def ticks(self) -> list[float]:
        """Powers of ten, thinned out to nine; with 2 and 5 between where there are few."""
        step = max(1, math.ceil((self.high - self.low) / 9))
        factors = (1.0, 2.0, 5.0) if self.high - self.low < 2.0 else (1.0,)
        values = [
            factor * 10.0**k
            for k in range(math.floor(self.low), math.floor(self.high) + 1)
            for factor in factors
            if k % step == 0
        ]
        return [value for value in values if self.low <= math.log10(value) <= self.high]


def scale_of(title: str, values: Sequence[float], start: int, end: int) -> Scale:
    low, high = math.log10(min(values)), math.log10(max(values))
    edge = max(0.08 * (high - low), 0.15)
    return Scale(title, low - edge, high + edge, start, end)


def front_of(times: Sequence[float], errors: Sequence[float]) -> list[bool]:
    """Which points nothing beats in both."""
    pairs = list(zip(times, errors, strict=True))
    return [
        not any((t <= a and e <= b) and (t < a or e < b) for t, e in pairs) for a, b in pairs
    ]  # fmt: skip


def plots_of(bench: dict[str, Any]) -> list[Plot]:
    """All plots of a kept bench report."""
    found = [plot for task in bench["tasks"] for plot in task_plots(task)]
    if "resolution" in bench:
        found.append(resolution_plot(bench["resolution"]))
    return found


def task_plots(task: dict[str, Any]) -> list[Plot]:
    """Time per ray against the median and against the largest error of one task."""
    methods = task["methods"]
    made = []
    for which, words in (("median", "median"), ("largest", "largest")):
        # An error of 0 has no logarithm: it is drawn at a hundredth of a rounding.
        errors = [max(method[which], 1e-18) for method in methods]
        times = [method["nanoseconds"] for method in methods]
        fronts = front_of(times, errors)
        points = [
            Point(t, e, method["name"], MARKERS[k % len(MARKERS)], front)
            for k, (method, t, e, front) in enumerate(
                zip(methods, times, errors, fronts, strict=True)
            )
        ]
        title = f"{task['title']}: {words} error of the distance"
        made.append(Plot(
            f"{task['key']}-{which}", title, "nanoseconds a ray, one thread", "relative error",
            points,
            f"Log-log scatter of time per ray against the {words} relative error of the hit "
            "distance; its numbers are in the table below. Filled markers lie on the front.",
        ))  # fmt: skip
    return made


def resolution_plot(resolution: dict[str, Any]) -> Plot:
    """Picture error against resolution."""
    rows = resolution["rows"]
    return Plot(
        "resolution", "Picture error against resolution", "pixels a side",
        "mean error, steps of 8 bits",
        [Point(row["size"], row["error"], str(row["size"])) for row in rows],
        "Log-log line of mean picture error against pixels a side.", True,
        ["Pixels a side", "Mean error, steps of 8 bits", "Pixels off by more than half a step"],
        [[str(row["size"]), f"{row['error']:.3f}", f"{100 * row['off']:.1f} %"] for row in rows],
    )  # fmt: skip
