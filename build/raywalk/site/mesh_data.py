"""A mesh for the rasterised stage, small.

Faces are walked from neighbour to neighbour and vertices numbered as they are first met,
so an index is mostly close to the newest one and a vertex close to the one before: what
is stored are those differences, byte plane by byte plane, which gzip likes (the bunny:
23 KB against 35 KB plain).
"""

from __future__ import annotations

import base64
from dataclasses import dataclass

import numpy as np

from raywalk.site.scene_types import MeshData


@dataclass(frozen=True, eq=False)
class DisplayMesh:
    """Triangles to rasterise, relative to `centre` in world directions and scale."""

    centre: np.ndarray  # (3,)
    vertices: np.ndarray  # (v, 3)
    faces: np.ndarray  # (f, 3)
    normals: np.ndarray | None  # (v, 3) unit; None if flat
    colours: np.ndarray | None = None  # (v, 3) uint8 base colours; None without


def mesh_data(mesh: DisplayMesh) -> MeshData:
    """Positions in 16 bits of the mesh's box, normals in 8: below a pixel on any screen."""
    faces = mesh.faces[face_walk(mesh.faces)]
    used, faces = in_order_of_use(faces)
    vertices = mesh.vertices[used]
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    size = np.where(high > low, high - low, 1.0)
    steps = np.rint((vertices - low) / size * 65535).astype(np.int64)
    data: MeshData = {
        "box": [low.tolist(), (low + size).tolist()],
        "positions": byte_planes(differences(steps), 2),
        "indices": byte_planes(behind_newest(faces), 4),
    }
    if mesh.normals is not None:
        turned = np.rint(mesh.normals[used] * 127).astype(np.int64)
        data["normals"] = byte_planes(differences(turned), 1)
    if mesh.colours is not None:
        data["colours"] = byte_planes(differences(mesh.colours[used].astype(np.int64)), 1)
    return data


def face_walk(faces: np.ndarray) -> np.ndarray:
    """(f,) an order of the faces in which most follow a neighbour over an edge."""
    beside: dict[tuple[int, int], list[int]] = {}
    corners = faces.tolist()
    for face, (a, b, c) in enumerate(corners):
        for one, other in ((a, b), (b, c), (c, a)):
            beside.setdefault((min(one, other), max(one, other)), []).append(face)
    met, order = [False] * len(corners), []
    for start in range(len(corners)):
        waiting = [] if met[start] else [start]
        met[start] = True
        while waiting:
            face = waiting.pop()
            order.append(face)
            a, b, c = corners[face]
            for one, other in ((a, b), (b, c), (c, a)):
                for neighbour in beside[min(one, other), max(one, other)]:
                    if not met[neighbour]:
                        met[neighbour] = True
                        waiting.append(neighbour)
    return np.array(order, np.int64)


def in_order_of_use(faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The vertices in the order of their first use, and the faces in their new numbers."""
    vertices, first, place = np.unique(faces, return_index=True, return_inverse=True)
    order = np.argsort(first)
    number = np.empty(len(vertices), np.int64)
    number[order] = np.arange(len(vertices))
    return vertices[order], number[place.reshape(faces.shape)]


def behind_newest(faces: np.ndarray) -> np.ndarray:
    """How far each index lies behind the next new one: 0 is a new vertex."""
    flat = faces.reshape(-1)
    newest = np.maximum.accumulate(flat)
    is_new = np.diff(newest, prepend=-1) > 0
    return np.where(is_new, 0, newest + 1 - flat)


def differences(rows: np.ndarray) -> np.ndarray:
    """Each row less the one before, axis by axis."""
    return np.diff(rows, axis=0, prepend=0).T.reshape(-1)


def byte_planes(values: np.ndarray, count: int) -> str:
    """All low bytes, then all next ones, ...; base64. Negative values in two's complement."""
    planes = [((values >> (8 * k)) & 255).astype(np.uint8) for k in range(count)]
    return base64.b64encode(np.concatenate(planes).tobytes()).decode("ascii")
