"""Behind the lesson: the numbers of each pixel that it walks, its rays and its sum, and what its
steps work out."""

from __future__ import annotations

from raywalk.slides.blocks import BODY_SIZE, flow, flow_texts, title
from raywalk.slides.figure import Run, Slide, Table
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.ray_table import ray_tables
from raywalk.slides.step_slide import Lesson, source_line
from raywalk.slides.stops import Stop
from raywalk.slides.sum_slide import sum_slides
from raywalk.slides.words import say, switched
from raywalk.slides.worked_backup import worked_pages

FEW = 5  # rays: they stand above their sum


def backup_slides(lesson: Lesson) -> list[Slide]:
    """A divider, then each pixel once, in the lesson's order, and what its steps work out; [] where
    there is neither."""
    walks: dict[object, Stop] = {}
    for stop in lesson.stops:
        if stop.rows and stop.kind != "question":
            walks.setdefault(stop.walk, stop)
    worked = _worked(lesson)
    if not walks and not worked:
        return []
    slides = [_divider(lesson)]
    for stop in walks.values():
        tables = ray_tables(stop, lesson.layout.below_title)
        if len(stop.rows) <= FEW:
            slides += sum_slides(lesson, stop, tables[0])
        else:
            slides += [*_tables(lesson, stop, tables), *sum_slides(lesson, stop)]
    return [*slides, *worked]


def _worked(lesson: Lesson) -> list[Slide]:
    """What its steps work out, all of it: on their slides are the key rows."""
    slides: list[Slide] = []
    layout = lesson.layout
    for page in worked_pages(lesson.scene, lesson.stops, lesson.worked, layout.below_title):
        name = say("slides.continued", title=page.title) if page.is_continued else page.title
        items = (title(name, layout.title), *page.tables, *source_line(lesson, page.stop))
        slides.append(Slide(name, items, (), "table", page.is_continued))
    return slides


def _divider(lesson: Lesson) -> Slide:
    head, layout = say("slides.backup"), lesson.layout
    says = flow([Paragraph((Run(say("slides.backupSays")),))], BODY_SIZE, layout.title.width)
    items = (title(head, layout.title), *flow_texts(says, layout.below_title))
    return Slide(head, items, (), "backup")


def _tables(lesson: Lesson, stop: Stop, tables: list[Table]) -> list[Slide]:
    head, layout = say("slides.raysOfPixel", x=stop.pixel[0], y=stop.pixel[1]), lesson.layout
    head = ", ".join([head, *switched(stop.switches)])
    slides: list[Slide] = []
    for table in tables:
        name = say("slides.continued", title=head) if slides else head
        items = (title(name, layout.title), table, *source_line(lesson, stop))
        slides.append(Slide(name, items, (), "table", bool(slides)))
    return slides
