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
from raywalk.slides.words import say


def course_slides(scenes: list[Scene], pictures: list[Path], layout: Layout) -> list[Slide]:
    """The course's title, its agenda, and how it fits into lectures."""
    return [
        _title(scenes, pictures, layout),
        *list_slides(say("slides.scenes"), _agenda(scenes), layout, "goals"),
        *list_slides(say("slides.times"), _times(scenes), layout, "goals"),
    ]


def summary_slides(scenes: list[Scene], layout: Layout) -> list[Slide]:
    """What each lesson has taught."""
    rules = [Paragraph((Run(scene.teaches),), "•") for scene in scenes]
    return list_slides(say("slides.rules"), rules, layout, "goals")


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


def _agenda(scenes: list[Scene]) -> list[Paragraph]:
    """The lessons by their places in the course, under their chapters where they have some."""
    points, count = list[Paragraph](), 0
    for chapter, group in groupby(scenes, key=lambda scene: scene.chapter):
        if chapter:
            points.append(Paragraph((Run(say(f"pages.chapters.{chapter}"), True),)))
        for scene in group:
            count += 1
            points.append(Paragraph((Run(_called(scene)),), str(count)))
    return points


def _called(scene: Scene) -> str:
    if not scene.key:
        return scene.title
    return say("pages.scene.link", key=scene.key, title=scene.title)


def _times(scenes: list[Scene]) -> list[Paragraph]:
    """For each length of a lecture which lessons go into one, lecture by lecture."""
    minutes = [lesson_minutes(scene) for scene in scenes]
    points = [Paragraph((Run(say("slides.timesSay")),))]
    for most in LECTURES:
        lectures = parted(minutes, most)
        places = " | ".join(", ".join(str(k + 1) for k in each) for each in lectures)
        head = say("slides.lectures", minutes=most, count=len(lectures))
        points.append(Paragraph((Run(head, True), Run(f" {places}")), "•"))
    return points
