"""Normals at the corners of a mesh: the file's own, by smoothing groups, or averaged."""

from __future__ import annotations

import math

import numpy as np

from raywalk.models.edges import edges_of, joined


def averaged_normals(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Unit vertex normals, face normals weighted by their angle at the vertex.

    Thuermer and Wuethrich, "Computing vertex normals from polygonal facets", JGT 3(1),
    1998: independent of how a flat part is cut into triangles.
    """
    corners = vertices[faces]
    flat = face_normals(corners)
    sums = np.zeros_like(vertices)
    for k in range(3):
        one = corners[:, (k + 1) % 3] - corners[:, k]
        other = corners[:, (k + 2) % 3] - corners[:, k]
        across = np.linalg.norm(np.cross(one, other), axis=1)
        angle = np.arctan2(across, (one * other).sum(axis=1))
        np.add.at(sums, faces[:, k], angle[:, None] * flat)
    return unit_rows(sums)


def face_normals(corners: np.ndarray) -> np.ndarray:
    """(f, 3) unit, of triangles (f, 3, 3) that have an area."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return np.asarray(normals / np.linalg.norm(normals, axis=1, keepdims=True))


def grouped_normals(
    vertices: np.ndarray, faces: np.ndarray, groups: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Normals (n, 3) and the row of each corner (f, 3): averaged over triangles of one smoothing
    group only. groups: (f,) int; those of group 0 are flat, each by itself."""
    alone = np.where(groups == 0, -1 - np.arange(len(faces)), groups.astype(np.int64))
    keys = np.column_stack([faces.reshape(-1), np.repeat(alone, 3)])
    held, row = np.unique(keys, axis=0, return_inverse=True)
    rows = row.reshape(-1, 3)
    return averaged_normals(vertices[held[:, 0]], rows), rows


def creased_normals(
    vertices: np.ndarray, faces: np.ndarray, crease: float
) -> tuple[np.ndarray, np.ndarray]:
    """The same: averaged over triangles that hang together at a vertex by edges at which they turn
    by at most `crease` degrees. Edges of one triangle, or of more than two, are sharp."""
    if crease >= 180.0:
        return averaged_normals(vertices, faces), faces
    edges = edges_of(faces)
    first = edges.start[edges.uses == 2]
    one, other = edges.side[first], edges.side[first + 1]
    flat = face_normals(vertices[faces])
    turn = (flat[one // 3] * flat[other // 3]).sum(axis=1)
    # Regular prisms are met whose sides turn by the crease itself: rounding makes none sharp.
    is_smooth = turn >= math.cos(math.radians(crease)) - 1e-9
    if is_smooth.all():
        return averaged_normals(vertices, faces), faces
    one, other = one[is_smooth], other[is_smooth]
    with_it = edges.along[first[is_smooth]] == edges.along[first[is_smooth] + 1]
    begin, end = _after(one), one  # of the other's side, where it runs back
    begin, end = np.where(with_it, end, begin), np.where(with_it, begin, end)
    ties = np.concatenate([begin, end]), np.concatenate([other, _after(other)])
    fan, _, _ = joined(3 * len(faces), *ties, np.zeros(2 * len(one), bool))
    held, row = np.unique(fan, return_inverse=True)
    rows = row.reshape(-1, 3)
    return averaged_normals(vertices[faces.reshape(-1)[held]], rows), rows


def _after(corner: np.ndarray) -> np.ndarray:
    """The next corner of each one's triangle, counted as 3 * triangle + corner."""
    return np.asarray(corner - corner % 3 + (corner % 3 + 1) % 3)


def own_normals(
    table: np.ndarray, rows: np.ndarray, corners: np.ndarray, linear: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """The same from a file's own normals (n, 3), which a linear map (3, 3) took into the scene.

    rows: (f, 3), -1 for none; corners: (f, 3, 3), placed. A triangle whose normals look the other
    way than it was wound at last gets them turned; a corner without a normal gets the triangle's.
    """
    flat = face_normals(corners)
    # Normals go by the inverse transpose, here times the determinant: cofactors lose no digits.
    size = np.abs(linear).max()
    table = np.where(np.isfinite(table), table, 0.0)
    largest = np.abs(table).max(axis=1, keepdims=True, initial=0.0)
    table = np.divide(table, largest, out=np.zeros_like(table), where=largest > 0)
    mapped = unit_rows(
        unit_rows(np.where(np.isfinite(table), table, 0.0)) @ _cofactors(linear / size).T
    )
    at = np.where((rows >= 0)[:, :, None], mapped[rows], 0.0)
    facing = (at * flat[:, None]).sum(axis=2)
    at[facing.sum(axis=1) < 0] *= -1.0
    missing = (at == 0.0).all(axis=2)
    at = np.where(missing[:, :, None], flat[:, None], at)
    held, row = np.unique(at.reshape(-1, 3), axis=0, return_inverse=True)
    return held, row.reshape(-1, 3)


def _cofactors(matrix: np.ndarray) -> np.ndarray:
    a, b, c = matrix
    return np.array([np.cross(b, c), np.cross(c, a), np.cross(a, b)])


def unit_rows(rows: np.ndarray) -> np.ndarray:
    """Rows of length 1; 0 stays 0."""
    lengths = np.linalg.norm(rows, axis=1, keepdims=True)
    return np.divide(rows, lengths, out=np.zeros_like(rows), where=lengths > 0)
