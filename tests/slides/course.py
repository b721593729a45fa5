"""The decks of the course's lessons as display lists, from what `make` left in .work."""

from __future__ import annotations

import io
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from PIL import Image
from tests.cases import EVERY

from raywalk.commands.slides import traced
from raywalk.pipeline.figures import filled_lessons
from raywalk.pipeline.scenes import translated
from raywalk.pipeline.site import in_all_languages
from raywalk.pipeline.slides import Plan, Source, plans_of, sources_of
from raywalk.pipeline.worked import FILE as WORKED
from raywalk.scene.read import read_scenes
from raywalk.site.scene_data import scene_words
from raywalk.slides import pictures
from raywalk.slides.deck import Sources, lesson_slides, scene_deck
from raywalk.slides.figure import Deck, Slide
from raywalk.slides.formats import SIGHTS
from raywalk.slides.layout import LAYOUTS, WIDE, Layout
from raywalk.slides.step_slide import Lesson
from raywalk.slides.words import speaking
from raywalk.stops.process import Stops
from raywalk.words import read_words
from raywalk.words.catalogue import DEFAULT
from raywalk.work.pool import Workers
from raywalk.work.store import Store

from .conftest import STOPS, last

ROOT = Path(__file__).parent.parent.parent
#: What the others share most with: German has the longer words, 4:3 the narrower lines.
HARDEST = ("de", "4:3")
#: And of every third lesson, and of those that a test asks for by name, this.
OTHER, EACH, NAMED = ("en", "16:9"), 3, {"03-two-lights", "08-glass"}


@dataclass(frozen=True, eq=False)
class CourseDeck:
    """One lesson's deck in one language and aspect."""

    language: str
    layout: Layout
    sources: Sources
    lesson: Lesson
    slides: list[Slide]  # the lesson's alone
    deck: Deck

    @property
    def name(self) -> str:
        return f"{self.language}/{self.deck.id} {self.layout.name}"


def _quickly(image: Image.Image, kind: str, **options: Any) -> bytes:
    """A picture's file as large as its encoder makes it in the least time: no law here is about its
    bytes, and to make them few is a quarter of all work."""
    out = io.BytesIO()
    image.save(out, kind, **options | {"optimize": False, "method": 0, "compress_level": 1})
    return out.getvalue()


#: Of a view all tell where words can be read on it; decks carry a sixteenth of them, for no
#: law here is about its pixels either.
_view_pixels = pictures.view_pixels


@cache
def course_decks() -> list[CourseDeck]:
    """Of every scene in two languages and aspects, or in all that there are."""
    with pytest.MonkeyPatch.context() as patch:
        if not EVERY:
            patch.setattr(pictures, "_file", _quickly)
            patch.setattr(pictures, "view_pixels", lambda view: _view_pixels(view)[::4, ::4])
        return _course_decks()


def _course_decks() -> list[CourseDeck]:
    store = Store(ROOT / ".work")
    with Workers() as workers:
        spoken = last(
            filled_lessons(store, in_all_languages(read_scenes(ROOT / "scenes")), workers)
        )
    decks = []
    for number, each in enumerate(spoken[DEFAULT]):
        source = last(traced(store, each.scene))
        sources = [
            replace(source, scene=scene, language=code)
            for code, scene in translated(each.scene, spoken).items()
        ]
        plans = last(plans_of(store, STOPS, sources))
        for plan, of in zip(plans, sources, strict=True):
            decks += [
                _deck(STOPS, plan, of, layout) for layout in LAYOUTS.values()
                if _is_asked(number, of.scene.id, (plan.language, layout.name))
            ]  # fmt: skip
    return decks


def _is_asked(number: int, id: str, kind: tuple[str, str]) -> bool:
    """Whether there is this deck of a lesson. number: its place in the course."""
    is_chosen = number % EACH == 0 or id in NAMED
    return EVERY or kind == HARDEST or (kind == OTHER and is_chosen)


def decks_of(id: str) -> list[CourseDeck]:
    """All of a lesson's."""
    own = [each for each in course_decks() if each.deck.id == id]
    assert {(each.language, each.layout.name) for each in own} >= {HARDEST}
    return own


def _deck(stops: Stops, plan: Plan, of: Source, layout: Layout) -> CourseDeck:
    with speaking(plan.language), TemporaryDirectory() as folder:
        sources = sources_of(plan)
        if layout is not WIDE:
            sources = _as_if_seen(stops, plan, of, layout, Path(folder))
        lesson = sources.lesson(layout)
        slides = lesson_slides(lesson)
        deck = scene_deck(sources, layout, lesson=lesson, slides=slides)
    return CourseDeck(plan.language, layout, sources, lesson, slides, deck)


def _as_if_seen(stops: Stops, plan: Plan, of: Source, layout: Layout, folder: Path) -> Sources:
    """In another aspect: the tracer is not asked anew, for what is hidden behind an object and the
    views alone would differ, and no law here is about them."""
    where: dict[str, object] = {
        "scene": str(of.page_data.folder / "scene.js"), "traces": str(of.traced.folder),
        "size": {"width": layout.figure.width, "height": layout.figure.height},
    }  # fmt: skip
    if of.sweeps:
        where["sweeps"] = {id: str(each.folder) for id, each in of.sweeps.items()}
    if of.base_data:
        where["base"] = str(of.base_data.folder / "scene.js")
    asked, lesson = folder / "asked.json", folder / "lesson.json"
    asked.write_text(stops.ask({"do": "ask", **where}), encoding="utf-8")
    words = read_words(plan.language).tree
    spoken = None if plan.language == DEFAULT else scene_words(of.scene)
    lesson.write_text(stops.ask({
        "do": "lesson", **where, "asked": str(asked), "words": words, "spoken": spoken,
        "sights": str(plan.sights.folder / SIGHTS),
        **({"worked": str(plan.worked / WORKED)} if plan.worked else {}),
    }), encoding="utf-8")  # fmt: skip
    worked = sources_of(plan).worked
    return Sources(plan.scene, plan.traced, plan.sights.folder, lesson, worked)
