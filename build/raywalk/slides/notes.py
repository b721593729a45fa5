"""What a speaker reads: the step's words, then its rays event by event, as the player does."""

from __future__ import annotations

from collections.abc import Iterator

from raywalk.slides.lesson_words import plain_text
from raywalk.slides.placing import Placed
from raywalk.slides.sights import Seen
from raywalk.slides.words import say, words
from raywalk.telling import RayEvent, events_of, tell, told_scene


def step_notes(placed: Placed, seen: Seen) -> Iterator[str]:
    """Paragraphs; an asking step's say nothing that gives its answer away."""
    yield plain_text(seen.stop.text)
    if seen.stop.kind == "question":
        yield say("slides.questionNote")
    elif seen.chosen:
        for event in pixel_events(placed, seen):
            told = tell(event, words())
            yield " ".join(part for part in (told.sentence, told.numbers) if part)


def pixel_events(placed: Placed, seen: Seen) -> list[RayEvent]:
    """What happens to the selected pixel's rays, in true order."""
    return events_of(seen.trace, told_scene(seen.scene, placed.radius), seen.view.pixel)


def lit_hits(placed: Placed, seen: Seen) -> Iterator[tuple[int, str]]:
    """Each hit with a colour of its own, as its ray and the sum that its lights make."""
    for event in pixel_events(placed, seen):
        if event.what == "local":
            yield event.ray, tell(event, words()).numbers
