"""Where things stand on a slide. Points (1/72 inch), from the slide's top left."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple


class Box(NamedTuple):
    left: float
    top: float
    width: float
    height: float

    @property
    def right(self) -> float:
        return self.left + self.width

    @property
    def bottom(self) -> float:
        return self.top + self.height

    @property
    def corners(self) -> tuple[tuple[float, float], ...]:
        """Clockwise from the top left."""
        left, top = self.left, self.top
        return (left, top), (self.right, top), (self.right, self.bottom), (left, self.bottom)

    def overlaps(self, other: Box) -> bool:
        return (
            self.left < other.right
            and other.left < self.right
            and self.top < other.bottom
            and other.top < self.bottom
        )

    def holds(self, other: Box) -> bool:
        return (
            self.left <= other.left
            and self.top <= other.top
            and other.right <= self.right
            and other.bottom <= self.bottom
        )


@dataclass(frozen=True)
class Layout:
    """One aspect's frames. Text of a slide runs in `words`; what is left below holds numbers."""

    name: str
    width: float
    height: float
    title: Box
    figure: Box
    words: Box
    aside: Box | None  # of numbers and picture; None: below the words
    footer: Box


MARGIN = 40.0
# No text is smaller: it must be read from the last row.
SMALLEST = 14.0

WIDE = Layout(
    name="16:9",
    width=960.0,
    height=540.0,
    title=Box(MARGIN, 26, 880, 64),
    figure=Box(MARGIN, 98, 520, 360),
    words=Box(580, 98, 340, 394),
    aside=None,
    footer=Box(MARGIN, 504, 880, 20),
)
# Text above, figure left, numbers right of it.
TALL = Layout(
    name="4:3",
    width=720.0,
    height=540.0,
    title=Box(MARGIN, 22, 640, 66),
    figure=Box(MARGIN, 196, 316, 248),
    words=Box(MARGIN, 92, 640, 100),
    aside=Box(368, 200, 312, 292),
    footer=Box(MARGIN, 504, 640, 20),
)
LAYOUTS = {layout.name: layout for layout in (WIDE, TALL)}
