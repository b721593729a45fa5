"""The nodes of a glTF file: which mesh stands where."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from raywalk.models.faults import ModelFault
from raywalk.models.gltf_buffers import entry_of

COUNTS = {"matrix": 16, "rotation": 4, "scale": 3, "translation": 3}
HUGE = 1e100  # of a node's matrix


class Placed(NamedTuple):
    """A mesh where a node puts it."""

    mesh: int
    matrix: np.ndarray  # (4, 4)
    name: str


def placed_meshes(path: Path, document: dict[str, Any]) -> Iterator[Placed]:
    """Every mesh of the scene that is shown; of all nodes if the file names no scene. Raises
    ModelFault for nodes in a circle."""
    nodes = document.get("nodes", [])
    scenes = document.get("scenes", [])
    if scenes:
        first = entry_of(path, document, "scenes", document.get("scene", 0)).get("nodes", [])
    else:
        inner = {child for node in nodes for child in node.get("children", [])}
        first = [k for k in range(len(nodes)) if k not in inner]
    if not nodes:  # meshes alone
        yield from (Placed(k, np.eye(4), str(mesh.get("name") or f"mesh {k + 1}"))
                    for k, mesh in enumerate(document.get("meshes", [])))  # fmt: skip
        return
    waiting, met = [(index, np.eye(4)) for index in reversed(first)], set()
    while waiting:
        index, outer = waiting.pop()
        if index in met:
            raise ModelFault(
                path, f"node {index}", "it stands below two nodes, or below itself",
                "the file is damaged: export the model again",
            )  # fmt: skip
        met.add(index)
        node = entry_of(path, document, "nodes", index)
        for key, count in COUNTS.items():
            if key in node and not _are_numbers(node[key], count):
                raise ModelFault(
                    path, f"node {index}", f"its {key} is not {count} numbers",
                    "the file is damaged: export the model again",
                )  # fmt: skip
        own = _matrix(node)
        if not (np.abs(own) < HUGE).all():
            raise ModelFault(path, f"node {index}", "its place is no number", "export it again")
        matrix = outer @ own
        if "mesh" in node:
            mesh = entry_of(path, document, "meshes", node["mesh"])
            name = node.get("name") or mesh.get("name") or f"node {index}"
            yield Placed(node["mesh"], matrix, str(name))
        waiting += [(child, matrix) for child in reversed(node.get("children", []))]


def _are_numbers(value: Any, count: int) -> bool:
    return (
        isinstance(value, list)
        and len(value) == count
        and all(isinstance(each, int | float) for each in value)
    )


def _matrix(node: dict[str, Any]) -> np.ndarray:
    if not all((np.abs(np.array(node.get(key, [0]), float)) < HUGE).all() for key in COUNTS):
        return np.full((4, 4), np.nan)
    if "matrix" in node:
        return np.array(node["matrix"], float).reshape(4, 4).T
    made = np.eye(4)
    x, y, z, w = np.array(node.get("rotation", [0, 0, 0, 1]), float)
    made[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    made[:3, :3] *= np.array(node.get("scale", [1, 1, 1]), float).reshape(3)
    made[:3, 3] = np.array(node.get("translation", [0, 0, 0]), float).reshape(3)
    return made
