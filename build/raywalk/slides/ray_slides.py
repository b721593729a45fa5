"""The walk along one pixel's rays: a slide a ray, each with what happens to it."""

from __future__ import annotations

from dataclasses import replace

from raywalk.slides.blocks import Flow, continued, flow, flow_texts, footer, title
from raywalk.slides.figure import Run, Slide
from raywalk.slides.layout import SMALLEST, Box, Layout
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.step_figure import step_figure
from raywalk.slides.step_slide import Lesson, legend, step_place, where
from raywalk.slides.stops import Event, Row, Stop
from raywalk.slides.sum_slide import summed_pixel
from raywalk.slides.words import kind_word, say

FEWEST = 2  # rays: the walk along a single one is the step itself
SIZE = SMALLEST + 1
LONG_NUMBERS = 90  # letters: two lines
GATHERED = ("gather", "pixel")  # what comes back stands on the slide of the sum


def ray_slides(lesson: Lesson) -> list[Slide]:
    """The rays of the pixel whose sum is shown, one after the other; [] where there is only one."""
    stop = summed_pixel(lesson)
    if stop is None or len(stop.rows) < FEWEST:
        return []
    return [slide for ray in stop.rows for slide in _ray(lesson, stop, ray)]


def _ray(lesson: Lesson, whole: Stop, ray: Row) -> list[Slide]:
    layout, stop = lesson.layout, _until(whole, ray.number)
    head = say("slides.rayTitle", ray=ray.number, of=len(stop.rows), kind=kind_word(ray.kind))
    figure = step_figure(lesson.drawing(stop, now=ray.number))
    figure = replace(figure, items=(*figure.items, *legend(figure, layout)))
    here = step_place(lesson, stop, ray.number, ray.number)
    under = footer(where(lesson, stop), here, layout)
    events = [each for each in stop.events if each.ray == ray.number and each.what not in GATHERED]
    notes = (here, *(event.in_words for event in events))
    box = _words_box(layout, layout.figure.top)
    if _fitting(events, box).height() > box.height:
        box = _words_box(layout, layout.words.top)
    first, rest = _fitting(events, box).split(box.height)
    items = (title(head, layout.title), figure, *flow_texts(first, box), *under)
    no_figure = box._replace(left=layout.title.left)
    return [
        Slide(head, items, notes, "ray", figure=figure),
        *continued(rest, no_figure, head, layout, "ray", under),
    ]


def _fitting(events: list[Event], box: Box) -> Flow:
    """The events in the box: smaller where they are many, and then without the longest numbers,
    which stand on the slide of the sum."""
    for size, most in ((SIZE, None), (SMALLEST, None), (SMALLEST, LONG_NUMBERS)):
        words = flow([_as_paragraph(each, most) for each in events], size, box.width)
        if words.height() <= box.height:
            break
    return words


def _as_paragraph(event: Event, most: int | None) -> Paragraph:
    """most: numbers of more letters are left out; None: of none."""
    says = tuple(Run(text, mark is not None) for text, mark in event.phrases)
    shown = event.numbers if most is None or len(event.numbers) <= most else ""
    return Paragraph((*says, Run(" "), Run(shown, italic=True)) if shown else says)


def _until(whole: Stop, number: int) -> Stop:
    """What is drawn at a ray: it and its shadow rays, and the way that led to it."""
    chosen = tuple(
        line
        for line in whole.chosen
        if line.ray == number or (line.ray < number and line.light < 0)
    )
    return replace(whole, chosen=chosen, thin=(), one_in=1)


def _words_box(layout: Layout, top: float) -> Box:
    """Beside the figure, and from above it where the words are many."""
    box = layout.aside or layout.words
    return Box(box.left, top, box.width, layout.footer.top - 12 - top)
