"""A step with several rays, a slide a ray: camera ray and hit, shadow rays, mirrored and bent ones,
each with what happens to it, before the step shows them all."""

from __future__ import annotations

from dataclasses import replace

from raywalk.slides.blocks import BODY_SIZE, flow_texts, title
from raywalk.slides.figure import Run, Slide
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.step_slide import Lesson, head_and_body, source_line
from raywalk.slides.stops import Event, Stop
from raywalk.slides.word_parts import word_parts
from raywalk.slides.words import say

MOST = 4  # before the step itself: more keep a class waiting
#: Each of these begins a slide: a ray has ended. What else happens is said with the one before.
HITS, LIGHTS = ("meets", "background"), ("reached", "blocked")
ENDS = HITS + LIGHTS
GATHERED = ("gather", "pixel")  # the sum has slides of its own


def build_up(lesson: Lesson, stop: Stop) -> list[Slide]:
    """[] where there is but one ray to be seen; the last one is the step's own slide."""
    shown = _slides_of(stop)
    if len(shown) - 1 > MOST:
        shown = _without_shadow_rays(shown)
    count = min(MOST, len(shown) - 1)
    return [_slide(lesson, stop, shown[: k + 1], len(shown)) for k in range(count)]


def _slides_of(stop: Stop) -> list[list[Event]]:
    """The events of each slide, in the order in which they happen."""
    slides: list[list[Event]] = []
    before: list[Event] = []  # a ray sets out
    for event in stop.events:
        if event.what in GATHERED:
            continue
        if event.what in ENDS:
            slides.append([*before, event])
            before = []
        elif event.what in ("camera", "reflected", "refracted", "total"):
            before.append(event)
        elif slides:
            slides[-1].append(event)
    return slides


def _without_shadow_rays(slides: list[list[Event]]) -> list[list[Event]]:
    """Where they would be too many, a hit has its shadow rays at once: what a step is about, a ray
    that is bent or mirrored, would never come."""
    fewer: list[list[Event]] = []
    for events in slides:
        if fewer and any(event.what in LIGHTS for event in events):
            fewer[-1] = [*fewer[-1], *events]
        else:
            fewer.append(events)
    return fewer


def _slide(lesson: Lesson, whole: Stop, slides: list[list[Event]], of: int) -> Slide:
    layout, events = lesson.layout, slides[-1]
    reached = {(event.ray, event.light) for slide in slides for event in slide}
    chosen = tuple(line for line in whole.chosen if (line.ray, line.light) in reached)
    stop = replace(whole, chosen=chosen, thin=(), one_in=1)
    head, _ = head_and_body(lesson, whole)
    has_hit = any(event.what in HITS for event in events)
    told = [event for event in events if event.light < 0 or not has_hit]
    words = [Paragraph(tuple(Run(t, mark is not None) for t, mark in e.phrases)) for e in told]
    part = word_parts(_as_one(words), layout.words, BODY_SIZE)[0]
    here = say("slides.buildOf", part=len(slides), of=of)
    items = (
        title(head, layout.title),
        lesson.figure(stop, now=events[-1].ray),
        *flow_texts(part, layout.words),
        *source_line(lesson, whole, here),
    )
    return Slide(head, items, (here, *(event.in_words for event in events)), "build")


def _as_one(sentences: list[Paragraph]) -> list[Paragraph]:
    """Sentences as one paragraph, which begins with a capital even where a name stands first."""
    runs: list[Run] = []
    for sentence in sentences:
        runs += [*([Run(" ")] if runs else []), *sentence.runs]
    first = runs[0]
    runs[0] = replace(first, text=first.text[:1].upper() + first.text[1:])
    return [Paragraph(tuple(runs))]
