"""Decks: a scene's lesson, and the whole course, as lists of slides."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any

from raywalk.scene.model import Scene
from raywalk.slides.backup import backup_slides
from raywalk.slides.build_up import build_up
from raywalk.slides.course import chapters, course_slides, lesson_place, rules_slides
from raywalk.slides.figure import Deck, Slide
from raywalk.slides.formats import COURSE
from raywalk.slides.front import credits_slides, goals_slides, title_slide
from raywalk.slides.layout import Layout
from raywalk.slides.question_slide import question_slides
from raywalk.slides.step_slide import Lesson, step_slides
from raywalk.slides.stops import read_stops
from raywalk.slides.words import say, words


@dataclass(frozen=True)
class Sources:
    """Where a scene's slides come from."""

    scene: Scene
    traced: Path  # the folder of picture.png
    sights: Path  # that of view-<k>.png, of the layout's aspect
    stops: Path  # Lesson as JSON, of the layout's aspect
    worked: dict[str, Any] = field(default_factory=dict)  # what its steps work out (worked.py)

    def lesson(self, layout: Layout) -> Lesson:
        stops = read_stops(self.stops)
        picture = self.traced / "picture.png"
        return Lesson(self.scene, stops, self.sights, picture, layout, self.worked)


def scene_deck(
    sources: Sources,
    layout: Layout,
    steps: frozenset[int] | None = None,
    lesson: Lesson | None = None,
    slides: list[Slide] | None = None,
) -> Deck:
    """steps: which of the lesson, from 0; with them only their slides and no others. lesson and
    slides: those of these sources, where they are at hand."""
    scene, lesson = sources.scene, lesson or sources.lesson(layout)
    slides = lesson_slides(lesson, steps) if slides is None else slides
    if steps is None:
        front = [title_slide(scene, lesson.picture, layout), *goals_slides(scene, layout)]
        slides = [*front, *slides, *credits_slides([scene], layout), *backup_slides(lesson)]
    return Deck(scene.id, scene.title, layout.width, layout.height, tuple(slides), words().code)


def lesson_slides(lesson: Lesson, steps: frozenset[int] | None = None) -> list[Slide]:
    """The steps; where a pixel's rays are walked for the first time, they come one by one."""
    slides: list[Slide] = []
    walked = set()
    for k, stop in enumerate(lesson.stops):
        if steps is not None and stop.step not in steps:
            continue
        if stop.kind == "question":
            slides += question_slides(lesson, k)
            continue
        if stop.kind == "step" and stop.rows and stop.walk not in walked:
            slides += build_up(lesson, stop)
            walked.add(stop.walk)
        slides += step_slides(lesson, k)
    return slides


def course_of(all_sources: list[Sources], lessons: list[list[Slide]], layout: Layout) -> Deck:
    """Every scene's lesson after the other, at each chapter's end its rules, without their backup
    and what builds slides up: those are in each lesson's own deck."""
    scenes = [sources.scene for sources in all_sources]
    pictures = [sources.traced / "picture.png" for sources in all_sources]
    slides = course_slides(scenes, pictures, layout)
    rest = zip(scenes, pictures, lessons, strict=True)
    place = 0
    for chapter, group in chapters(scenes):
        for scene, picture, lesson in islice(rest, len(group)):
            place += 1
            where = lesson_place(scene, place, len(scenes))
            slides.append(title_slide(scene, picture, layout, "section", where))
            slides += [slide for slide in lesson if slide.kind != "build"]
        slides += rules_slides(chapter, group, layout)
    slides += credits_slides(scenes, layout)
    return Deck(
        COURSE, say("slides.course"), layout.width, layout.height, tuple(slides), words().code
    )
