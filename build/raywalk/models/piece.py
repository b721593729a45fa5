"""Which triangles of a model an object of a scene is made of."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Piece:
    """The triangles of one label, as `labels` gives them for these names."""

    of: str  # what the whole is called in its scene
    label: str
    dressed: tuple[str, ...] = ()  # names that the scene gives a material
    by_material: bool = False  # the others are kept apart by the file's materials
    first: bool = True  # it speaks for the whole
