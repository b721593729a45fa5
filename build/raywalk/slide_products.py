"""A lesson's slides as files: what `make` publishes, and what `raywalk slides` writes on demand."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterator
from pathlib import Path

from raywalk.slide_pipeline import KEPT, REMARKS
from raywalk.slides.deck import Sources, course_of, lesson_slides, scene_deck
from raywalk.slides.figure import Deck, Picture, Slide
from raywalk.slides.handout import PER_SHEET, handout_pdf
from raywalk.slides.html import deck_html
from raywalk.slides.layout import Layout
from raywalk.slides.palette import PRINT, SCREEN, Palette
from raywalk.slides.pdf import MissingGlyphs, deck_pdf
from raywalk.slides.pptx import deck_pptx
from raywalk.slides.step_slide import Lesson
from raywalk.slides.svg import standalone
from raywalk.slides.worksheet import worksheet

# What is published: paper's colours in PDF, the screen's in PPTX, both in HTML.
DECK_FORMATS = ("html", "pdf", "pptx")
SHEET_FORMATS = tuple(f"handout-{count}" for count in PER_SHEET)
LEGEND_HIGH = 42.0  # points under a figure, for its legend
LESSON_FORMATS = ("svg", "worksheet", "answers")
FORMATS = (*DECK_FORMATS, *SHEET_FORMATS, *LESSON_FORMATS)
PUBLISHED = FORMATS


def write_scene_slides(sources: Sources, layout: Layout, folder: Path) -> None:
    """Every published file of a scene, and its slides for the course."""
    lesson = sources.lesson(layout)
    deck = scene_deck(sources, layout, lesson=lesson)
    write_files(folder, deck, PUBLISHED, lesson)
    (folder / KEPT).write_bytes(pickle.dumps(lesson_slides(lesson), protocol=5))


def write_course_slides(
    all_sources: list[Sources], kept: list[Path], layout: Layout, folder: Path
) -> None:
    """The course's deck. kept: the KEPT file of each scene."""
    lessons: list[list[Slide]] = [pickle.loads(path.read_bytes()) for path in kept]
    deck = course_of(all_sources, lessons, layout)
    write_files(folder, deck, DECK_FORMATS, None)


def write_files(
    folder: Path, deck: Deck, formats: tuple[str, ...], lesson: Lesson | None,
    palette: Palette | None = None, strict: bool = False,
) -> None:  # fmt: skip
    """Each format as a file. Where the font lacks a letter there is no PDF, and REMARKS says why;
    strict: raises MissingGlyphs instead."""
    remarks: dict[str, None] = {}
    for format in formats:
        try:
            for name, data in deck_files(deck, (format,), palette, lesson):
                (folder / name).write_bytes(data)
        except MissingGlyphs as lost:
            if strict:
                raise
            remarks[str(lost)] = None
    if remarks:
        (folder / REMARKS).write_text("\n".join(remarks), encoding="utf-8")


def deck_files(
    deck: Deck, formats: tuple[str, ...], palette: Palette | None, lesson: Lesson | None
) -> Iterator[tuple[str, bytes]]:
    """Name and content; without a palette each format has the one it is published in.

    Raises MissingGlyphs for PDF.
    """
    makers: dict[str, Callable[[], bytes]] = {
        "html": lambda: deck_html(deck).encode(),
        "pdf": lambda: deck_pdf(deck, palette or PRINT),
        "pptx": lambda: deck_pptx(deck, palette or SCREEN),
    }
    for name in formats:
        if name in makers:
            yield f"{deck.id}.{name}", makers[name]()
        elif name in SHEET_FORMATS:
            yield f"{deck.id}-{name}.pdf", handout_pdf(deck, int(name[-1]))
        elif name in ("worksheet", "answers") and lesson:
            sheet = worksheet(lesson, with_answers=name == "answers")
            yield f"{deck.id}-{name}.pdf", deck_pdf(sheet, PRINT)
        elif name == "svg":
            yield from _figures(deck, palette or PRINT)


def _figures(deck: Deck, palette: Palette) -> Iterator[tuple[str, bytes]]:
    """Each step's figure with its legend, as deck-step-NN.svg in the lesson's order."""
    figures = [slide.figure for slide in deck.slides if slide.figure]
    for count, figure in enumerate(figures, start=1):
        view = figure.items[0]
        assert isinstance(view, Picture)
        frame = view.box._replace(height=view.box.height + LEGEND_HIGH)
        text = standalone([figure], frame, palette, f"{deck.title} {count}", figure.alt)
        yield f"{deck.id}-figure-{count:02}.svg", text.encode()
