"""The numbers of a glTF file: accessors into views of buffers."""

from __future__ import annotations

import base64
import binascii
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from raywalk.models.faults import ModelFault, quoted

KINDS = {5120: "i1", 5121: "u1", 5122: "i2", 5123: "u2", 5125: "u4", 5126: "f4"}
WIDE = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
CUT = "it is cut short or damaged: export the model again"


class Buffers:
    """Reads accessors; a buffer when it is first asked for."""

    def __init__(self, path: Path, document: dict[str, Any], chunk: bytes | memoryview):
        self.path, self.json, self.chunk = path, document, chunk
        self._read: dict[int, bytes | memoryview] = {}

    def accessor(self, index: int, wide: tuple[int, ...]) -> np.ndarray:
        """(n, w) float64, w one of those wanted. Raises ModelFault."""
        entry, values, kind = self._values(index, wide)
        found = values.astype(float)
        if entry.get("normalized") and kind[0] in "iu":
            found = np.maximum(found / np.iinfo(kind).max, -1.0)
        return found

    def indices(self, index: int, known: int) -> np.ndarray:
        """(n,) int32 that all are from 0 on and below `known`. Raises ModelFault."""
        values = self._values(index, (1,))[1][:, 0]
        beyond = values[~((values >= 0) & (values < known))]
        if len(beyond):
            raise ModelFault(
                self.path, f"accessor {index}",
                f"it names vertex {beyond[0]:.17g}, and there are 0 to {known - 1}",
                "the file is damaged: export the model again",
            )  # fmt: skip
        return values.astype(np.int32)

    def _values(self, index: int, wide: tuple[int, ...]) -> tuple[dict[str, Any], np.ndarray, str]:
        """Its entry, its numbers (n, w) as they are, and their kind."""
        entry = entry_of(self.path, self.json, "accessors", index)
        kind, size = KINDS.get(entry["componentType"]), WIDE.get(entry["type"])
        count = whole(entry["count"])
        if kind is None or size not in wide:
            raise self._fault(index, f"it holds {entry['type']} of {entry['componentType']}")
        if "bufferView" in entry:
            values = self._view(
                index, entry["bufferView"], entry.get("byteOffset", 0), kind, count, size
            )
        elif "sparse" in entry and count <= 64 * len(self.chunk) + 1_000_000:
            values = np.zeros((count, size), kind)
        else:
            raise self._fault(index, f"its {count} values stand in no buffer")
        return entry, self._sparse(index, entry, values, kind, size), kind

    def view(self, index: int) -> bytes:
        """The bytes of a view of a buffer, as far as they are there. Raises ModelFault."""
        entry = entry_of(self.path, self.json, "bufferViews", index)
        begin = whole(entry.get("byteOffset", 0))
        held = self._buffer(whole(entry["buffer"]))
        return bytes(held[begin : begin + whole(entry["byteLength"])])

    def _sparse(
        self, index: int, entry: dict[str, Any], values: np.ndarray, kind: str, size: int
    ) -> np.ndarray:
        """With the values that are given one by one."""
        if "sparse" not in entry:
            return values
        sparse = entry["sparse"]
        count, places = whole(sparse["count"]), sparse["indices"]
        rows = self._view(
            index, places["bufferView"], places.get("byteOffset", 0),
            KINDS[places["componentType"]], count, 1,
        )[:, 0].astype(np.int64)  # fmt: skip
        given = sparse["values"]
        new = self._view(index, given["bufferView"], given.get("byteOffset", 0), kind, count, size)
        if ((rows < 0) | (rows >= len(values))).any():
            raise self._fault(index, f"a sparse value has a place beyond its {len(values)}")
        values = values.copy()
        values[rows] = new
        return values

    def _view(
        self, index: int, view: int, offset: int, kind: str, count: int, size: int
    ) -> np.ndarray:
        entry = entry_of(self.path, self.json, "bufferViews", view)
        data = self._buffer(whole(entry["buffer"]))
        begin, length = whole(entry.get("byteOffset", 0)), whole(entry["byteLength"])
        item = np.dtype(kind).itemsize * size
        step = whole(entry.get("byteStride", 0)) or item
        end = whole(offset) + (count - 1) * step + item if count else 0
        if step < item or end > length or begin + length > len(data) or count < 0:
            raise self._fault(index, f"its {count} values do not fit into their buffer")
        table = np.ndarray(
            (count, size), np.dtype(kind).newbyteorder("<"), data, begin + offset,
            (step, np.dtype(kind).itemsize),
        )  # fmt: skip
        return np.ascontiguousarray(table)

    def _buffer(self, index: int) -> bytes | memoryview:
        if index not in self._read:
            self._read[index] = self._bytes(index)
        return self._read[index]

    def _bytes(self, index: int) -> bytes | memoryview:
        uri = entry_of(self.path, self.json, "buffers", index).get("uri")
        if uri is None:
            return self.chunk
        if uri.startswith("data:"):
            if (data := data_of(uri)) is None:
                raise ModelFault(self.path, f"buffer {index}", "its base64 is damaged", CUT)
            return data
        try:
            return (self.path.parent / unquote(uri)).read_bytes()
        except (OSError, ValueError):
            raise ModelFault(
                self.path, f"buffer {index}", f"its file {quoted(uri)} is not there",
                "copy it beside the model, or export it as one .glb file",
            ) from None  # fmt: skip

    def _fault(self, index: int, cause: str) -> ModelFault:
        return ModelFault(self.path, f"accessor {index}", cause, CUT)


def data_of(uri: str) -> bytes | None:
    """What a data: URI holds in base64; None if that is damaged, or it is none."""
    try:
        return base64.b64decode(uri.split(",", 1)[1], validate=True)
    except (IndexError, binascii.Error):
        return None


def beside_gltf(path: Path, document: dict[str, Any]) -> Iterator[Path]:
    """The files that hold its buffers."""
    for buffer in document.get("buffers", []):
        uri = buffer.get("uri")
        if isinstance(uri, str) and not uri.startswith("data:"):
            yield path.parent / unquote(uri)


ONE = {"meshes": "mesh"}  # of others without the s


def entry_of(path: Path, document: dict[str, Any], kind: str, index: Any) -> dict[str, Any]:
    """One of a list of the file, such as its meshes. Raises ModelFault where it has fewer."""
    entries, place = document.get(kind, []), whole(index)
    if not isinstance(entries, list):
        raise TypeError(f"{kind} is no list")
    if place >= len(entries):
        there = f"there are 0 to {len(entries) - 1}" if entries else "there is none"
        raise ModelFault(
            path, "", f"it names {ONE.get(kind, kind[:-1])} {place}, and {there}",
            "the file is damaged: export the model again",
        )  # fmt: skip
    found: dict[str, Any] = entries[place]
    return found


def whole(value: Any) -> int:
    """An index or size. Raises TypeError for what is none."""
    if not isinstance(value, int) or isinstance(value, bool) or value < 0:
        raise TypeError(f"{value!r} is not a whole number of at least 0")
    return value
