"""Meshes for the stage: what is packed for the viewer (tests/viewer/mesh.test.mjs unpacks it)."""

from __future__ import annotations

import base64
from dataclasses import replace

import numpy as np
import pytest

from raywalk.site.mesh_data import DisplayMesh, face_walk, in_order_of_use, mesh_data

TETRAHEDRON = DisplayMesh(
    centre=np.zeros(3),
    vertices=np.array([[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 4.0]]),
    faces=np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]),
    normals=np.array([[-1, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]),
)


def unpacked(text: str, planes: int) -> np.ndarray:
    raw = np.frombuffer(base64.b64decode(text), np.uint8).reshape(planes, -1).astype(np.int64)
    return sum(raw[k] << (8 * k) for k in range(planes))


def faces_of(data: dict) -> np.ndarray:
    newest, faces = 0, []
    for behind in unpacked(data["indices"], 4).tolist():
        faces.append(newest if behind == 0 else newest - behind)
        newest += behind == 0
    return np.array(faces).reshape(-1, 3)


def positions_of(data: dict) -> np.ndarray:
    low, high = np.array(data["box"])
    steps = np.cumsum(unpacked(data["positions"], 2).reshape(3, -1), axis=1).T % 65536
    return low + steps / 65535 * (high - low)


def test_the_viewers_test_unpacks_these_very_bytes():
    """Both tests hold the same tetrahedron, so neither side can drift alone."""
    data = mesh_data(TETRAHEDRON)
    assert data["positions"] == "AAD/AQD/AQAAAAD/AAD/AAD/AAAAAAD/"
    assert data["normals"] == "gX9/gQB/gQAAAAB/"
    assert data["indices"] == "AAAAAwEAAgMBBAEDAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"


@pytest.mark.parametrize("seed", range(5), ids=lambda seed: f"seed {seed}")
def test_no_triangle_is_lost_moved_or_turned(seed):
    """Any soup of triangles: the same corners in the same turn, within half a step of 16 bits."""
    rng = np.random.default_rng(seed)
    vertices = rng.normal(size=(50, 3))
    faces = np.array([rng.choice(50, 3, replace=False) for _ in range(80)])
    data = mesh_data(DisplayMesh(np.zeros(3), vertices, faces, None))
    walked = vertices[faces[face_walk(faces)]]
    step = np.ptp(vertices, axis=0).max() / 65535
    assert np.abs(positions_of(data)[faces_of(data)] - walked).max() <= 0.51 * step
    assert "normals" not in data


def test_colours_of_vertices_come_back_as_they_are():
    """In the order in which vertices are first used."""
    colours = np.array([[255, 0, 7], [0, 255, 128], [9, 8, 7], [200, 100, 50]], np.uint8)
    data = mesh_data(replace(TETRAHEDRON, colours=colours))
    steps = unpacked(data["colours"], 1).reshape(3, -1)
    found = np.cumsum(steps, axis=1).T % 256
    used, _ = in_order_of_use(TETRAHEDRON.faces[face_walk(TETRAHEDRON.faces)])
    assert (found == colours[used]).all()
    assert "colours" not in mesh_data(TETRAHEDRON)
