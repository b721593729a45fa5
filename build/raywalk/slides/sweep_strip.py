"""What moves, on paper: a slide with some stops of a sweep side by side, behind the step's own."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from raywalk.slides.blocks import one_line, title
from raywalk.slides.figure import Group, Item, Polygon, Slide
from raywalk.slides.layout import SMALLEST, Box, Layout
from raywalk.slides.picture_inset import framed_picture
from raywalk.slides.pictures import WHOLE
from raywalk.slides.stops import Stop, StripPicture
from raywalk.slides.words import say

LEAST = 160.0  # points across: smaller ones are not seen from the last row
GAP = 14.0  # between pictures
VALUE = 34.0  # a line under each


def strip_slides(
    picture: Path, name: str, stop: Stop, layout: Layout, under: list[Item]
) -> list[Slide]:
    """[] where nothing moves. name: the scene's title. under: what stands at the foot."""
    if stop.strip is None:
        return []
    box = layout.below_title
    shown = _few(stop.strip.pictures, int((box.width + GAP) / (LEAST + GAP)))
    side = min((box.width - GAP * (len(shown) - 1)) / len(shown), box.height - VALUE)
    wide = len(shown) * (side + GAP) - GAP
    left, top = box.left + (box.width - wide) / 2, box.top + (box.height - side - VALUE) / 2
    told = say("slides.strip", name=stop.strip.name)
    head = told[:1].upper() + told[1:]
    parts: list[Item] = []
    for k, each in enumerate(shown):
        frame = Box(left + k * (side + GAP), top, side, side)
        parts += framed_picture(picture, name, replace(stop, picture=each), frame, WHOLE)
        if each.is_here:
            around = Box(frame.left - 3, frame.top - 3, side + 6, side + 6)
            parts.append(Polygon(around.corners, None, "chosen", 3.0, name=each.value))
        below = Box(frame.left - GAP / 2, frame.bottom + 8, side + GAP, VALUE - 8)
        parts.append(one_line(each.value, below, SMALLEST, "ink", "centre"))
    alt = f"{head}: {', '.join(each.value for each in shown)}"
    group = Group(head, alt, tuple(parts))
    return [Slide(head, (title(head, layout.title), group, *under), (alt,), stop.kind, True)]


def _few(pictures: tuple[StripPicture, ...], most: int) -> list[StripPicture]:
    """Both ends and, if there is room, the step's own stop and others between."""
    if len(pictures) <= most:
        return list(pictures)
    last = len(pictures) - 1
    here = next(k for k, each in enumerate(pictures) if each.is_here)
    between = [k for k in range(1, last) if k != here]
    middle = sorted(between, key=lambda k: abs(k - last / 2))
    kept = [*{0: None, last: None, here: None}, *middle][:most]
    return [pictures[k] for k in sorted(kept)]
