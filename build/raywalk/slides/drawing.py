"""What the parts of a step's figure share: scene, stop, and where a point of the view is."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raywalk.scene.model import Scene
from raywalk.slides.clip import clipped_line
from raywalk.slides.figure import Point
from raywalk.slides.layout import Box
from raywalk.slides.stops import ChosenLine, Ends, Stop


@dataclass(frozen=True, eq=False)
class Drawing:
    """What the parts of one figure share."""

    scene: Scene
    stop: Stop
    view: Path  # the shaded view that lies behind
    box: Box  # on the slide
    now: int | None = None  # the ray that a walk has come to: others are drawn less strongly
    picture: Path | None = None  # the traced one, where the step shows it in its place

    def point(self, at: Point | None) -> Point | None:
        """Where a point of the figure is on the slide; None beyond the frame, or None itself."""
        if at is None or not (0 <= at[0] <= self.box.width and 0 <= at[1] <= self.box.height):
            return None
        return (self.box.left + at[0], self.box.top + at[1])

    def line(self, ends: Ends | None) -> tuple[np.ndarray, tuple[float, float]] | None:
        """(2, 2) slide coordinates of a line of the figure (not cut at the frame), and between
        which shares of it it is within the frame; None where nothing of it is."""
        if ends is None:
            return None
        at = np.array(ends) + np.array(self.box[:2])
        inside = clipped_line(tuple(at[0]), tuple(at[1]), self.box)
        return (at, inside) if inside else None


def hits(stop: Stop) -> list[ChosenLine]:
    """The selected pixel's rays that end on something."""
    return [line for line in stop.chosen if line.light < 0 and not line.leaves]
