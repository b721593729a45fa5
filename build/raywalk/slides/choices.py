"""A question's choices on paper: a box to tick before each; with the answer the right one is ticked
and each has its reason."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from raywalk.scene.model import Choice, LessonStep, Scene
from raywalk.slides.blocks import (
    LEADING,
    flow,
    flow_texts,
    one_line,
    title,
)
from raywalk.slides.figure import Dot, Group, Item, Line, Point, Polygon, Run, Slide, hex_of
from raywalk.slides.labels import Inset, Places
from raywalk.slides.layout import Box, Layout
from raywalk.slides.lesson_words import Paragraph, plain_text
from raywalk.slides.stops import Stop
from raywalk.slides.word_parts import MOST_WORDS
from raywalk.slides.word_parts import count_words as words_in
from raywalk.slides.words import say

SIZE = 24.0  # on a slide
INDENT = 1.7  # of the letters' size: the box, and room after it
BOX = 0.82  # of the letters' size
TICK = ((0.16, 0.52), (0.42, 0.8), (0.92, 0.08))  # of the box's side, from its top left
MARK, LETTER = 12.0, 18.0  # of a pixel that is a choice: a circle's radius, its letter's size
BETWEEN = 0.5  # of a line, between two choices


@dataclass(frozen=True)
class ChoiceWords:
    """A choice as paper has it."""

    letter: str
    label: str
    because: str
    right: bool
    swatch: str | None  # #rrggbb
    pixel: tuple[int, int] | None  # column, row

    @property
    def lettered(self) -> str:
        """ "A  Dark grey"."""
        return f"{self.letter}  {self.label}"


def choice_words(scene: Scene, step: LessonStep) -> list[ChoiceWords]:
    return [
        ChoiceWords(
            chr(ord("A") + k),
            _label(scene, choice),
            plain_text(choice.because, on_page=True),
            choice.right,
            hex_of([round(255 * part) for part in choice.colour]) if choice.colour else None,
            choice.pixel,
        )
        for k, choice in enumerate(step.choices)
    ]


def _label(scene: Scene, choice: Choice) -> str:
    if choice.pixel is not None:
        column, row = choice.pixel
        return say("card.pixel", column=column, row=row)
    if choice.object is not None:
        return scene.objects[choice.object].name
    return plain_text(choice.text, on_page=True)


def choice_items(
    choices: list[ChoiceWords], box: Box, size: float, revealed: bool
) -> tuple[list[Item], float]:
    """From the box's top down, and the height that they take."""
    items: list[Item] = []
    top = box.top
    for k, choice in enumerate(choices):
        top += BETWEEN * size * LEADING if k else 0.0
        made, high = _one(choice, Box(box.left, top, box.width, box.bottom - top), size, revealed)
        items += made
        top += high
    return items, top - box.top


def _one(choice: ChoiceWords, box: Box, size: float, revealed: bool) -> tuple[list[Item], float]:
    side, left = BOX * size, box.left + INDENT * size
    frame = Box(box.left, box.top + (LEADING * size - side) / 2, side, side)
    is_ticked = revealed and choice.right
    name = say("slides.tickedBox" if is_ticked else "slides.box")
    items: list[Item] = [Polygon(frame.corners, None, "ink", 1.2, name=name)]
    if is_ticked:
        at = [(frame.left + x * side, frame.top + y * side) for x, y in TICK]
        items += [Line(*ends, "ink", 0.14 * size, name=name) for ends in pairwise(at)]
    bold = not revealed or choice.right
    line = size * LEADING
    place = Box(left, box.top, size, line)
    items.append(one_line(choice.letter, place, size, bold=bold, name="letter"))
    left += 1.2 * size
    if choice.swatch:
        swatch = Box(left, frame.top - 1, side + 2, side + 2)
        sample = say("slides.swatch")
        items.append(Polygon(swatch.corners, choice.swatch, "rule", 0.75, name=sample))
        left += side + 0.6 * size
    used = 0.0
    for words in [Run(choice.label, bold), *([Run(choice.because)] if revealed else [])]:
        whole = flow([Paragraph((words,))], size, box.right - left)
        place = Box(left, box.top + used, box.right - left, whole.height())
        items += [replace(item, name="choice") for item in flow_texts(whole, place)]
        used += whole.height()
    return items, used


def choice_marks(choices: list[ChoiceWords], stop: Stop) -> Inset:
    """What draws letters on the figure's tiles, where choices are pixels."""

    def draw(places: Places) -> list[Item]:
        frame, items = places.frame, list[Item]()
        for choice in choices:
            if choice.pixel is None:
                continue
            across, down = (np.array(at + 0.5) for at in choice.pixel)
            x, y, depth = stop.figure.on_plane(across, down)
            place = Box(frame.left + x - MARK, frame.top + y - MARK, 2 * MARK, 2 * MARK)
            if depth > stop.figure.near and frame.holds(place):
                items.append(_mark(choice, (frame.left + float(x), frame.top + float(y))))
                places.boxes.append(place)
        return items

    return draw


def marks_on_picture(choices: list[ChoiceWords], n: int, frame: Box) -> list[Item]:
    """The same on the whole traced picture."""
    items: list[Item] = []
    for choice in choices:
        if choice.pixel is not None:
            column, row = choice.pixel
            x = frame.left + (column + 0.5) / n * frame.width
            items.append(_mark(choice, (x, frame.top + (row + 0.5) / n * frame.height)))
    return items


def _mark(choice: ChoiceWords, centre: Point) -> Group:
    x, y = centre
    high = LETTER * LEADING
    box = Box(x - MARK, y - high / 2, 2 * MARK, high)
    dot = Dot(centre, MARK, "#f0e442", "#15170a", name=choice.lettered)
    letter = one_line(choice.letter, box, LETTER, "#15170a", "centre", bold=True)
    return Group(choice.lettered, "", (dot, letter))


def choice_slides(
    choices: list[ChoiceWords], head: str, box: Box, layout: Layout, under: list[Item],
    revealed: bool,
) -> Iterator[Slide]:  # fmt: skip
    """Choices on as many slides of their own as they need. head: of the slide that they go on."""
    kind = "answer" if revealed else "question"
    while choices:
        count = _fitting(choices, box, revealed)
        items, _ = choice_items(choices[:count], box, SIZE, revealed)
        yield Slide(head, (title(head, layout.title), *items, *under), (), kind, True)
        choices = choices[count:]


def _fitting(choices: list[ChoiceWords], box: Box, revealed: bool) -> int:
    """How many go below one another into the box, with few words; at least one."""
    for count in range(len(choices), 1, -1):
        part = choices[:count]
        if (
            count_words(part, revealed) <= MOST_WORDS
            and choice_items(part, box, SIZE, revealed)[1] <= box.height
        ):
            return count
    return 1


def count_words(choices: list[ChoiceWords], revealed: bool) -> int:
    """Without their letters."""
    said = (f"{each.label} {each.because if revealed else ''}" for each in choices)
    return sum(map(words_in, said))


def in_notes(scene: Scene, step: LessonStep, revealed: bool) -> Iterator[str]:
    """For who speaks: the choices; with the answer why the right one is, and what each wrong one
    misunderstands."""
    for choice in choice_words(scene, step):
        if not revealed:
            yield choice.lettered
        elif choice.right:
            yield f"{choice.lettered} ({say('choices.right')}): {choice.because}"
        else:
            yield say("slides.misconception", label=choice.lettered, because=choice.because)
