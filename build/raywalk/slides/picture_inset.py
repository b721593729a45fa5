"""The traced picture in a corner of the figure, with the selected pixel framed: whole where a
tile of it can be seen from the last row, else enlarged round the pixel."""

from __future__ import annotations

from pathlib import Path

from raywalk.slides.blocks import one_line
from raywalk.slides.clip import clipped_line
from raywalk.slides.figure import Item, Point, Polygon, hex_of
from raywalk.slides.labels import Inset, Places
from raywalk.slides.layout import SMALLEST, Box
from raywalk.slides.pictures import PICTURE_SIDE, Window, grid_picture, picture_of, traced_picture
from raywalk.slides.stops import Stop
from raywalk.slides.words import chosen_tile, say

SIDE = 164.0
SHARP = 246  # pixels: it is in each figure's file
CAPTION = 26.0
EDGE = 10.0  # to the figure's
MOST_TILES = 21  # across: finer grids are shown in part
SHOWN_TILES = 15  # of those


def inset_of(picture: Path, title: str, stop: Stop) -> Inset:
    """What draws it, in the corner where it covers least."""

    def draw(places: Places) -> list[Item]:
        box = _corner(places, CAPTION if stop.rows else 0.0)
        places.boxes.append(box)
        place = Box(box.left, box.top, SIDE, SIDE)
        return [
            *framed_picture(picture, title, stop, place, sharp=SHARP),
            *(_caption(stop, box) if stop.rows else []),
        ]

    return draw


def framed_picture(
    picture: Path, title: str, stop: Stop, frame: Box, window: Window | None = None,
    sharp: int = PICTURE_SIDE, is_marked: bool = True,
) -> list[Item]:  # fmt: skip
    """The picture, or a part of it; is_marked: with the selected tile framed. window: None for the
    part round that tile."""
    window = window or window_of(stop.n, stop.pixel)
    if stop.picture:  # with the step's switches set, as the finest grid has it
        data = grid_picture(stop.picture.tiles, stop.picture.n, window)
    else:
        data = traced_picture(picture, sharp, window)
    items: list[Item] = [
        picture_of(data, frame, say("picture.alt", title=title)),
        Polygon(frame.corners, None, "rule", 1.0, name=say("slides.picture")),
    ]
    return [*items, *(_frame_of_tile(stop, frame, window) if is_marked else [])]


def _frame_of_tile(stop: Stop, frame: Box, window: Window) -> list[Item]:
    tile = frame.width / stop.n / window.share
    left = frame.left + (stop.pixel[0] / stop.n - window.left) / window.share * frame.width
    top = frame.top + (stop.pixel[1] / stop.n - window.top) / window.share * frame.height
    square = Box(left - 1, top - 1, tile + 2, tile + 2).corners
    name = chosen_tile(stop.pixel)
    return [
        Polygon(square, None, "#000000", 5.0, name=name),
        Polygon(square, None, "#f0e442", 2.6, name=name),
    ]


def window_of(n: int, pixel: tuple[int, int]) -> Window:
    """Which part of the picture is shown; whole tiles of it, shares of its side."""
    if n <= MOST_TILES:
        return Window(0.0, 0.0, 1.0)
    first = [min(max(0, k - SHOWN_TILES // 2), n - SHOWN_TILES) for k in pixel]
    return Window(first[0] / n, first[1] / n, SHOWN_TILES / n)


def _corner(places: Places, below: float) -> Box:
    """The corner of the figure with the fewest of the selected rays; of equal ones the first."""
    frame, high = places.frame, SIDE + below
    lefts = (frame.right - EDGE - SIDE, frame.left + EDGE)
    tops = (frame.top + EDGE, frame.bottom - EDGE - high)
    corners = [Box(left, top, SIDE, high) for top in tops for left in lefts]

    def crossed(box: Box, by: list[tuple[Point, Point]]) -> int:
        return sum(clipped_line(*stroke, box) is not None for stroke in by)

    def covers(box: Box) -> tuple[int, int]:
        taken = sum(box.overlaps(other) for other in places.boxes)
        return crossed(box, places.strokes) + taken, crossed(box, places.faint)

    return min(corners, key=covers)


def _caption(stop: Stop, box: Box) -> list[Item]:
    """The pixel's colour, under the picture."""
    plate = Box(box.left, box.top + SIDE, box.width, CAPTION)
    swatch = Box(plate.left + 6, plate.top + 5, 16, 16)
    words = Box(swatch.right + 8, plate.top, plate.right - swatch.right - 10, CAPTION)
    return [
        Polygon(plate.corners, "ground", opacity=0.85, name="plate of the colour"),
        Polygon(swatch.corners, hex_of(stop.bytes), "rule", 0.75, name=say("slides.swatch")),
        one_line(", ".join(map(str, stop.bytes)), words, SMALLEST),
    ]
