"""The guide: two pages a lesson, for who teaches it."""

from __future__ import annotations

from collections.abc import Iterable

from raywalk.scene.model import Scene
from raywalk.scene.slots import own_pixel
from raywalk.slides.addresses import address
from raywalk.slides.blocks import one_line, text
from raywalk.slides.choices import choice_words
from raywalk.slides.figure import Deck, Item, Run, Slide
from raywalk.slides.handout import A4
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import Paragraph, plain_text
from raywalk.slides.pictures import picture_of, traced_picture
from raywalk.slides.step_slide import Lesson
from raywalk.slides.times import LECTURES
from raywalk.slides.words import say, words
from raywalk.slides.worksheet import MARGIN, WIDE, fitting, flowed, moved
from raywalk.teacher.timing import schedule
from raywalk.teacher.topics import prerequisites

HEAD, FOOT = 20.0, 9.5
SIZES = (
    11.5,
    11.0,
    10.5,
    10.0,
    9.5,
    9.0,
    8.5,
)  # the largest is taken in which a page has room for all
SIDE, SHARP = 150.0, 400  # of the picture: points, pixels
TOP = MARGIN + HEAD * 1.9
BOTTOM = A4[1] - MARGIN
APART = 20.0  # between two columns

Points = list[Paragraph]


def guide(lessons: list[Lesson], base: str) -> Deck:
    """base: what addresses begin with, or ""."""
    course = [lesson.scene for lesson in lessons]
    slides = [slide for each in lessons for slide in _lesson(each, course, base)]
    return Deck("guide", say("teacher.guide"), *A4, tuple(slides), words().code)


def _lesson(lesson: Lesson, course: list[Scene], base: str) -> list[Slide]:
    scene = lesson.scene
    number = [each.id for each in course].index(scene.id) + 1
    head = say("teacher.lesson", number=number, title=scene.title)
    first = _first_page(lesson, course, base)
    second = _fitting([_questions(lesson), _misconceptions(lesson)], BOTTOM - TOP)
    return [
        _page(head, k, items, number, len(course))
        for k, items in enumerate((first, second), start=1)
    ]


def _page(head: str, k: int, items: list[Item], number: int, count: int) -> Slide:
    title = Box(MARGIN, MARGIN - 6, WIDE, HEAD * 1.2)
    under = Box(MARGIN, BOTTOM + 8, WIDE, FOOT * 1.3)
    said = say("slides.sheetOf", sheet=2 * number - 2 + k, of=2 * count)
    frame = [
        text([(Run(head, bold=True),)], title, fitting(head, HEAD), name="title", is_title=True),
        one_line(say("teacher.guide"), under, FOOT, "soft"),
        one_line(said, under, FOOT, "soft", "right", name="sheet"),
    ]
    return Slide(head, (*frame, *(moved(item, TOP, MARGIN) for item in items)), kind="worksheet")


def _first_page(lesson: Lesson, course: list[Scene], base: str) -> list[Item]:
    """The picture beside what the lesson is about; below, both timings, then materials."""
    scene, beside = lesson.scene, WIDE - SIDE - APART
    data = traced_picture(lesson.picture, SHARP)
    frame = Box(WIDE - SIDE, 0.0, SIDE, SIDE)
    alt = say("picture.alt", title=scene.title)
    goals = [plain_text(goal, on_page=True) for goal in scene.goals]
    about = [
        Paragraph((Run(scene.teaches),)), *_list("teacher.before", prerequisites(scene, course)),
        *_list("slides.goals", goals),
    ]  # fmt: skip
    half = (WIDE - APART) / 2
    for size in SIZES:
        items, high = flowed(about, wide=beside, size=size)
        top = max(high, SIDE) + size * 1.5
        tables = [flowed(_timing(scene, length), wide=half, size=size) for length in LECTURES]
        below = top + max(high for _, high in tables) + size * 1.5
        links, more = flowed(_materials(lesson, base), size=size)
        if below + more <= BOTTOM - TOP or size == SIZES[-1]:
            break
    for k, (table, _) in enumerate(tables):
        items += [moved(item, top, k * (half + APART)) for item in table]
    items += [moved(item, below) for item in links]
    return [picture_of(data, frame, alt), *items]


def _fitting(parts: list[Points], room: float) -> list[Item]:
    """Parts under one another, in the largest letters that the room has."""
    points = [point for part in parts for point in part]
    for size in SIZES:
        items, high = flowed(points, size=size)
        if high <= room:
            break
    return items


def _list(key: str, entries: Iterable[str]) -> Points:
    """Under a head; nothing where there are none."""
    listed = [Paragraph((Run(each),), "•") for each in entries]
    return [Paragraph((Run(say(key), bold=True),)), *listed] if listed else []


def _timing(scene: Scene, length: int) -> Points:
    head = Paragraph((Run(say("teacher.timing", minutes=length), bold=True),))
    return [head, *(
        Paragraph((Run(f"{minutes}\u2032  ", bold=True), Run(what)), "•")
        for what, minutes in schedule(scene, length)
    )]  # fmt: skip


def _materials(lesson: Lesson, base: str) -> Points:
    scene = lesson.scene
    page = address(scene, base=base)
    own = [say("teacher.materialPage", address=page)]
    own += [
        say("teacher.materialSlides", address=address(scene, f"slides/{scene.id}.pdf", base)),
        say("teacher.materialSheets", id=scene.id),
        say("teacher.materialQuiz"),
    ]
    return _list("teacher.materials", own)


def _questions(lesson: Lesson) -> Points:
    """Each with its pixel, which "this ray" is of, and the answer that is expected."""
    points = [Paragraph((Run(say("teacher.keyQuestions"), bold=True),))]
    for k, step in enumerate(lesson.scene.lesson, start=1):
        if step.answer:
            asks, answer = (plain_text(each, on_page=True) for each in (step.text, step.answer))
            if pixel := own_pixel(step.view):
                n, x, y = pixel
                asks += f" ({say('slides.pixelOf', x=x, y=y, n=n)})"
            runs = (Run(asks + " "), Run(say("teacher.expected") + " ", True), Run(answer))
            points.append(Paragraph(runs, f"{k}."))
    return points if len(points) > 1 else []


def _misconceptions(lesson: Lesson) -> Points:
    """Wrong choices, and what cures them."""
    points: Points = [Paragraph((Run(say("teacher.misconceptions"), bold=True),))]
    for k, step in enumerate(lesson.scene.lesson, start=1):
        for choice in choice_words(lesson.scene, step):
            if not choice.right:
                head = say("teacher.wrongChoice", step=k, choice=choice.label)
                points.append(Paragraph((Run(head + " ", True), Run(choice.because)), "•"))
    return points if len(points) > 1 else []
