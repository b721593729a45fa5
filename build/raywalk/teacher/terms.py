"""The glossary on paper: all terms, as the site's page has them."""

from __future__ import annotations

from raywalk.slides.figure import Deck, Slide
from raywalk.slides.glossary_sheets import glossary_sheets
from raywalk.slides.handout import A4
from raywalk.slides.layout import Box
from raywalk.slides.words import say, words
from raywalk.slides.worksheet import BOTTOM, MARGIN, WIDE, numbered
from raywalk.terms.glossary import read_glossary


def glossary() -> Deck:
    """In the language that is spoken."""
    title, box = say("pages.glossary.title"), Box(MARGIN, MARGIN, WIDE, A4[1] - MARGIN - BOTTOM)
    sheets = glossary_sheets(read_glossary(words().code).terms, box)
    slides = [Slide(title, tuple(items), kind="worksheet") for items in sheets]
    return Deck("glossary", title, *A4, tuple(numbered(slides)), words().code)
