"""The header of a PLY file: which elements follow, with which properties."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from raywalk.models.faults import ModelFault, quoted, shown

KINDS = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2",
    "ushort": "u2", "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
    "int64": "i8", "uint64": "u8",
}  # fmt: skip
FLOATS = ("f4", "f8")
FORMATS = ("ascii", "binary_little_endian", "binary_big_endian")
LONGEST = 1 << 20  # bytes of a header


@dataclass(frozen=True)
class Property:
    name: str
    kind: str  # numpy's, without the order of bytes
    count_kind: str = ""  # of a list


@dataclass(frozen=True)
class Element:
    name: str
    count: int
    properties: tuple[Property, ...]


@dataclass(frozen=True)
class Header:
    format: str
    elements: tuple[Element, ...]
    end: int  # bytes
    lines: int

    def element(self, name: str) -> Element:
        """The element of a name that is there."""
        return next(each for each in self.elements if each.name == name)


def read_header(path: Path, data: bytes) -> Header:
    """Raises ModelFault with the line."""
    return _Reader(path).read(data)


class _Reader:
    def __init__(self, path: Path):
        self.path, self.line = path, 0
        self.format, self.elements = "", []  # type: tuple[str, list[tuple[str, int, list[Property]]]]

    def _fault(self, cause: str, remedy: str = "export the model again") -> NoReturn:
        raise ModelFault(self.path, f"line {self.line}", cause, remedy)

    def read(self, data: bytes) -> Header:
        """The header, and where it ends."""
        at = 3 if data[:3] == b"\xef\xbb\xbf" else 0
        while True:
            line, at = self._next(data, at)
            self.line += 1
            words = line.decode("latin-1").split()
            if self.line == 1 and words != ["ply"]:
                self._fault(f"{quoted(line)} stands where `ply` should", "it is no PLY file")
            if words[:1] == ["end_header"]:
                break
            self._take(words)
        if not self.format:
            self._fault("the header names no format")
        made = tuple(Element(name, count, tuple(found)) for name, count, found in self.elements)
        return Header(self.format, made, at, self.line)

    def _next(self, data: bytes, at: int) -> tuple[bytes, int]:
        ends = [
            end
            for end in (data.find(b"\n", at, LONGEST), data.find(b"\r", at, LONGEST))
            if end >= 0
        ]
        if not ends:
            self._fault("the file ends in its header", "it is cut short: copy or export it again")
        end = min(ends)
        # The line feed belongs to the end of the header's last line only where others have it too.
        after = end + (2 if data[end : end + 2] == b"\r\n" else 1)
        return data[at:end], after

    def _take(self, words: list[str]) -> None:
        match words:
            case ["format", kind, *_]:
                if kind not in FORMATS:
                    self._fault(f"{quoted(kind)} is no format of PLY")
                self.format = kind
            case ["element", name, count]:
                if not count.isdecimal() or len(count) > 18:
                    self._fault(f"{quoted(count)} is not a number of elements")
                if any(name == other for other, _, _ in self.elements):
                    self._fault(f"there is a second element {quoted(name)}")
                self.elements.append((name, int(count), []))
            case ["property", "list", count_kind, kind, name]:
                if count_kind in KINDS and KINDS[count_kind] in FLOATS:
                    self._fault(f"{quoted(count_kind)} cannot count a list's items")
                self._property(Property(name, self._kind(kind), self._kind(count_kind)))
            case ["property", kind, name]:
                self._property(Property(name, self._kind(kind)))
            case ["property" | "element" | "format", *_]:
                self._fault(f"{quoted(' '.join(words))} cannot be read")

    def _kind(self, word: str) -> str:
        if word not in KINDS:
            self._fault(f"{quoted(word)} is no type", f"known: {', '.join(KINDS)}")
        return KINDS[word]

    def _property(self, found: Property) -> None:
        if not self.elements:
            self._fault(f"the property {shown(found.name)} belongs to no element")
        if any(found.name == other.name for other in self.elements[-1][2]):
            self._fault(f"there is a second property {quoted(found.name)}")
        self.elements[-1][2].append(found)
