"""STL, binary and as text, with the face colours of VisCAM and Magics.

Our own: trimesh 5.2 refuses a binary file whose count of triangles is not its length's, though what
follows is whole, and says of a broken text neither line nor value.
"""

from __future__ import annotations

from array import array
from pathlib import Path

import numpy as np

from raywalk.models.faults import ModelFault, quoted
from raywalk.models.model import Model, PerCorner
from raywalk.models.text import a_number, lines, name_of, one_encoding

HEADER, TRIANGLE = 84, 50  # bytes
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("colour", "<u2")])
FLOAT32 = 2.0**-23


def read_stl(path: Path, data: bytes) -> Model:
    """The model. Raises ModelFault with the line, or the triangle."""
    text = one_encoding(data)
    if text[:512].lstrip()[:5].lower() == b"solid" and not _is_binary(data):
        return _text(path, text)
    return _binary(path, data)


def _is_binary(data: bytes) -> bool:
    """Some binary files begin with "solid" too: their length tells them, or bytes of no text."""
    if len(data) < HEADER:
        return False
    if len(data) == HEADER + TRIANGLE * _stated_count(data):
        return True
    head = data[:4096]
    return b"\x00" in head and b"facet" not in head.lower()


def _stated_count(data: bytes) -> int:
    return int.from_bytes(data[80:HEADER], "little")


def _binary(path: Path, data: bytes) -> Model:
    if len(data) < HEADER + TRIANGLE:
        raise ModelFault(
            path, "", f"it has {len(data)} bytes, and an STL of one triangle has 134",
            "it is cut short, or no STL file: export the model again",
        )  # fmt: skip
    stated, (there, rest) = _stated_count(data), divmod(len(data) - HEADER, TRIANGLE)
    ignored = []
    if stated > there and rest:
        raise ModelFault(
            path, f"triangle {there + 1} of {stated}", "the file ends in it",
            "it is cut short: copy or export it again",
        )  # fmt: skip
    count = stated if 0 < stated <= there else there
    if stated != there:
        follow = "1 triangle follows" if there == 1 else f"{there} triangles follow"
        ignored.append(f"the count in its header, {stated}, is wrong: {follow}")
        ignored += [f"what follows triangle {count} is not read"] if count < there else []
    records = np.frombuffer(data, RECORD, count, HEADER)
    with np.errstate(invalid="ignore"):
        vertices = records["corners"].reshape(-1, 3).astype(float)
    colours = _colours(data[:80], records["colour"])
    faces = np.arange(3 * count).reshape(-1, 3)
    return Model(
        path, "binary STL", vertices, faces, colours=colours, ignored=tuple(ignored),
        colours_of="faces" if colours else "", grain=FLOAT32,
    )  # fmt: skip


def _colours(header: bytes, attributes: np.ndarray) -> PerCorner | None:
    """5 bits a channel. VisCAM: blue lowest, the top bit says that there is one. Magics: red
    lowest, the top bit says that the header's colour holds."""
    is_magics = b"COLOR=" in header
    has_own = (attributes >> 15 == 1) != is_magics
    if not has_own.any() or (not is_magics and not has_own.all()):
        return None
    channels = np.column_stack([(attributes >> shift) & 31 for shift in (0, 5, 10)]) / 31.0
    if not is_magics:
        channels = channels[:, ::-1]
    else:
        rgb = np.frombuffer(header.split(b"COLOR=")[1][:3].ljust(3, b"\xff"), np.uint8) / 255.0
        channels = np.where(has_own[:, None], channels, rgb)
    row = np.repeat(np.arange(len(attributes))[:, None], 3, axis=1)
    return PerCorner(np.ascontiguousarray(channels), row)


def _text(path: Path, data: bytes) -> Model:
    places, part = array("d"), array("i")
    names: dict[str, int] = {}
    held, name, number, is_open = 0, "", 0, True
    for number, line in lines(data):
        words = line.split()
        if not words:
            continue
        word = words[0].lower()
        if word == b"vertex":
            if len(words) < 4:
                raise ModelFault(
                    path, f"line {number}",
                    f"{quoted(line.strip())} has {len(words) - 1} of a vertex's 3 coordinates",
                    "write x, y and z, or export the model again",
                )  # fmt: skip
            places.extend(a_number(each, path, number) for each in words[1:4])
            held += 1
        elif word in (b"endloop", b"facet", b"endfacet") and held:
            _refuse_other(path, number, held)
            part.append(names.setdefault(name, len(names)))
            held = 0
        elif word == b"solid":
            name, is_open = name_of(b" ".join(words[1:])), True
        elif word == b"endsolid":
            is_open = False
        elif word not in (b"facet", b"endfacet", b"outer", b"endloop", b"normal"):
            raise ModelFault(
                path, f"line {number}", f"{quoted(line.strip())} is no line of an STL file",
                "a triangle is `facet normal`, `outer loop`, three times `vertex`, `endloop`, "
                "`endfacet`: export the model again",
            )  # fmt: skip
    if held or (is_open and places):
        raise ModelFault(
            path, f"line {number}", f"the file ends in triangle {len(part) + 1}, before `endsolid`",
            "it is cut short: copy or export it again",
        )  # fmt: skip
    vertices = np.frombuffer(places or array("d")).reshape(-1, 3)
    return Model(
        path, "STL as text", vertices, np.arange(len(vertices)).reshape(-1, 3),
        parts=tuple(names) or ("",), part=np.array(part, np.int32), grain=FLOAT32,
    )  # fmt: skip


def _refuse_other(path: Path, number: int, held: int) -> None:
    if held != 3:
        raise ModelFault(
            path, f"line {number}", f"a facet of {held} vertices ends here, and one has three",
            "export the model again as triangles",
        )  # fmt: skip
