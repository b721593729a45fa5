"""What several slides show alike stands once in a file, and is seen on each of them."""

from __future__ import annotations

import io
import re
from collections import Counter

from pypdf import PdfReader

from raywalk.slides.figure import Deck, Group, flat
from raywalk.slides.html import deck_html
from raywalk.slides.palette import PRINT
from raywalk.slides.pdf import deck_pdf
from raywalk.slides.repeats import MANY, is_large, repeated_groups


def shown(deck: Deck) -> Counter[Group]:
    """How often each large group is shown."""
    items = (item for slide in deck.slides for item in flat(slide.items))
    return Counter(item for item in items if isinstance(item, Group) and is_large(item))


def test_the_decks_tiles_are_repeated(deck):
    """7 x 7 tiles, on each slide that builds a step up."""
    repeated = repeated_groups(slide.items for slide in deck.slides)
    assert repeated and set(repeated) <= set(shown(deck))
    assert all(len(group.items) >= MANY for group in repeated)
    assert len(set(repeated.values())) == len(repeated)


def test_a_pdf_has_each_once_and_every_page_of_it_refers_there(deck):
    reader = PdfReader(io.BytesIO(deck_pdf(deck, PRINT)))
    forms: Counter[int] = Counter()
    for page in reader.pages:
        drawn = page.get_contents().get_data().decode("latin-1")
        for name, reference in (page["/Resources"].get("/XObject") or {}).items():
            if reference.get_object()["/Subtype"] == "/Form":
                uses = len(re.findall(rf"{name}\s+Do\b", drawn))
                forms[page["/Resources"]["/XObject"].raw_get(name).idnum] += uses
    counts = shown(deck)
    repeated = repeated_groups(slide.items for slide in deck.slides)
    assert sorted(forms.values()) == sorted(counts[group] for group in repeated)


def test_a_page_has_each_once_and_uses_name_what_is_there(deck):
    html = deck_html(deck)
    ids = re.findall(r'<g id="(g\d+)"', html)
    uses = re.findall(r'<use href="#(g\d+)"/>', html)
    assert len(ids) == len(set(ids)) == len(shown(deck))
    assert set(uses) <= set(ids) and len(ids) + len(uses) == sum(shown(deck).values())
