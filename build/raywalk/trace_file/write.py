"""Writes one level as the two files it is published as."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raywalk.scene.model import Scene
from raywalk.trace.tree import RayTree
from raywalk.trace_file.container import pack
from raywalk.trace_file.encode import encode
from raywalk.trace_file.script import write_beside, write_packed


def write_level(folder: Path, level: RayTree, n: int, scene: Scene, picture: np.ndarray) -> None:
    """<n>.json.gz for anyone, <n>.js for the viewer, which cannot fetch from file://."""
    packed = pack(encode(level, scene, picture))
    write_beside(folder / f"{n}.json.gz", packed)
    write_packed(folder / f"{n}.js", f"{scene.id}/{n}", packed)
