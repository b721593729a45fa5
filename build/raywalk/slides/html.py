"""A deck as one HTML file: dark on the screen, on paper a slide a page in printer's colours."""

from __future__ import annotations

import base64
import hashlib
from html import escape

from raywalk.slides.figure import Deck, Group, Slide
from raywalk.slides.palette import PRINT, SCREEN
from raywalk.slides.svg import inline, picture_store, theme_rules
from raywalk.slides.words import say

SHEET = """
html{{color-scheme:dark;background:#05070a;color:{ink}}}
html{{font:16px/1.5 Arial,"Liberation Sans",Helvetica,sans-serif}}
body{{margin:0;padding:16px}}
section{{max-width:min(1280px,calc((100vh - 32px)*{aspect}));margin:0 auto 24px}}
svg{{display:block;width:100%;height:auto;background:{ground};border-radius:8px}}
svg.store{{position:absolute;width:0;height:0}}
.on-paper{{display:none}}
details{{margin:8px 4px;color:{soft}}}
summary{{min-height:44px;line-height:44px;cursor:pointer}}
details p{{margin:0 0 8px}}
:focus-visible{{outline:3px solid {accent};outline-offset:2px}}
"""
PAPER = """
@media print{{@page{{size:{width}pt {height}pt;margin:0}}
html,body{{background:#fff;color-scheme:light;padding:0;margin:0}}
section{{max-width:none;margin:0;width:{width}pt;height:{height}pt;break-after:page;break-inside:avoid;overflow:hidden}}
svg{{background:#fff;border-radius:0}}
details,.on-screen{{display:none}}.on-paper{{display:inline}}}}
"""


def deck_html(deck: Deck) -> str:
    """The whole page; its policy allows its own style sheet and nothing else."""
    sheet, notes_word = _sheet(deck), say("slides.notes")
    digest = base64.b64encode(hashlib.sha256(sheet.encode()).digest()).decode("ascii")
    policy = f"default-src 'none'; img-src data:; style-src 'sha256-{digest}'; base-uri 'none'"
    shared, groups = dict[bytes, str](), dict[Group, str]()
    slides = "\n".join(
        _section(deck, slide, k, notes_word, (shared, groups))
        for k, slide in enumerate(deck.slides, start=1)
    )
    return (
        f'<!doctype html>\n<html lang="{deck.language}">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape(deck.title)} · Raywalk</title>\n"
        f'<link rel="icon" href="data:,">\n<style>{sheet}</style>\n</head>\n<body>\n<main>\n'
        f"{picture_store(shared)}\n{slides}\n</main>\n</body>\n</html>\n"
    )


def _sheet(deck: Deck) -> str:
    sizes = {"width": f"{deck.width:g}", "height": f"{deck.height:g}"}
    screen = SHEET.format(aspect=f"{deck.width / deck.height:.4f}", **_plain(SCREEN.colours))
    themed = f"@media screen{{{theme_rules(SCREEN)}}}"
    paper = f"@media print{{{theme_rules(PRINT)}}}"
    return screen + themed + paper + PAPER.format(**sizes)


def _plain(colours: dict[str, str]) -> dict[str, str]:
    return {role: colours[role] for role in ("ink", "soft", "ground", "accent")}


def _section(
    deck: Deck, slide: Slide, number: int, notes_word: str,
    had: tuple[dict[bytes, str], dict[Group, str]],
) -> str:  # fmt: skip
    paragraphs = "".join(f"<p>{escape(note)}</p>" for note in slide.notes)
    notes = f"<details><summary>{notes_word}</summary>{paragraphs}</details>" if paragraphs else ""
    drawing = inline(slide.items, deck.width, deck.height, *had)
    name = escape(f"{number}: {slide.title}")
    return f'<section id="s{number}" aria-label="{name}">{drawing}{notes}</section>'
