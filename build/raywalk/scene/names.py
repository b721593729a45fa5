"""Names for what a scene leaves unnamed."""

from __future__ import annotations

from collections.abc import Iterable


def with_defaults(items: Iterable[tuple[int, str | None, str]]) -> dict[int, str]:
    """Names by place: the given ones, else the kind and its number, "sphere 2".

    items: (place, name or None, kind) in the file's order. The number counts all of
    that kind, named or not; a number whose name a person has taken is skipped.
    """
    items = list(items)
    taken = {name for _, name, _ in items if name}
    counts: dict[str, int] = {}
    names = {}
    for place, name, kind in items:
        counts[kind] = number = counts.get(kind, 0) + 1
        while not name and f"{kind} {number}" in taken:
            number += 1
        names[place] = name or f"{kind} {number}"
        taken.add(names[place])
    return names


def untaken(name: str, taken: set[str]) -> str:
    """The name, with a number behind it if it is taken; from now on it is."""
    free, number = name, 1
    while free in taken:
        number += 1
        free = f"{name} {number}"
    taken.add(free)
    return free
