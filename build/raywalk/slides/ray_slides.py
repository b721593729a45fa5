"""The walk along one pixel's rays: a slide a ray, each with what happens to it."""

from __future__ import annotations

from dataclasses import replace

from raywalk.slides.blocks import Flow, flow, flow_texts, footer, title
from raywalk.slides.figure import Run, Slide
from raywalk.slides.layout import SMALLEST, Box, Layout
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.notes import pixel_events
from raywalk.slides.sights import Seen, Sight
from raywalk.slides.step_figure import Drawing, ray_order, step_figure
from raywalk.slides.step_slide import Lesson, legend, step_place, where
from raywalk.slides.sum_slide import told_pixel
from raywalk.slides.words import kind_word, say, words
from raywalk.telling import Told, tell
from raywalk.trace_file import Kind

FEWEST = 2  # rays: the walk along a single one is the step itself
SIZE = SMALLEST + 1
LONG_NUMBERS = 90  # letters: two lines
GATHERED = ("gather", "pixel")  # what comes back stands on the slide of the sum


def ray_slides(lesson: Lesson) -> list[Slide]:
    """The rays of the pixel whose sum is told, one after the other; [] where there is only one."""
    index = told_pixel(lesson)
    if index is None:
        return []
    order = ray_order(lesson.seen[index])
    if len(order) < FEWEST:
        return []
    return [slide for number in range(1, len(order) + 1) for slide in _ray(lesson, index, number)]


def _ray(lesson: Lesson, index: int, number: int) -> list[Slide]:
    layout, whole = lesson.layout, lesson.seen[index]
    order = ray_order(whole)
    seen, sight = _until(whole, lesson.sights[index], order, number)
    ray = order[number - 1]
    kind = kind_word(Kind(int(seen.trace.kind[ray])).name.lower())
    head = say("slides.rayTitle", ray=number, of=len(order), kind=kind)
    figure = step_figure(Drawing(lesson.placed, seen, sight, layout.figure, now=ray))
    figure = replace(figure, items=(*figure.items, *legend(figure, layout)))
    here = step_place(lesson, seen, number, number)
    under = footer(where(lesson, seen), here, layout)
    told = [tell(event, words()) for event in pixel_events(lesson.placed, whole)
            if event.ray == ray and event.what not in GATHERED]  # fmt: skip
    notes = (here, *(" ".join(p for p in (t.sentence, t.numbers) if p) for t in told))
    box = _words_box(layout, layout.figure.top)
    if _fitting(told, box).height() > box.height:
        box = _words_box(layout, layout.words.top)
    first, rest = _fitting(told, box).split(box.height)
    items = (title(head, layout.title), figure, *flow_texts(first, box), *under)
    slides = [Slide(head, items, notes, "ray", figure=figure)]
    while rest.lines:
        part, rest = rest.split(box.height)
        box = box._replace(left=layout.title.left)  # no figure stands there
        again = say("slides.continued", title=head)
        items = (title(again, layout.title), *flow_texts(part, box), *under)
        slides.append(Slide(again, items, (), "ray", True))
    return slides


def _fitting(told: list[Told], box: Box) -> Flow:
    """The events in the box: smaller where they are many, and then without the longest numbers,
    which stand on the slide of the sum."""
    for size, most in ((SIZE, None), (SMALLEST, None), (SMALLEST, LONG_NUMBERS)):
        words = flow([_told(each, most) for each in told], size, box.width)
        if words.height() <= box.height:
            break
    return words


def _told(event: Told, most: int | None) -> Paragraph:
    """most: numbers of more letters are left out; None: of none."""
    says = tuple(Run(text, mark is not None) for text, mark in event.says)
    shown = event.numbers if most is None or len(event.numbers) <= most else ""
    return Paragraph((*says, Run(" "), Run(shown, italic=True)) if shown else says)


def _until(whole: Seen, sight: Sight, order: list[int], number: int) -> tuple[Seen, Sight]:
    """What is drawn at a ray: it and its shadow rays, and the way that led to it."""
    ray, before = order[number - 1], set(order[: number - 1])
    kept = [
        k
        for k, line in enumerate(whole.chosen)
        if line.ray == ray or (line.ray in before and line.light < 0)
    ]
    chosen, hidden = [whole.chosen[k] for k in kept], [sight.chosen[k] for k in kept]
    return (
        replace(whole, chosen=chosen, thin=[], one_in=1),
        replace(sight, chosen=hidden, thin=[]),
    )


def _words_box(layout: Layout, top: float) -> Box:
    """Beside the figure, and from above it where the words are many."""
    box = layout.aside or layout.words
    return Box(box.left, top, box.width, layout.footer.top - 12 - top)
