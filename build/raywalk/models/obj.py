"""Wavefront OBJ, with the polygons, materials and smoothing groups of its MTL files.

Our own: tinyobjloader 2.0rc13 reads `0,5`, `v 0 0` and NaN as 0 in silence, keeps an index beyond
the last vertex, loses a first line with a byte order mark, refuses a line that goes on after a
backslash with CRLF; trimesh 5.2 reads -1 after all vertices, cuts concave polygons as fans, and
reads no tabs. Format: Wavefront, "Object Files (.obj)", Advanced Visualizer manual, appendix B1.
"""

from __future__ import annotations

from array import array
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import numpy as np

from raywalk.models.faults import ModelFault, quoted
from raywalk.models.model import Model, PerCorner
from raywalk.models.obj_libraries import names_of, read_libraries
from raywalk.models.polygons import triangulated
from raywalk.models.text import a_number, lines, name_of, one_encoding

# What a file may hold besides triangles, as its readers call it.
NOT_READ = {
    b"l": "lines", b"p": "points",
    **dict.fromkeys((b"curv", b"curv2", b"surf", b"vp", b"cstype"), "free-form surfaces"),
}  # fmt: skip

FARTHEST = 1 << 62  # an index that no file has, and that still is a number of 64 bits


def read_obj(path: Path, data: bytes) -> Model:
    """The model. Raises ModelFault with the line."""
    reader = _Reader(path)
    held, begun = b"", 0
    for number, line in lines(one_encoding(data)):
        if line.rstrip().endswith(b"\\"):  # goes on with the next line
            held, begun = held + line.rstrip()[:-1] + b" ", begun or number
            continue
        if held:
            line, number, held, begun = held + line, begun, b"", 0
        reader.take(number, line)
    reader.take(begun, held)
    return reader.model()


class _Reader:
    """What has been read so far. Arrays, as lists of Python's numbers weigh eight times as much."""

    def __init__(self, path: Path):
        self.path, self.line = path, 0
        self.places, self.colours = array("d"), array("d")
        self.normals, self.textures = array("d"), array("d")
        self.counts, self.line_of = array("i"), array("q")
        self.vertex, self.texture, self.normal = array("q"), array("q"), array("q")
        self.part, self.material, self.smoothing = array("i"), array("i"), array("i")
        self.parts: dict[str, int] = {}
        self.named: dict[str, int] = {}  # materials
        self.named_at: dict[str, int] = {}  # the line that first uses each
        self.libraries: list[str] = []
        self.missing: list[str] = []
        self.group, self.object, self.now = "", "", (-1, -1, -1)
        self.skipped: Counter[str] = Counter()
        self.broken: dict[str, int] = {}  # what is not used because of its first broken line
        self._by_word: dict[bytes, Callable[[list[bytes], bytes], None]] = {
            b"v": self._place, b"vn": self._normal, b"vt": self._texture,
            b"f": self._face, b"fo": self._face, b"s": self._group_of_smoothing,
            b"g": self._name_group, b"o": self._name_object,
            b"usemtl": self._use, b"mtllib": self._library,
        }  # fmt: skip

    def take(self, number: int, line: bytes) -> None:
        """One line."""
        words = line.split()
        if not words or words[0].startswith(b"#"):
            return
        self.line = number
        handler = self._by_word.get(words[0])
        if handler:
            handler(words, line)
        elif words[0] in NOT_READ:
            self.skipped[NOT_READ[words[0]]] += 1
        else:
            self.skipped["unknown"] += 1

    def _fault(self, cause: str, remedy: str, line: int = 0) -> ModelFault:
        return ModelFault(self.path, f"line {line or self.line}", cause, remedy)

    def _place(self, words: list[bytes], line: bytes) -> None:
        try:
            values = [float(word) for word in words[1:]]
        except ValueError:
            words = _without_comment(words)
            values = [a_number(word, self.path, self.line) for word in words[1:]]
        if len(values) < 3:
            raise self._fault(
                f"{quoted(line.strip())} has {len(values)} of a vertex's 3 coordinates",
                "write x, y and z, or export the model again",
            )
        self.places.extend(values[:3])
        if len(values) >= 6:
            self.colours.extend(values[-3:])

    def _normal(self, words: list[bytes], line: bytes) -> None:
        self._extend(self.normals, "own normals", words, 3, 3)

    def _texture(self, words: list[bytes], line: bytes) -> None:
        self._extend(self.textures, "texture coordinates", words, 1, 2)

    def _extend(self, table: array, what: str, words: list[bytes], least: int, most: int) -> None:
        """A broken one costs what it is for, not the model."""
        try:
            values = [float(word) for word in words[1 : most + 1]]
        except ValueError:
            values = []
        if len(values) < least:
            self.broken.setdefault(what, self.line)
            values = [float("nan")] * most
        table.extend(values + [0.0] * (most - len(values)))

    def _face(self, words: list[bytes], line: bytes) -> None:
        words = _without_comment(words)[1:]
        if len(words) < 3:
            self.skipped["faces with fewer than three corners"] += 1
            return
        if b"/" in line:
            self._fill_up()
            for word in words:
                self._corner(word)
        else:
            self._plain_corners(words)
        self.counts.append(len(words))
        self.line_of.append(self.line)
        part, material, smoothing = self.now
        self.part.append(self._part() if part < 0 else part)
        self.material.append(material)
        self.smoothing.append(smoothing)

    def _fill_up(self) -> None:
        """Corners without them have no texture coordinates and normals; most files have none."""
        for rows in (self.texture, self.normal):
            rows.frombytes(bytes((len(self.vertex) - len(rows)) * rows.itemsize))

    def _plain_corners(self, words: list[bytes]) -> None:
        try:
            rows = [int(word) for word in words]
        except ValueError:
            rows = [0]
        if not 0 < min(rows) <= max(rows) < FARTHEST:
            rows = [self._index(word, len(self.places) // 3) for word in words]
        self.vertex.extend(rows)

    def _corner(self, word: bytes) -> None:
        """v, v/t, v//n or v/t/n; rows from 1, 0 for none."""
        v, *others = word.split(b"/")
        self.vertex.append(self._index(v, len(self.places) // 3, word))
        for table, which, rows, what in (
            (self.texture, 0, len(self.textures) // 2, "texture coordinates"),
            (self.normal, 1, len(self.normals) // 3, "own normals"),
        ):
            given = others[which] if which < len(others) else b""
            try:
                row = int(given) if given else 0
            except ValueError:
                row = -rows - 1
            row = rows + 1 + row if row < 0 else row
            if row < 0 or (row == 0 and given):
                self.broken.setdefault(what, self.line)
                row = 0
            table.append(min(row, FARTHEST))

    def _index(self, word: bytes, known: int, corner: bytes = b"") -> int:
        """The row from 1 that is meant: -k counts back from the line it stands on."""
        try:
            row = int(word)
        except ValueError:
            raise self._fault(
                f"{quoted(corner or word)} is not a corner",
                "a corner is v, v/t, v//n or v/t/n, each a whole number: export the model again",
            ) from None
        if row < 0:
            row += known + 1
        if row < 1:
            cause = f"{quoted(corner or word)} is no vertex: " + (
                "they are counted from 1" if int(word) == 0 else f"{_count(known)} stand before it"
            )
            raise self._fault(cause, "the file is damaged: export the model again")
        return min(row, FARTHEST)

    def _part(self) -> int:
        name = self.object if self.object and not self.group else self.group
        if self.object and self.group and self.group != self.object:
            name = f"{self.object} {self.group}"
        place = self.parts.setdefault(name, len(self.parts))
        self.now = (place, *self.now[1:])
        return place

    def _name_group(self, words: list[bytes], line: bytes) -> None:
        self.group = name_of(b" ".join(words[1:]))
        self.group = "" if self.group in ("default", "off") else self.group
        self.now = (-1, *self.now[1:])

    def _name_object(self, words: list[bytes], line: bytes) -> None:
        self.object, self.group = name_of(b" ".join(words[1:])), ""
        self.now = (-1, *self.now[1:])

    def _use(self, words: list[bytes], line: bytes) -> None:
        name = name_of(b" ".join(words[1:]))
        self.named_at.setdefault(name, self.line)
        self.now = (self.now[0], self.named.setdefault(name, len(self.named)), self.now[2])

    def _library(self, words: list[bytes], line: bytes) -> None:
        """One file whose name may have spaces, or several."""
        whole = name_of(line.strip()[len(b"mtllib") :])
        if not whole:
            self.missing.append(f"line {self.line}: mtllib names no file")
            return
        several = [name_of(word) for word in words[1:]]
        self.libraries += names_of(self.path.parent, whole, several)

    def _group_of_smoothing(self, words: list[bytes], line: bytes) -> None:
        switch = words[1] if len(words) > 1 else b"off"
        try:
            group = 0 if switch.lower() in (b"off", b"null") else int(switch) & 0x7FFFFFFF
        except ValueError:
            group = 1 if switch.lower() == b"on" else 0
        self.now = (*self.now[:2], group)

    def model(self) -> Model:
        """All of it. Raises ModelFault for an index that no vertex has."""
        vertices = np.frombuffer(self.places or array("d")).reshape(-1, 3)
        counts, corners = _whole(self.counts, np.int64), _whole(self.vertex, np.int64) - 1
        if not len(counts):
            raise self._no_face(len(vertices))
        self._refuse_beyond(corners, counts, len(vertices))
        if self.normal:
            self._fill_up()
        triangles, polygon = triangulated(vertices, counts, corners)
        told = read_libraries(self.path.parent, self.libraries, self.named_at)
        self.missing += told.lacks
        smoothing = _whole(self.smoothing, np.int32)[polygon]
        normals = self._table(self.normals, self.normal, 3, "own normals", triangles)
        colours = self._colours(len(vertices), corners[triangles])
        return Model(
            path=self.path,
            format="OBJ",
            vertices=vertices,
            faces=corners[triangles],
            parts=tuple(self.parts),
            part=_whole(self.part, np.int32)[polygon],
            materials=tuple(told.materials),
            material=_whole(self.material, np.int32)[polygon] if told.materials else None,
            normals=normals,
            texture_places=self._table(
                self.textures, self.texture, 2, "texture coordinates", triangles
            ),
            colours=colours,
            colours_of="vertices" if colours else "",
            # A group that is not named for some faces is taken as one of its own.
            smoothing=smoothing & 0x7FFFFFFF if (smoothing >= 0).any() else None,
            ignored=tuple(self._ignored()),
            beside=tuple(told.found),
        )

    def _no_face(self, vertices: int) -> ModelFault:
        what = f"{_count(vertices)} but no face" if vertices else "neither a vertex nor a face"
        few = self.skipped["faces with fewer than three corners"]
        if few:
            what = f"{few} faces, all with fewer than three corners"
        elif not vertices and self.skipped["unknown"]:
            what = "no line of an OBJ file that is a vertex or a face"
        return ModelFault(
            self.path, "", f"it holds {what}", "export a mesh of polygons, not points or curves"
        )

    def _refuse_beyond(self, corners: np.ndarray, counts: np.ndarray, known: int) -> None:
        beyond = np.flatnonzero(corners >= known)
        if not len(beyond):
            return
        face = int(np.searchsorted(np.cumsum(counts), beyond[0], side="right"))
        raise self._fault(
            f"a face names vertex {corners[beyond[0]] + 1}, and the file has {_count(known)}",
            "it is cut short or damaged: export the model again",
            self.line_of[face],
        )

    def _table(
        self, values: array, rows: array, wide: int, what: str, triangles: np.ndarray
    ) -> PerCorner | None:
        """Rows of a table at the corners of triangles; None, and said, where it is broken."""
        row = _whole(rows, np.int64)
        if not row.any():
            return None
        table = np.frombuffer(values or array("d")).reshape(-1, wide)
        if row.max() > len(table):
            place = int(np.searchsorted(np.cumsum(self.counts), row.argmax(), side="right"))
            self.broken.setdefault(what, self.line_of[place])
        if what in self.broken:
            return None
        return PerCorner(table, row[triangles] - 1)

    def _colours(self, vertices: int, faces: np.ndarray) -> PerCorner | None:
        if not self.colours:
            return None
        if len(self.colours) != 3 * vertices:
            self.skipped["colours"] = len(self.colours) // 3
            return None
        table = np.frombuffer(self.colours).reshape(-1, 3)
        with np.errstate(invalid="ignore"):
            table = table / 255.0 if table.max() > 1.0 else table
        return PerCorner(np.clip(np.nan_to_num(table), 0.0, 1.0), faces)

    def _ignored(self) -> list[str]:
        ignored = [f"{what} are not read" for what in dict.fromkeys(NOT_READ.values())
                   if self.skipped[what]]  # fmt: skip
        few = self.skipped["faces with fewer than three corners"]
        if few:
            ignored.append(f"{few} faces with fewer than three corners are left out")
        if self.skipped["colours"]:
            ignored.append(
                f"colours stand at {self.skipped['colours']} vertices only and are not used"
            )
        ignored += [
            f"{what} are not used: line {line} is broken" for what, line in self.broken.items()
        ]
        return ignored + self.missing


def _without_comment(words: list[bytes]) -> list[bytes]:
    end = next((k for k, word in enumerate(words) if word.startswith(b"#")), len(words))
    return words[:end]


def _whole(values: array, kind: type) -> np.ndarray:
    return (
        np.frombuffer(values, dtype=f"i{values.itemsize}").astype(kind)
        if values
        else np.zeros(0, kind)
    )


def _count(vertices: int) -> str:
    return f"{vertices} {'vertex' if vertices == 1 else 'vertices'}"
