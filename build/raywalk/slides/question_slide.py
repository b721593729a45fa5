"""A question fills its slide: large, beside the picture if that does not give its answer away."""

from __future__ import annotations

from dataclasses import replace

from raywalk.slides.blocks import Flow, flow_texts, title
from raywalk.slides.choices import SIZE as CHOICES
from raywalk.slides.choices import (
    ChoiceWords,
    choice_items,
    choice_slides,
    count_words,
    marks_on_picture,
)
from raywalk.slides.figure import Item, Slide
from raywalk.slides.layout import Box
from raywalk.slides.picture_inset import framed_picture
from raywalk.slides.pictures import WHOLE
from raywalk.slides.step_slide import (
    Lesson,
    asked_choices,
    figure_slides,
    head_and_body,
    said_to,
    shown_slides,
    source_line,
)
from raywalk.slides.stops import Stop
from raywalk.slides.word_parts import MOST_WORDS, word_parts

SIZE = 30.0
PICTURE, LEAST_WORDS = 296.0, 356.0  # points: the picture's side, and what the words keep
GAP = 32.0
UNDER = 22.0  # from the question to its choices


def question_slides(lesson: Lesson, index: int) -> list[Slide]:
    """The question with its choices, then the pictures of its text; the answer is a stop of its
    own. Where the tiles are still empty the question stands under its figure, which shows what is
    known."""
    stop = lesson.stops[index]
    slides = _beside_picture(lesson, index) if stop.filled else _under_figure(lesson, index)
    return [*slides, *shown_slides(lesson, stop)]


def _under_figure(lesson: Lesson, index: int) -> list[Slide]:
    layout, stop = lesson.layout, lesson.stops[index]
    choices = asked_choices(lesson, stop)
    head, _ = head_and_body(lesson, stop)
    under = source_line(lesson, stop)
    return [
        *figure_slides(lesson, index),
        *choice_slides(choices, head, layout.below_title, layout, under, revealed=False),
    ]


def _beside_picture(lesson: Lesson, index: int) -> list[Slide]:
    layout, stop = lesson.layout, lesson.stops[index]
    choices = asked_choices(lesson, stop)
    head, body = head_and_body(lesson, stop)
    room, beside = _words_box(lesson), [*_picture(lesson, stop), *source_line(lesson, stop)]
    parts = word_parts(body, room, SIZE)
    boxes = _below(parts, choices, room)
    slides: list[Slide] = []
    for part in parts:
        items = (title(head, layout.title), *flow_texts(part, room), *boxes, *beside)
        slides.append(Slide(head, items, (), stop.kind, bool(slides)))
    if choices and not boxes:
        slides += choice_slides(choices, head, room, layout, beside, revealed=False)
    first = replace(slides[0], notes=said_to(lesson, index), figure=lesson.figure(stop))
    return [first, *slides[1:]]


def _below(parts: list[Flow], choices: list[ChoiceWords], room: Box) -> list[Item]:
    """The choices under the question; [] where they take slides of their own."""
    [first, *more] = parts
    left, top, wide, high = room
    used = first.height() + UNDER
    place = Box(left, top + used, wide, high - used)
    items, taken = choice_items(choices, place, CHOICES, revealed=False)
    count = sum(len(run.text.split()) for line in first.lines for run in line[0])
    is_short = count + count_words(choices, revealed=False) <= MOST_WORDS
    return items if not more and is_short and taken <= place.height else []


def _words_box(lesson: Lesson) -> Box:
    """What the picture leaves."""
    left, top, wide, high = lesson.layout.below_title
    return Box(left, top, wide - _side(wide) - GAP, high)


def _side(wide: float) -> float:
    return min(PICTURE, wide - GAP - LEAST_WORDS)


def _picture(lesson: Lesson, stop: Stop) -> list[Item]:
    box = lesson.layout.below_title
    side = _side(box.width)
    frame = Box(box.right - side, box.top, side, side)
    marks = marks_on_picture(asked_choices(lesson, stop), stop.n, frame)
    window = WHOLE if marks else None  # with its choices marked, no other tile
    title = lesson.scene.title
    shown = framed_picture(lesson.picture, title, stop, frame, window, is_marked=not marks)
    return [*shown, *marks]
