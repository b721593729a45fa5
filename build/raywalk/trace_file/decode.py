"""JSON bytes back into columns; the same numbers, bit by bit, as the viewer's decode.ts."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.trace_file.checksum import checksum
from raywalk.trace_file.container import FORMAT, VERSION, unpack
from raywalk.trace_file.errors import TraceFileError
from raywalk.trace_file.reading import Reading
from raywalk.trace_file.walk import walk


@dataclass(frozen=True, eq=False)
class DecodedTrace:
    """Columns of types.ts's Trace, with its names, shapes (count,), (count, 3), (count, lights)."""

    header: dict[str, Any]
    kind: np.ndarray
    parent: np.ndarray
    pixel: np.ndarray  # row * n + column
    depth: np.ndarray
    object: np.ndarray
    material: np.ndarray
    inside: np.ndarray
    t: np.ndarray
    weight: np.ndarray
    localWeight: np.ndarray
    tests: np.ndarray
    point: np.ndarray
    normal: np.ndarray
    colour: np.ndarray
    visibility: np.ndarray
    blocker: np.ndarray
    blockedAt: np.ndarray
    passed: np.ndarray
    diffuse: np.ndarray
    specular: np.ndarray
    tiles: np.ndarray  # (3 * n * n,) 8-bit
    hitsStart: np.ndarray
    hitsT: np.ndarray
    hitsObject: np.ndarray

    @property
    def n(self) -> int:
        return int(self.header["n"])

    @property
    def count(self) -> int:
        return len(self.kind)


COLUMNS = tuple(name for name in DecodedTrace.__dataclass_fields__ if name != "header")


def read_trace(path: Path) -> DecodedTrace:
    """A .json.gz or .js file."""
    return decode(unpack(path.read_bytes()))


def decode(data: bytes, scene: str | None = None, n: int | None = None) -> DecodedTrace:
    """Columns from JSON bytes; refuses what is damaged, or not of this scene and resolution."""
    header = checked_header(data, scene, n)
    reading = Reading(header)
    try:
        ray = walk(header, reading)
        reading.finish()
    except TraceFileError:
        raise
    except (LookupError, TypeError, ValueError, ArithmeticError) as error:
        raise TraceFileError("damaged", f"the header lacks something: {error!r}") from error
    return DecodedTrace(header, **{name: ray[name] for name in COLUMNS})


def checked_header(data: bytes, scene: str | None, n: int | None) -> dict[str, Any]:
    try:
        header = json.loads(data)
    except ValueError as error:
        raise TraceFileError("damaged", f"not JSON: {error}") from error
    if not isinstance(header, dict) or header.get("format") != FORMAT:
        raise TraceFileError("not-a-trace", f'"format" is not "{FORMAT}"')
    if header.get("version") != VERSION:
        raise TraceFileError(
            "version", f"written as version {header.get('version')}, this reads {VERSION}"
        )
    for key, wanted in (("scene", scene), ("n", n)):
        if wanted is not None and header.get(key) != wanted:
            raise TraceFileError("scene", f"holds {key} {header.get(key)!r}, not {wanted!r}")
    columns = header.get("columns")
    if not isinstance(columns, dict) or not all(isinstance(c, str) for c in columns.values()):
        raise TraceFileError("damaged", "no columns")
    if checksum(header) != header.get("crc32"):
        raise TraceFileError("damaged", "the columns' checksum does not match")
    return header
