"""Plots as SVG by hand: text as text, generic fonts, black on white, markers by shape."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from html import escape
from typing import Any

WIDTH, HEIGHT = 720, 440
LEFT, TOP, BOTTOM = 84, 46, 62
RIGHT = 20  # of the plot; with a legend beside it:
LEGEND = 290
FONT = "font-family='sans-serif'"
# Shape alone tells them apart; the greys only help.
MARKERS = (
    "circle",
    "square",
    "triangle",
    "diamond",
    "cross",
    "plus",
    "star",
    "ring",
    "wedge",
    "bow",
)


@dataclass(frozen=True)
class Point:
    x: float
    y: float
    label: str
    marker: str
    front: bool = False  # on the Pareto front: nothing is better in both


@dataclass(frozen=True)
class Plot:
    name: str  # of the file, without .svg
    title: str
    svg: str
    says: str  # for those who do not see it
    head: list[str] = field(default_factory=list)
    rows: list[list[str]] = field(default_factory=list)


@dataclass(frozen=True)
class Scale:
    """Logarithmic, from value to pixel."""

    low: float
    high: float
    start: float
    end: float

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


def scatter(title: str, x_title: str, y_title: str, points: Sequence[Point]) -> str:
    """Log-log scatter of methods with a legend; the front is a stepped line."""
    x = scale_of([p.x for p in points], LEFT, WIDTH - LEGEND)
    y = scale_of([p.y for p in points], HEIGHT - BOTTOM, TOP)
    parts = [frame(title, x_title, y_title, x, y)]
    chain = sorted((p for p in points if p.front), key=lambda p: p.x)
    parts.append(chain_of([(x.at(p.x), y.at(p.y)) for p in chain], straight=False))
    for k, p in enumerate(points):
        parts.append(marker(p.marker, x.at(p.x), y.at(p.y), p.front))
        row = TOP + 12 + 24 * k
        parts.append(marker(p.marker, WIDTH - LEGEND + 22, row, p.front))
        parts.append(text_at(p.label, WIDTH - LEGEND + 36, row + 4, 11.5))
    row = TOP + 24 * (len(points) + 1)
    parts.append(
        text_at("filled or bold: nothing is better in both", WIDTH - LEGEND + 14, row, 11.5)
    )
    return svg(title, parts)


def line(title: str, x_title: str, y_title: str, points: Sequence[Point]) -> str:
    """Log-log line through points with their names beside them."""
    x = scale_of([p.x for p in points], LEFT, WIDTH - RIGHT)
    y = scale_of([p.y for p in points], HEIGHT - BOTTOM, TOP)
    parts = [frame(title, x_title, y_title, x, y)]
    parts.append(chain_of([(x.at(p.x), y.at(p.y)) for p in points], straight=True))
    for p in points:
        parts.append(marker(p.marker, x.at(p.x), y.at(p.y), True))
        parts.append(text_at(p.label, x.at(p.x) + 9, y.at(p.y) - 9, 11.5))
    return svg(title, parts)


def svg(title: str, parts: Sequence[str]) -> str:
    body = "\n".join(parts)
    return (
        f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {HEIGHT}' "
        f"width='{WIDTH}' height='{HEIGHT}' role='img'>\n<title>{escape(title)}</title>\n"
        f"<rect width='{WIDTH}' height='{HEIGHT}' fill='#fff'/>\n{body}\n</svg>\n"
    )


def scale_of(values: Sequence[float], start: float, end: float) -> Scale:
    low, high = math.log10(min(values)), math.log10(max(values))
    edge = max(0.08 * (high - low), 0.15)
    return Scale(low - edge, high + edge, start, end)


def frame(title: str, x_title: str, y_title: str, x: Scale, y: Scale) -> str:
    """Title, axes, grid lines and tick labels."""
    parts = [
        f"<text x='{LEFT}' y='24' {FONT} font-size='16' font-weight='600'>{escape(title)}</text>",
        f"<text x='{(LEFT + x.end) / 2}' y='{HEIGHT - 14}' {FONT} font-size='13' "
        f"text-anchor='middle'>{escape(x_title)}</text>",
        f"<text transform='translate(18 {(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)' {FONT} "
        f"font-size='13' text-anchor='middle'>{escape(y_title)}</text>",
    ]
    for value in x.ticks():
        at = x.at(value)
        parts.append(rule(at, TOP, at, HEIGHT - BOTTOM))
        parts.append(power_of_ten(value, at, HEIGHT - BOTTOM + 18, "middle"))
    for value in y.ticks():
        at = y.at(value)
        parts.append(rule(LEFT, at, x.end, at))
        parts.append(power_of_ten(value, LEFT - 8, at + 4, "end"))
    parts.append(f"<path d='M{LEFT} {TOP}V{HEIGHT - BOTTOM}H{x.end}' fill='none' stroke='#000'/>")
    return "\n".join(parts)


def rule(x1: float, y1: float, x2: float, y2: float) -> str:
    return f"<path d='M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}' stroke='#ddd'/>"


def power_of_ten(value: float, x: float, y: float, anchor: str) -> str:
    """10 with its exponent raised; small whole numbers as they are."""
    exponent = round(math.log10(value))
    if 1e-3 <= value <= 1e4:
        text = f"{value:g}"
    else:
        text = f"10<tspan dy='-5' font-size='9'>{exponent}</tspan>"
    return (
        f"<text x='{x:.1f}' y='{y:.1f}' {FONT} font-size='12' text-anchor='{anchor}'>{text}</text>"
    )


def chain_of(chain: list[tuple[float, float]], straight: bool) -> str:
    """The line through the points; the front in steps, as nothing lies between two of them."""
    if len(chain) < 2:
        return ""
    path = f"M{chain[0][0]:.1f} {chain[0][1]:.1f}"
    for cx, cy in chain[1:]:
        path += f"L{cx:.1f} {cy:.1f}" if straight else f"H{cx:.1f}V{cy:.1f}"
    dash = "" if straight else " stroke-dasharray='5 4'"
    return f"<path d='{path}' fill='none' stroke='#666'{dash}/>"


def marker(shape: str, x: float, y: float, filled: bool) -> str:
    """One marker; filled on the front."""
    fill = "#000" if filled else "#fff"
    width = 3.0 if filled and shape in ("cross", "plus", "star") else 1.5  # they have no inside
    paint = f"fill='{fill}' stroke='#000' stroke-width='{width}'"
    match shape:
        case "circle":
            return f"<circle cx='{x:.1f}' cy='{y:.1f}' r='6' {paint}/>"
        case "ring":
            return (
                f"<circle cx='{x:.1f}' cy='{y:.1f}' r='6.5' fill='#fff' stroke='#000'/>"
                f"<circle cx='{x:.1f}' cy='{y:.1f}' r='3' {paint}/>"
            )
    outline = {
        "square": "M-5.5-5.5h11v11h-11z",
        "triangle": "M0-7l7 12h-14z",
        "diamond": "M0-7.5l7.5 7.5l-7.5 7.5l-7.5-7.5z",
        "cross": "M-5-5l10 10M-5 5l10-10",
        "plus": "M-7 0h14M0-7v14",
        "wedge": "M0 7l7-12h-14z",
        "bow": "M-6-6v12l12-12v12z",
        "star": "M-6 0h12M-3-5.2l6 10.4M3-5.2l-6 10.4",
    }[shape]
    return f"<path transform='translate({x:.1f} {y:.1f})' d='{outline}' {paint}/>"


def text_at(text: str, x: float, y: float, size: float) -> str:
    return f"<text x='{x:.1f}' y='{y:.1f}' {FONT} font-size='{size}'>{escape(text)}</text>"


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
            f"{task['key']}-{which}", title,
            scatter(title, "nanoseconds a ray, one thread", "relative error", points),
            f"Log-log scatter of time per ray against the {words} relative error of the hit "
            "distance; its numbers are in the table below. Filled markers lie on the front.",
        ))  # fmt: skip
    return made


def resolution_plot(resolution: dict[str, Any]) -> Plot:
    """Picture error against resolution."""
    rows = resolution["rows"]
    points = [Point(row["size"], row["error"], str(row["size"]), "circle") for row in rows]
    title = "Picture error against resolution"
    return Plot(
        "resolution", title,
        line(title, "pixels a side", "mean error, steps of 8 bits", points),
        "Log-log line of mean picture error against pixels a side.",
        ["Pixels a side", "Mean error, steps of 8 bits", "Pixels off by more than half a step"],
        [[str(row["size"]), f"{row['error']:.3f}", f"{100 * row['off']:.1f} %"] for row in rows],
    )  # fmt: skip
