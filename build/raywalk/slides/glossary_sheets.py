"""The terms of a lesson with their meanings, for the end of a handout."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from raywalk.scene.model import Scene
from raywalk.slides.blocks import flow, flow_texts, text
from raywalk.slides.figure import Item, Run
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import Paragraph, plain_text
from raywalk.slides.words import say, words
from raywalk.terms.glossary import Term, read_glossary

SIZE, HEAD = 11.5, 18.0


def lesson_terms(scene: Scene) -> list[Term]:
    """Those that the lesson uses, in the order of their words, in the language that is spoken."""
    glossary = read_glossary(words().code)
    texts = [plain_text(said) for step in scene.lesson for said, _ in step.said().values()]
    used = {found.term.id for each in texts for found in glossary.found_in(each)}
    return [term for term in glossary.terms if term.id in used and term.is_marked]


def glossary_sheets(terms: Sequence[Term], box: Box) -> Iterator[list[Item]]:
    """Items of as many sheets as the terms need; none without terms."""
    if not terms:
        return
    heading = (Run(say("pages.glossary.title"), bold=True),)
    left: list[Item] = [text([heading], box._replace(height=HEAD * 1.2), HEAD, name="title")]
    room = Box(box.left, box.top + HEAD * 1.8, box.width, box.height - HEAD * 1.8)
    rest = flow(
        [Paragraph((Run(term.term, bold=True), Run(f": {term.says}"))) for term in terms],
        SIZE, box.width,
    )  # fmt: skip
    while rest.lines:
        part, rest = rest.split_between(room.height)
        yield [*left, *flow_texts(part, room)]
        left, room = [], box
