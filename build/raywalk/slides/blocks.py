"""Words laid out: titles, paragraphs over one or more slides, footers."""

from __future__ import annotations

from dataclasses import dataclass

from raywalk.slides.figure import Item, Run, Text
from raywalk.slides.layout import SMALLEST, SOURCE, Box, Layout
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.typeface import is_right_to_left, shortened, width, wrapped

TITLE_SIZES = (30.0, 27.0, 24.0)  # the largest in which it takes one line
BODY_SIZE = 24.0
LEADING = 1.25
PARAGRAPH_GAP = 0.45  # of a line
INDENT, LEAST_INDENT = 1.45, 20.0  # of a list's items: of the letters' size, points


@dataclass(frozen=True)
class Flow:
    """Paragraphs wrapped to a width: lines with the paragraph that each belongs to."""

    lines: tuple[tuple[tuple[Run, ...], Paragraph, bool], ...]  # runs, paragraph, is its first
    size: float

    @property
    def line_height(self) -> float:
        return self.size * LEADING

    def height(self) -> float:
        """Points that all lines take."""
        gaps = sum(first for _, _, first in self.lines[1:])
        return self.line_height * (len(self.lines) + PARAGRAPH_GAP * gaps)

    def split(self, room: float) -> tuple[Flow, Flow]:
        """As many lines as fit into the height, at least one, and the rest."""
        used, count = 0.0, 0
        for k, (_, _, first) in enumerate(self.lines):
            used += self.line_height * (1 + (PARAGRAPH_GAP if first and k else 0))
            if used > room + 0.01 and k:
                break
            count = k + 1
        return Flow(self.lines[:count], self.size), Flow(self.lines[count:], self.size)

    def split_between(self, room: float) -> tuple[Flow, Flow]:
        """As split, but between paragraphs: the one that would be torn goes on whole."""
        first, rest = self.split(room)
        begins = [k for k, (_, _, is_first) in enumerate(first.lines) if is_first]
        if rest.lines and not rest.lines[0][2] and begins and begins[-1]:
            return Flow(self.lines[: begins[-1]], self.size), Flow(
                self.lines[begins[-1] :], self.size
            )
        return first, rest


def indent_of(size: float) -> float:
    """Room for a sign or a number before an item of a list."""
    return max(LEAST_INDENT, INDENT * size)


def flow(paragraphs: list[Paragraph], size: float, most: float) -> Flow:
    lines = []
    for paragraph in paragraphs:
        room = most - (indent_of(size) if paragraph.bullet else 0)
        for k, runs in enumerate(wrapped(paragraph.runs, size, room)):
            lines.append((runs, paragraph, k == 0))
    return Flow(tuple(lines), size)


def flow_texts(whole: Flow, box: Box, colour: str = "ink") -> list[Item]:
    """A text item a paragraph, from the box's top down."""
    items: list[Item] = []
    top, k = box.top, 0
    while k < len(whole.lines):
        paragraph, first = whole.lines[k][1], whole.lines[k][2]
        end = k + 1
        while (
            end < len(whole.lines) and whole.lines[end][1] is paragraph and not whole.lines[end][2]
        ):
            end += 1
        lines = tuple(line for line, _, _ in whole.lines[k:end])
        if first and k:
            top += PARAGRAPH_GAP * whole.line_height
        indent = indent_of(whole.size) if paragraph.bullet else 0.0
        place = Box(box.left + indent, top, box.width - indent, whole.line_height * len(lines))
        backwards = is_right_to_left(paragraph.text)
        if paragraph.bullet and first:
            mark = Box(box.left, top, indent, whole.line_height)
            items.append(text([(Run(paragraph.bullet),)], mark, whole.size, colour, name="bullet"))
        items.append(
            Text(
                place, lines, whole.size, colour, "right" if backwards else "left", LEADING,
                backwards, paragraphs=(_one(lines),), name="words",
            )
        )  # fmt: skip
        top += whole.line_height * len(lines)
        k = end
    return items


def _one(lines: tuple[tuple[Run, ...], ...]) -> tuple[Run, ...]:
    """Lines as one paragraph again, for writers that wrap by themselves."""
    runs: list[Run] = []
    for k, line in enumerate(lines):
        if k and runs and not runs[-1].text.endswith("-"):
            last = runs[-1]
            runs[-1] = Run(last.text + " ", last.bold, last.italic)
        runs += line
    return tuple(runs)


def text(
    lines: list[tuple[Run, ...]], box: Box, size: float, colour: str = "ink", align: str = "left",
    name: str = "text", is_title: bool = False,
) -> Text:  # fmt: skip
    whole = "".join(run.text for line in lines for run in line)
    backwards = is_right_to_left(whole)
    if backwards and align == "left":
        align = "right"
    return Text(
        box, tuple(lines), size, colour, align, LEADING if not is_title else 1.2, backwards,
        paragraphs=(_one(tuple(lines)),), name=name, is_title=is_title,
    )  # fmt: skip


def one_line(words: str, box: Box, size: float = SMALLEST, colour: str = "ink",
             align: str = "left", bold: bool = False, name: str = "text") -> Text:  # fmt: skip
    """One line, cut with an ellipsis where it is too long."""
    cut = shortened(words, size, box.width, bold)
    return text([(Run(cut, bold),)], box, size, colour, align, name)


def title_fits(words: str, most: float) -> bool:
    """Whether a title takes one line of so many points, in its smallest size."""
    return width(words, TITLE_SIZES[-1], bold=True) <= most


def title(words: str, box: Box) -> Text:
    """One bold line, as large as it fits; cut where it fits in no size."""
    fitting = (size for size in TITLE_SIZES if width(words, size, bold=True) <= box.width)
    size = next(fitting, TITLE_SIZES[-1])
    cut = shortened(words, size, box.width, bold=True)
    high = size * 1.2
    place = Box(box.left, box.top + (box.height - high) / 2, box.width, high)
    return text([(Run(cut, bold=True),)], place, size, name="title", is_title=True)


def footer(left: str, right: str, layout: Layout) -> list[Item]:
    """The source line: what a slide is of, and which part of it."""
    box = layout.footer
    room = width(right, SOURCE) + 12
    return [
        one_line(left, Box(box.left, box.top, box.width - room, box.height), SOURCE, "soft",
                 name="where"),
        one_line(right, Box(box.right - room, box.top, room, box.height), SOURCE, "soft", "right",
                 name="place"),
    ]  # fmt: skip
