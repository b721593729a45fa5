"""Handouts: two, three or six slides on a sheet of A4, with lines for notes; then the glossary."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from reportlab.pdfgen.canvas import Canvas

from raywalk.slides.figure import Deck, Group
from raywalk.slides.glossary_sheets import glossary_sheets
from raywalk.slides.layout import Box
from raywalk.slides.palette import PRINT
from raywalk.slides.pdf import draw_slide, finished, font, new_canvas
from raywalk.slides.repeats import repeated_groups
from raywalk.slides.words import say
from raywalk.terms.glossary import Term

A4 = (595.28, 841.89)
MARGIN, TOP, BOTTOM = 42.0, 60.0, 46.0
GAP = 18.0
LINE = 22.0  # from one line for notes to the next
SHARP = 120 / 72  # pixels a point of paper: lines and words are sharper than their pale views


def handout_pdf(deck: Deck, per_sheet: int, terms: Sequence[Term] = ()) -> bytes:
    """per_sheet: 2 (lines below each slide), 3 (beside it) or 6 (below, in two columns). terms: of
    the glossary, which stand on sheets of their own at the end."""
    canvas, out = new_canvas(say("slides.handout", title=deck.title), deck.language, A4)
    sheets = -(-len(deck.slides) // per_sheet)
    wide, high = A4[0] - 2 * MARGIN, A4[1] - TOP - BOTTOM
    repeated = repeated_groups(slide.items for slide in deck.slides)
    glossary = list(glossary_sheets(terms, Box(MARGIN, TOP, wide, high)))
    for sheet in range(sheets):
        _heading(canvas, deck, sheet + 1, sheets + len(glossary))
        part = deck.slides[sheet * per_sheet : (sheet + 1) * per_sheet]
        for place, slide in zip(_places(per_sheet), part, strict=False):
            _slide(canvas, deck, slide.items, place, per_sheet == 3, repeated)
        canvas.showPage()
    for count, items in enumerate(glossary, start=sheets + 1):
        _heading(canvas, deck, count, sheets + len(glossary))
        draw_slide(canvas, tuple(items), replace(deck, width=A4[0], height=A4[1]), PRINT, SHARP)
        canvas.showPage()
    return finished(canvas, out)


def _heading(canvas: Canvas, deck: Deck, sheet: int, of: int) -> None:
    canvas.setFillColor(PRINT["soft"])
    canvas.setFont(font(), 11)
    canvas.drawString(MARGIN, A4[1] - 36, deck.title)
    canvas.drawRightString(A4[0] - MARGIN, A4[1] - 36, say("slides.sheetOf", sheet=sheet, of=of))


def _places(per_sheet: int) -> list[Box]:
    """Boxes for a slide with its lines, y down."""
    columns = 2 if per_sheet == 6 else 1
    rows = per_sheet // columns
    wide = (A4[0] - 2 * MARGIN - (columns - 1) * GAP) / columns
    high = (A4[1] - TOP - BOTTOM - (rows - 1) * GAP) / rows
    return [
        Box(MARGIN + column * (wide + GAP), TOP + row * (high + GAP), wide, high)
        for row in range(rows)
        for column in range(columns)
    ]


def _slide(
    canvas: Canvas, deck: Deck, items: tuple, place: Box, beside: bool,
    repeated: Mapping[Group, str],
) -> None:  # fmt: skip
    """A slide scaled into its part of the place, lines in the rest."""
    if beside:
        frame_wide, frame_high = place.width * 0.56, place.height
    else:
        frame_wide, frame_high = place.width, place.height - 3 * LINE
    scale = min(frame_wide / deck.width, frame_high / deck.height)
    wide, high = deck.width * scale, deck.height * scale
    bottom = A4[1] - place.top - high
    canvas.saveState()
    canvas.translate(place.left, bottom)
    canvas.scale(scale, scale)
    path = canvas.beginPath()
    path.rect(0, 0, deck.width, deck.height)
    canvas.clipPath(path, stroke=0, fill=0)
    draw_slide(canvas, items, deck, PRINT, SHARP * scale, repeated)
    canvas.restoreState()
    canvas.setStrokeColor(PRINT["rule"])
    canvas.setLineWidth(0.75)
    canvas.rect(place.left, bottom, wide, high)
    left, top = (place.left + wide + GAP, place.top) if beside else (place.left, place.top + high)
    until = place.top + (high if beside else place.height)
    y = top + LINE
    while y <= until + 0.1:
        canvas.line(left, A4[1] - y, place.right, A4[1] - y)
        y += LINE
