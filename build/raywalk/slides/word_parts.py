"""A step's words in parts that a hall can read: few words each, broken between sentences."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from itertools import groupby

from raywalk.slides.blocks import Flow, flow
from raywalk.slides.figure import Run
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import Paragraph

MOST_WORDS = 40
SENTENCE_END = re.compile(r"(?<=[.?!…])\s+(?=[^\s])")


def word_parts(paragraphs: list[Paragraph], box: Box, size: float) -> list[Flow]:
    """The words laid out, a flow for each slide: at most 40 words and what fits into the box. A
    sentence that is longer by itself is broken between lines."""
    sentences = list(_sentences(paragraphs))
    parts = _filled(sentences, box, size, MOST_WORDS)
    # As many slides, but none with a few words that were left.
    even = -(-sum(map(_count, sentences)) // max(1, len(parts)))
    for most in range(even, MOST_WORDS):
        balanced = _filled(sentences, box, size, most)
        if len(balanced) == len(parts):
            return balanced
    return parts


def _filled(sentences: list[Sentence], box: Box, size: float, most: int) -> list[Flow]:
    """Sentence by sentence, each slide with as many words as it may have."""
    parts: list[Flow] = []
    held: list[Sentence] = []
    for sentence in sentences:
        if held and not _fits([*held, sentence], box, size, most):
            # A formula goes on with the sentence that leads to it.
            along = held[-1:] if sentence[1].is_formula and len(held) > 1 else []
            parts.append(flow(_joined(held[: len(held) - len(along)]), size, box.width))
            held = along
        held.append(sentence)
        if not _fits(held, box, size, MOST_WORDS):
            parts += _cut(flow(_joined(held), size, box.width), box)
            held = []
    return [*parts, flow(_joined(held), size, box.width)] if held else parts


#: With the number of the paragraph that it is of.
Sentence = tuple[int, Paragraph]


def _fits(sentences: list[Sentence], box: Box, size: float, most: int) -> bool:
    if sum(map(_count, sentences)) > most:
        return False
    return flow(_joined(sentences), size, box.width).height() <= box.height + 0.01


def count_words(text: str) -> int:
    """What is read: signs between spaces are none."""
    return sum(any(char.isalnum() for char in word) for word in text.split())


def _count(sentence: Sentence) -> int:
    return count_words(sentence[1].text)


def _cut(whole: Flow, box: Box) -> list[Flow]:
    """Between lines: as many words as are allowed, and as many lines as fit."""
    parts: list[Flow] = []
    while whole.lines:
        first, _ = whole.split(box.height)
        count, words = 0, 0
        for runs, _, _ in first.lines:
            words += count_words("".join(run.text for run in runs))
            if words > MOST_WORDS and count:
                break
            count += 1
        parts.append(Flow(whole.lines[:count], whole.size))
        whole = Flow(whole.lines[count:], whole.size)
    return parts


def _sentences(paragraphs: list[Paragraph]) -> Iterator[Sentence]:
    for k, paragraph in enumerate(paragraphs):
        is_short = count_words(paragraph.text) <= MOST_WORDS
        if paragraph.is_formula or (paragraph.bullet and is_short):  # what stays whole
            yield k, paragraph
            continue
        text = paragraph.text
        starts = [0, *(match.end() for match in SENTENCE_END.finditer(text))]
        for start, end in zip(starts, [*starts[1:], len(text)], strict=True):
            yield (
                k,
                Paragraph(_between(paragraph.runs, start, end), "" if start else paragraph.bullet),
            )


def _joined(sentences: list[Sentence]) -> list[Paragraph]:
    """Sentences of one paragraph as one again."""
    paragraphs = []
    for _, group in groupby(sentences, key=lambda each: each[0]):
        parts = [sentence for _, sentence in group]
        runs = [run for part in parts for run in part.runs]
        runs[-1] = replace(runs[-1], text=runs[-1].text.rstrip())
        paragraphs.append(Paragraph(tuple(runs), parts[0].bullet))
    return paragraphs


def _between(runs: tuple[Run, ...], start: int, end: int) -> tuple[Run, ...]:
    """The runs' characters from start up to end."""
    kept, at = [], 0
    for run in runs:
        piece = run.text[max(0, start - at) : max(0, end - at)]
        if piece:
            kept.append(replace(run, text=piece))
        at += len(run.text)
    return tuple(kept)
