"""A worksheet: questions whose answers the trace knows, and the sheet with the answers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Triple
from raywalk.slides.blocks import flow, flow_texts, one_line, text
from raywalk.slides.choices import ChoiceWords, choice_items, choice_words
from raywalk.slides.figure import Deck, Item, Line, Polygon, Run, Slide, Text
from raywalk.slides.handout import A4
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import Paragraph, plain_text
from raywalk.slides.step_slide import Lesson
from raywalk.slides.stops import Question
from raywalk.slides.words import numbers, say, words
from raywalk.words.catalogue import find, slots_of

SIZE = 12.0
HEAD = 20.0
MARGIN = 54.0
BOTTOM = 50.0
ANSWER_LINES = 2
LINE = 24.0
GAP = 12.0
FOOT = 11.0
COUNT = 60.0  # kept for the sheet's number at the foot


def worksheet(lesson: Lesson, with_answers: bool) -> Deck:
    """A4 pages: what stands where, the questions, lines to write on or the answers."""
    scene = lesson.scene
    key = "slides.answersTitle" if with_answers else "slides.worksheetTitle"
    title = say(key, title=scene.title)
    blocks = [_given(scene)]
    for k, question in enumerate(questions(lesson), start=1):
        blocks.append(_block(k, question, with_answers))
    return Deck(scene.id, title, *A4, tuple(_numbered(_pages(title, blocks))), words().code)


@dataclass(frozen=True)
class Asked(Question):
    """A question of the lesson, with the choices that it may have."""

    choices: list[ChoiceWords]


def questions(lesson: Lesson) -> list[Question]:
    """From the trace of the lesson's first grid, and the lesson's own."""
    said = partial(plain_text, on_page=True)
    return lesson.questions + [
        Asked(said(step.text), said(step.answer), choice_words(lesson.scene, step))
        for step in lesson.scene.lesson
        if step.answer
    ]


def _given(scene: Scene) -> tuple[list[Item], float]:
    """What one needs to know of the scene to work it out."""
    camera, vector = scene.camera, numbers().vector
    facts = [say("slides.givenCamera", eye=vector(camera.eye), target=vector(camera.target),
                fov=f"{camera.fov:g}")]  # fmt: skip
    facts += [f"{obj.name}: {shape_words(obj)}" for obj in scene.objects]
    facts += [
        say("slides.givenLight", light=light.name, at=vector(light.position))
        for light in scene.lights
    ]
    points = [Paragraph((Run(say("slides.given"), bold=True),))]
    points += [Paragraph((Run(each),), "•") for each in facts]
    return _flowed(points)


def shape_words(obj: SceneObject) -> str:
    """A shape in its own coordinates; the transform, if it has one, is only named."""
    word = obj.shape.word
    slots = slots_of(find(words().tree, f"slides.shape.{word}"))
    numbers = {slot: _written(getattr(obj.shape, slot)) for slot in slots}
    shape = say(f"slides.shape.{word}", **numbers)
    moved = not np.array_equal(obj.transform, np.eye(4))
    return say("slides.moved", shape=shape) if moved else shape


def _written(value: str | float | Triple) -> str:
    if isinstance(value, str):
        return value
    write = numbers()
    return write.number(value) if isinstance(value, float | int) else write.vector(value)


def _block(count: int, question: Question, with_answers: bool) -> tuple[list[Item], float]:
    items, high = _flowed([Paragraph((Run(question.asks),), f"{count}.")])
    choices = question.choices if isinstance(question, Asked) else []
    if choices:
        box = Box(20.0, high + 5, A4[0] - 2 * MARGIN - 20, A4[1])
        boxes, more = choice_items(choices, box, SIZE, with_answers)
        items, high = items + boxes, high + 5 + more
    if choices and not with_answers:
        return items, high
    if with_answers:
        answer, more = _flowed([Paragraph((Run(question.answer, bold=True),))], indent=20.0)
        return items + [_moved(item, high + 4) for item in answer], high + 4 + more
    wide = A4[0] - 2 * MARGIN
    lines: list[Item] = [
        Line((20.0, high + k * LINE), (wide, high + k * LINE), "rule", 0.75, name="answer")
        for k in range(1, ANSWER_LINES + 1)
    ]
    return items + lines, high + ANSWER_LINES * LINE


def _flowed(points: list[Paragraph], indent: float = 0.0) -> tuple[list[Item], float]:
    """Items from (0, 0) down, and their height."""
    wide = A4[0] - 2 * MARGIN - indent
    whole = flow(points, SIZE, wide)
    return flow_texts(whole, Box(indent, 0, wide, whole.height())), whole.height()


def _pages(title: str, blocks: list[tuple[list[Item], float]]) -> Iterator[Slide]:
    """Blocks one under the other, the first ones under the title."""
    for k, page in enumerate(_parted(blocks)):
        items, top = ([], MARGIN) if k else (_heading(title), MARGIN + HEAD * 1.6)
        for block, high in page:
            items += [_moved(item, top, MARGIN) for item in block]
            top += high + GAP
        yield Slide(title, tuple(items), kind="worksheet")


def _parted(blocks: list[tuple[list[Item], float]]) -> list[list[tuple[list[Item], float]]]:
    """Pages: a block that does not fit begins the next; the last one takes one along rather than
    stand alone."""
    pages, top = [[blocks[0]]], MARGIN + HEAD * 1.6 + blocks[0][1] + GAP
    for block in blocks[1:]:
        if top + block[1] > A4[1] - BOTTOM:
            pages.append([])
            top = MARGIN
        pages[-1].append(block)
        top += block[1] + GAP
    if len(pages) > 1 and len(pages[-1]) == 1 and len(pages[-2]) > 2:
        pages[-1].insert(0, pages[-2].pop())
    return pages


def _numbered(pages: Iterable[Slide]) -> list[Slide]:
    """Where there are several, each says at its foot which one it is: copied sheets get apart."""
    sheets = list(pages)
    if len(sheets) == 1:
        return sheets
    box = Box(MARGIN, A4[1] - BOTTOM + 10, A4[0] - 2 * MARGIN, FOOT * 1.3)
    numbered = []
    for k, slide in enumerate(sheets, start=1):
        count = say("slides.sheetOf", sheet=k, of=len(sheets))
        foot = (
            one_line(slide.title, Box(*box[:2], box.width - COUNT, box.height), FOOT, "soft"),
            one_line(count, box, FOOT, "soft", "right", name="sheet"),
        )
        numbered.append(replace(slide, items=(*slide.items, *foot)))
    return numbered


def _heading(title: str) -> list[Item]:
    box = Box(MARGIN, MARGIN - 6, A4[0] - 2 * MARGIN, HEAD * 1.2)
    return [text([(Run(title, bold=True),)], box, HEAD, name="title", is_title=True)]


def _moved(item: Item, down: float, right: float = 0.0) -> Item:
    """The item further down and to the right."""
    if isinstance(item, Polygon):
        return replace(item, points=tuple((x + right, y + down) for x, y in item.points))
    if isinstance(item, Line):
        (x1, y1), (x2, y2) = item.start, item.end
        return replace(item, start=(x1 + right, y1 + down), end=(x2 + right, y2 + down))
    assert isinstance(item, Text)
    box = item.box
    return replace(item, box=Box(box.left + right, box.top + down, box.width, box.height))
