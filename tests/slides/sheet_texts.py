"""A sheet's questions with their answers, as they stand in its display list."""

from __future__ import annotations

import re
from collections.abc import Iterator

from raywalk.slides.figure import Text


def question_texts(texts: list[Text], size: float) -> Iterator[tuple[str, str]]:
    """(question, answer): a text after a number, and the next one that is all bold and no choice.
    size: of their letters."""
    number, asked = False, ""
    for each in texts:
        if each.name == "bullet":
            number = bool(re.fullmatch(r"\d+\.", each.words))
        elif each.size == size and each.name == "words":
            is_bold = all(run.bold for line in each.lines for run in line)
            if number:
                asked, number = each.words, False
            elif is_bold and asked:
                yield asked, each.words
                asked = ""
