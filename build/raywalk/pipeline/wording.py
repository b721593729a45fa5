"""Words in lessons that the glossary says to avoid."""

from __future__ import annotations

from collections.abc import Iterator

from raywalk.errors import shown_path
from raywalk.scene.model import Scene
from raywalk.scene.translation import Spoken, translation_file
from raywalk.scene.wording import key_path
from raywalk.terms.glossary import Glossary, read_glossary
from raywalk.words.catalogue import DEFAULT


def avoided_words(spoken: list[Spoken], code: str) -> Iterator[str]:
    """A line for each: file, key, words, what to say instead. spoken: scenes in the language of
    this code; those that are not translated are in another one, and left out."""
    glossary = read_glossary(code)
    for each in spoken:
        if each.is_translated:
            yield from _of_scene(each.scene, code, glossary)


def _of_scene(scene: Scene, code: str, glossary: Glossary) -> Iterator[str]:
    file = scene.path if code == DEFAULT else translation_file(scene, code)
    for key, text in texts_of(scene):
        for avoided in glossary.avoided_in(text):
            yield f"{shown_path(file)}: {key}: {avoided}"


def texts_of(scene: Scene) -> Iterator[tuple[str, str]]:
    """All that a scene says, with its key in the scene's file."""
    yield "title", scene.title
    yield "teaches", scene.teaches
    for i, goal in enumerate(scene.goals):
        yield f"goals[{i}]", goal
    for i, step in enumerate(scene.lesson):
        for place, (text, _) in step.said().items():
            yield key_path(("lesson", i, *place)), text
