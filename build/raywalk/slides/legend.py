"""What the lines' styles mean, on a plate at the figure's lower edge."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from raywalk.slides.blocks import one_line
from raywalk.slides.figure import Group, Item, Line, Polygon, flat
from raywalk.slides.labels import Places
from raywalk.slides.layout import SMALLEST, Box
from raywalk.slides.palette import KINDS
from raywalk.slides.typeface import width
from raywalk.slides.words import kind_word, say

SAMPLE = 36.0  # of a line; a head would cover what its dashes tell
HIGH = 26.0
GAP = 16.0
EDGE = 10.0  # from the figure's
PAD = 6.0


class Entry(NamedTuple):
    word: str
    colour: str
    dash: str
    line_width: float

    @property
    def wide(self) -> float:
        return SAMPLE + 6 + width(self.word, SMALLEST)


def legend(
    items: Iterable[Item], places: Places, line_width: float, hidden_width: float
) -> list[Item]:
    """Only of lines that are drawn: rays may run outside the figure. In as few rows as find a
    place where they cover nothing."""
    lines = [item for item in flat(tuple(items)) if isinstance(item, Line)]
    drawn = {line.colour for line in lines}
    entries = [Entry(kind_word(k), k, k, line_width) for k in KINDS if k in drawn]
    if any(line.dash == "hidden" for line in lines):
        entries.append(Entry(say("slides.hidden"), "soft", "hidden", hidden_width))
    if not entries:
        return []
    rows, plate = _place(entries, places)
    places.boxes.append(plate)
    parts: list[Item] = [Polygon(plate.corners, "ground", opacity=0.85, name="plate of the legend")]
    for k, row in enumerate(rows):
        parts += _row(row, plate.left + PAD, plate.top + k * HIGH)
    return [Group(say("slides.legend"), "", tuple(parts))]


def _place(entries: list[Entry], places: Places) -> tuple[list[list[Entry]], Box]:
    """Its rows and its plate: below or above, left or beside what stands there; at last where it
    covers something, for it must be read. On no chosen ray, where that can be."""
    free = list(_free(entries, places))
    clear = (each for each in free if not places.is_struck(each[1]))
    if found := next(clear, None) or next(iter(free), None):
        return found
    rows = [[each] for each in entries]
    wide = max(each.wide for each in entries) + 2 * PAD
    high = HIGH * len(rows)
    frame = places.frame
    return rows, Box(frame.left + EDGE, frame.bottom - EDGE - high, wide, high)


def _free(entries: list[Entry], places: Places) -> Iterator[tuple[list[list[Entry]], Box]]:
    """What would cover no word and no thing, the best first."""
    frame = places.frame
    for count in range(1, len(entries) + 1):
        rows = _rows(entries, count)
        wide = max(sum(each.wide + GAP for each in row) - GAP for row in rows) + 2 * PAD
        high = HIGH * len(rows)
        for top in (frame.bottom - EDGE - high, frame.top + EDGE):
            lefts = [frame.left, *sorted(box.right for box in places.boxes)]
            for left in lefts:
                plate = Box(left + EDGE, top, wide, high)
                if plate.right <= frame.right - EDGE and not any(
                    box.overlaps(plate) for box in places.boxes
                ):
                    yield rows, plate


def _rows(entries: list[Entry], count: int) -> list[list[Entry]]:
    """Into so many rows, the first ones no shorter."""
    long = -(-len(entries) // count)
    return [entries[k : k + long] for k in range(0, len(entries), long)]


def _row(entries: list[Entry], left: float, top: float) -> list[Item]:
    items: list[Item] = []
    middle = top + HIGH / 2
    for entry in entries:
        ends = ((left, middle), (left + SAMPLE, middle))
        place = Box(left + SAMPLE + 6, top, width(entry.word, SMALLEST) + 1, HIGH)
        items.append(Line(*ends, entry.colour, entry.line_width, entry.dash, name=entry.word))
        items.append(one_line(entry.word, place, name=entry.word))
        left += entry.wide + GAP
    return items
