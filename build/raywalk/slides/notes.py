"""What a speaker reads: the step's words, then its rays event by event, as the player does."""

from __future__ import annotations

from collections.abc import Iterator

from raywalk.scene.model import Scene
from raywalk.slides.lesson_words import plain_text
from raywalk.slides.stops import Stop
from raywalk.slides.words import say


def step_notes(scene: Scene, stop: Stop) -> Iterator[str]:
    """Paragraphs; an asking step's say nothing that gives its answer away."""
    yield plain_text(stop.text(scene))
    if stop.kind == "question":
        yield say("slides.questionNote")
    yield from (event.in_words for event in stop.events)
