"""Behind the lesson: the numbers of each pixel that it walks, its rays and its sum."""

from __future__ import annotations

from raywalk.slides.blocks import BODY_SIZE, flow, flow_texts, title
from raywalk.slides.figure import Run, Slide, Table
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.ray_table import ray_tables
from raywalk.slides.step_slide import Lesson, source_line
from raywalk.slides.stops import Stop
from raywalk.slides.sum_slide import sum_slides
from raywalk.slides.words import say

FEW = 5  # rays: they stand above their sum


def backup_slides(lesson: Lesson) -> list[Slide]:
    """A divider, then each pixel once, in the lesson's order; [] where no pixel is walked."""
    walks: dict[object, Stop] = {}
    for stop in lesson.stops:
        if stop.rows and stop.kind != "question":
            walks.setdefault(stop.walk, stop)
    if not walks:
        return []
    slides = [_divider(lesson)]
    for stop in walks.values():
        tables = ray_tables(stop, lesson.layout.below_title)
        if len(stop.rows) <= FEW:
            slides += sum_slides(lesson, stop, tables[0])
        else:
            slides += [*_tables(lesson, stop, tables), *sum_slides(lesson, stop)]
    return slides


def _divider(lesson: Lesson) -> Slide:
    head, layout = say("slides.backup"), lesson.layout
    says = flow([Paragraph((Run(say("slides.backupSays")),))], BODY_SIZE, layout.title.width)
    items = (title(head, layout.title), *flow_texts(says, layout.below_title))
    return Slide(head, items, (), "backup")


def _tables(lesson: Lesson, stop: Stop, tables: list[Table]) -> list[Slide]:
    head, layout = say("slides.raysOfPixel", x=stop.pixel[0], y=stop.pixel[1]), lesson.layout
    slides: list[Slide] = []
    for table in tables:
        name = say("slides.continued", title=head) if slides else head
        items = (title(name, layout.title), table, *source_line(lesson, stop))
        slides.append(Slide(name, items, (), "table", bool(slides)))
    return slides
