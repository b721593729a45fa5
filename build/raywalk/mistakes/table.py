"""The mistakes, as data: mistakes.json, by families in the order of a ray's way.

    does      what the program does, one line
    needs     what a scene must have for it to show: features (features.py), all of them
    speckles  true where rounding decides pixel by pixel. Another program's speckles lie elsewhere:
              what tells is that each pixel is as without the mistake, or as with its own surface in
              the way, and not which of the two

Two that teachers report are not here, as meshes are left out: one normal a triangle where normals
should be interpolated, and interpolated normals that are not made one long.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

Mistakes = frozenset[str]  # names; none: the right program


@dataclass(frozen=True)
class Mistake:
    """One thing that a program does wrongly."""

    name: str
    family: str
    does: str
    needs: tuple[str, ...]
    speckles: bool


_FAMILIES = json.loads((Path(__file__).parent / "mistakes.json").read_text(encoding="utf-8"))
FAMILIES: tuple[str, ...] = tuple(_FAMILIES)
TABLE = tuple(
    Mistake(name, family, row["does"], tuple(row["needs"]), row.get("speckles", False))
    for family, rows in _FAMILIES.items()
    for name, row in rows.items()
)
BY_NAME = {mistake.name: mistake for mistake in TABLE}


def checked(names: Iterable[str]) -> Mistakes:
    """The names, if each is a mistake. Raises ValueError with the nearest names otherwise."""
    names = frozenset(names)
    for name in sorted(names):
        if name not in BY_NAME:
            known = ", ".join(get_close_matches(name, BY_NAME, 3) or BY_NAME)
            raise ValueError(f"there is no mistake {name!r}; did you mean one of: {known}?")
    return names
