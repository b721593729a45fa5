"""Which scenes show a mistake, and which one its page shows: asked of what clarity.py has found."""

from __future__ import annotations

from typing import Any, NamedTuple

from raywalk.mistakes.table import TABLE

# An earlier scene has fewer rays to look at: it is taken if it shows a mistake nearly as well.
NEARLY = 0.3


class Clarity(NamedTuple):
    """Of one mistake in one scene."""

    changed: float  # share of the pixels that it changes at all
    clear: float  # mean over all pixels of how plainly it changes them, 0 to 1
    is_seen: bool  # in enough of them to tell


class Shown(NamedTuple):
    """Ids of scenes."""

    best: str
    all: tuple[str, ...]  # that show it, in the course's order


def best_scenes(
    of_scenes: dict[str, dict[str, Any]], named: dict[str, tuple[str, ...]]
) -> dict[str, Shown]:
    """By mistake, of those that show anywhere. of_scenes: what clarity.json says, by scene, in the
    course's order; named: mistakes that scenes say they are good at showing."""
    shown = {}
    for mistake in TABLE:
        here = {
            id: Clarity(*told["mistakes"][mistake.name])
            for id, told in of_scenes.items()
            if mistake.name in told["mistakes"]
        }
        seen = {id: each.clear for id, each in here.items() if each.is_seen}
        if seen:
            most = max(seen.values())
            plainly = (id for id, clear in seen.items() if clear >= NEARLY * most)
            wished = (id for id in seen if mistake.name in named.get(id, ()))
            best = next(wished, None) or next(plainly)
            shown[mistake.name] = Shown(best, tuple(seen))
    return shown
