"""Slides as PPTX: native shapes that can be edited, grouped, named, with alternative texts.

python-pptx keeps the package in order; the shapes' XML is written here, because one call of
its API a shape takes a hundred times as long.
"""

from __future__ import annotations

import io
import zipfile
from datetime import datetime
from html import escape
from typing import Any

from pptx import Presentation
from pptx.oxml import parse_xml
from pptx.util import Pt

from raywalk.slides.figure import (
    Cell,
    Deck,
    Dot,
    Group,
    Item,
    Line,
    Picture,
    Polygon,
    Run,
    Slide,
    Table,
    Text,
)
from raywalk.slides.layout import Box
from raywalk.slides.palette import SCREEN, Palette
from raywalk.slides.svg import HEAD_LONG
from raywalk.slides.table_parts import cell_parts

EMU = 12700  # in a point
NAMESPACES = (
    'xmlns:a="http://schemas.openxmlformats.org/drawingml/2006/main" '
    'xmlns:p="http://schemas.openxmlformats.org/presentationml/2006/main" '
    'xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"'
)
PRESET_DASH = {
    "solid": "solid", "dash": "dash", "long": "lgDash", "short": "sysDash", "dots": "sysDot",
    "dashdot": "dashDot", "hidden": "sysDash",
}  # fmt: skip
FONT = "Arial"
TITLE_ONLY = 5  # of the template's layouts
LONG_AGO = datetime(2020, 1, 1)  # every file's date: the same slides are the same bytes
ALIGN = {"left": "l", "centre": "ctr", "right": "r"}


def deck_pptx(deck: Deck, palette: Palette) -> bytes:
    """A presentation whose notes hold what is said."""
    shown = Presentation()
    shown.slide_width, shown.slide_height = Pt(deck.width), Pt(deck.height)
    for slide in deck.slides:
        _add(shown, slide, palette)
    about = shown.core_properties
    about.title, about.author, about.language = deck.title, "Raywalk", deck.language
    about.last_modified_by, about.created, about.modified = "Raywalk", LONG_AGO, LONG_AGO
    out = io.BytesIO()
    shown.save(out)
    return steady_zip(out.getvalue())


def steady_zip(data: bytes) -> bytes:
    """The same files with one date each, in one order."""
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(out, "w") as new:
        for name in sorted(old.namelist(), key=lambda each: (each != "[Content_Types].xml", each)):
            info = zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0))
            info.external_attr, info.create_system = 0o600 << 16, 3
            packed = name.endswith((".png", ".jpg", ".jpeg"))
            info.compress_type = zipfile.ZIP_STORED if packed else zipfile.ZIP_DEFLATED
            new.writestr(info, old.read(name), compresslevel=6)
    return out.getvalue()


def _add(shown: Any, slide: Slide, palette: Palette) -> None:
    made = shown.slides.add_slide(shown.slide_layouts[TITLE_ONLY])
    writer = _Writer(made, palette)
    tree = made.shapes._spTree
    for item in slide.items:
        for xml in writer.shapes(item):
            tree.append(parse_xml(xml))
    if not writer.has_title:
        made.shapes.title._element.getparent().remove(made.shapes.title._element)
    ground = palette["ground"][1:]
    made._element.cSld.insert(0, parse_xml(
        f"<p:bg {NAMESPACES}><p:bgPr>{_solid(ground)}<a:effectLst/></p:bgPr></p:bg>"
    ))  # fmt: skip
    if slide.notes:
        made.notes_slide.notes_text_frame.text = "\n".join(slide.notes)


class _Writer:
    """XML of one slide's shapes; numbers them."""

    def __init__(self, slide: Any, palette: Palette):
        self.slide, self.palette = slide, palette
        self.last = 100
        self.has_title = False

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
        told = f' descr="{escape(alt)}"' if alt else ""
        extra = {"Sp": "<p:cNvSpPr/>", "CxnSp": "<p:cNvCxnSpPr/>", "GrpSp": "<p:cNvGrpSpPr/>",
                 "Pic": '<p:cNvPicPr><a:picLocks noChangeAspect="0"/></p:cNvPicPr>',
                 "Box": '<p:cNvSpPr txBox="1"/>',
                 "GraphicFrame": "<p:cNvGraphicFramePr/>"}[kind]  # fmt: skip
        tag = "Sp" if kind == "Box" else kind
        return (
            f'<p:nv{tag}Pr><p:cNvPr id="{self.last}" name="{escape(name)}"{told}/>{extra}'
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
            f"{_place(box, flips)}{_preset('line')}"
            f'<a:ln w="{_emu(line.width)}">{_solid(self._hex(line.colour))}'
            f'<a:prstDash val="{PRESET_DASH[line.dash]}"/>'
            f"{head if line.arrow and long_enough else ''}</a:ln></p:spPr></p:cxnSp>"
        )

    def _polygon(self, area: Polygon) -> str:
        xs, ys = [p[0] for p in area.points], [p[1] for p in area.points]
        box = Box(min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys))
        steps = [
            f'<a:pt x="{_emu(x - box.left)}" y="{_emu(y - box.top)}"/>' for x, y in area.points
        ]
        path = f"<a:moveTo>{steps[0]}</a:moveTo>" + "".join(
            f"<a:lnTo>{step}</a:lnTo>" for step in steps[1:]
        )
        return (
            f"<p:sp {NAMESPACES}>{self._about(area.name)}<p:spPr>{_place(box)}"
            f'<a:custGeom><a:avLst/><a:pathLst><a:path w="{_emu(box.width)}" '
            f'h="{_emu(box.height)}">{path}<a:close/></a:path></a:pathLst></a:custGeom>'
            f"{self._fill(area.fill, area.opacity)}{self._edge(area.edge, area.edge_width)}"
            "</p:spPr></p:sp>"
        )

    def _dot(self, dot: Dot) -> str:
        r = dot.radius
        box = Box(dot.centre[0] - r, dot.centre[1] - r, 2 * r, 2 * r)
        return (
            f"<p:sp {NAMESPACES}>{self._about(dot.name)}<p:spPr>{_place(box)}{_preset('ellipse')}"
            f"{self._fill(dot.fill)}{self._edge(dot.edge, 1.0)}</p:spPr></p:sp>"
        )

    def _picture(self, picture: Picture) -> str:
        data = picture.on_screen if self.palette is SCREEN else picture.on_paper
        _, rid = self.slide.part.get_or_add_image_part(io.BytesIO(data))
        return (
            f"<p:pic {NAMESPACES}>{self._about(picture.name, picture.alt, 'Pic')}"
            f'<p:blipFill><a:blip r:embed="{rid}"/><a:stretch><a:fillRect/></a:stretch>'
            f"</p:blipFill><p:spPr>{_place(picture.box)}{_preset('rect')}</p:spPr></p:pic>"
        )

    def _title(self, text: Text) -> str:
        """Into the layout's own place for it: outlines and screen readers look there."""
        self.has_title = True
        made = self.slide.shapes.title._element
        made.getparent().remove(made)
        self.last += 1
        return (
            f'<p:sp {NAMESPACES}><p:nvSpPr><p:cNvPr id="{self.last}" name="Title"/><p:cNvSpPr>'
            '<a:spLocks noGrp="1"/></p:cNvSpPr><p:nvPr><p:ph type="title"/></p:nvPr></p:nvSpPr>'
            f"<p:spPr>{_place(_wider(text))}</p:spPr>{self._body(text)}</p:sp>"
        )

    def _text(self, text: Text) -> str:
        return (
            f"<p:sp {NAMESPACES}>{self._about(text.name, kind='Box')}<p:spPr>{_place(_wider(text))}"
            f"{_preset('rect')}<a:noFill/></p:spPr>{self._body(text)}</p:sp>"
        )

    def _body(self, text: Text) -> str:
        wrap = "none" if len(text.lines) == 1 else "square"
        paragraphs = text.paragraphs or text.lines
        # As high as our line; PowerPoint counts in shares of the font's own line, 1.15 of the size.
        spacing = round(100_000 * text.leading / 1.15) if len(text.lines) > 1 else 100_000
        told = "".join(self._paragraph(runs, text, spacing) for runs in paragraphs)
        anchor = "ctr"
        return (
            f'<p:txBody><a:bodyPr wrap="{wrap}" lIns="0" tIns="0" rIns="0" bIns="0" '
            f'anchor="{anchor}"><a:noAutofit/></a:bodyPr><a:lstStyle/>{told}</p:txBody>'
        )

    def _paragraph(self, runs: tuple[Run, ...], text: Text, spacing: int) -> str:
        align = ALIGN[text.align]
        backwards = ' rtl="1"' if text.right_to_left else ""
        if text.right_to_left:  # there, "l" is where a line begins
            align = {"l": "r", "r": "l"}.get(align, align)
        told = "".join(self._run(run, text.size, text.colour) for run in runs)
        return (
            f'<a:p><a:pPr algn="{align}"{backwards} marL="0" indent="0"><a:lnSpc>'
            f'<a:spcPct val="{spacing}"/></a:lnSpc><a:spcBef><a:spcPts val="0"/></a:spcBef>'
            f"<a:buNone/></a:pPr>{told}</a:p>"
        )

    def _run(self, run: Run, size: float, colour: str) -> str:
        style = (' b="1"' if run.bold else ' b="0"') + (' i="1"' if run.italic else "")
        return (
            f'<a:r><a:rPr lang="en" sz="{round(100 * size)}"{style} dirty="0">'
            f'{_solid(self._hex(colour))}<a:latin typeface="{FONT}"/><a:cs typeface="{FONT}"/>'
            f"</a:rPr><a:t>{escape(run.text, quote=False)}</a:t></a:r>"
        )

    def _table(self, table: Table) -> list[str]:
        """A native table; samples of lines and swatches lie on it."""
        grid = "".join(f'<a:gridCol w="{_emu(w)}"/>' for w in table.widths)
        rows = "".join(self._table_row(table, k) for k in range(len(table.rows)))
        frame = (
            f"<p:graphicFrame {NAMESPACES}>{self._about(table.name, table.alt, 'GraphicFrame')}"
            f"{_place(table.box, tag='p:xfrm')}<a:graphic><a:graphicData "
            'uri="http://schemas.openxmlformats.org/drawingml/2006/table"><a:tbl>'
            f'<a:tblPr firstRow="1"/><a:tblGrid>{grid}</a:tblGrid>{rows}</a:tbl>'
            "</a:graphicData></a:graphic></p:graphicFrame>"
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

    def _table_row(self, table: Table, k: int) -> str:
        row = table.rows[k]
        # Words that say something of the whole table run over all its columns.
        spans = (
            len(row) if len(row) > 1 and k and not any(c.text or c.swatch for c in row[1:]) else 1
        )
        cells = []
        for column, (cell, align) in enumerate(zip(row, table.align, strict=True)):
            covered = spans > 1 and column > 0
            span = f' gridSpan="{spans}"' if spans > 1 and column == 0 else ""
            span = ' hMerge="1"' if covered else span
            cells.append(self._cell(cell, align, table.size, k, span, k + 1 == len(table.rows)))
        return f'<a:tr h="{_emu(table.row_height)}">{"".join(cells)}</a:tr>'

    def _cell(self, cell: Cell, align: str, size: float, row: int, span: str, is_last: bool) -> str:
        run = self._run(Run(cell.text, cell.bold), size, "ink") if cell.text else ""
        end = f'<a:endParaRPr sz="{round(100 * size)}"/>' if not cell.text else ""
        none = "".join(f"<a:{side}><a:noFill/></a:{side}>" for side in ("lnL", "lnR", "lnT"))
        rule = _solid(self._hex("rule"))
        width = _emu(1.0 if row == 0 else 0.5)
        below = "<a:lnB><a:noFill/></a:lnB>" if is_last else f'<a:lnB w="{width}">{rule}</a:lnB>'
        left = _emu(26.0) if cell.sample else 0
        return (
            f'<a:tc{span}><a:txBody><a:bodyPr wrap="none"/><a:lstStyle/><a:p>'
            f'<a:pPr algn="{ALIGN[align]}"/>{run}{end}</a:p></a:txBody>'
            f'<a:tcPr marL="{left}" marR="0" marT="0" marB="0" '
            f'anchor="ctr">{none}{below}<a:noFill/></a:tcPr></a:tc>'
        )

    def _group(self, group: Group) -> list[str]:
        inner = [xml for item in group.items for xml in self.shapes(item)]
        if not inner:
            return []
        box = bounds(group)
        bare = "".join(xml.replace(f" {NAMESPACES}", "", 1) for xml in inner)
        about = self._about(group.name, group.alt if group.is_figure else "", "GrpSp")
        return [
            f"<p:grpSp {NAMESPACES}>{about}<p:grpSpPr>{_place(box, children=True)}</p:grpSpPr>"
            f"{bare}</p:grpSp>"
        ]

    def _hex(self, colour: str) -> str:
        return self.palette[colour][1:]

    def _fill(self, colour: str | None, opacity: float = 1.0) -> str:
        return _solid(self._hex(colour), opacity) if colour else "<a:noFill/>"

    def _edge(self, colour: str | None, width: float) -> str:
        if not colour:
            return "<a:ln><a:noFill/></a:ln>"
        return f'<a:ln w="{_emu(width)}">{_solid(self._hex(colour))}</a:ln>'


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
            box = _wider(item)
            return [(box.left, box.top), (box.right, box.bottom)]
    return [(item.box.left, item.box.top), (item.box.right, item.box.bottom)]


def _wider(text: Text) -> Box:
    """The text's box with a little room: where a line just fits, rounding must not break it."""
    box, room = text.box, 3.0
    left = {"left": 0.0, "centre": room / 2, "right": room}[text.align]
    high = len(text.lines) * text.size * text.leading
    return Box(box.left - left, box.top, box.width + room, max(high, 1.0))


def _place(box: Box, flips: str = "", tag: str = "a:xfrm", children: bool = False) -> str:
    off = f'x="{_emu(box.left)}" y="{_emu(box.top)}"'
    size = f'cx="{_emu(box.width)}" cy="{_emu(box.height)}"'
    inner = f"<a:chOff {off}/><a:chExt {size}/>" if children else ""
    return f"<{tag}{flips}><a:off {off}/><a:ext {size}/>{inner}</{tag}>"


def _preset(shape: str) -> str:
    return f'<a:prstGeom prst="{shape}"><a:avLst/></a:prstGeom>'


def _solid(hex_colour: str, opacity: float = 1.0) -> str:
    clear = f'<a:alpha val="{round(100_000 * opacity)}"/>' if opacity < 1 else ""
    return f'<a:solidFill><a:srgbClr val="{hex_colour}">{clear}</a:srgbClr></a:solidFill>'


def _emu(points: float) -> int:
    return round(points * EMU)
