"""A step's words on several slides: few on each, whole sentences, no few words left over."""

from __future__ import annotations

import pytest

from raywalk.slides.figure import Run
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import Paragraph
from raywalk.slides.word_parts import MOST_WORDS, word_parts

BOX = Box(0, 0, 896, 122)


def said(parts) -> list[str]:
    return [" ".join("".join(run.text for run in runs) for runs, _, _ in p.lines) for p in parts]


def paragraph(*lengths: int) -> Paragraph:
    """Sentences of so many words."""
    sentences = [" ".join(["word"] * (count - 1) + [f"end{k}."]) for k, count in enumerate(lengths)]
    return Paragraph((Run(" ".join(sentences)),))


@pytest.mark.parametrize(
    ("lengths", "counts"),
    [
        ((20, 20), [40]),
        ((20, 21), [20, 21]),
        ((30, 5, 6), [30, 11]),
        ((12, 12, 12, 12), [24, 24]),  # not 36 and 12
        ((90,), None),
    ],
)
def test_slides_take_whole_sentences_and_share_them_evenly(lengths, counts):
    """At most 40 words each; a sentence that has more is broken between lines."""
    parts = said(word_parts([paragraph(*lengths)], BOX, 24))
    assert " ".join(parts) == paragraph(*lengths).text
    assert all(len(part.split()) <= MOST_WORDS for part in parts)
    if counts:
        assert [len(part.split()) for part in parts] == counts
        assert all(part.endswith(".") for part in parts)


def test_styles_and_bullets_stay_with_their_words():
    """A sentence in bold is bold on its slide; only a list's first sentence has its sign."""
    bold = Paragraph((Run("One two. ", True), Run("Three. " + "four " * 40 + "five.")), "•")
    first, *rest = word_parts([bold], BOX, 24)
    [(runs, owner, is_first), *_] = first.lines
    assert runs[0] == Run("One two. ", True) and owner.bullet == "•" and is_first
    assert rest and all(owner.bullet == "" for part in rest for _, owner, _ in part.lines)
