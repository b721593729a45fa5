"""What every reader makes: triangles with all that their file says of them, before any cleaning."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

Colour = tuple[float, float, float]


@dataclass(frozen=True)
class FileMaterial:
    """A material as a file describes it; colours from 0 to 1."""

    name: str
    diffuse: Colour | None = None
    specular: Colour | None = None
    shininess: float | None = None
    opacity: float = 1.0
    texture: Path | None = None  # file of a picture that multiplies `diffuse`
    texture_inside: int = -1  # which picture of a glTF file it is
    texture_filter: str = "bilinear"  # or "nearest"


@dataclass(frozen=True, eq=False)
class PerCorner:
    """A value at each corner of each triangle: rows of a table, which corners may share."""

    table: np.ndarray  # (n, k) float64
    row: np.ndarray  # (f, 3) int64; -1 where the file gives none

    def of(self, triangles: np.ndarray) -> PerCorner:
        """The same of these triangles only: a mask or indices."""
        return PerCorner(self.table, self.row[triangles])


@dataclass(frozen=True, eq=False)
class Model:
    """Triangles of one file, in its own coordinates. f triangles, v vertices."""

    path: Path
    format: str  # as a person calls it, such as "binary STL"
    vertices: np.ndarray  # (v, 3) float64
    faces: np.ndarray  # (f, 3) int64
    parts: tuple[str, ...] = ("",)  # names; "" is what has none
    part: np.ndarray | None = None  # (f,) int32 into parts; None: all are of the first
    materials: tuple[FileMaterial, ...] = ()
    material: np.ndarray | None = None  # (f,) int32 into materials, -1 for none
    normals: PerCorner | None = None  # of 3
    texture_places: PerCorner | None = None  # of 2: u to the right and v up
    colours: PerCorner | None = None  # of 3, each from 0 to 1
    colours_of: str = ""  # "vertices" or "faces"
    smoothing: np.ndarray | None = None  # (f,) int32 groups; 0 flat
    flat: bool = False  # one normal a triangle, unless a scene says `smooth = true`
    ignored: tuple[str, ...] = ()  # what of the file is not used, a sentence each
    grain: float = 0.0  # step of its numbers as a share of their place; 2^-23 for float32
    unit: str = ""  # if the file says it
    beside: tuple[Path, ...] = field(default=())  # other files that it was read from

    def part_of(self) -> np.ndarray:
        """(f,) int32"""
        if self.part is None:
            return np.broadcast_to(np.int32(0), len(self.faces))  # of no weight
        return self.part

    def material_of(self) -> np.ndarray:
        """(f,) int32, -1 for none"""
        if self.material is None:
            return np.full(len(self.faces), -1, np.int32)
        return self.material
