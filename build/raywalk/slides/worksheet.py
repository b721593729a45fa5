"""A worksheet: what is given, the formulas, questions whose answers follow from these, and the
sheet with the answers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from raywalk.slides.blocks import (
    LEADING,
    PARAGRAPH_GAP,
    flow,
    flow_texts,
    one_line,
    text,
)
from raywalk.slides.choices import choice_items
from raywalk.slides.figure import Deck, Item, Line, Picture, Polygon, Run, Slide, Text
from raywalk.slides.handout import A4
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.sheet_facts import formulas, given
from raywalk.slides.sheet_figure import HIGH, SIDE, sheet_figure
from raywalk.slides.sheet_question import Question
from raywalk.slides.sheet_questions import questions, sheet_facts
from raywalk.slides.sheet_worked import worked_given
from raywalk.slides.step_slide import Lesson
from raywalk.slides.typeface import width
from raywalk.slides.words import say, words

SIZE = 12.0
SMALL = 10.5  # what is given, and formulas
HEAD = 20.0
MARGIN = 54.0
BOTTOM = 50.0
WIDE = A4[0] - 2 * MARGIN
INDENT = 20.0
ANSWER_LINES = 2
LINE = 24.0
GAP = 12.0
FOOT = 11.0
COUNT = 60.0  # kept for the sheet's number at the foot
TOGETHER = 3  # lines that stay with their head

Block = tuple[list[Item], float]  # from (0, 0) down, and its height


def worksheet(lesson: Lesson, with_answers: bool) -> Deck:
    """A4 pages: what stands where, the questions, lines to write on or the answers."""
    scene, facts = lesson.scene, sheet_facts(lesson)
    key = "slides.answersTitle" if with_answers else "slides.worksheetTitle"
    title = say(key, title=scene.title)
    blocks = list(listed(say("slides.given"), given(scene, facts)))
    blocks += listed(say("sheet.formulas"), formulas(scene, facts))
    blocks += listed(say("sheet.worked.head"), worked_given(lesson))
    for k, question in enumerate(questions(lesson), start=1):
        blocks.append(_question(lesson, k, question, with_answers))
    return Deck(scene.id, title, *A4, tuple(numbered(pages(title, blocks))), words().code)


def listed(head: str, lines: list[str]) -> Iterator[Block]:
    """Under a head that has three lines below it at least, if there are so many; what follows
    may go on overleaf."""
    parts = [lines[:TOGETHER], *([each] for each in lines[TOGETHER:])] if lines else []
    for k, part in enumerate(parts):
        points = [] if k else [Paragraph((Run(head, bold=True),))]
        points += [Paragraph((Run(each),), "•") for each in part]
        items, high = flowed(points, size=SMALL)
        yield items, high if k == len(parts) - 1 else high - GAP + SMALL * LEADING * PARAGRAPH_GAP


def _question(lesson: Lesson, count: int, question: Question, with_answers: bool) -> Block:
    """With its figure at the right, where it speaks of a pixel that is to be seen."""
    has_figure = question.stop is not None
    wide = WIDE - SIDE - GAP if has_figure else WIDE
    items, high = flowed([Paragraph((Run(question.asks),), f"{count}.")], wide=wide)
    if question.choices:
        box = Box(INDENT, high + 5, wide - INDENT, A4[1])
        boxes, more = choice_items(list(question.choices), box, SIZE, with_answers)
        items, high = items + boxes, high + 5 + more
    if has_figure:
        items += sheet_figure(lesson, question, WIDE - SIDE, with_answers)
        high = max(high, HIGH) if not with_answers else high
    if with_answers:
        answer, more = flowed(
            [Paragraph((Run(question.answer, bold=True),))], INDENT, wide - INDENT
        )
        items += [moved(item, high + 4) for item in answer]
        return items, max(high + 4 + more, HIGH if has_figure else 0.0)
    if question.choices:
        return items, high
    lines: list[Item] = [
        Line((INDENT, high + k * LINE), (WIDE, high + k * LINE), "rule", 0.75, name="answer")
        for k in range(1, ANSWER_LINES + 1)
    ]
    return items + lines, high + ANSWER_LINES * LINE


def flowed(
    points: list[Paragraph], indent: float = 0.0, wide: float = WIDE, size: float = SIZE
) -> Block:
    """Items from (indent, 0) down."""
    whole = flow(points, size, wide)
    return flow_texts(whole, Box(indent, 0, wide, whole.height())), whole.height()


def pages(title: str, blocks: list[Block]) -> Iterator[Slide]:
    """Blocks one under the other, the first ones under the title."""
    for k, page in enumerate(_parted(blocks)):
        items, top = ([], MARGIN) if k else (_heading(title), MARGIN + HEAD * 1.6)
        for block, high in page:
            items += [moved(item, top, MARGIN) for item in block]
            top += high + GAP
        yield Slide(title, tuple(items), kind="worksheet")


def _parted(blocks: list[Block]) -> list[list[Block]]:
    """Pages: a block that does not fit begins the next; the last one takes one along rather than
    stand alone."""
    sheets, top = [[blocks[0]]], MARGIN + HEAD * 1.6 + blocks[0][1] + GAP
    for block in blocks[1:]:
        if top + block[1] > A4[1] - BOTTOM:
            sheets.append([])
            top = MARGIN
        sheets[-1].append(block)
        top += block[1] + GAP
    if len(sheets) > 1 and len(sheets[-1]) == 1 and len(sheets[-2]) > 2:
        sheets[-1].insert(0, sheets[-2].pop())
    return sheets


def numbered(slides: Iterable[Slide]) -> list[Slide]:
    """Where there are several, each says at its foot which one it is: copied sheets get apart."""
    sheets = list(slides)
    if len(sheets) == 1:
        return sheets
    box = Box(MARGIN, A4[1] - BOTTOM + 10, WIDE, FOOT * 1.3)
    marked = []
    for k, slide in enumerate(sheets, start=1):
        count = say("slides.sheetOf", sheet=k, of=len(sheets))
        foot = (
            one_line(slide.title, Box(*box[:2], box.width - COUNT, box.height), FOOT, "soft"),
            one_line(count, box, FOOT, "soft", "right", name="sheet"),
        )
        marked.append(replace(slide, items=(*slide.items, *foot)))
    return marked


def _heading(title: str) -> list[Item]:
    box = Box(MARGIN, MARGIN - 6, WIDE, HEAD * 1.2)
    size = fitting(title, HEAD)
    return [text([(Run(title, bold=True),)], box, size, name="title", is_title=True)]


def fitting(title: str, size: float) -> float:
    """The size, or the smaller one in which a title fits on its line."""
    return min(size, size * WIDE / width(title, size, bold=True))


def moved(item: Item, down: float, right: float = 0.0) -> Item:
    """The item further down and to the right."""
    if isinstance(item, Polygon):
        return replace(item, points=tuple((x + right, y + down) for x, y in item.points))
    if isinstance(item, Line):
        (x1, y1), (x2, y2) = item.start, item.end
        return replace(item, start=(x1 + right, y1 + down), end=(x2 + right, y2 + down))
    assert isinstance(item, Text | Picture)
    box = item.box
    return replace(item, box=Box(box.left + right, box.top + down, box.width, box.height))
