"""Pieces of a model that a scene dresses by name: its parts and its materials."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from raywalk.models.clean import Cleaned
from raywalk.models.model import FileMaterial, Model
from raywalk.models.piece import Piece

REST = ""  # the label of what no name was given for


def names_in(model: Model) -> list[str]:
    """All that a scene can dress, materials first."""
    return [*dict.fromkeys(each.name for each in model.materials if each.name),
            *dict.fromkeys(name for name in model.parts if name)]  # fmt: skip


def labels(
    cleaned: Cleaned, dressed: Iterable[str], by_material: bool
) -> tuple[list[str], np.ndarray]:
    """The labels that occur, in the order of the file, and which (f,) int64 a triangle has.

    A part that is named goes before a material that is; what neither names is kept apart by its
    material, or is the rest.
    """
    model, named = cleaned.model, set(dressed)
    found: dict[str, int] = {}
    part = [found.setdefault(n, len(found)) if n in named else -1 for n in model.parts]
    material = [
        found.setdefault(m.name, len(found)) if by_material or m.name in named else -1
        for m in model.materials
    ]
    rest = len(found)
    by_part = np.array([*part, -1])[model.part_of()[cleaned.source]]
    by_name = np.array([*material, -1])[model.material_of()[cleaned.source]]
    which = np.where(by_part >= 0, by_part, np.where(by_name >= 0, by_name, rest))
    occur, index = np.unique(which, return_inverse=True)
    every = [*found, REST]
    return [every[k] for k in occur], index


def chosen(cleaned: Cleaned, piece: Piece) -> np.ndarray:
    """(f,) bool: the triangles of a piece."""
    names, which = labels(cleaned, piece.dressed, piece.by_material)
    if piece.label not in names:
        return np.zeros(len(which), bool)
    return np.asarray(which == names.index(piece.label))


def material_named(model: Model, name: str) -> FileMaterial | None:
    """The file's material of that name."""
    return next((each for each in model.materials if each.name == name), None)
