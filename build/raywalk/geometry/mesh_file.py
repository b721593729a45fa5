"""A mesh file as clean float64 triangles: what is unusable is dropped, by name and count."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from raywalk.errors import SourceError, SourceErrors
from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Mesh

# A triangle thinner than this share of its longest edge has no direction left in float64:
# its normal would be rounding. Slivers down to aspect 1e10 stay.
FLATTEST = 1e-14
# A corner further out than this many times the usual distance (1e30 in a broken export) leaves
# the rest of the mesh no digits.
FARTHEST = 1e12


@dataclass(frozen=True)
class Triangles:
    """Triangles in the world's directions and scale, around `centre`."""

    centre: np.ndarray  # (3,) world
    vertices: np.ndarray  # (v, 3) relative to centre
    faces: np.ndarray  # (f, 3) int64
    normals: np.ndarray | None  # (v, 3) unit vertex normals; None if flat
    closed: bool
    dropped: dict[str, int]  # reason -> triangles

    @property
    def corners(self) -> np.ndarray:
        """(f, 3, 3) rows a, b, c relative to centre."""
        return np.ascontiguousarray(self.vertices[self.faces])


def load_triangles(scene: Scene, obj: SceneObject) -> Triangles:
    """Reads, subdivides, cleans and places one mesh object. Raises SourceErrors if unusable."""
    import trimesh

    assert isinstance(obj.shape, Mesh)
    try:
        # No welding by trimesh: its tolerance is absolute (1e-8), scenes have any scale.
        loaded = trimesh.load(obj.shape.path, process=False, force="mesh")
    except Exception as problem:  # trimesh raises whatever its readers raise
        raise _unreadable(scene, obj, f"cannot be read as a mesh ({problem})") from problem
    if not isinstance(loaded, trimesh.Trimesh) or len(loaded.faces) == 0:
        raise _unreadable(scene, obj, "holds no triangle")
    vertices, faces = _weld(np.asarray(loaded.vertices, float), np.asarray(loaded.faces))
    vertices, faces, dropped = _within_reach(vertices, faces)
    if obj.shape.subdivide and len(faces):
        smooth = trimesh.Trimesh(vertices, faces, process=False)
        smooth = smooth.subdivide_loop(iterations=obj.shape.subdivide)
        vertices, faces = np.asarray(smooth.vertices, float), np.asarray(smooth.faces)
    placed = _placed(scene, obj, vertices, faces)
    return replace(placed, dropped={**dropped, **placed.dropped})


def _placed(scene: Scene, obj: SceneObject, vertices: np.ndarray, faces: np.ndarray) -> Triangles:
    import trimesh

    assert isinstance(obj.shape, Mesh)
    if not len(faces):
        raise _unreadable(scene, obj, "holds no usable triangle")
    middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    linear, offset = obj.transform[:3, :3], obj.transform[:3, 3]
    placed = (vertices - middle) @ linear.T
    faces, dropped = _clean(placed, faces)
    if not len(faces):
        raise _unreadable(scene, obj, "holds no usable triangle")
    if np.linalg.det(linear) < 0:  # a mirrored copy: keep normals outward
        faces = faces[:, ::-1]
    mesh = trimesh.Trimesh(placed, faces, process=False)
    closed = bool(mesh.is_watertight and mesh.is_winding_consistent)
    if closed and _volume(placed[faces]) < 0:  # the file has it inside out
        faces = faces[:, ::-1]
    centre, rest = _centre(linear, middle, offset)
    return Triangles(
        centre=centre,
        vertices=placed + rest,
        faces=faces,
        normals=_vertex_normals(placed, faces) if obj.shape.smooth else None,
        closed=closed,
        dropped=dropped,
    )


def _centre(
    linear: np.ndarray, middle: np.ndarray, offset: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """linear @ middle + offset, each (3,), and what its rounding leaves over (1e-9 at 1e7)."""
    exact = [
        sum(
            (Fraction(a) * Fraction(m) for a, m in zip(row, middle.tolist(), strict=True)),
            Fraction(b),
        )
        for row, b in zip(linear.tolist(), offset.tolist(), strict=True)
    ]
    centre = [float(each) for each in exact]
    rest = [float(each - Fraction(c)) for each, c in zip(exact, centre, strict=True)]
    return np.array(centre), np.array(rest)


def _volume(corners: np.ndarray) -> float:
    """Six times the volume that a closed mesh encloses; negative if it is inside out."""
    a, b, c = corners.transpose(1, 0, 2)
    return float((a * np.cross(b, c)).sum())


def _within_reach(
    vertices: np.ndarray, faces: np.ndarray
) -> tuple[np.ndarray, np.ndarray, dict[str, int]]:
    """Only vertices that some face uses, without faces that reach to infinity or next to it."""
    finite = np.isfinite(vertices[faces]).all(axis=(1, 2))
    corners = vertices[faces[finite]]
    near = np.ones(len(corners), bool)
    if len(corners):
        away = np.abs(corners / 2 - np.median(corners, axis=(0, 1)) / 2).max(axis=(1, 2))
        near = away <= FARTHEST * np.median(away)
    kept = faces[finite][near]
    used, index = np.unique(kept, return_inverse=True)
    dropped = {"not finite": int((~finite).sum()), "too far out": int((~near).sum())}
    return (
        vertices[used],
        index.reshape(-1, 3),
        {reason: n for reason, n in dropped.items() if n},
    )


def _weld(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Joins vertices of exactly equal position, as formats without sharing (STL) need."""
    unique, index = np.unique(vertices, axis=0, return_inverse=True)
    return unique, index.reshape(-1)[faces]


def _clean(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, dict[str, int]]:
    """Faces worth tracing, and what was dropped: without area, or twice the same."""
    dropped = {}
    a, b, c = vertices[faces].transpose(1, 0, 2)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    longest = np.max([np.linalg.norm(e, axis=1) for e in (b - a, c - b, a - c)], axis=0)
    keep = area > FLATTEST * longest**2
    dropped["without area"] = int((~keep).sum())
    faces = faces[keep]
    _, first = np.unique(np.sort(faces, axis=1), axis=0, return_index=True)
    dropped["duplicates"] = len(faces) - len(first)
    return faces[np.sort(first)], {reason: n for reason, n in dropped.items() if n}


def _vertex_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Unit vertex normals, face normals weighted by their angle at the vertex.

    Thuermer and Wuethrich, "Computing vertex normals from polygonal facets", JGT 3(1),
    1998: independent of how a flat part is cut into triangles.
    """
    corners = vertices[faces]
    face_normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    face_normals /= np.linalg.norm(face_normals, axis=1, keepdims=True)
    sums = np.zeros_like(vertices)
    for k in range(3):
        one = corners[:, (k + 1) % 3] - corners[:, k]
        other = corners[:, (k + 2) % 3] - corners[:, k]
        across = np.linalg.norm(np.cross(one, other), axis=1)
        angle = np.arctan2(across, (one * other).sum(axis=1))
        np.add.at(sums, faces[:, k], angle[:, None] * face_normals)
    lengths = np.linalg.norm(sums, axis=1, keepdims=True)
    return np.divide(sums, lengths, out=np.zeros_like(sums), where=lengths > 0)


def _unreadable(scene: Scene, obj: SceneObject, why: str) -> SourceErrors:
    assert isinstance(obj.shape, Mesh)
    key = f'objects "{obj.name}".model'
    problem = SourceError(scene.path, key, f"{obj.shape.path.name} {why}")
    return SourceErrors([problem])
