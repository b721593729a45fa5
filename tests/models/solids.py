"""Model files that tests write: cubes, in the shapes in which they come."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np

from raywalk.models.model import Model

QUADS = np.array(
    [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
)


def cube(half: float = 0.5, at: tuple[float, float, float] = (0, 0, 0)) -> np.ndarray:
    """(8, 3) corners, x slowest; QUADS are its faces, outward."""
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    return half * signs + at


def triangles() -> np.ndarray:
    """(12, 3) the same faces cut in two, outward."""
    return np.concatenate([QUADS[:, [0, 1, 2]], QUADS[:, [0, 2, 3]]])


def obj_text(vertices: np.ndarray, faces: np.ndarray, first: int = 1, head: str = "") -> str:
    """An OBJ file; `first` is the number of its first vertex, -8 for one that counts back."""
    lines = [f"v {x} {y} {z}" for x, y, z in vertices.tolist()]
    lines += ["f " + " ".join(str(k + first) for k in face) for face in faces.tolist()]
    return head + "\n".join(lines) + "\n"


def stl_bytes(corners: np.ndarray, count: int | None = None, head: bytes = b"") -> bytes:
    """A binary STL of triangles (f, 3, 3); `count` is what its header says."""
    records = b"".join(
        struct.pack("<12fH", 0, 0, 0, *corner.reshape(-1).tolist(), 0) for corner in corners
    )
    stated = len(corners) if count is None else count
    return head.ljust(80, b"\0") + struct.pack("<I", stated) + records


def written(path: Path, content: str | bytes) -> Path:
    """The file, with that content."""
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


def area(model: Model) -> float:
    """Of all triangles."""
    a, b, c = model.vertices[model.faces].transpose(1, 0, 2)
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def volume(vertices: np.ndarray, faces: np.ndarray) -> float:
    """Signed, of closed surfaces."""
    a, b, c = vertices[faces].transpose(1, 0, 2)
    return float((a * np.cross(b, c)).sum() / 6)
