"""Areas of one kind in a row, as the tiles of a grid are: writers put them together."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby

from raywalk.slides.figure import Item, Point, Polygon

FEWEST = 4  # areas: fewer are written one by one


def gathered(items: Iterable[Item]) -> Iterator[Item | list[Polygon]]:
    """The items in order; opaque areas in a row with the same edge, which do not overlap, as a
    list. Those with an edge are filled with a colour as it is, no palette's."""
    for key, run in groupby(items, _edge):
        row = list(run)
        if key is None or len(row) < FEWEST:
            yield from row
        else:
            yield [area for area in row if isinstance(area, Polygon)]


def _edge(item: Item) -> tuple[str | None, float] | None:
    """What areas must have in common; None for what is no such area."""
    if isinstance(item, Polygon) and item.opacity == 1 and (item.fill or "#")[0] == "#":
        return item.edge, item.edge_width
    return None


def by_fill(areas: Iterable[Polygon]) -> dict[str | None, list[tuple[Point, ...]]]:
    """Outlines by the colour that fills them, None for those that are empty."""
    filled: dict[str | None, list[tuple[Point, ...]]] = {}
    for area in areas:
        filled.setdefault(area.fill, []).append(area.points)
    return filled
