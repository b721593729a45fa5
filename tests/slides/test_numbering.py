"""Every slide whose step shows rays says which of how many: "step 2 of 4 · ray 1 of 2"."""

from __future__ import annotations

import io
import re

from pptx import Presentation
from pypdf import PdfReader

from raywalk.slides.figure import Deck, Group, Slide, Text, flat
from raywalk.slides.html import deck_html
from raywalk.slides.palette import PRINT, SCREEN
from raywalk.slides.pdf import deck_pdf
from raywalk.slides.pptx import deck_pptx

PLACE = re.compile(r"step (\d+) of (\d+)(?: · rays? (\d+)(?: to (\d+))? of (\d+))?")


def place(slide: Slide) -> str:
    [words] = [t.words for t in flat(slide.items) if isinstance(t, Text) and t.name == "place"]
    return words


def test_steps_and_rays_are_numbered(deck: Deck, balls):
    """The steps in order; of a step's rays those that its figure shows, of the whole tree."""
    places = [place(s) for s in deck.slides if s.kind in ("step", "ray", "question", "answer")]
    count = [len(stop.rows) for stop in balls.lesson().stops]
    assert count[0] == 0 and count[1] == 2
    assert places[:5] == [
        "step 1 of 4",
        "step 2 of 4 · rays 1 to 2 of 2",
        f"step 3 of 4 · {'ray 1' if count[2] == 1 else f'rays 1 to {count[2]}'} of {count[2]}",
        "step 2 of 4 · ray 1 of 2",
        "step 2 of 4 · ray 2 of 2",
    ]
    assert places[5:] == ["step 4 of 4 · ray 1 of 1"] * 2


def test_a_rays_number_is_the_one_in_figure_and_table(deck: Deck):
    """The slide "ray 2 of 2" draws ray 2, and names it in its title and its groups."""
    second = next(s for s in deck.slides if s.kind == "ray" and place(s).endswith("ray 2 of 2"))
    assert second.title == "Ray 2 of 2: reflected"
    assert second.figure
    names = [item.name for item in second.figure.items if isinstance(item, Group)]
    assert "Ray 1, camera ray" in names and "Ray 2, reflected" in names
    first = next(s for s in deck.slides if s.kind == "ray")
    assert first.figure
    assert not any("Ray 2" in item.name for item in first.figure.items)


def test_the_number_is_in_every_format_and_in_the_notes(deck: Deck):
    """As text that can be searched, on the slide and where the speaker reads."""
    pages = PdfReader(io.BytesIO(deck_pdf(deck, PRINT))).pages
    shown = Presentation(io.BytesIO(deck_pptx(deck, SCREEN))).slides
    sections = deck_html(deck).split("<section ")[1:]
    numbered = 0
    for slide, page, made, section in zip(deck.slides, pages, shown, sections, strict=True):
        if slide.kind not in ("step", "ray", "question", "answer"):
            continue
        places = place(slide)
        assert PLACE.fullmatch(places)
        numbered += "ray" in places
        assert places in page.extract_text()
        assert places in [s.text_frame.text for s in made.shapes if s.has_text_frame]
        assert section.count(places) == 2  # drawn, and in the notes
        assert slide.notes[0] == places
        assert made.notes_slide.notes_text_frame.text.startswith(places)
    assert numbered >= 5
