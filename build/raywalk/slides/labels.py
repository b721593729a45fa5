"""Where words beside things stand: clear of one another, of lines and of the figure's edge.

A label with no clear place is left out; the table beside the figure says the same.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass

import numpy as np

from raywalk.slides.clip import clipped_line
from raywalk.slides.figure import Item, Point, Polygon, Run, Text
from raywalk.slides.layout import SMALLEST, Box
from raywalk.slides.typeface import shortened, width

RINGS = (9.0, 16.0, 26.0, 38.0)  # points from the thing to its label
DIRECTIONS = (0, 180, 90, 270, 45, 315, 135, 225, 22, 338, 158, 202, 68, 112, 248, 292)
PAD = 3.0  # round the words
LONGEST = 220.0


@dataclass(frozen=True)
class Label:
    text: str
    at: Point  # what it belongs to
    colour: str = "ink"
    bold: bool = False


class Places:
    """What is taken in a figure: boxes of labels, strokes of lines, faint ones of thin lines.

    view: (rows, columns, 4) 8-bit, the shaded view behind it all, as wide and high as the frame;
    where its last number is 0 nothing is seen.
    """

    def __init__(self, frame: Box, view: np.ndarray):
        self.frame = frame
        self.view = view
        self.boxes: list[Box] = []
        self.strokes: list[tuple[Point, Point]] = []
        # Of less weight: a plate may lie on them where there is no place beside.
        self.faint: list[tuple[Point, Point]] = []

    def put(self, labels: Iterable[Label]) -> list[Item]:
        """Plates and words of the labels that found a place, the first ones first."""
        items: list[Item] = []
        for label in labels:
            text = shortened(label.text, SMALLEST, LONGEST, label.bold)
            box = self._free(label.at, width(text, SMALLEST, label.bold) + 2 * PAD)
            if box is None:
                continue
            self.boxes.append(box)
            items += _drawn(box, text, label)
        return items

    def plate(self, words: str, left: float, top: float) -> list[Item]:
        """Words that stand where they stand; labels keep clear of them."""
        text = shortened(words, SMALLEST, self.frame.right - left - 2 * PAD)
        box = Box(left, top, width(text, SMALLEST) + 2 * PAD, SMALLEST * 1.15)
        self.boxes.append(box)
        return _drawn(box, text, Label(text, (left, top)))

    def seen(self, box: Box) -> float:
        """The share of a box in the frame where the scene is seen."""
        rows, columns, _ = self.view.shape
        x = [(end - self.frame.left) / self.frame.width * columns for end in (box.left, box.right)]
        y = [(end - self.frame.top) / self.frame.height * rows for end in (box.top, box.bottom)]
        part = self.view[round(y[0]) : round(y[1]), round(x[0]) : round(x[1]), 3]
        return float((part > 0).mean())

    def is_struck(self, box: Box) -> bool:
        """Whether a ray that matters runs through it."""
        return any(clipped_line(*stroke, box) for stroke in self.strokes)

    def _free(self, at: Point, wide: float) -> Box | None:
        return self._clear_of(at, wide, [*self.strokes, *self.faint]) or self._clear_of(
            at, wide, self.strokes
        )

    def _clear_of(self, at: Point, wide: float, strokes: list[tuple[Point, Point]]) -> Box | None:
        high = SMALLEST * 1.15
        for ring in RINGS:
            for degrees in DIRECTIONS:
                x, y = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
                # The box's nearest edge is `ring` away from the thing.
                left = at[0] + x * ring + (x - 1) / 2 * wide
                top = at[1] + y * ring + (y - 1) / 2 * high
                box = Box(left, top, wide, high)
                if self.frame.holds(box) and self._is_clear(box, strokes):
                    return box
        return None

    def _is_clear(self, box: Box, strokes: list[tuple[Point, Point]]) -> bool:
        return not any(box.overlaps(other) for other in self.boxes) and not any(
            clipped_line(*stroke, box) for stroke in strokes
        )


def _drawn(box: Box, text: str, label: Label) -> list[Item]:
    plate = Polygon(box.corners, "ground", opacity=0.85, name=f"plate of {text}")
    inner = Box(box.left + PAD, box.top, box.width - 2 * PAD, box.height)
    runs = (Run(text, label.bold),)
    words = Text(inner, (runs,), SMALLEST, label.colour, leading=1.15, name=f"label {text}")
    return [plate, words]


#: Draws something into a figure where it covers little, and takes the place for it.
Inset = Callable[[Places], list[Item]]
