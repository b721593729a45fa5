"""3MF: the build items of a package, with their components, materials and colours.

Our own: trimesh 5.2 wants networkx for it, which we do not have; lib3mf is 1.5 MB compiled.
Format: 3MF Consortium, "Core Specification" 1.3, "Materials and Properties" 1.2 for colours, and
"Production" 1.1 for packages of many parts, which slicers write: an object is named there by its
part and its id.
"""

from __future__ import annotations

import re
import zipfile
from array import array
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import islice, zip_longest
from pathlib import Path
from typing import IO, NoReturn
from xml.etree.ElementTree import Element, ParseError, iterparse
from xml.parsers.expat import errors
from zlib import error as ZlibError

import numpy as np

from raywalk.models.faults import ModelFault, quoted
from raywalk.models.model import Colour, FileMaterial, Model
from raywalk.models.text import why_no_number

MODEL = "3d/3dmodel.model"
PART_PATH = "{http://schemas.microsoft.com/3dmanufacturing/production/2015/06}path"
MOST_TIMES = 40  # as large as the file its XML may be: 10 to 15 times is usual
ALWAYS = 64 << 20  # bytes of XML that are read anyway
MOST_TRIANGLES = 20_000_000  # with all copies
LEFT_OUT = {"texture2d": "textures", "compositematerials": "mixtures of materials"}
UNBOUND = errors.codes[errors.XML_ERROR_UNBOUND_PREFIX]
NAMESPACES = {  # of the extensions, by the prefixes that all of their examples use
    "m": "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "p": "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "b": "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02",
    "s": "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
}
HUGE = 1e100  # of a transform
DEEPEST = 32  # components within components
CUT = "it is cut short or damaged: copy or export it again"
Key = tuple[str, str]  # a part of the package, and an id in it


@dataclass
class _Object:
    name: str
    places: array = field(default_factory=lambda: array("d"))
    corners: array = field(default_factory=lambda: array("i"))
    colour: array = field(default_factory=lambda: array("i"))  # rows of all materials, -1 for none
    parts: list[tuple[Key, np.ndarray]] = field(default_factory=list)  # of other objects


def read_3mf(path: Path, data: bytes) -> Model:
    """The model. Raises ModelFault with the element."""
    reader = _Reader(path)
    try:
        with zipfile.ZipFile(path) as package:
            room = max(ALWAYS, MOST_TIMES * len(data))
            for part in reader.wanted:  # it grows while they are read
                found = _part_of(path, package, part)
                room -= found.file_size
                if room < 0:
                    raise ModelFault(
                        path, "", f"its XML is more than {MOST_TIMES} times as large as the file",
                        "export it as 3MF again",
                    )  # fmt: skip
                with package.open(found) as file:
                    reader.read(file, part)
    except (
        zipfile.BadZipFile,
        ZlibError,
        EOFError,
        NotImplementedError,
        RuntimeError,
        OSError,
        ValueError,
    ) as problem:
        raise ModelFault(
            path, "", f"its package cannot be unpacked ({problem})"[:200], CUT
        ) from None
    except ParseError as problem:
        raise _xml_fault(path, reader.part, problem) from None
    return reader.model()


def _xml_fault(path: Path, part: str, problem: ParseError) -> ModelFault:
    """A prefix that nothing declares has a cause of its own; many exporters forget one."""
    if problem.code != UNBOUND:
        return ModelFault(path, "", f"its XML is broken ({problem})", CUT)
    line, column = problem.position
    with zipfile.ZipFile(path) as package, package.open(_part_of(path, package, part)) as file:
        text = next(islice(file, line - 1, line), b"")[column : column + 200]
    found = re.search(rb"([\w.-]+):[\w.-]+", text)
    prefix = found[1].decode("ascii", "replace") if found else ""
    return ModelFault(
        path, f"{part}, line {line}", f"the prefix {quoted(prefix)} of its XML is declared nowhere",
        f'write xmlns:{prefix}="{NAMESPACES.get(prefix, "...")}" into its <model>, or export it '
        "again",
    )  # fmt: skip


def _part_of(path: Path, package: zipfile.ZipFile, part: str) -> zipfile.ZipInfo:
    """A part's entry; of the first one any .model that there is."""
    entries = {each.filename.lower().lstrip("/"): each for each in package.infolist()}
    if part in entries:
        return entries[part]
    if part != MODEL:
        raise ModelFault(path, "", f"its part {quoted(part)} is not in the package", CUT)
    found = [each for name, each in entries.items() if name.endswith(".model")]
    if not found:
        raise ModelFault(path, "", "there is no 3D/3dmodel.model in it", "export it as 3MF again")
    return found[0]


class _Reader:
    def __init__(self, path: Path):
        self.path = path
        self.unit = "millimeter"
        self.wanted = [MODEL]  # parts of the package, each once
        self.part = MODEL  # that is read now
        self.objects: dict[Key, _Object] = {}
        self.items: list[tuple[Key, np.ndarray]] = []
        self.groups: dict[Key, list[int]] = {}  # of a group -> its materials' rows, or -1
        self.layers: list[str] = []  # groups that a <multiproperties> lays over one another
        self.materials: list[FileMaterial] = []
        self.left_out: dict[str, None] = {}
        self.now, self.default, self.own_group = _Object(""), -1, ""  # of the object that is read

    def read(self, file: IO[bytes], part: str) -> None:
        """Element by element, each forgotten once it is read."""
        self.part = part
        group: Key | None = None
        stack: list[Element] = []
        for event, element in iterparse(file, ("start", "end")):
            kind = element.tag.rpartition("}")[2]
            if event == "start":
                stack.append(element)
                if kind == "model" and part == MODEL:
                    self.unit = element.get("unit", "millimeter")
                elif kind == "object":
                    self._begin(element)
                elif kind in ("basematerials", "colorgroup", "multiproperties"):
                    group = self.part, element.get("id", "")
                    self.groups[group] = []
                    self.layers = element.get("pids", "").split()
                continue
            self._end(kind, element, group)
            stack.pop()
            if stack:
                stack[-1].remove(element)

    def _begin(self, element: Element) -> None:
        id = element.get("id", "")
        self.now = _Object(element.get("name") or f"object {id}")
        self.objects[self.part, id] = self.now
        self.own_group = element.get("pid", "")
        self.default = self._row(self.own_group, element.get("pindex", "0"))
        if element.get("type", "model") not in ("model", "solidsupport"):
            self.left_out[f"objects of the type {quoted(element.get('type', ''))}"] = None

    def _end(self, kind: str, element: Element, group: Key | None) -> None:
        match kind:
            case "vertex":
                self.now.places.extend(self._number(element, axis) for axis in "xyz")
            case "triangle":
                self.now.corners.extend(self._index(element, key) for key in ("v1", "v2", "v3"))
                group_of, own = element.get("pid", self.own_group), element.get("p1")
                self.now.colour.append(self._row(group_of, own) if own else self.default)
            case "component":
                self.now.parts.append((self._named(element), self._matrix(element)))
            case "item":
                self.items.append((self._named(element), self._matrix(element)))
            case "base" | "color" if group is not None:
                text = element.get("displaycolor") or element.get("color") or ""
                name = element.get("name") or f"colour {text}"
                self.groups[group].append(len(self.materials))
                self.materials.append(FileMaterial(name, _colour(text)))
            case "multi" if group is not None:
                self.groups[group].append(self._undermost(element.get("pindices", "").split()))
            case "texture2d" | "beamlattice" | "slicestack" | "compositematerials":
                self.left_out[LEFT_OUT.get(kind, kind)] = None

    def _named(self, element: Element) -> Key:
        """The object that an item or component places, of this part or of another."""
        part = element.get(PART_PATH, self.part).lower().lstrip("/")
        if part not in self.wanted:
            self.wanted.append(part)
        return part, element.get("objectid", "")

    def _fault(self, element: Element, cause: str) -> NoReturn:
        kind = element.tag.rpartition("}")[2]
        raise ModelFault(self.path, f"a <{kind}> of {quoted(self.now.name)}", cause, CUT)

    def _number(self, element: Element, key: str) -> float:
        try:
            return float(element.attrib[key])
        except KeyError:
            self._fault(element, f"it has no {key}")
        except ValueError:
            cause, remedy = why_no_number(element.attrib[key].encode())
            kind = element.tag.rpartition("}")[2]
            place = f"{key} of a <{kind}> of {quoted(self.now.name)}"
            raise ModelFault(self.path, place, cause, remedy) from None

    def _index(self, element: Element, key: str) -> int:
        text = element.get(key, "")
        if not (text.isascii() and text.isdigit() and len(text) < 10):
            self._fault(element, f"{key} is {quoted(text)}, which is no vertex")
        return int(text)

    def _row(self, group: str, place: str) -> int:
        """Of a material by its group and place; -1 for none that is known."""
        rows = self.groups.get((self.part, group), [])
        known = place.isascii() and place.isdigit() and len(place) < 18 and int(place) < len(rows)
        return rows[int(place)] if known else -1

    def _undermost(self, places: list[str]) -> int:
        """Of the layers of a <multi> the first that is a material or a colour, on which the others
        are laid; places that are left out are 0."""
        layers = zip_longest(self.layers, places[: len(self.layers)], fillvalue="0")
        return next((row for row in (self._row(*layer) for layer in layers) if row >= 0), -1)

    def _matrix(self, element: Element) -> np.ndarray:
        """(4, 3): a row vector's last is its place."""
        text = element.get("transform")
        if text is None:
            return np.eye(4, 3)
        try:
            matrix = np.array([float(word) for word in text.split()]).reshape(4, 3)
        except ValueError:
            matrix = np.full((4, 3), np.nan)
        if not (np.abs(matrix) < HUGE).all():
            self._fault(element, f"{quoted(text)} is not a transform of 12 numbers")
        return matrix

    def model(self) -> Model:
        """All items of the build, or all objects if there is none."""
        items = self.items or [(key, np.eye(4, 3)) for key in self.objects]
        vertices, faces, colour, part = [], [], [], []
        parts: dict[str, int] = {}
        count = first = 0
        for name, key, matrix in self._placed(items):
            found = self.objects[key]
            corners = np.asarray(found.corners).reshape(-1, 3)
            count += len(corners)
            if count > MOST_TRIANGLES:
                raise ModelFault(self.path, "", f"its items place more than {MOST_TRIANGLES} "
                                 "triangles", "leave out some copies")  # fmt: skip
            places = np.asarray(found.places).reshape(-1, 3)
            if len(corners) and corners.max() >= len(places):
                raise ModelFault(
                    self.path, f"object {quoted(found.name)}",
                    f"a triangle names vertex {corners.max()}, and there are 0 to "
                    f"{len(places) - 1}", CUT,
                )  # fmt: skip
            if np.linalg.det(matrix[:3]) < 0:
                corners = corners[:, ::-1]
            vertices.append(places @ matrix[:3] + matrix[3])
            faces.append(corners + np.int32(first))
            first += len(places)
            colour.append(np.asarray(found.colour))
            part.append(np.full(len(corners), parts.setdefault(name, len(parts)), np.int32))
        if not count:
            raise ModelFault(self.path, "", "it holds no triangle", "export a mesh of triangles")
        rows = np.concatenate(colour)
        del colour, found, corners, places
        self.objects.clear()
        return Model(
            self.path, "3MF", np.concatenate(vertices), np.concatenate(faces),
            parts=tuple(parts), part=np.concatenate(part) if len(parts) > 1 else None,
            materials=tuple(self.materials), material=rows if (rows >= 0).any() else None,
            ignored=tuple(f"{what} are not read" for what in self.left_out), unit=self.unit,
        )  # fmt: skip

    def _placed(self, items: list[tuple[Key, np.ndarray]]) -> Iterator[tuple[str, Key, np.ndarray]]:
        """Name, key and matrix (4, 3) of every mesh that stands in the build."""
        waiting = [("", key, matrix, 0) for key, matrix in reversed(items)]
        met = 0
        while waiting:
            name, key, matrix, depth = waiting.pop()
            met += 1
            if key not in self.objects or depth > DEEPEST or met > 100_000:
                cause = f"it names object {quoted(key[1])}, which is not there"
                if key in self.objects:
                    cause = "its components hold one another too often"
                raise ModelFault(self.path, "build", cause, CUT)
            found = self.objects[key]
            name = name or found.name
            if found.corners:
                yield name, key, matrix
            for part, inner in reversed(found.parts):
                linear = inner[:3] @ matrix[:3]
                whole = np.vstack([linear, inner[3] @ matrix[:3] + matrix[3]])
                waiting.append((name, part, whole, depth + 1))


def _colour(text: str) -> Colour | None:
    try:
        r, g, b = bytes.fromhex(text.lstrip("#")[:6])
    except ValueError:
        return None
    return (r / 255.0, g / 255.0, b / 255.0)
