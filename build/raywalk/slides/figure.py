"""A slide as a display list: plain data, in points from the slide's top left, y down.

One list, three writers (svg.py, pdf.py, pptx.py). A colour is a role that a palette names
("ink", "reflected") or "#rrggbb" as it is. Nothing here knows a file format.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from raywalk.slides.layout import Box

Point = tuple[float, float]
ASCENT, TALL = 0.905, 1.117  # of a text's size: from the baseline up, and of all; as in Arial


def hex_of(bytes_: Sequence[int]) -> str:
    """Three 8-bit numbers as #rrggbb."""
    return "#{:02x}{:02x}{:02x}".format(*bytes_)


@dataclass(frozen=True)
class Run:
    """Words in one style."""

    text: str
    bold: bool = False
    italic: bool = False


@dataclass(frozen=True)
class Line:
    """A straight line; its name says what it is of."""

    start: Point
    end: Point
    colour: str
    width: float = 1.0
    dash: str = "solid"
    arrow: bool = False  # a head whose tip is the end
    name: str = "line"


@dataclass(frozen=True)
class Polygon:
    points: tuple[Point, ...]
    fill: str | None
    edge: str | None = None
    edge_width: float = 0.5
    opacity: float = 1.0  # of the fill
    name: str = "area"


@dataclass(frozen=True)
class Dot:
    """A filled circle."""

    centre: Point
    radius: float
    fill: str
    edge: str | None = None
    name: str = "point"


@dataclass(frozen=True)
class Picture:
    """Pixels; `on_screen` and `on_paper` are files of the same size for the two palettes,
    `on_web` one for both that browsers read, b"" if there is none."""

    box: Box
    on_screen: bytes
    on_paper: bytes
    name: str
    alt: str
    on_web: bytes = b""


@dataclass(frozen=True)
class Text:
    """Lines already wrapped to the box's width; paragraphs are what was wrapped."""

    box: Box
    lines: tuple[tuple[Run, ...], ...]
    size: float
    colour: str = "ink"
    align: str = "left"  # left, centre, right
    leading: float = 1.25  # of the size
    right_to_left: bool = False
    paragraphs: tuple[tuple[Run, ...], ...] = ()  # for writers that wrap; else the lines
    name: str = "text"
    is_title: bool = False

    def baseline(self, line: int) -> float:
        """Of one of the lines; its letters stand in the middle: half of what is left goes above."""
        high = self.size * self.leading
        return self.box.top + line * high + (high - TALL * self.size) / 2 + ASCENT * self.size

    @property
    def words(self) -> str:
        """The text as one string."""
        return " ".join("".join(run.text for run in line).strip() for line in self.lines)


@dataclass(frozen=True)
class Cell:
    """Of a table: words, or a sample of a ray's line, or a swatch of a colour."""

    text: str = ""
    sample: str | None = None  # a kind of ray, drawn before the words
    swatch: str | None = None  # #rrggbb, drawn before the words
    bold: bool = False


@dataclass(frozen=True)
class Table:
    box: Box
    widths: tuple[float, ...]  # of the columns, points
    align: tuple[str, ...]  # of the columns: left, right
    rows: tuple[tuple[Cell, ...], ...]  # the first is the heading
    row_height: float
    size: float
    name: str
    alt: str


@dataclass(frozen=True)
class Group:
    """Things that belong together; `ends` are those of the ray that it draws, if any."""

    name: str
    alt: str
    items: tuple[Item, ...]
    is_figure: bool = False


Item = Line | Polygon | Dot | Picture | Text | Table | Group


@dataclass(frozen=True)
class Slide:
    """One page with what is said to it."""

    title: str  # for outlines and lists of slides
    items: tuple[Item, ...]
    notes: tuple[str, ...] = ()  # speaker notes, a paragraph each
    # title, goals, section, build, step, question, answer, credits; backup (a divider), table, sum
    kind: str = "step"
    is_continued: bool = False
    # Of each stop on the first of its slides, as a file of its own.
    figure: Group | None = field(default=None, compare=False)


@dataclass(frozen=True)
class Deck:
    """What becomes one file."""

    id: str
    title: str
    width: float
    height: float
    slides: tuple[Slide, ...]
    language: str = "en"


def flat(items: tuple[Item, ...]) -> Iterator[Item]:
    """Every item, those in groups too, groups before what is in them."""
    for item in items:
        yield item
        if isinstance(item, Group):
            yield from flat(item.items)
