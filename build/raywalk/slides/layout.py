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
    """One aspect's frames: a title's line, the figure from edge to edge under it, at least three
    fifths of the slide, then words; in the last line the source."""

    name: str
    width: float
    height: float
    title: Box
    figure: Box
    words: Box
    footer: Box

    @property
    def below_title(self) -> Box:
        """All of a slide without a figure."""
        left, top, wide, _ = self.title
        top = self.title.bottom + 12
        return Box(left, top, wide, self.footer.top - 10 - top)


MARGIN = 32.0
# No text but the source is smaller: it must be read from the last row.
SMALLEST = 18.0
SOURCE = 12.0


def _layout(name: str, width: float) -> Layout:
    inner = width - 2 * MARGIN
    return Layout(
        name=name, width=width, height=540.0,
        title=Box(MARGIN, 8, inner, 42),
        figure=Box(0, 56, width, 326),
        words=Box(MARGIN, 388, inner, 122),
        footer=Box(MARGIN, 516, inner, 16),
    )  # fmt: skip


WIDE, TALL = _layout("16:9", 960.0), _layout("4:3", 720.0)
LAYOUTS = {layout.name: layout for layout in (WIDE, TALL)}
