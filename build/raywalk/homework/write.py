"""Writes a scene's vectors: <scene>.json and <scene>.csv."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from raywalk.homework.rows import as_csv
from raywalk.homework.vectors import vectors_of
from raywalk.scene.model import Scene
from raywalk.trace.wavefront import Tracer


def write_vectors(scene: Scene, folder: Path) -> None:
    """Traces the scene's small pictures and writes both files."""
    vectors = vectors_of(Tracer(scene))
    (folder / f"{scene.id}.json").write_text(as_json(vectors), encoding="utf-8")
    (folder / f"{scene.id}.csv").write_text(as_csv(vectors), encoding="utf-8")


def as_json(vectors: dict[str, Any]) -> str:
    """A line for each pixel, so that a person finds one and a comparison of two files shows it."""
    grids = ",\n".join(_grid(grid) for grid in vectors["grids"])
    rest = _compact({key: value for key, value in vectors.items() if key != "grids"})
    return f'{rest[:-1]},"grids":[\n{grids}\n]}}\n'


def _grid(grid: dict[str, Any]) -> str:
    pixels = ",\n".join(map(_compact, grid["pixels"]))
    return f'{{"n":{grid["n"]},"left_out":{_compact(grid["left_out"])},"pixels":[\n{pixels}\n]}}'


def _compact(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False, allow_nan=False)
