"""Pictures of a lesson's text on slides of their own, behind that of their step."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from pathlib import Path

from PIL import Image

from raywalk.slides.blocks import one_line, title
from raywalk.slides.figure import Item, Picture, Polygon, Slide
from raywalk.slides.layout import SMALLEST, Box, Layout
from raywalk.slides.lesson_words import Shown
from raywalk.slides.pictures import CLEAR, jpeg, png, webp
from raywalk.slides.words import say

MOST_PIXELS = 1600  # across: more is not seen on a slide
CAPTION = 24.0  # points
EDGE = 8.0  # of paper round a picture


def picture_slides(
    shown: Iterable[Shown], folder: Path, head: str, box: Box, layout: Layout, under: list[Item],
    kind: str,
) -> Iterator[Slide]:  # fmt: skip
    """A slide a picture, with what it shows under it; `under` stands on each.

    folder: the scene's. box: the slide's room below its title.
    """
    again = say("slides.continued", title=head)
    for each in shown:
        data, size = laid_on_white(folder / each.file)
        room = Box(
            box.left + EDGE, box.top + EDGE, box.width - 2 * EDGE, box.height - CAPTION - 2 * EDGE
        )
        # A point a pixel at most: more would be blurred.
        scale = min(room.width / size[0], room.height / size[1], 1.0)
        wide, high = size[0] * scale, size[1] * scale
        frame = Box(
            room.left + (room.width - wide) / 2, room.top + (room.height - high) / 2, wide, high
        )
        paper = Box(frame.left - EDGE, frame.top - EDGE, wide + 2 * EDGE, high + 2 * EDGE)
        below = Box(box.left, paper.bottom + 4, box.width, CAPTION - 4)
        items: list[Item] = [
            title(again, layout.title),
            Polygon(paper.corners, "#ffffff", "rule", 0.75, name=each.file),
            Picture(frame, data[0], data[0], each.file, each.alt, data[1]),
            one_line(each.alt, below, SMALLEST, "soft", "centre", name="caption"),
        ]
        yield Slide(again, (*items, *under), (each.alt,), kind, True)


@lru_cache(maxsize=8)
def laid_on_white(file: Path) -> tuple[tuple[bytes, bytes], tuple[int, int]]:
    """A picture's file for paper and screen and its WebP, and its width and height: on white, as
    black lines without a ground would not be seen on dark slides; photographs stay JPEG."""
    with Image.open(file) as opened:
        drawn = opened.format in ("PNG", "WEBP")
        image = opened.convert("RGBA")
    ground = Image.new("RGBA", image.size, "white")
    image = Image.alpha_composite(ground, image).convert("RGB")
    image.thumbnail((MOST_PIXELS, MOST_PIXELS), Image.Resampling.LANCZOS)
    sharp = png(image) if drawn else b""
    small = jpeg(image, CLEAR)
    best = sharp if sharp and len(sharp) < max(60_000, 2 * len(small)) else small
    return (best, webp(image)), image.size
