"""Slides as PDF by ReportLab: text is text in an embedded font, with title, language, outline."""

from __future__ import annotations

import io
from collections.abc import Iterable, Mapping
from functools import cache, lru_cache

from reportlab import rl_config
from reportlab.lib.colors import HexColor
from reportlab.lib.utils import ImageReader
from reportlab.pdfbase import pdfmetrics
from reportlab.pdfbase.ttfonts import TTFont
from reportlab.pdfgen.canvas import Canvas

from raywalk.slides.figure import (
    Deck,
    Dot,
    Group,
    Item,
    Line,
    Picture,
    Point,
    Polygon,
    Run,
    Table,
    Text,
    flat,
)
from raywalk.slides.formats import COURSE
from raywalk.slides.mosaic import by_fill, gathered
from raywalk.slides.palette import DASH_LENGTHS, SCREEN, Palette
from raywalk.slides.pictures import smaller
from raywalk.slides.repeats import is_large, repeated_groups
from raywalk.slides.svg import arrow_head
from raywalk.slides.table_parts import table_parts
from raywalk.slides.typeface import font_file, is_right_to_left, run_width, width


class MissingGlyphs(Exception):
    """Characters that the embedded font does not have; str() names them."""

    def __init__(self, characters: Iterable[str]):
        self.characters = sorted(set(characters))
        named = ", ".join(f"{c} (U+{ord(c):04X})" for c in self.characters[:8])
        more = f" and {len(self.characters) - 8} more" if len(self.characters) > 8 else ""
        super().__init__(f"{named}{more}")


def deck_pdf(deck: Deck, palette: Palette) -> bytes:
    """A page a slide. Raises MissingGlyphs."""
    canvas, out = new_canvas(deck.title, deck.language, (deck.width, deck.height))
    repeated = repeated_groups(slide.items for slide in deck.slides)
    for k, slide in enumerate(deck.slides):
        if not slide.is_continued:
            canvas.bookmarkPage(f"s{k}")
            level = 1 if deck.id == COURSE and slide.kind not in OUTER else 0
            canvas.addOutlineEntry(slide.title, f"s{k}", level, closed=level == 0)
        draw_slide(canvas, slide.items, deck, palette, repeated=repeated)
        canvas.showPage()
    return finished(canvas, out)


# Kinds of slides that head a course's outline; the others stand below them.
OUTER = ("title", "section", "goals", "credits")


def new_canvas(title: str, language: str, size: tuple[float, float]) -> tuple[Canvas, io.BytesIO]:
    """Invariant: no date, no random number, so the same slides are the same bytes."""
    rl_config.useA85 = 0  # pictures as they are: a fifth smaller, and half the time
    out = io.BytesIO()
    canvas = Canvas(out, pagesize=size, invariant=1, pageCompression=1, lang=language)
    canvas.setTitle(title)
    canvas.setAuthor("Raywalk")
    canvas.setCreator("Raywalk")
    canvas.setProducer("Raywalk")
    return canvas, out


def finished(canvas: Canvas, out: io.BytesIO) -> bytes:
    canvas.save()
    return out.getvalue()


def draw_slide(
    canvas: Canvas, items: Iterable[Item], deck: Deck, palette: Palette,
    pixels: float | None = None, repeated: Mapping[Group, str] | None = None,
) -> None:  # fmt: skip
    """Everything of a slide with its lower left corner at the origin; the rest: as Pen has it."""
    refuse_missing(items)
    canvas.setFillColor(palette["ground"])
    canvas.rect(0, 0, deck.width, deck.height, stroke=0, fill=1)
    pen = Pen(canvas, (deck.width, deck.height), palette, pixels, repeated)
    for item in items:
        pen.draw(item)


def refuse_missing(items: Iterable[Item]) -> None:
    """Raises MissingGlyphs if a text has what the font has not."""
    known = _face(False, False)
    lost = {
        char
        for item in flat(tuple(items))
        for run in _runs(item)
        for char in run.text
        if ord(char) not in known and char != "\u200f"
    }
    if lost:
        raise MissingGlyphs(lost)


def _runs(item: Item) -> Iterable[Run]:
    if isinstance(item, Text):
        return (run for line in item.lines for run in line)
    if isinstance(item, Table):
        return (Run(cell.text) for row in item.rows for cell in row)
    return ()


def font(bold: bool = False, italic: bool = False) -> str:
    """The name under which the style is registered."""
    name = "Arimo" + ("-Bold" if bold else "") + ("-Italic" if italic else "")
    if name not in pdfmetrics.getRegisteredFontNames():
        pdfmetrics.registerFont(TTFont(name, str(font_file(bold, italic))))
    return name


def _face(bold: bool, italic: bool) -> dict[int, int]:
    return pdfmetrics.getFont(font(bold, italic)).face.charToGlyph


# ReportLab would parse a colour's text, and decode a picture, each time it is drawn.
_hex = cache(HexColor)


@lru_cache(maxsize=64)
def _image(data: bytes) -> ImageReader:
    return ImageReader(io.BytesIO(data))


class _Outlines:
    """Closed outlines as a canvas asks a path for them. A fine grid has thousands of corners, and
    ReportLab takes five times as long to write a number."""

    def __init__(self, outlines: Iterable[list[tuple[str, str]]]):
        self._parts = ["n"]
        for (x, y), *others in outlines:
            self._parts.append(f"{x} {y} m")
            self._parts += [f"{to_x} {to_y} l" for to_x, to_y in others]
            self._parts.append("h")

    def getCode(self) -> str:
        return " ".join(self._parts)


@lru_cache(maxsize=1 << 16)
def number(points: float) -> str:
    """A hundredth of a point is finer than any printer; no zero that says nothing."""
    text = f"{points:.2f}".rstrip("0").rstrip(".")
    return text[1:] if text.startswith("0.") else "0" if text == "-0" else text


class Pen:
    """Draws items on a canvas whose y goes up; ours goes down."""

    def __init__(
        self, canvas: Canvas, size: tuple[float, float], palette: Palette,
        pixels: float | None = None, repeated: Mapping[Group, str] | None = None,
    ):  # fmt: skip
        """pixels: that a picture has at most for each of the slide's points; None: all it has.
        repeated: groups that the file holds once, by name, and refers to."""
        self.canvas, self.palette = canvas, palette
        self.width, self.height = size
        self.pixels, self.repeated = pixels, repeated or {}

    def draw(self, item: Item) -> None:
        match item:
            case Line():
                self._line(item)
            case Polygon():
                self._polygon(item)
            case Dot():
                self._dot(item)
            case Picture():
                self._picture(item)
            case Text():
                self._text(item)
            case Table():
                for part in table_parts(item):
                    self.draw(part)
            case Group():
                name = self.repeated.get(item) if is_large(item) else None
                if name:
                    self._again(name, item)
                else:
                    self._group(item)

    def _group(self, group: Group) -> None:
        for piece in gathered(group.items):
            if isinstance(piece, list):
                self._mosaic(piece)
            else:
                self.draw(piece)

    def _again(self, name: str, group: Group) -> None:
        """By its form, which is drawn when it is met first."""
        c = self.canvas
        if not c.hasForm(name):
            c.beginForm(name, 0, 0, self.width, self.height)
            self._group(group)
            c.endForm()
        c.doForm(name)

    def _line(self, line: Line) -> None:
        c = self.canvas
        c.setStrokeColor(self._colour(line.colour))
        c.setLineWidth(line.width)
        c.setDash(list(DASH_LENGTHS[line.dash]))
        c.line(line.start[0], self.height - line.start[1], line.end[0], self.height - line.end[1])
        c.setDash([])
        if head := arrow_head(line):
            self._polygon(Polygon(head, line.colour))

    def _polygon(self, area: Polygon) -> None:
        c = self.canvas
        path = self._path([area.points])
        if area.fill:
            c.setFillColor(self._colour(area.fill))
            c.setFillAlpha(area.opacity)
        if area.edge:
            c.setStrokeColor(self._colour(area.edge))
            c.setLineWidth(area.edge_width)
        c.drawPath(path, stroke=bool(area.edge), fill=bool(area.fill))
        if area.fill and area.opacity < 1:
            c.setFillAlpha(1)

    def _mosaic(self, areas: list[Polygon]) -> None:
        """A path a colour, and one for all edges."""
        c = self.canvas
        for colour, outlines in by_fill(areas).items():
            if colour is None:
                continue
            c.setFillColor(self._colour(colour))
            c.drawPath(self._path(outlines), stroke=0, fill=1)
        if edge := areas[0].edge:
            c.setStrokeColor(self._colour(edge))
            c.setLineWidth(areas[0].edge_width)
            c.drawPath(self._path(area.points for area in areas), stroke=1, fill=0)

    def _path(self, outlines: Iterable[tuple[Point, ...]]) -> _Outlines:
        return _Outlines(
            [(number(x), number(self.height - y)) for x, y in outline] for outline in outlines
        )

    def _colour(self, role: str) -> HexColor:
        return _hex(self.palette[role])

    def _dot(self, dot: Dot) -> None:
        c = self.canvas
        c.setFillColor(self._colour(dot.fill))
        if dot.edge:
            c.setStrokeColor(self._colour(dot.edge))
            c.setLineWidth(1)
        c.circle(*(dot.centre[0], self.height - dot.centre[1]), dot.radius, bool(dot.edge), 1)

    def _picture(self, picture: Picture) -> None:
        data = picture.on_screen if self.palette is SCREEN else picture.on_paper
        box = picture.box
        if self.pixels:
            data = smaller(data, round(box.width * self.pixels))
        mask = "auto" if data.startswith(b"\x89PNG") else None
        place = (box.left, self.height - box.bottom, box.width, box.height)
        self.canvas.drawImage(_image(data), *place, mask=mask)

    def _text(self, text: Text) -> None:
        c = self.canvas
        c.setFillColor(self._colour(text.colour))
        for k, line in enumerate(text.lines):
            runs = _in_visual_order(line, text.right_to_left)
            whole = sum(run_width(run, text.size) for run in runs)
            left = text.box.left
            left += {"left": 0, "centre": 0.5, "right": 1}[text.align] * (text.box.width - whole)
            for run in runs:
                c.setFont(font(run.bold, run.italic), text.size)
                c.drawString(left, self.height - text.baseline(k), run.text)
                left += width(run.text, text.size, run.bold, run.italic)


def _in_visual_order(line: tuple[Run, ...], is_backwards: bool) -> tuple[Run, ...]:
    """Left to right as it is seen. A line with Hebrew is reordered as a whole, in one style."""
    words = "".join(run.text for run in line)
    if not is_backwards and not any(is_right_to_left(char) for char in words):
        return line
    from bidi import get_display

    first = line[0]
    return (Run(get_display(words, base_dir="R" if is_backwards else "L"), first.bold),)
