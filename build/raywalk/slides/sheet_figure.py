"""The traced picture, small, with the pixel marked that a question speaks of."""

from __future__ import annotations

from collections.abc import Iterator

from raywalk.slides.blocks import one_line
from raywalk.slides.choices import ChoiceWords
from raywalk.slides.figure import Item, Polygon
from raywalk.slides.layout import Box
from raywalk.slides.pictures import picture_of, traced_picture
from raywalk.slides.sheet_question import Question
from raywalk.slides.step_slide import Lesson
from raywalk.slides.words import chosen_tile, say

SIDE = 104.0  # points
SHARP = 300  # pixels of the picture
CAPTION, ROW = 9.5, 13.0
LEAST = 6.0  # points: a frame round a smaller pixel is this wide
LETTER = 8.5
HIGH = SIDE + ROW


def sheet_figure(lesson: Lesson, question: Question, left: float, revealed: bool) -> list[Item]:
    """From (left, 0) down, HIGH points. A pixel whose colour is the answer stays blank until it is
    revealed; where choices are pixels, each has its letter."""
    stop = question.stop
    assert stop
    frame = Box(left, 2.0, SIDE, SIDE)
    data = traced_picture(lesson.picture, SHARP)
    items: list[Item] = [picture_of(data, frame, say("picture.alt", title=lesson.scene.title))]
    lettered = [choice for choice in question.choices if choice.pixel]
    if lettered:
        for choice in lettered:
            items += _letter(choice, frame, stop.n)
        caption = say("sheet.grid", n=stop.n)
    else:
        items += _marked(stop.pixel, frame, stop.n, blank=not (revealed or stop.filled))
        caption = say("slides.pixelOf", x=stop.pixel[0], y=stop.pixel[1], n=stop.n)
    under = Box(left, frame.bottom, SIDE, ROW)
    return [*items, one_line(caption, under, CAPTION, "soft", name="caption")]


def _tile(pixel: tuple[int, int], frame: Box, n: int, least: float = LEAST) -> Box:
    side = frame.width / n
    wide = max(side, least)
    left = frame.left + (pixel[0] + 0.5) * side - wide / 2
    top = frame.top + (pixel[1] + 0.5) * side - wide / 2
    return Box(left, top, wide, wide)


def _marked(pixel: tuple[int, int], frame: Box, n: int, blank: bool) -> Iterator[Item]:
    """A dark frame in a light one: seen on any ground."""
    tile = _tile(pixel, frame, n)
    outer = Box(tile.left - 1.2, tile.top - 1.2, tile.width + 2.4, tile.height + 2.4)
    name = chosen_tile(pixel)
    yield Polygon(outer.corners, None, "#ffffff", 1.2, name=name)
    yield Polygon(tile.corners, "#ffffff" if blank else None, "#111111", 1.2, name=name)


def _letter(choice: ChoiceWords, frame: Box, n: int) -> Iterator[Item]:
    assert choice.pixel
    tile = _tile(choice.pixel, frame, n, LETTER * 1.25)
    yield Polygon(tile.corners, "#f0e442", "#15170a", 0.75, name=choice.lettered)
    line = Box(tile.left, tile.top + (tile.height - LETTER * 1.25) / 2, tile.width, LETTER * 1.25)
    yield one_line(choice.letter, line, LETTER, "#15170a", "centre", bold=True)
