"""Slides round a lesson: title, goals, credits; lists."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from raywalk.scene.credits import named_models
from raywalk.scene.model import Scene
from raywalk.scene.models import ModelTable
from raywalk.slides.blocks import BODY_SIZE, flow, flow_texts, text, title
from raywalk.slides.figure import Item, Run, Slide
from raywalk.slides.layout import SMALLEST, Box, Layout
from raywalk.slides.lesson_words import Paragraph, paragraphs_of, words_and_pictures
from raywalk.slides.pictures import TITLE_SIDE, picture_of, traced_picture
from raywalk.slides.step_slide import headline_and_body
from raywalk.slides.times import lesson_minutes
from raywalk.slides.typeface import wrapped
from raywalk.slides.word_parts import word_parts
from raywalk.slides.words import say

BIG = 40.0
GAP = 28.0


def title_slide(
    scene: Scene, picture: Path, layout: Layout, kind: str = "title", where: str = ""
) -> Slide:
    """The scene's picture, name and sentence. where: above them; else the brand and its key."""
    frame, box = halves(layout)
    size = BIG if layout.width > 800 else BIG * 0.8
    lines = _at_most(wrapped([Run(scene.title, True)], size, box.width), 3)
    high = size * 1.2 * len(lines)
    says = flow([Paragraph((Run(scene.teaches),))], BODY_SIZE, box.width)
    keyed = say("slides.sceneKey", key=scene.key) if scene.key else ""
    where = where or " · ".join(part for part in (say("slides.brand"), keyed) if part)
    above = flow([Paragraph((Run(where),))], BODY_SIZE, box.width)
    says, _ = says.split(box.height - high - above.height() - 34)
    used = high + says.height() + above.height() + 24
    top = box.top + max(0.0, (box.height - used) / 2)
    over, under = Box(box.left, top, box.width, above.height()), top + above.height() + 6
    items: list[Item] = [
        picture_of(
            traced_picture(picture, TITLE_SIDE), frame, say("picture.alt", title=scene.title)
        ),
        *(replace(each, name="text") for each in flow_texts(above, over, "soft")),
        text(lines, Box(box.left, under, box.width, high), size, name="title", is_title=True),
        *flow_texts(says, Box(box.left, under + high + 14, box.width, says.height()), "soft"),
    ]
    minutes = say("slides.minutes", count=lesson_minutes(scene))
    return Slide(scene.title, tuple(items), (scene.teaches, minutes), kind)


def halves(layout: Layout) -> tuple[Box, Box]:
    """Of a title: the picture's and the words'."""
    side = min(layout.height - 160, layout.width * 0.42)
    frame = Box(layout.title.left, (layout.height - side) / 2, side, side)
    left = frame.right + GAP
    return frame, Box(left, frame.top, layout.width - layout.title.left - left, side)


def goals_slides(scene: Scene, layout: Layout) -> list[Slide]:
    """What is to be learnt: the written goals; where there are none, the scene's sentence and what
    its steps are called."""
    points = [Paragraph(_runs(goal), "•") for goal in scene.goals] or _named_steps(scene, layout)
    return list_slides(say("slides.goals"), points, layout, "goals")


def _named_steps(scene: Scene, layout: Layout) -> list[Paragraph]:
    points = [Paragraph((Run(scene.teaches, bold=True),))]
    for step in scene.lesson:
        head, _ = headline_and_body(step.headline, words_and_pictures(step.text)[0], layout)
        if head and not step.answer:
            points.append(Paragraph((Run(head),), "•"))
    return points


def _runs(markdown: str) -> tuple[Run, ...]:
    return tuple(run for paragraph in paragraphs_of(markdown) for run in paragraph.runs)


def credits_slides(scenes: list[Scene], layout: Layout) -> list[Slide]:
    """Who made what and under which licence: of its conditions the first, all in the notes."""
    entries = [say("slides.madeWith"), say("slides.fontCredit")]
    models = {table.title: table for scene in scenes for table in named_models(scene)}
    entries += [_credit(table, _first_clause(table.licence)) for table in models.values()]
    conditions = [_credit(table, table.licence) for table in models.values()]
    notes = (*entries[:2], *conditions)
    head, box, slides = say("slides.credits"), layout.below_title, list[Slide]()
    more = [Paragraph((Run(say("slides.conditions")),))] if conditions else []
    rest = flow([*(Paragraph((Run(each),)) for each in entries), *more], SMALLEST, box.width)
    while rest.lines:
        part, rest = rest.split_between(box.height)
        name = say("slides.continued", title=head) if slides else head
        items = (title(name, layout.title), *flow_texts(part, box))
        slides.append(Slide(name, items, () if slides else notes, "credits", bool(slides)))
    return slides


def _credit(table: ModelTable, licence: str) -> str:
    return say("pages.figures.modelIs", title=table.title, credit=table.credit, licence=licence)


def _first_clause(licence: str) -> str:
    return licence.partition(";")[0]


def list_slides(
    head: str, points: list[Paragraph], layout: Layout, kind: str, is_continued: bool = False
) -> list[Slide]:
    """Paragraphs over as many slides as they need. is_continued: from other slides of that head."""
    box, slides = layout.below_title, list[Slide]()
    for part in word_parts(points, box, BODY_SIZE):
        goes_on = bool(slides) or is_continued
        name = say("slides.continued", title=head) if goes_on else head
        items = (title(name, layout.title), *flow_texts(part, box))
        notes = () if slides else tuple(point.text for point in points)
        slides.append(Slide(name, items, notes, kind, goes_on))
    return slides


def _at_most(lines: list[tuple[Run, ...]], count: int) -> list[tuple[Run, ...]]:
    if len(lines) <= count:
        return lines
    last = "".join(run.text for run in lines[count - 1])[:-2].rstrip() + "…"
    return [*lines[: count - 1], (Run(last, True),)]
