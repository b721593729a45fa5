"""OFF, also with colours (COFF) and normals (NOFF) at its vertices, and colours of faces.

Our own: trimesh 5.2 says of a broken one neither line nor value, and knows no colours. Format:
Geomview manual, "OFF".
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

import numpy as np

from raywalk.models.faults import ModelFault, quoted
from raywalk.models.model import Model, PerCorner
from raywalk.models.polygons import triangulated
from raywalk.models.text import a_number, lines, one_encoding

HEADER = re.compile(rb"(ST)?(C)?(N)?(4)?(n)?OFF$")


def read_off(path: Path, data: bytes) -> Model:
    """The model. Raises ModelFault with the line."""
    return _Reader(path, one_encoding(data)).model()


class _Reader:
    def __init__(self, path: Path, data: bytes):
        self.path, self.line = path, 0
        self._rows = self._telling(data)
        self.kind = b""

    def _telling(self, data: bytes) -> Iterator[list[bytes]]:
        for self.line, line in lines(data):
            words = line.split(b"#", 1)[0].split()
            if words:
                yield words

    def _fault(self, cause: str, remedy: str = "export the model again") -> NoReturn:
        raise ModelFault(self.path, f"line {self.line}", cause, remedy)

    def _row(self, what: str) -> list[bytes]:
        row = next(self._rows, None)
        if row is None:
            self._fault(f"the file ends before {what}", "it is cut short: copy or export it again")
        return row

    def _whole(self, word: bytes, what: str) -> int:
        try:
            return int(word)
        except ValueError:
            self._fault(f"{quoted(word)} is not {what}, a whole number")

    def model(self) -> Model:
        """All of it."""
        vertices, faces = self._counts()
        places, normals, colours = self._vertices(vertices)
        counts, corners, painted = self._faces(faces, vertices)
        triangles, polygon = triangulated(places, counts, corners)
        of_faces = None
        if painted is not None:
            of_faces = PerCorner(painted, np.repeat(polygon[:, None], 3, axis=1))
        at_corners = corners[triangles]
        of_vertices = None if colours is None else PerCorner(colours, at_corners)
        return Model(
            self.path, "OFF", places, at_corners,
            normals=None if normals is None else PerCorner(normals, at_corners),
            colours=of_faces or of_vertices,
            colours_of="faces" if of_faces else "vertices" if of_vertices else "",
        )  # fmt: skip

    def _counts(self) -> tuple[int, int]:
        first = self._row("its first line")
        match = HEADER.match(first[0])
        if match is None:
            self._fault(f"{quoted(first[0])} stands where OFF should", "it is no OFF file")
        if b"BINARY" in first or match[4] or match[5]:
            self._fault(f"{quoted(b' '.join(first))} is not read", "save it as an OFF file of text")
        self.kind = first[0]
        row = first[1:] or self._row("its counts")
        if len(row) < 2:
            self._fault(f"{quoted(b' '.join(row))} is not the number of vertices, faces and edges")
        vertices = self._whole(row[0], "the number of vertices")
        faces = self._whole(row[1], "the number of faces")
        if vertices < 1 or faces < 1:
            self._fault(f"it tells of {vertices} vertices and {faces} faces")
        return vertices, faces

    def _vertices(self, count: int) -> tuple[np.ndarray, np.ndarray | None, np.ndarray | None]:
        """Places, normals and colours, each (v, 3); the order of a row is x y z, normal, colour."""
        has_normal, has_colour = b"N" in self.kind, b"C" in self.kind
        values, wide = array("d"), 3 + 3 * has_normal + 3 * has_colour
        for k in range(count):
            row = self._row(f"vertex {k} of {count}")
            if len(row) < wide:
                self._fault(f"{quoted(b' '.join(row))} has {len(row)} of a vertex's {wide} numbers")
            values.extend(a_number(word, self.path, self.line) for word in row[:wide])
        table = np.frombuffer(values).reshape(-1, wide)
        normals = table[:, 3:6] if has_normal else None
        colours = _in_share(table[:, -3:]) if has_colour else None
        return np.ascontiguousarray(table[:, :3]), normals, colours

    def _faces(self, count: int, vertices: int) -> tuple[np.ndarray, np.ndarray, np.ndarray | None]:
        """Corners of each, all of them in a row, and colours (f, 3) if all have one."""
        counts, corners, colours = array("q"), array("q"), array("d")
        for k in range(count):
            row = self._row(f"face {k} of {count}")
            size = self._whole(row[0], "a face's number of corners")
            if size < 3:
                continue
            if len(row) < 1 + size:
                self._fault(f"{quoted(b' '.join(row))} has {len(row) - 1} of its {size} corners")
            for word in row[1 : 1 + size]:
                index = self._whole(word, "a vertex")
                if not 0 <= index < vertices:
                    self._fault(f"a face names vertex {index}, and there are 0 to {vertices - 1}")
                corners.append(index)
            counts.append(size)
            channels = row[1 + size :]
            if len(channels) >= 3:
                colours.extend(a_number(word, self.path, self.line) for word in channels[:3])
        if not counts:
            self._fault("no face has three corners", "export a mesh of polygons")
        painted = np.frombuffer(colours).reshape(-1, 3) if len(colours) == 3 * len(counts) else None
        return (
            np.frombuffer(counts, np.int64), np.frombuffer(corners, np.int64),
            None if painted is None else _in_share(painted),
        )  # fmt: skip


def _in_share(colours: np.ndarray) -> np.ndarray:
    """From 0 to 1; whole numbers go to 255."""
    colours = np.nan_to_num(colours)
    return np.clip(colours / 255.0 if colours.max(initial=0.0) > 1.0 else colours, 0.0, 1.0)
