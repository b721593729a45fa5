"""Slides as SVG: text is text, pictures are inside, nothing is loaded from elsewhere."""

from __future__ import annotations

import base64
import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from html import escape
from itertools import pairwise

from raywalk.slides.figure import Dot, Group, Item, Line, Picture, Point, Polygon, Table, Text
from raywalk.slides.layout import Box
from raywalk.slides.mosaic import by_fill, gathered
from raywalk.slides.palette import DASH_LENGTHS, PRINT, SCREEN, Palette
from raywalk.slides.repeats import is_large
from raywalk.slides.table_parts import table_parts
from raywalk.slides.typeface import FAMILY

HEAD_LONG, HEAD_WIDE = 4.0, 3.4  # of an arrow, in widths of its line
LEAST_HEAD = 1.6  # points: the line width that the thinnest line's head goes by


@dataclass(frozen=True)
class Ink:
    """How colours are written: `themed` gives each its role as a class, for a style sheet that
    has both palettes, and pictures for both."""

    palette: Palette
    themed: bool = False
    shared: dict[bytes, str] = field(default_factory=dict)  # pictures of a page, by their id
    groups: dict[Group, str] = field(default_factory=dict)  # large ones that were drawn, likewise

    def fill(self, colour: str | None) -> str:
        return self._paint("fill", "f", colour)

    def stroke(self, colour: str) -> str:
        return self._paint("stroke", "s", colour)

    def _paint(self, attribute: str, letter: str, colour: str | None) -> str:
        if colour is None:
            return f'{attribute}="none"'
        if self.themed and not colour.startswith("#"):
            return f'class="{letter}-{colour}"'
        return f'{attribute}="{self.palette[colour]}"'


def standalone(items: Iterable[Item], frame: Box, palette: Palette, title: str, alt: str) -> str:
    """A file of its own that shows what is within the frame."""
    view = " ".join(_n(v) for v in frame)
    body = "".join(_item(item, Ink(palette)) for item in items)
    back = (
        f'<rect x="{_n(frame.left)}" y="{_n(frame.top)}" width="{_n(frame.width)}" '
        f'height="{_n(frame.height)}" fill="{palette["ground"]}"/>'
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_n(frame.width)}pt" '
        f'height="{_n(frame.height)}pt" viewBox="{view}" role="img" font-family="{FAMILY}">'
        f"<title>{escape(title)}</title><desc>{escape(alt)}</desc>{back}{body}</svg>\n"
    )


def inline(
    items: Iterable[Item], width: float, height: float, shared: dict[bytes, str],
    groups: dict[Group, str],
) -> str:  # fmt: skip
    """For a page whose style sheet has both palettes: `themed` paper colours. Pictures are only
    named; `shared` gathers them for `picture_store`. groups: those that the page has by now."""
    ink = Ink(PRINT, themed=True, shared=shared, groups=groups)
    body = "".join(_item(item, ink) for item in items)
    return f'<svg viewBox="0 0 {_n(width)} {_n(height)}" font-family="{FAMILY}">{body}</svg>'


def theme_rules(palette: Palette) -> str:
    """CSS for a themed SVG in another palette."""
    return "".join(
        f".f-{role}{{fill:{colour}}}.s-{role}{{stroke:{colour}}}"
        for role, colour in palette.colours.items()
    )


def arrow_head(line: Line) -> tuple[Point, Point, Point] | None:
    """Tip and two corners; None on a line too short to carry one."""
    dx, dy = line.end[0] - line.start[0], line.end[1] - line.start[1]
    long = math.hypot(dx, dy)
    wide = max(line.width, LEAST_HEAD)
    head = HEAD_LONG * wide
    if not line.arrow or long < head:
        return None
    ux, uy, half = dx / long, dy / long, HEAD_WIDE * wide / 2
    x, y = line.end[0] - ux * head, line.end[1] - uy * head
    return line.end, (x - uy * half, y + ux * half), (x + uy * half, y - ux * half)


def _item(item: Item, ink: Ink) -> str:
    match item:
        case Line():
            return _line(item, ink)
        case Polygon():
            return _polygon(item, ink)
        case Dot():
            edge = f" {ink.stroke(item.edge)}" if item.edge and not ink.themed else ""
            return (
                f'<circle cx="{_n(item.centre[0])}" cy="{_n(item.centre[1])}" '
                f'r="{_n(item.radius)}" {ink.fill(item.fill)}{edge}/>'
            )
        case Picture():
            return _picture(item, ink)
        case Text():
            return _text(item, ink)
        case Table():
            return _group(item.name, item.alt, "".join(_item(p, ink) for p in table_parts(item)))
        case Group():
            return (
                _drawn_or_named(item, ink) if is_large(item) and ink.themed else _drawn(item, ink)
            )


def _drawn(group: Group, ink: Ink) -> str:
    inner = "".join(
        _mosaic(part, ink) if isinstance(part, list) else _item(part, ink)
        for part in gathered(group.items)
    )
    return _group(group.name, group.alt if group.is_figure else "", inner)


def _drawn_or_named(group: Group, ink: Ink) -> str:
    """A page has it once."""
    if group in ink.groups:
        return f'<use href="#{ink.groups[group]}"/>'
    name = ink.groups[group] = f"g{len(ink.groups)}"
    return f'<g id="{name}">{_drawn(group, ink)}</g>'


def _group(name: str, alt: str, inner: str) -> str:
    attributes = f' role="img" aria-label="{escape(alt)}"' if alt else ""
    return f'<g data-name="{escape(name)}"{attributes}>{inner}</g>'


def _line(line: Line, ink: Ink) -> str:
    dashes = DASH_LENGTHS[line.dash]
    dash = f' stroke-dasharray="{" ".join(map(_n, dashes))}"' if dashes else ""
    drawn = (
        f'<line x1="{_n(line.start[0])}" y1="{_n(line.start[1])}" x2="{_n(line.end[0])}" '
        f'y2="{_n(line.end[1])}" {ink.stroke(line.colour)} stroke-width="{_n(line.width)}"{dash}/>'
    )
    head = arrow_head(line)
    return drawn + (_polygon(Polygon(head, line.colour), ink) if head else "")


def _polygon(area: Polygon, ink: Ink) -> str:
    points = " ".join(f"{_n(x)},{_n(y)}" for x, y in area.points)
    clear = f' fill-opacity="{area.opacity:g}"' if area.opacity < 1 else ""
    if area.edge and area.fill and ink.themed and not area.edge.startswith("#"):
        # One class an element: an area in its own colour, its edge in the theme's.
        alone = replace(area, fill=None)
        return _polygon(replace(area, edge=None), ink) + _polygon(alone, ink)
    edge = f' {ink.stroke(area.edge)} stroke-width="{_n(area.edge_width)}"' if area.edge else ""
    return f'<polygon points="{points}" {ink.fill(area.fill)}{clear}{edge}/>'


def _mosaic(areas: list[Polygon], ink: Ink) -> str:
    """A path a colour, with the edges of its areas."""
    edge = areas[0].edge
    line = f' {ink.stroke(edge)} stroke-width="{_n(areas[0].edge_width)}"' if edge else ""
    paths = "".join(
        f'<path d="{"".join(map(_outline, outlines))}" fill="{colour or "none"}"/>'
        for colour, outlines in by_fill(areas).items()
    )
    return f"<g{line}>{paths}</g>"


def _outline(points: tuple[Point, ...]) -> str:
    """To a tenth of a point: no eye tells where an edge between tiles is more exactly."""
    tenths = [(round(10 * x), round(10 * y)) for x, y in points]
    (x, y), *_ = tenths
    steps = "".join(_tenths(b[0] - a[0]) + _tenths(b[1] - a[1]) for a, b in pairwise(tenths))
    return f"M{_tenths(x).strip()}{_tenths(y)}l{steps.strip()}z"


def _tenths(value: int) -> str:
    """As short as a path may have it, set off from what stands before."""
    text = f"{abs(value) / 10:g}".removeprefix("0") or "0"
    return f"-{text}" if value < 0 else f" {text}"


def _picture(picture: Picture, ink: Ink) -> str:
    box = picture.box
    place = (
        f'x="{_n(box.left)}" y="{_n(box.top)}" width="{_n(box.width)}" height="{_n(box.height)}" '
        'preserveAspectRatio="none"'
    )
    attributes = f' role="img" aria-label="{escape(picture.alt)}"' if picture.alt else ""
    if not ink.themed:
        data = picture.on_screen if ink.palette is SCREEN else picture.on_paper
        return f'<image {place}{attributes} href="{data_url(data)}"/>'
    to = f"translate({_n(box.left)} {_n(box.top)}) scale({_n(box.width)} {_n(box.height)})"
    names = [
        ink.shared.setdefault(data, f"p{len(ink.shared)}")
        for data in (picture.on_web or picture.on_screen, picture.on_web or picture.on_paper)
    ]
    if names[0] == names[1]:
        return f'<use href="#{names[0]}" transform="{to}"{attributes}/>'
    return (
        f'<use href="#{names[0]}" transform="{to}"{attributes} class="on-screen"/>'
        f'<use href="#{names[1]}" transform="{to}" class="on-paper"/>'
    )


def picture_store(shared: dict[bytes, str]) -> str:
    """Every picture of a page once, one unit wide and high."""
    images = "".join(
        f'<image id="{name}" width="1" height="1" preserveAspectRatio="none" '
        f'href="{data_url(data)}"/>'
        for data, name in shared.items()
    )
    return f'<svg class="store" aria-hidden="true"><defs>{images}</defs></svg>'


def data_url(data: bytes) -> str:
    kind = {b"\x89PNG": "png", b"RIFF": "webp"}.get(data[:4], "jpeg")
    return f"data:image/{kind};base64,{base64.b64encode(data).decode('ascii')}"


def _text(text: Text, ink: Ink) -> str:
    box = text.box
    x = {"left": box.left, "centre": box.left + box.width / 2, "right": box.right}[text.align]
    anchor = {"left": "start", "centre": "middle", "right": "end"}[text.align]
    if text.right_to_left:  # then a line starts at its right
        anchor = {"start": "end", "middle": "middle", "end": "start"}[anchor]
    shape = f' text-anchor="{anchor}"' if anchor != "start" else ""
    shape += ' direction="rtl"' if text.right_to_left else ""
    lines = []
    for k, line in enumerate(text.lines):
        words = "".join(_run(run.text, run.bold, run.italic) for run in line)
        kept = ' xml:space="preserve"' if "  " in words else ""
        lines.append(
            f'<text x="{_n(x)}" y="{_n(text.baseline(k))}" font-size="{_n(text.size)}" '
            f"{ink.fill(text.colour)}{shape}{kept}>{words}</text>"
        )
    return "".join(lines)


def _run(words: str, bold: bool, italic: bool) -> str:
    style = (' font-weight="700"' if bold else "") + (' font-style="italic"' if italic else "")
    return f"<tspan{style}>{escape(words)}</tspan>" if style else escape(words)


def _n(value: float) -> str:
    """At most two decimals: a hundredth of a point."""
    return f"{value:.2f}".rstrip("0").rstrip(".").replace("-0", "0" if value > -0.005 else "-0")
