"""A slide's words as the one body that outlines and screen readers look for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from raywalk.slides.figure import Item, Text
from raywalk.slides.layout import Box

APART = 1.0  # of a line: paragraphs further from one another belong to different things


class BodyParagraph(NamedTuple):
    text: Text
    bullet: str
    before: float  # points above it


class Body(NamedTuple):
    box: Box
    paragraphs: list[BodyParagraph]
    items: list[Item]  # which of the slide's it is made of


def body_of(items: Sequence[Item]) -> Body | None:
    """The first words of a slide with all paragraphs that stand below one another; None of a slide
    without words."""
    bullets: dict[float, Text] = {}
    body: Body | None = None
    for item in items:
        if not isinstance(item, Text) or item.name not in ("bullet", "words"):
            continue
        if item.name == "bullet":
            bullets[item.box.top] = item
            continue
        before = item.box.top - body.box.bottom if body else 0.0
        if before > APART * item.size or before < -1:
            break
        mark = bullets.get(item.box.top)
        own: list[Item] = [mark, item] if mark else [item]
        paragraph = BodyParagraph(item, mark.words if mark else "", before)
        if body is None:
            body = Body(item.box, [paragraph], own)
        else:
            body = Body(
                _round_both(body.box, item.box), [*body.paragraphs, paragraph], body.items + own
            )
    if body is None:
        return None
    left = min(item.box.left for item in body.items if isinstance(item, Text))
    return body._replace(box=_round_both(body.box, body.box._replace(left=left, width=1.0)))


def _round_both(a: Box, b: Box) -> Box:
    left, top = min(a.left, b.left), min(a.top, b.top)
    return Box(left, top, max(a.right, b.right) - left, max(a.bottom, b.bottom) - top)
