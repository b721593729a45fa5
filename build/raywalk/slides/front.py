"""Slides round a lesson: title, goals, credits; and those of the whole course."""

from __future__ import annotations

from pathlib import Path

from raywalk.scene.credits import named_models
from raywalk.scene.model import Scene
from raywalk.slides.blocks import BODY_SIZE, continued, flow, flow_texts, one_line, text, title
from raywalk.slides.figure import Item, Run, Slide
from raywalk.slides.layout import Box, Layout
from raywalk.slides.lesson_words import Paragraph, title_and_body, words_and_pictures
from raywalk.slides.pictures import TITLE_SIDE, picture_of, traced_picture
from raywalk.slides.typeface import wrapped
from raywalk.slides.words import say

BIG = 40.0
TEACHES = 20.0
GAP = 28.0


def title_slide(scene: Scene, picture: Path, layout: Layout, kind: str = "title") -> Slide:
    """The scene's picture, name and sentence."""
    frame, box = _halves(layout)
    size = BIG if layout.width > 800 else BIG * 0.8
    lines = _at_most(wrapped([Run(scene.title, True)], size, box.width), 3)
    high = size * 1.2 * len(lines)
    says = flow([Paragraph((Run(scene.teaches),))], TEACHES, box.width)
    says, _ = says.split(box.height - high - 60)
    top = box.top + max(0.0, (box.height - high - says.height() - 50) / 2)
    number = " · ".join(part for part in (say("slides.brand"), scene.key) if part)
    items: list[Item] = [
        picture_of(
            traced_picture(picture, TITLE_SIDE), frame, say("picture.alt", title=scene.title)
        ),
        one_line(number, Box(box.left, top, box.width, 24), BODY_SIZE, "soft"),
        text(lines, Box(box.left, top + 32, box.width, high), size, name="title", is_title=True),
        *flow_texts(says, Box(box.left, top + 32 + high + 14, box.width, says.height()), "soft"),
    ]
    return Slide(scene.title, tuple(items), (scene.teaches,), kind)


def _halves(layout: Layout) -> tuple[Box, Box]:
    """Of a title: the picture's and the words'."""
    side = min(layout.height - 160, layout.width * 0.42)
    frame = Box(layout.title.left, (layout.height - side) / 2, side, side)
    left = frame.right + GAP
    return frame, Box(left, frame.top, layout.width - layout.title.left - left, side)


def goals_slides(scene: Scene, layout: Layout) -> list[Slide]:
    """What is to be learnt, and the steps by their first sentences."""
    points = [Paragraph((Run(scene.teaches, bold=True),))]
    for step in scene.lesson:
        head, _ = title_and_body(words_and_pictures(step.text)[0])
        if head and not step.answer:
            points.append(Paragraph((Run(head),), bullet="•"))
    return list_slides(say("slides.goals"), points, layout, "goals")


def credits_slides(scenes: list[Scene], layout: Layout) -> list[Slide]:
    entries = [say("slides.madeWith"), say("slides.fontCredit")]
    for scene in scenes:
        for table in named_models(scene):
            credit = say(
                "pages.figures.modelIs",
                title=table.title,
                credit=table.credit,
                licence=table.licence,
            )
            entries += [credit] if credit not in entries else []
    points = [Paragraph((Run(each),)) for each in entries]
    return list_slides(say("slides.credits"), points, layout, "credits")


def course_slides(scenes: list[Scene], pictures: list[Path], layout: Layout) -> list[Slide]:
    """The course's title and its scenes."""
    data = traced_picture(pictures[-1], TITLE_SIDE)
    frame, (left, _, wide, _) = _halves(layout)
    lines = wrapped([Run(say("slides.course"), True)], BIG, wide)
    high = BIG * 1.2 * len(lines)
    top = layout.height / 2 - high
    says = flow([Paragraph((Run(say("slides.courseSays")),))], TEACHES, wide)
    first = Slide(
        say("slides.course"),
        (
            picture_of(data, frame, say("picture.alt", title=scenes[-1].title)),
            one_line(say("slides.brand"), Box(left, top - 34, wide, 24), BODY_SIZE, "soft"),
            text(lines, Box(left, top, wide, high), BIG, name="title", is_title=True),
            *flow_texts(says, Box(left, top + high + 14, wide, says.height()), "soft"),
        ),
        (say("slides.courseSays"),),
        "title",
    )
    named = [
        Paragraph((Run(scene.title, True), Run(f": {scene.teaches}")), f"{scene.key or '•'}")
        for scene in scenes
    ]
    return [first, *list_slides(say("slides.scenes"), named, layout, "goals")]


def list_slides(head: str, points: list[Paragraph], layout: Layout, kind: str) -> list[Slide]:
    """Paragraphs over as many slides as they need."""
    top = layout.title.bottom + 14
    box = Box(layout.title.left, top, layout.title.width, layout.height - 44 - top)
    first, rest = flow(points, BODY_SIZE, box.width).split(box.height)
    items = (title(head, layout.title), *flow_texts(first, box))
    notes = tuple(point.text for point in points)
    return [Slide(head, items, notes, kind), *continued(rest, box, head, layout, kind)]


def _at_most(lines: list[tuple[Run, ...]], count: int) -> list[tuple[Run, ...]]:
    if len(lines) <= count:
        return lines
    last = "".join(run.text for run in lines[count - 1])[:-2].rstrip() + "…"
    return [*lines[: count - 1], (Run(last, True),)]
