"""What a lesson's figures need of the tracer, and what it answers, both as plain data.

slides/ asks (requests), the trace stage answers into a folder (sight_products.py), slides/ reads.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.slides.costs import tile_colours
from raywalk.slides.frustum import PicturePlane, picture_plane
from raywalk.slides.layout import Layout
from raywalk.slides.lines import RayLine, pixel_lines, thin_pixels
from raywalk.slides.observer import Observer, Projection, observer_of
from raywalk.slides.placing import Placed
from raywalk.slides.views import Stop, View, stops_of
from raywalk.slides.what_if import PAINTS, switched_scene, switched_trace
from raywalk.trace_file import DecodedTrace, read_trace

PIXELS_A_POINT = 1.0  # of the shaded view: it lies pale behind the lines
MOST_THIN = 450  # lines: more hide one another, and make a slide slow to edit
ANSWERS = "sights.json"


@dataclass(frozen=True, eq=False)
class Seen:
    """One stop's geometry: what is drawn, and from where."""

    stop: Stop
    scene: Scene  # with the step's switches set
    observer: Observer
    projection: Projection  # to points of the layout's figure
    plane: PicturePlane
    trace: DecodedTrace  # with the step's switches set
    tiles: np.ndarray  # (n * n, 3) 8-bit, what filled tiles show
    chosen: list[RayLine]
    thin: list[RayLine]
    one_in: int  # of how many pixels the thin lines show one

    @property
    def view(self) -> View:
        return self.stop.view


def stops_seen(placed: Placed, traces: Path, layout: Layout) -> list[Seen]:
    """Every stop of the lesson. traces: the folder of <n>.json.gz."""
    plane = picture_plane(placed)
    return [
        _seen(placed, plane, stop, trace_of(traces / f"{stop.view.n}.json.gz"), layout)
        for stop in stops_of(placed.scene)
    ]


# Both that asks the tracer and that draws read a scene's few grids, one after the other.
trace_of = lru_cache(maxsize=9)(read_trace)


def _seen(
    placed: Placed, plane: PicturePlane, stop: Stop, trace: DecodedTrace, layout: Layout
) -> Seen:
    box, view = layout.figure, stop.view
    observer = observer_of(view.observer, placed, plane, box.width / box.height)
    trace = switched_trace(trace, placed.scene, view.switches)
    scene = switched_scene(placed.scene, view.switches)
    chosen = [view.index] if "pixel" in view.rays else []
    thin, one_in = _thinned(trace, scene, thin_pixels(view), view.n)
    return Seen(
        stop, scene, observer, Projection(observer, box.width, box.height), plane, trace,
        tile_colours(trace, view.colours), pixel_lines(trace, scene, chosen), thin, one_in,
    )  # fmt: skip


def _thinned(
    trace: DecodedTrace, scene: Scene, pixels: list[int], n: int
) -> tuple[list[RayLine], int]:
    """Lines of these pixels; where there are too many those of every k-th row and column."""
    for one_in in range(1, n + 1):
        kept = [
            p for p in pixels if p // n % one_in == one_in // 2 and p % n % one_in == one_in // 2
        ]
        # A single row or column keeps its place.
        if len({p // n for p in pixels}) == 1 or len({p % n for p in pixels}) == 1:
            kept = pixels[one_in // 2 :: one_in]
        lines = pixel_lines(trace, scene, kept)
        if len(lines) <= MOST_THIN:
            return lines, one_in
    return [], n


def requests(seen: list[Seen]) -> dict[str, Any]:
    """{"looks": distinct onlookers and lights, "steps": [{"look", "chosen", "thin", "tiles"}]};
    lines as [[x y z], [x y z]], tiles by their centres."""
    looks: list[dict[str, Any]] = []
    steps = []
    for each in seen:
        look = _look(each)
        if look not in looks:
            looks.append(look)
        n, where = each.view.n, np.arange(each.view.n**2)
        centres = each.plane.at(where % n + 0.5, where // n + 0.5, n)
        steps.append({
            "look": looks.index(look),
            "chosen": [line.ends.tolist() for line in each.chosen],
            "thin": [line.ends.tolist() for line in each.thin],
            "tiles": centres.tolist(),
        })  # fmt: skip
    return {"looks": looks, "steps": steps}


def _look(seen: Seen) -> dict[str, Any]:
    view = seen.projection
    width, height = (round(PIXELS_A_POINT * side) for side in (view.width, view.height))
    return {
        "eye": seen.observer.eye.tolist(),
        "right": view.right.tolist(),
        "up": view.up.tolist(),
        "forward": view.forward.tolist(),
        "focal": float(view.focal * width / view.width),
        "width": width,
        "height": height,
        "switches": replace(
            seen.view.switches,
            # Which rays are sent on stays: the view is pale, and mirrors are to be known as such.
            without=tuple(part for part in seen.view.switches.without if part in PAINTS),
        ),
    }


@dataclass(frozen=True)
class Sight:
    """The tracer's answer for one step."""

    picture: Path  # shaded view, RGBA
    chosen: list[list[tuple[float, float]]]  # hidden stretches of each line, shares of its way
    thin: list[list[tuple[float, float]]]
    hidden_tiles: frozenset[int]


def read_sights(folder: Path) -> list[Sight]:
    """One a step, from what the trace stage wrote."""
    answers = json.loads((folder / ANSWERS).read_text(encoding="utf-8"))
    return [
        Sight(
            folder / f"view-{each['look']}.png",
            [[(a, b) for a, b in line] for line in each["chosen"]],
            [[(a, b) for a, b in line] for line in each["thin"]],
            frozenset(each["tiles"]),
        )
        for each in answers["steps"]
    ]
