"""A text's XML in PPTX: paragraphs that PowerPoint wraps as we did."""

from __future__ import annotations

import re
from dataclasses import replace
from html import escape

from raywalk.slides.figure import Run, Text
from raywalk.slides.layout import Box
from raywalk.slides.palette import Palette
from raywalk.slides.pptx_xml import solid

FONT = "Arial"
ALIGN = {"left": "l", "centre": "ctr", "right": "r"}


def text_body(text: Text, palette: Palette, language: str) -> str:
    wrap = "none" if len(text.lines) == 1 else "square"
    paragraphs = text.paragraphs or text.lines
    # As high as our line; PowerPoint counts in shares of the font's own line, 1.15 of the size.
    spacing = round(100_000 * text.leading / 1.15) if len(text.lines) > 1 else 100_000
    xml = "".join(_paragraph(runs, text, spacing, palette, language) for runs in paragraphs)
    # Its own wrapping may need a line less: what stands below is placed for ours.
    anchor = "ctr" if len(text.lines) == 1 or text.is_title else "t"
    return (
        f'<p:txBody><a:bodyPr wrap="{wrap}" lIns="0" tIns="0" rIns="0" bIns="0" '
        f'anchor="{anchor}"><a:noAutofit/></a:bodyPr><a:lstStyle/>{xml}</p:txBody>'
    )


def _paragraph(
    runs: tuple[Run, ...], text: Text, spacing: int, palette: Palette, language: str
) -> str:
    align = ALIGN[text.align]
    backwards = ' rtl="1"' if text.right_to_left else ""
    if text.right_to_left:  # there, "l" is where a line begins
        align = {"l": "r", "r": "l"}.get(align, align)
    kept = runs if text.is_title else tuple(replace(run, text=_kept(run.text)) for run in runs)
    xml = "".join(run_xml(run, text.size, palette[text.colour], language) for run in kept)
    return (
        f'<a:p><a:pPr algn="{align}"{backwards} marL="0" indent="0"><a:lnSpc>'
        f'<a:spcPct val="{spacing}"/></a:lnSpc><a:spcBef><a:spcPts val="0"/></a:spcBef>'
        f"<a:buNone/></a:pPr>{xml}</a:p>"
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
