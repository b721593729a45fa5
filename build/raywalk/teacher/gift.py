"""A quiz as GIFT, which Moodle imports: plain text, a blank line between questions.

Rules: https://docs.moodle.org/en/GIFT_format.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from raywalk.teacher.quiz import Item

CONTROL = "~=#{}:"  # marks of the format: a backslash takes their meaning


def escaped(text: str) -> str:
    """As it may stand anywhere: no mark, no line's end, no arrow (which makes pairs)."""
    text = text.replace("\\", "\\\\").replace("->", "→")
    for mark in CONTROL:
        text = text.replace(mark, f"\\{mark}")
    return "\\n".join(part.strip() for part in text.splitlines() if part.strip())


def gift(lessons: Iterable[tuple[str, list[Item]]], course: str) -> str:
    """A category a lesson, in the order given."""
    blocks = []
    for title, items in lessons:
        if items:
            # A slash parts categories; a colon or the like is no mark here.
            path = "/".join(part.replace("/", "-") for part in (course, title))
            blocks.append(f"$CATEGORY: {path}")
            blocks += [_question(item) for item in items]
    return "\n\n".join(blocks) + "\n"


def _question(item: Item) -> str:
    head = f"// {item.id}\n::{escaped(item.title)}::[plain]{escaped(item.asks)} "
    return head + "{" + "\n".join([*_answers(item), *_after(item)]) + "\n}"


def _answers(item: Item) -> Iterator[str]:
    if not item.options:
        yield f"#{item.value:.12g}:{item.tolerance:.12g}"
        return
    yield ""
    for option in item.options:
        mark = "=" if option.right else "~"
        because = f"#{escaped(option.because)}" if option.because else ""
        yield f"\t{mark}{escaped(option.text)}{because}"


def _after(item: Item) -> Iterator[str]:
    if item.feedback:
        yield f"\t####{escaped(item.feedback)}"
