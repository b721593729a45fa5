"""Trace files as columns, decoded by the viewer's own modules."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.stops.process import Stops

VECTORS = ("point", "normal", "base", "colour")
OF_LIGHTS = ("visibility", "blocker", "blockedAt", "passed", "diffuse", "specular")


class DecodedTrace:
    """The header of a trace file, and as attributes the columns of Trace (viewer/trace/types.ts) by
    their names there: (count,), (count, 3) or (count, lights); tiles (3 * n * n,)."""

    def __init__(self, header: dict[str, Any], columns: dict[str, np.ndarray]):
        self.header, self.n, self.count = header, int(header["n"]), len(columns["kind"])
        wide = dict.fromkeys(VECTORS, 3) | dict.fromkeys(OF_LIGHTS, len(header["lights"]))
        for name, column in columns.items():
            shape = (self.count, wide[name]) if name in wide else (-1,)
            setattr(self, name, column.reshape(shape))

    def __getattr__(self, name: str) -> np.ndarray:
        raise AttributeError(f"traces have no column {name}")


def read_trace(
    path: Path, stops: Stops | None = None, scene: str | None = None, n: int | None = None
) -> DecodedTrace:
    """A .json.gz or .js file; scene, n: of which it must be. Raises SourceErrors if it is damaged,
    of another version, scene or resolution, or no trace. stops: where it is asked, if it is open.
    """
    if stops is None:
        with Stops() as own:
            return read_trace(path, own, scene, n)
    request = {"do": "columns", "trace": str(path.absolute()), "id": scene, "n": n}
    wanted = {key: value for key, value in request.items() if value is not None}
    answer = json.loads(stops.ask(wanted, path))
    return DecodedTrace(answer["header"], {
        name: np.frombuffer(base64.b64decode(text), kind.removesuffix("Array").lower())
        for name, (kind, text) in answer["columns"].items()
    })  # fmt: skip
