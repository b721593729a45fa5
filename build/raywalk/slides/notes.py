"""What a speaker reads under a slide."""

from __future__ import annotations

from collections.abc import Iterator

from raywalk.scene.model import Scene
from raywalk.slides.addresses import step_address
from raywalk.slides.choices import in_notes
from raywalk.slides.lesson_words import plain_text
from raywalk.slides.stops import Stop
from raywalk.slides.times import STEP_MINUTES
from raywalk.slides.words import say


def step_notes(scene: Scene, stops: list[Stop], index: int) -> Iterator[str]:
    """The step's words, then its rays event by event, as the player does; what to ask next, and
    where it is live. Paragraphs; an asking step's say nothing that gives its answer away."""
    stop = stops[index]
    yield plain_text(stop.text(scene))
    if stop.kind != "answer":
        yield say("slides.minutes", count=STEP_MINUTES)
    if stop.kind == "question":
        yield say("slides.questionNote")
    if stop.kind != "step":
        yield from in_notes(scene, scene.lesson[stop.step], stop.kind == "answer")
    yield from (event.in_words for event in stop.events)
    asked = next((later for later in stops[index + 1 :] if later.kind == "question"), None)
    if asked and stop.kind == "step":
        yield say("slides.ask", question=plain_text(asked.text(scene)))
    yield say("slides.live", address=step_address(scene, stop.step, stop.kind == "answer"))
