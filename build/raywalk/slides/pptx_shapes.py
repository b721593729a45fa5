"""Items of the display list as PPTX shapes: native, grouped, named, with alternative texts.

The XML is written here, because one call of python-pptx's API a shape takes a hundred times as
long.
"""

from __future__ import annotations

import io
from dataclasses import replace
from html import escape
from typing import Any

from pptx.opc.constants import RELATIONSHIP_TYPE
from pptx.opc.packuri import PackURI
from pptx.parts.image import Image, ImagePart

from raywalk.slides.figure import Cell, Dot, Group, Item, Line, Picture, Point, Polygon, Table, Text
from raywalk.slides.layout import Box
from raywalk.slides.mosaic import by_fill, gathered
from raywalk.slides.palette import SCREEN, Palette
from raywalk.slides.pptx_body import Body
from raywalk.slides.pptx_text import (
    NAMESPACES,
    body_xml,
    emu,
    place,
    preset,
    solid,
    table_xml,
    text_body,
    wider,
)
from raywalk.slides.svg import HEAD_LONG
from raywalk.slides.table_parts import cell_parts
from raywalk.trace.kinds import SLIDES

PRESET_DASH: dict[str, str] = {
    "solid": "solid", "hidden": "sysDash", **{k: row["powerPoint"] for k, row in SLIDES.items()},
}  # fmt: skip

FINE = 20  # of an outline's own units in a point: short numbers, and no eye tells


class Pictures:
    """A presentation's pictures, each once. python-pptx would look for each through the whole
    package, which takes longer than all else where there are many slides."""

    def __init__(self, package: Any):
        self._package, self._parts = package, dict[bytes, ImagePart]()

    def part(self, data: bytes) -> ImagePart:
        """Of the package, where the picture is from now on."""
        if data not in self._parts:
            image = Image.from_file(io.BytesIO(data))
            name = PackURI(f"/ppt/media/image{len(self._parts) + 1}.{image.ext}")
            self._parts[data] = ImagePart(name, image.content_type, self._package, image.blob)
        return self._parts[data]


class ShapeWriter:
    """XML of one slide's shapes; numbers them."""

    def __init__(self, slide: Any, palette: Palette, language: str, pictures: Pictures):
        self.slide, self.palette, self.language = slide, palette, language
        self.pictures = pictures
        self.last = 100

    def shapes(self, item: Item) -> list[str]:
        """One shape, or those of which the item is made."""
        match item:
            case Line():
                return [self._line(item)]
            case Polygon():
                return [self._polygon(item)]
            case Dot():
                return [self._dot(item)]
            case Picture():
                return [self._picture(item)]
            case Text():
                return [self._title(item) if item.is_title else self._text(item)]
            case Table():
                return self._table(item)
            case Group():
                return self._group(item)

    def _about(self, name: str, alt: str = "", kind: str = "Sp") -> str:
        self.last += 1
        description = f' descr="{escape(alt)}"' if alt else ""
        extra = {"Sp": "<p:cNvSpPr/>", "CxnSp": "<p:cNvCxnSpPr/>", "GrpSp": "<p:cNvGrpSpPr/>",
                 "Pic": '<p:cNvPicPr><a:picLocks noChangeAspect="0"/></p:cNvPicPr>',
                 "Box": '<p:cNvSpPr txBox="1"/>',
                 "GraphicFrame": "<p:cNvGraphicFramePr/>"}[kind]  # fmt: skip
        tag = "Sp" if kind == "Box" else kind
        return (
            f'<p:nv{tag}Pr><p:cNvPr id="{self.last}" name="{escape(name)}"{description}/>{extra}'
            f"<p:nvPr/></p:nv{tag}Pr>"
        )

    def _line(self, line: Line) -> str:
        (x1, y1), (x2, y2) = line.start, line.end
        flips = (' flipH="1"' if x2 < x1 else "") + (' flipV="1"' if y2 < y1 else "")
        box = Box(min(x1, x2), min(y1, y2), abs(x2 - x1), abs(y2 - y1))
        head = '<a:tailEnd type="triangle" w="med" len="med"/>'
        long_enough = abs(x2 - x1) + abs(y2 - y1) > HEAD_LONG * line.width
        return (
            f"<p:cxnSp {NAMESPACES}>{self._about(line.name, kind='CxnSp')}<p:spPr>"
            f"{place(box, flips)}{preset('line')}"
            f'<a:ln w="{emu(line.width)}">{solid(self._hex(line.colour))}'
            f'<a:prstDash val="{PRESET_DASH[line.dash]}"/>'
            f"{head if line.arrow and long_enough else ''}</a:ln></p:spPr></p:cxnSp>"
        )

    def _mosaic(self, areas: list[Polygon]) -> list[str]:
        """A shape a colour: hundreds of tiles one by one would be slow to open and to edit."""
        first = areas[0]
        return [
            self._outlines(replace(first, fill=colour, name=colour or first.name), outlines)
            for colour, outlines in by_fill(areas).items()
        ]

    def _polygon(self, area: Polygon) -> str:
        return self._outlines(area, [area.points])

    def _outlines(self, area: Polygon, outlines: list[tuple[Point, ...]]) -> str:
        """One shape of one or more outlines, in the style of an area."""
        xs, ys = ([p[k] for points in outlines for p in points] for k in (0, 1))
        box = Box(min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys))
        path = ""
        for points in outlines:
            steps = [
                f'<a:pt x="{round(FINE * (x - box.left))}" y="{round(FINE * (y - box.top))}"/>'
                for x, y in points
            ]
            path += f"<a:moveTo>{steps[0]}</a:moveTo>"
            path += "".join(f"<a:lnTo>{step}</a:lnTo>" for step in steps[1:]) + "<a:close/>"
        return (
            f"<p:sp {NAMESPACES}>{self._about(area.name)}<p:spPr>{place(box)}"
            f'<a:custGeom><a:avLst/><a:pathLst><a:path w="{round(FINE * box.width)}" '
            f'h="{round(FINE * box.height)}">{path}</a:path></a:pathLst></a:custGeom>'
            f"{self._fill(area.fill, area.opacity)}{self._edge(area.edge, area.edge_width)}"
            "</p:spPr></p:sp>"
        )

    def _dot(self, dot: Dot) -> str:
        r = dot.radius
        box = Box(dot.centre[0] - r, dot.centre[1] - r, 2 * r, 2 * r)
        return (
            f"<p:sp {NAMESPACES}>{self._about(dot.name)}<p:spPr>{place(box)}{preset('ellipse')}"
            f"{self._fill(dot.fill)}{self._edge(dot.edge, 1.0)}</p:spPr></p:sp>"
        )

    def _picture(self, picture: Picture) -> str:
        data = picture.on_screen if self.palette is SCREEN else picture.on_paper
        rid = self.slide.part.relate_to(self.pictures.part(data), RELATIONSHIP_TYPE.IMAGE)
        return (
            f"<p:pic {NAMESPACES}>{self._about(picture.name, picture.alt, 'Pic')}"
            f'<p:blipFill><a:blip r:embed="{rid}"/><a:stretch><a:fillRect/></a:stretch>'
            f"</p:blipFill><p:spPr>{place(picture.box)}{preset('rect')}</p:spPr></p:pic>"
        )

    def _title(self, text: Text) -> str:
        """Into the layout's own place for it: outlines and screen readers look there."""
        return self._placed("Title", 'type="title"', wider(text), self._body(text))

    def body(self, body: Body) -> str:
        """The same for the slide's words."""
        words = body_xml(body, self.palette, self.language)
        return self._placed("words", 'type="body" idx="1"', body.box, words)

    def _placed(self, name: str, kind: str, box: Box, words: str) -> str:
        self.last += 1
        return (
            f'<p:sp {NAMESPACES}><p:nvSpPr><p:cNvPr id="{self.last}" name="{name}"/><p:cNvSpPr>'
            f'<a:spLocks noGrp="1"/></p:cNvSpPr><p:nvPr><p:ph {kind}/></p:nvPr></p:nvSpPr>'
            f"<p:spPr>{place(box)}</p:spPr>{words}</p:sp>"
        )

    def _text(self, text: Text) -> str:
        return (
            f"<p:sp {NAMESPACES}>{self._about(text.name, kind='Box')}<p:spPr>{place(wider(text))}"
            f"{preset('rect')}<a:noFill/></p:spPr>{self._body(text)}</p:sp>"
        )

    def _body(self, text: Text) -> str:
        return text_body(text, self.palette, self.language)

    def _table(self, table: Table) -> list[str]:
        """A native table; samples of lines and swatches lie on it."""
        frame = (
            f"<p:graphicFrame {NAMESPACES}>{self._about(table.name, table.alt, 'GraphicFrame')}"
            f"{place(table.box, tag='p:xfrm')}"
            f"{table_xml(table, self.palette, self.language)}</p:graphicFrame>"
        )
        signs: list[Item] = []
        for k, row in enumerate(table.rows):
            left, top = table.box.left, table.box.top + k * table.row_height
            for cell, width in zip(row, table.widths, strict=True):
                sign = Cell(sample=cell.sample, swatch=cell.swatch)
                signs += cell_parts(
                    sign, Box(left, top, width, table.row_height), "left", table.size
                )
                left += width
        return [frame, *(xml for sign in signs for xml in self.shapes(sign))]

    def _group(self, group: Group) -> list[str]:
        inner = [
            xml
            for part in gathered(group.items)
            for xml in (self._mosaic(part) if isinstance(part, list) else self.shapes(part))
        ]
        if not inner:
            return []
        box = bounds(group)
        bare = "".join(xml.replace(f" {NAMESPACES}", "", 1) for xml in inner)
        about = self._about(group.name, group.alt if group.is_figure else "", "GrpSp")
        return [
            f"<p:grpSp {NAMESPACES}>{about}<p:grpSpPr>{place(box, children=True)}</p:grpSpPr>"
            f"{bare}</p:grpSp>"
        ]

    def _hex(self, colour: str) -> str:
        return self.palette[colour][1:]

    def _fill(self, colour: str | None, opacity: float = 1.0) -> str:
        return solid(self._hex(colour), opacity) if colour else "<a:noFill/>"

    def _edge(self, colour: str | None, width: float) -> str:
        if not colour:
            return "<a:ln><a:noFill/></a:ln>"
        return f'<a:ln w="{emu(width)}">{solid(self._hex(colour))}</a:ln>'


def bounds(group: Group) -> Box:
    """The box round everything in a group."""
    corners = [corner for item in group.items for corner in _corners(item)]
    left, top = min(x for x, _ in corners), min(y for _, y in corners)
    return Box(left, top, max(x for x, _ in corners) - left, max(y for _, y in corners) - top)


def _corners(item: Item) -> list[tuple[float, float]]:
    match item:
        case Line():
            return [item.start, item.end]
        case Polygon():
            return list(item.points)
        case Dot():
            (x, y), r = item.centre, item.radius
            return [(x - r, y - r), (x + r, y + r)]
        case Group():
            return [corner for part in item.items for corner in _corners(part)]
        case Text():
            box = wider(item)
            return [(box.left, box.top), (box.right, box.bottom)]
    return [(item.box.left, item.box.top), (item.box.right, item.box.bottom)]
