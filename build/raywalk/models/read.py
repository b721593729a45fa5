"""A model file to a Model: the reader is chosen by the name's ending."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from raywalk.models.faults import ModelFault, shown
from raywalk.models.model import Model

# Ending -> what reads it. Each is imported only where a file ends so.
READABLE = (".obj", ".stl", ".ply", ".off", ".gltf", ".glb", ".3mf")
LARGEST = 1 << 31  # bytes


def read_model(path: Path) -> Model:
    """The model of a file. Raises ModelFault with the one sentence that helps."""
    kind = path.suffix.lower()
    if kind not in READABLE:
        raise ModelFault(
            path, "", f"a file that ends in {shown(kind) or 'nothing'} is not read",
            f"export it as one of {', '.join(READABLE)}",
        )  # fmt: skip
    data = _bytes(path)
    try:
        # Numbers that are none, or too large, are dropped later, and counted.
        with np.errstate(all="ignore"):
            return _reader(kind)(path, data)
    except MemoryError:
        raise ModelFault(
            path, "", "it needs more memory than there is", "make it smaller"
        ) from None


def _bytes(path: Path) -> bytes:
    try:
        if path.stat().st_size > LARGEST:
            raise ModelFault(path, "", "it is larger than 2 GB", "reduce its triangles")
        data = path.read_bytes()
    except FileNotFoundError:
        raise ModelFault(path, "", "there is no such file", "look at its name and place") from None
    except (OSError, ValueError) as problem:
        why = getattr(problem, "strerror", None) or "no file can be called so"
        raise ModelFault(path, "", why.lower(), "choose another file") from None
    if not data:
        raise ModelFault(path, "", "it is empty", "copy or export it again")
    return data


def _reader(kind: str) -> Callable[[Path, bytes], Model]:
    match kind:
        case ".obj":
            from raywalk.models.obj import read_obj

            return read_obj
        case ".stl":
            from raywalk.models.stl import read_stl

            return read_stl
        case ".ply":
            from raywalk.models.ply import read_ply

            return read_ply
        case ".off":
            from raywalk.models.off import read_off

            return read_off
        case ".3mf":
            from raywalk.models.threemf import read_3mf

            return read_3mf
    from raywalk.models.gltf import read_gltf

    return read_gltf
