"""A table's XML in PPTX: a native one, with its rules and margins."""

from __future__ import annotations

from html import escape

from raywalk.slides.figure import Cell, Run, Table
from raywalk.slides.palette import Palette
from raywalk.slides.pptx_text import ALIGN, run_xml
from raywalk.slides.pptx_xml import emu, solid
from raywalk.slides.table_parts import SAMPLE_ROOM

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
