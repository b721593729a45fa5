"""DrawingML as text: places, fills, paragraphs that PowerPoint wraps as we did, native tables with
their rules and margins. Lengths are points, written as EMU."""

from __future__ import annotations

import re
from dataclasses import replace
from html import escape
from typing import NamedTuple

from raywalk.slides.figure import Cell, Run, Table, Text
from raywalk.slides.layout import Box
from raywalk.slides.palette import Palette
from raywalk.slides.pptx_body import Body
from raywalk.slides.table_parts import SAMPLE_ROOM

EMU = 12700  # in a point
NAMESPACES = (
    'xmlns:a="http://schemas.openxmlformats.org/drawingml/2006/main" '
    'xmlns:p="http://schemas.openxmlformats.org/presentationml/2006/main" '
    'xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"'
)


def place(box: Box, flips: str = "", tag: str = "a:xfrm", children: bool = False) -> str:
    off = f'x="{emu(box.left)}" y="{emu(box.top)}"'
    size = f'cx="{emu(box.width)}" cy="{emu(box.height)}"'
    inner = f"<a:chOff {off}/><a:chExt {size}/>" if children else ""
    return f"<{tag}{flips}><a:off {off}/><a:ext {size}/>{inner}</{tag}>"


def preset(shape: str) -> str:
    return f'<a:prstGeom prst="{shape}"><a:avLst/></a:prstGeom>'


def solid(hex_colour: str, opacity: float = 1.0) -> str:
    clear = f'<a:alpha val="{round(100_000 * opacity)}"/>' if opacity < 1 else ""
    return f'<a:solidFill><a:srgbClr val="{hex_colour}">{clear}</a:srgbClr></a:solidFill>'


def emu(points: float) -> int:
    return round(points * EMU)


FONT = "Arial"
ALIGN = {"left": "l", "centre": "ctr", "right": "r"}


def text_body(text: Text, palette: Palette, language: str) -> str:
    wrap = "none" if len(text.lines) == 1 else "square"
    paragraphs = text.paragraphs or text.lines
    # As high as our line; PowerPoint counts in shares of the font's own line, 1.15 of the size.
    spacing = round(100_000 * text.leading / 1.15) if len(text.lines) > 1 else 100_000
    style = _Style(palette, language, spacing)
    xml = "".join(_paragraph(runs, text, style) for runs in paragraphs)
    # Its own wrapping may need a line less: what stands below is placed for ours.
    anchor = "ctr" if len(text.lines) == 1 or text.is_title else "t"
    return (
        f'<p:txBody><a:bodyPr wrap="{wrap}" lIns="0" tIns="0" rIns="0" bIns="0" '
        f'anchor="{anchor}"><a:noAutofit/></a:bodyPr><a:lstStyle/>{xml}</p:txBody>'
    )


def body_xml(body: Body, palette: Palette, language: str) -> str:
    """What the body's placeholder holds, a paragraph each, wrapped by PowerPoint."""
    xml = ""
    for text, bullet, before in body.paragraphs:
        style = _Style(palette, language, round(100_000 * text.leading / 1.15), before, bullet)
        style = style._replace(indent=text.box.left - body.box.left if bullet else 0.0)
        for runs in text.paragraphs or text.lines:
            xml += _paragraph(runs, text, style)
    return (
        '<p:txBody><a:bodyPr wrap="square" lIns="0" tIns="0" rIns="0" bIns="0" anchor="t">'
        f"<a:noAutofit/></a:bodyPr><a:lstStyle/>{xml}</p:txBody>"
    )


class _Style(NamedTuple):
    palette: Palette
    language: str
    spacing: int  # of lines, thousandths of a per cent
    before: float = 0.0  # points
    bullet: str = ""
    indent: float = 0.0  # points


def _paragraph(runs: tuple[Run, ...], text: Text, style: _Style) -> str:
    align = ALIGN[text.align]
    backwards = ' rtl="1"' if text.right_to_left else ""
    if text.right_to_left:  # there, "l" is where a line begins
        align = {"l": "r", "r": "l"}.get(align, align)
    kept = runs if text.is_title else tuple(replace(run, text=_kept(run.text)) for run in runs)
    is_sign = style.bullet == "•"
    if style.bullet and not is_sign:  # a number: PowerPoint's own would count by itself
        kept = (Run(style.bullet + "\t"), *kept)
    colour = style.palette[text.colour]
    xml = "".join(run_xml(run, text.size, colour, style.language) for run in kept)
    mark = f'<a:buFont typeface="{FONT}"/><a:buChar char="•"/>' if is_sign else "<a:buNone/>"
    edge = emu(style.indent)
    return (
        f'<a:p><a:pPr algn="{align}"{backwards} marL="{edge}" indent="{-edge}"><a:lnSpc>'
        f'<a:spcPct val="{style.spacing}"/></a:lnSpc><a:spcBef>'
        f'<a:spcPts val="{round(100 * style.before)}"/></a:spcBef>{mark}</a:pPr>{xml}</a:p>'
    )


def _kept(words: str) -> str:
    """A number keeps its per cent sign, by a space that never ends a line."""
    return re.sub(r"(?<=\d) (?=%)", "\N{NO-BREAK SPACE}", words)


def run_xml(run: Run, size: float, colour: str, language: str) -> str:
    style = (' b="1"' if run.bold else ' b="0"') + (' i="1"' if run.italic else "")
    return (
        f'<a:r><a:rPr lang="{language}" sz="{round(100 * size)}"{style} dirty="0">'
        f'{solid(colour[1:])}<a:latin typeface="{FONT}"/><a:cs typeface="{FONT}"/>'
        f"</a:rPr><a:t>{escape(run.text, quote=False)}</a:t></a:r>"
    )


def wider(text: Text) -> Box:
    """The text's box with a little room: where a line just fits, rounding must not break it."""
    box, room = text.box, 3.0
    left = {"left": 0.0, "centre": room / 2, "right": room}[text.align]
    high = len(text.lines) * text.size * text.leading
    return Box(box.left - left, box.top, box.width + room, max(high, 1.0))


TABLE_URI = "http://schemas.openxmlformats.org/drawingml/2006/table"


def table_xml(table: Table, palette: Palette, language: str) -> str:
    """What a graphic frame holds; samples of lines and swatches are laid on it as shapes."""
    grid = "".join(f'<a:gridCol w="{emu(w)}"/>' for w in table.widths)
    rows = "".join(_row(table, k, palette, language) for k in range(len(table.rows)))
    return (
        f'<a:graphic><a:graphicData uri="{escape(TABLE_URI)}"><a:tbl>'
        f'<a:tblPr firstRow="1"/><a:tblGrid>{grid}</a:tblGrid>{rows}</a:tbl>'
        "</a:graphicData></a:graphic>"
    )


def _row(table: Table, k: int, palette: Palette, language: str) -> str:
    row = table.rows[k]
    # Words that say something of the whole table run over all its columns.
    is_remark = len(row) > 1 and k and not any(cell.text or cell.swatch for cell in row[1:])
    below = _rule(k, k + 1 == len(table.rows), palette)
    cells = []
    for column, (cell, align) in enumerate(zip(row, table.align, strict=True)):
        span = "" if not is_remark else ' hMerge="1"' if column else f' gridSpan="{len(row)}"'
        run = run_xml(Run(cell.text, cell.bold), table.size, palette["ink"], language)
        cells.append(_cell(cell, align, run, table.size, span, below))
    return f'<a:tr h="{emu(table.row_height)}">{"".join(cells)}</a:tr>'


def _rule(row: int, is_last: bool, palette: Palette) -> str:
    if is_last:
        return "<a:lnB><a:noFill/></a:lnB>"
    return f'<a:lnB w="{emu(1.0 if row == 0 else 0.5)}">{solid(palette["rule"][1:])}</a:lnB>'


def _cell(cell: Cell, align: str, run: str, size: float, span: str, below: str) -> str:
    runs = run if cell.text else f'<a:endParaRPr sz="{round(100 * size)}"/>'
    none = "".join(f"<a:{side}><a:noFill/></a:{side}>" for side in ("lnL", "lnR", "lnT"))
    left = emu(SAMPLE_ROOM) if cell.sample else 0
    return (
        f'<a:tc{span}><a:txBody><a:bodyPr wrap="none"/><a:lstStyle/><a:p>'
        f'<a:pPr algn="{ALIGN[align]}"/>{runs}</a:p></a:txBody>'
        f'<a:tcPr marL="{left}" marR="0" marT="0" marB="0" '
        f'anchor="ctr">{none}{below}<a:noFill/></a:tcPr></a:tc>'
    )
