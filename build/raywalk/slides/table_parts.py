"""A table as lines, words, samples and swatches, for writers without tables of their own."""

from __future__ import annotations

from raywalk.slides.figure import Cell, Item, Line, Polygon, Run, Table, Text
from raywalk.slides.layout import Box

SAMPLE = 20.0  # of a ray's line
SAMPLE_ROOM = 26.0
SWATCH = 12.0
CELL_GAP = 6.0


def table_parts(table: Table) -> list[Item]:
    """Rules under the heading and between rows, and each cell's content."""
    items: list[Item] = []
    for k, row in enumerate(table.rows):
        top = table.box.top + k * table.row_height
        left = table.box.left
        for cell, width, align in zip(row, table.widths, table.align, strict=True):
            items += cell_parts(cell, Box(left, top, width, table.row_height), align, table.size)
            left += width
        if k + 1 < len(table.rows):
            y = top + table.row_height
            ends = ((table.box.left, y), (table.box.right, y))
            items.append(Line(*ends, "rule", 1.0 if k == 0 else 0.5, name="rule"))
    return items


def cell_parts(cell: Cell, box: Box, align: str, size: float) -> list[Item]:
    """What a cell holds, within its box."""
    items: list[Item] = []
    left, middle = box.left, box.top + box.height / 2
    if cell.sample:
        ends = ((left, middle), (left + SAMPLE, middle))
        items.append(Line(*ends, cell.sample, 2.2, cell.sample, name=cell.sample))
        left += SAMPLE_ROOM
    if cell.swatch:
        place = Box(box.right - SWATCH, middle - SWATCH / 2, SWATCH, SWATCH)
        items.append(Polygon(place.corners, cell.swatch, "rule", 0.75, name="swatch"))
    if cell.text:
        right = box.right - (CELL_GAP if align == "left" else 0)
        place = Box(left, box.top, right - left, box.height)
        runs = ((Run(cell.text, cell.bold),),)
        items.append(Text(place, runs, size, align=align, leading=box.height / size, name="cell"))
    return items
