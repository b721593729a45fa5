"""What a step of the lesson shows: its view with what it leaves out as at the scene's start.

The same rules as the viewer's startState and applyView (state/view-state.ts).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from raywalk.scene.model import Scene
from raywalk.slides.what_if import AS_TRACED, Switches, switches_of


@dataclass(frozen=True)
class View:
    n: int  # tiles across and down
    pixel: tuple[int, int]  # column, row from the top left
    rays: tuple[str, ...]  # of "pixel", "row", "column", "all"
    filled: bool  # whether the tiles show their colours
    observer: Any  # "start", "camera" or {"eye": .., "target": ..}
    switches: Switches = AS_TRACED
    colours: str = "picture"  # what filled tiles show: the picture, or what it cost

    @property
    def index(self) -> int:
        """row * n + column of the selected pixel."""
        return self.pixel[1] * self.n + self.pixel[0]


def start_view(scene: Scene) -> View:
    """What a visitor meets: the first step's resolution and pixel."""
    first = scene.lesson[0].view if scene.lesson else {}
    levels = sorted(scene.render.resolutions)
    n = first.get("resolution") or min(levels, key=lambda level: (abs(level - 15), level))
    pixel = first.get("pixel") if "resolution" in first else None
    column, row = pixel or (n // 2, n // 2)
    return View(n, (column, row), ("pixel",), False, "start")


@dataclass(frozen=True)
class Stop:
    """A step of the lesson, or the answer to its question, as a slide of its own."""

    step: int  # of the lesson, from 0
    kind: str  # step, question, answer
    text: str  # Markdown
    view: View


def stops_of(scene: Scene) -> list[Stop]:
    """The lesson as one goes through it."""
    stops = []
    for k, step in enumerate(scene.lesson):
        kinds = ("question", "answer") if step.answer else ("step",)
        for kind, (text, view) in zip(kinds, step.stops(), strict=True):
            stops.append(Stop(k, kind, text, view_of(scene, view)))
    return stops


def view_of(scene: Scene, given: dict[str, Any]) -> View:
    """A view as the scene's file has it, completed."""
    start = start_view(scene)
    n = given.get("resolution") or start.n
    if "pixel" in given:
        column, row = given["pixel"]
    else:  # the same place in the picture
        column, row = (min(n - 1, int((k + 0.5) / start.n * n)) for k in start.pixel)
    rays = given.get("rays", start.rays)
    if (plane := given.get("slice", "none")) != "none":
        rays = (*rays, plane)  # a slice's rays, drawn in space
    # The traced look is the picture, in its only place.
    observer = "camera" if given.get("look") == "traced" else given.get("observer")
    return View(
        n,
        (column, row),
        tuple(dict.fromkeys(rays)),
        given.get("tiles", "empty") == "filled",
        observer or start.observer,
        switches_of(given.get("switches"), scene),
        given.get("colours", "picture"),
    )
