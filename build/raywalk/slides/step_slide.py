"""A stop of the lesson as slides: its headline, its figure, a few of its words on each."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

from raywalk.scene.model import Scene
from raywalk.slides.blocks import BODY_SIZE, flow_texts, footer, title, title_fits
from raywalk.slides.choices import ChoiceWords, choice_marks, choice_slides, choice_words
from raywalk.slides.drawing import Drawing
from raywalk.slides.figure import Group, Item, Slide
from raywalk.slides.layout import Layout
from raywalk.slides.lesson_pictures import picture_slides
from raywalk.slides.lesson_words import Paragraph, plain_text, title_and_body, words_and_pictures
from raywalk.slides.notes import step_notes
from raywalk.slides.picture_inset import inset_of
from raywalk.slides.step_figure import step_figure
from raywalk.slides.stops import Stop
from raywalk.slides.sweep_strip import strip_slides
from raywalk.slides.word_parts import word_parts
from raywalk.slides.words import altered, place, say
from raywalk.slides.worked_figures import Worked, view_of
from raywalk.slides.worked_panel import panel_inset, panel_of


@dataclass(frozen=True, eq=False)
class Lesson:
    """What all slides of one scene's lesson need."""

    scene: Scene
    stops: list[Stop]
    views: Path  # the folder of SIGHTS and view-<k>.png, shaded views
    picture: Path  # the traced picture
    layout: Layout
    worked: Worked = field(default_factory=dict)  # what its steps work out

    def figure(self, stop: Stop, now: int | None = None) -> Group:
        """What is seen at a stop, with the letters of its choices, and the picture in a corner
        unless it gives an answer away. now: the ray that a build-up has come to."""
        view = self.views / f"view-{stop.viewpoint}.png"
        # In its place the picture needs no corner.
        shown = self.picture if view_of(self.scene, stop).get("look") == "traced" else None
        drawing = Drawing(self.scene, stop, view, self.layout.figure, now, shown)
        insets = [choice_marks(asked_choices(self, stop), stop)]
        if (stop.kind != "question" or stop.filled) and not shown:
            insets.append(inset_of(self.picture, self.scene.title, stop))
        panel = panel_of(self.scene, self.stops, stop, self.worked) if now is None else None
        if not panel:
            return step_figure(drawing, insets)
        figure = step_figure(drawing, [*insets, panel_inset(panel, self.scene, stop, self.worked)])
        return replace(figure, alt=f"{figure.alt} {panel.figures.in_words}")

    @property
    def place(self) -> str:
        """The scene in a footer."""
        return " ".join(part for part in (self.scene.key, self.scene.title) if part)


def step_slides(lesson: Lesson, index: int) -> list[Slide]:
    """A step or an answer: its words under its figure, then why each choice is right or wrong, and
    the pictures of its text."""
    layout, stop = lesson.layout, lesson.stops[index]
    choices = asked_choices(lesson, stop)
    head, _ = head_and_body(lesson, stop)
    under = source_line(lesson, stop)
    return [
        *figure_slides(lesson, index),
        *choice_slides(choices, head, layout.below_title, layout, under, revealed=True),
        *shown_slides(lesson, stop),
        *strip_slides(lesson.picture, lesson.scene.title, stop, layout, under),
    ]


def asked_choices(lesson: Lesson, stop: Stop) -> list[ChoiceWords]:
    """Of a question or an answer; [] of a step that asks nothing."""
    step = lesson.scene.lesson[stop.step]
    return choice_words(lesson.scene, step) if stop.kind != "step" else []


def figure_slides(lesson: Lesson, index: int) -> list[Slide]:
    """A stop's words under its figure, on as many slides as they take."""
    layout, stop = lesson.layout, lesson.stops[index]
    figure = lesson.figure(stop)
    head, body = head_and_body(lesson, stop)
    slides = []
    for k, part in enumerate(word_parts(body, layout.words, BODY_SIZE) or [None]):
        texts = flow_texts(part, layout.words) if part else []
        items = (title(head, layout.title), figure, *texts, *source_line(lesson, stop))
        # One figure a stop: as a file of its own it is the same on all of these.
        slides.append(
            Slide(head, items, () if k else said_to(lesson, index), stop.kind, k > 0,
                  None if k else figure)
        )  # fmt: skip
    return slides


def shown_slides(lesson: Lesson, stop: Stop) -> list[Slide]:
    """The pictures of a stop's text."""
    head, _ = head_and_body(lesson, stop)
    _, shown = words_and_pictures(stop.text(lesson.scene))
    folder, layout = lesson.scene.path.parent, lesson.layout
    under = source_line(lesson, stop)
    return [*picture_slides(shown, folder, head, layout.below_title, layout, under, stop.kind)]


def said_to(lesson: Lesson, index: int) -> tuple[str, ...]:
    """A stop's notes."""
    here = step_place(lesson, lesson.stops[index])
    return (here, *step_notes(lesson.scene, lesson.stops, index))


def head_and_body(lesson: Lesson, stop: Stop) -> tuple[str, list[Paragraph]]:
    """What a stop is called, at least the scene's title, and its words."""
    paragraphs, _ = words_and_pictures(stop.text(lesson.scene))
    headline = lesson.scene.lesson[stop.step].headline
    head, body = headline_and_body(headline, paragraphs, lesson.layout)
    return head or lesson.scene.title, body


def headline_and_body(
    headline: str, paragraphs: list[Paragraph], layout: Layout
) -> tuple[str, list[Paragraph]]:
    """A step's written headline and all of its words; where it has none, its first sentence, if it
    fits as a title, and the rest."""
    if headline:
        return plain_text(headline), paragraphs
    return title_and_body(paragraphs, lambda sentence: title_fits(sentence, layout.title.width))


def step_place(lesson: Lesson, stop: Stop) -> str:
    """ "step 4 of 9"."""
    return say("slides.stepOf", step=stop.step + 1, of=len(lesson.scene.lesson))


def source_line(lesson: Lesson, stop: Stop, here: str = "") -> list[Item]:
    """What a slide is of, and which part of it; here: else the step."""
    return footer(where(lesson, stop), here or step_place(lesson, stop), lesson.layout)


def where(lesson: Lesson, stop: Stop) -> str:
    """What a slide is of."""
    parts = [say("slides.brand"), lesson.place]
    if stop.rows:
        parts.append(say("slides.pixelOf", **place(stop)))
    else:
        parts.append(f"{stop.n} × {stop.n}")
    if stop.one_in > 1:
        parts.append(say("slides.oneIn", count=stop.one_in))
    return " · ".join([*parts, *altered(stop)])
