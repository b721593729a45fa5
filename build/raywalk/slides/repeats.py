"""What several slides show alike, so that a file may hold it once: a grid's tiles, above all."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from raywalk.slides.figure import Group, Item, Line, Polygon, flat

MANY = 40  # parts: of fewer a reference would save nothing


def is_large(group: Group) -> bool:
    """Of many plain areas and lines: no words, no pictures, nothing that shows through."""
    return len(group.items) >= MANY and all(map(_is_plain, group.items))


def _is_plain(item: Item) -> bool:
    return isinstance(item, Line) or (isinstance(item, Polygon) and item.opacity == 1.0)


def repeated_groups(slides: Iterable[tuple[Item, ...]]) -> dict[Group, str]:
    """Large groups that stand on more than one of the slides, each with a name of its own."""
    found = Counter(
        item for items in slides for item in flat(items)
        if isinstance(item, Group) and is_large(item)
    )  # fmt: skip
    again = [group for group, count in found.items() if count > 1]
    return {group: f"group-{k}" for k, group in enumerate(again)}
