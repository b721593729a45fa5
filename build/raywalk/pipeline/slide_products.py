"""A lesson's slides as files: what `make` publishes, and what `raywalk slides` writes on demand."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

from raywalk.errors import SourceError
from raywalk.scene.model import Scene
from raywalk.scene.translation import translation_file
from raywalk.scene.wording import key_path
from raywalk.slides.deck import Sources, course_of, lesson_slides, scene_deck
from raywalk.slides.figure import Deck, Picture, Slide
from raywalk.slides.formats import (
    COURSE_FORMATS,
    KEPT,
    PUBLISHED,
    REMARKS,
    SHEET_FORMATS,
    TRANSLATED,
)
from raywalk.slides.glossary_sheets import lesson_terms
from raywalk.slides.handout import handout_pdf
from raywalk.slides.html import deck_html
from raywalk.slides.layout import Layout
from raywalk.slides.palette import PRINT, SCREEN, Palette
from raywalk.slides.pdf import MissingGlyphs, deck_pdf
from raywalk.slides.pptx import deck_pptx
from raywalk.slides.step_slide import Lesson
from raywalk.slides.svg import standalone
from raywalk.slides.words import speaking, words
from raywalk.slides.worksheet import worksheet
from raywalk.words.catalogue import DEFAULT


def write_scene_slides(
    sources: Sources, layout: Layout, folder: Path, language: str = DEFAULT
) -> None:
    """Every published file of a scene, and its slides for the course."""
    with speaking(language):
        lesson = sources.lesson(layout)
        slides = lesson_slides(lesson)
        deck = scene_deck(sources, layout, lesson=lesson, slides=slides)
        formats = PUBLISHED if language == DEFAULT else TRANSLATED
        write_files(folder, deck, formats, lesson, [sources.scene])
    (folder / KEPT).write_bytes(pickle.dumps(slides, protocol=5))


def write_course_slides(
    all_sources: list[Sources], kept: list[Path], layout: Layout, folder: Path,
    language: str = DEFAULT,
) -> None:  # fmt: skip
    """The course's deck. kept: the KEPT file of each scene."""
    lessons: list[list[Slide]] = [pickle.loads(path.read_bytes()) for path in kept]
    with speaking(language):
        deck = course_of(all_sources, lessons, layout)
        write_files(folder, deck, COURSE_FORMATS, None, [each.scene for each in all_sources])


def write_files(
    folder: Path, deck: Deck, formats: tuple[str, ...], lesson: Lesson | None,
    scenes: list[Scene], palette: Palette | None = None, strict: bool = False,
) -> None:  # fmt: skip
    """Each format as a file. Where the font lacks a letter there is no PDF, and REMARKS says why;
    strict: raises MissingGlyphs instead."""
    lost_letters: set[str] = set()
    for format in formats:
        try:
            for name, data in deck_files(deck, (format,), palette, lesson):
                (folder / name).write_bytes(data)
        except MissingGlyphs as lost:
            if strict:
                raise
            lost_letters |= set(lost.characters)
    if lost_letters:
        problem = missing_letters(scenes, sorted(lost_letters))
        (folder / REMARKS).write_text(str(problem), encoding="utf-8")


def missing_letters(scenes: list[Scene], characters: list[str]) -> SourceError:
    """Where the first of the characters stands that the PDFs' font has not, and what to do."""
    named = ", ".join(f"{c} (U+{ord(c):04X})" for c in characters[:8])
    language = words().code
    for scene in scenes:
        file = scene.path if language == DEFAULT else translation_file(scene, language)
        for key, step, text in _written(scene):
            if any(c in text for c in characters):
                return _no_letters(file, key, step, named)
    return _no_letters(scenes[0].path, "", "", named)


def _written(scene: Scene) -> Iterator[tuple[str, str, str]]:
    """Each text of a scene that slides show: its key, "step 2: " where it is a step's, the text."""
    yield "title", "", scene.title
    yield "teaches", "", scene.teaches
    for k, step in enumerate(scene.lesson):
        for place, (text, _) in step.said().items():
            yield key_path(("lesson", k, *place)), f"step {k + 1}: ", text
    for k, obj in enumerate(scene.objects):
        yield f"objects[{k}].name", "", obj.name
    for k, light in enumerate(scene.lights):
        yield f"lights[{k}].name", "", light.name


def _no_letters(file: Path, key: str, step: str, named: str) -> SourceError:
    return SourceError(
        file, key, f"{step}the font of PDF slides has no {named}",
        hint="use --format html,svg,pptx, which the reader's own fonts set; or write it in "
        "Latin, Greek, Cyrillic or Hebrew letters",
    )  # fmt: skip


def deck_files(
    deck: Deck, formats: tuple[str, ...], palette: Palette | None, lesson: Lesson | None
) -> Iterator[tuple[str, bytes]]:
    """Name and content; without a palette each format has the one it is published in: paper's
    colours in PDF, the screen's in PPTX, both in HTML.

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
            terms = lesson_terms(lesson.scene) if lesson else []
            yield f"{deck.id}-{name}.pdf", handout_pdf(on_paper(deck), int(name[-1]), terms)
        elif name in ("worksheet", "answers") and lesson:
            sheet = worksheet(lesson, with_answers=name == "answers")
            yield f"{deck.id}-{name}.pdf", deck_pdf(sheet, PRINT)
        elif name == "svg":
            yield from _figures(deck, palette or PRINT)


def on_paper(deck: Deck) -> Deck:
    """The deck without what builds a slide up: on a sheet its end says it all."""
    return replace(deck, slides=tuple(each for each in deck.slides if each.kind != "build"))


def _figures(deck: Deck, palette: Palette) -> Iterator[tuple[str, bytes]]:
    """Each step's figure, as deck-step-NN.svg in the lesson's order."""
    figures = [slide.figure for slide in deck.slides if slide.figure]
    for count, figure in enumerate(figures, start=1):
        view = figure.items[0]
        assert isinstance(view, Picture)
        text = standalone([figure], view.box, palette, f"{deck.title} {count}", figure.alt)
        yield f"{deck.id}-figure-{count:02}.svg", text.encode()
