"""Slides of the whole course: its agenda, what fits into a lecture, and its rules at the end."""

from __future__ import annotations

from itertools import groupby
from pathlib import Path

from raywalk.scene.model import Scene
from raywalk.slides.blocks import BODY_SIZE, flow, flow_texts, one_line, text
from raywalk.slides.figure import Run, Slide
from raywalk.slides.front import BIG, halves, list_slides
from raywalk.slides.layout import Box, Layout
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.pictures import TITLE_SIDE, picture_of, traced_picture
from raywalk.slides.times import LECTURES, lesson_minutes, parted
from raywalk.slides.typeface import wrapped
from raywalk.slides.word_parts import word_parts
from raywalk.slides.words import say


def course_slides(scenes: list[Scene], pictures: list[Path], layout: Layout) -> list[Slide]:
    """The course's title, its agenda, and how it fits into lectures."""
    slides = [_title(scenes, pictures, layout), *_agenda(scenes, layout)]
    for most in LECTURES:
        head = say("slides.times", minutes=most)
        slides += list_slides(head, _lectures(scenes, most), layout, "goals")
    return slides


def rules_slides(chapter: str, scenes: list[Scene], layout: Layout) -> list[Slide]:
    """What the lessons of a chapter have taught."""
    rules = [Paragraph((Run(scene.teaches),), "•") for scene in scenes]
    name = _chapter_name(chapter)
    head = say("slides.rulesOf", chapter=name) if name else say("slides.rules")
    return list_slides(head, rules, layout, "goals")


def lesson_place(scene: Scene, place: int, count: int) -> str:
    """Of a divider: where in the course one is. place: from 1."""
    parts = [_chapter_name(scene.chapter), say("slides.lessonOf", place=place, of=count)]
    if scene.key:
        parts.append(say("slides.sceneKey", key=scene.key))
    return " · ".join(part for part in parts if part)


def chapters(scenes: list[Scene]) -> list[tuple[str, list[Scene]]]:
    """Neighbours of one chapter, in order."""
    return [(name, list(group)) for name, group in groupby(scenes, key=lambda each: each.chapter)]


def _chapter_name(chapter: str) -> str:
    return say(f"pages.chapters.{chapter}") if chapter else ""


def _title(scenes: list[Scene], pictures: list[Path], layout: Layout) -> Slide:
    data = traced_picture(pictures[-1], TITLE_SIDE)
    frame, (left, _, wide, _) = halves(layout)
    lines = wrapped([Run(say("slides.course"), True)], BIG, wide)
    high = BIG * 1.2 * len(lines)
    top = layout.height / 2 - high
    says = flow([Paragraph((Run(say("slides.courseSays")),))], BODY_SIZE, wide)
    return Slide(
        say("slides.course"),
        (
            picture_of(data, frame, say("picture.alt", title=scenes[-1].title)),
            one_line(say("slides.brand"), Box(left, top - 34, wide, 30), BODY_SIZE, "soft"),
            text(lines, Box(left, top, wide, high), BIG, name="title", is_title=True),
            *flow_texts(says, Box(left, top + high + 14, wide, says.height()), "soft"),
        ),
        (say("slides.courseSays"),),
        "title",
    )


def _agenda(scenes: list[Scene], layout: Layout) -> list[Slide]:
    """The lessons by their places in the course, whole chapters on a slide as long as they fit."""
    parts, count = list[list[Paragraph]](), 0
    for chapter, group in chapters(scenes):
        name = _chapter_name(chapter)
        points = [Paragraph((Run(name, True),))] if name else []
        for scene in group:
            count += 1
            points.append(Paragraph((Run(scene.title),), str(count)))
        parts.append(points)
    slides = list[Slide]()
    for page in _packed(parts, layout):
        made = list_slides(say("slides.scenes"), page, layout, "goals", bool(slides))
        slides += made
    return slides


def _packed(parts: list[list[Paragraph]], layout: Layout) -> list[list[Paragraph]]:
    """Parts on as few pages as keep each of them whole; one that is too long has its own."""
    pages: list[list[Paragraph]] = []
    for part in parts:
        whole = [*(pages[-1] if pages else []), *part]
        if pages and len(word_parts(whole, layout.below_title, BODY_SIZE)) == 1:
            pages[-1] = whole
        else:
            pages.append(part)
    return pages


def _lectures(scenes: list[Scene], most: int) -> list[Paragraph]:
    """Which lessons go into each lecture of so many minutes."""
    minutes = [lesson_minutes(scene) for scene in scenes]
    return [Paragraph((Run(say("slides.timesSay")),))] + [
        Paragraph((Run(" · ".join(scenes[k].title for k in lecture)),), str(count))
        for count, lecture in enumerate(parted(minutes, most), start=1)
    ]
