"""Every slide whose step shows rays says which of how many: "step 2 of 4 · ray 1 of 2"."""

from __future__ import annotations

import io
import re
from itertools import pairwise

from pptx import Presentation
from pypdf import PdfReader

from raywalk.pipeline.slide_products import on_paper
from raywalk.slides.figure import Deck, Group, Slide, Text, flat
from raywalk.slides.html import deck_html
from raywalk.slides.palette import PRINT, SCREEN
from raywalk.slides.pdf import deck_pdf
from raywalk.slides.pptx import deck_pptx

PLACE = re.compile(r"step (\d+) of (\d+)|ray (\d+) of (\d+)")


def place(slide: Slide) -> str:
    [words] = [t.words for t in flat(slide.items) if isinstance(t, Text) and t.name == "place"]
    return words


def test_steps_and_rays_are_numbered(deck: Deck, balls):
    """The steps in order; before a step the rays that build it up, the last of which it shows."""
    slides = [s for s in deck.slides if s.kind in ("step", "question", "answer")]
    assert [place(s) for s in slides] == [f"step {k} of 4" for k in (1, 2, 3, 4, 4)]
    second = [place(s) for s in deck.slides if s.title == "The mirror sends the ray on."]
    count = len({(line.ray, line.light) for line in balls.lesson().stops[1].chosen})
    assert count > 2
    built = [f"ray {k} of {count}" for k in range(1, min(count, 5))]
    assert second[: len(built) + 1] == [*built, "step 2 of 4"]


def test_a_build_up_draws_each_ray_after_those_before_it(deck: Deck):
    """The camera ray first; each slide has the lines of the one before and one more."""
    built = [s for s in deck.slides if s.kind == "build" and s.title.startswith("The mirror")]
    drawn = []
    for slide in built:
        [figure] = [i for i in slide.items if isinstance(i, Group) and i.is_figure]
        drawn.append([i.name for i in figure.items if isinstance(i, Group) and "Ray " in i.name])
    assert drawn[0] == ["Ray 1, camera ray"] and "Ray 2, reflected" in drawn[1]
    assert all(len(more) == len(few) + 1 for few, more in pairwise(drawn))


def test_a_pixel_is_built_up_once_and_not_on_handouts(made):
    """Who has seen its rays come one by one need not see it again; on a sheet the end says all."""
    step = '[[lesson]]\ntext = "A."\nview = { resolution = 7, pixel = [2, 4] }\n'
    once, twice = (made(step * count).deck() for count in (1, 2))
    built = [len([s for s in deck.slides if s.kind == "build"]) for deck in (once, twice)]
    assert built[0] == built[1] > 0
    assert len(on_paper(twice).slides) == len(twice.slides) - built[1]


def test_the_number_is_in_every_format_and_in_the_notes(deck: Deck):
    """As text that can be searched, on the slide and where the speaker reads."""
    pages = PdfReader(io.BytesIO(deck_pdf(deck, PRINT))).pages
    shown = Presentation(io.BytesIO(deck_pptx(deck, SCREEN))).slides
    sections = deck_html(deck).split("<section ")[1:]
    numbered = 0
    for slide, page, made, section in zip(deck.slides, pages, shown, sections, strict=True):
        if slide.kind not in ("step", "build", "question", "answer"):
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
