"""What a speaker reads: the step's words, and its rays with all numbers."""

from __future__ import annotations

from collections.abc import Iterator

from raywalk.scene.model import Scene
from raywalk.slides.lesson_words import plain_text
from raywalk.slides.sights import Seen
from raywalk.slides.words import say


def step_notes(scene: Scene, seen: Seen) -> Iterator[str]:
    """Paragraphs."""
    yield plain_text(seen.stop.text)
    if seen.stop.kind == "question":
        yield say("slides.questionNote")
