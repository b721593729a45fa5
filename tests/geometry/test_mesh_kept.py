"""A mesh that was made ready is used again where nothing that decides on it has changed."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from tests.geometry.by_hand import affine, mesh_of, scene_of, write_ply

from raywalk.geometry import mesh_kept
from raywalk.geometry.mesh_kept import mesh_target
from raywalk.scene.model import SceneObject


def cube_in(folder: Path) -> SceneObject:
    made = trimesh.creation.box((2, 2, 2))
    path = write_ply(folder / "cube.ply", np.asarray(made.vertices, float), np.asarray(made.faces))
    return SceneObject("cube", mesh_of(path), 0, np.eye(4))


def target(obj: SceneObject, glass: bool = False):
    return mesh_target(scene_of([obj]), 0, glass)


def test_another_colour_reads_no_mesh_again(tmp_path):
    """Nor does another name or another material."""
    obj = cube_in(tmp_path)
    assert target(obj) is target(replace(obj, name="die"))
    assert target(obj) is target(replace(obj, material=1))


@pytest.mark.parametrize("what", ["place", "normals", "subdivision", "glass", "file"])
def test_what_decides_on_a_mesh_makes_it_anew(what, tmp_path):
    """And what was there before is still there."""
    obj = cube_in(tmp_path)
    first = target(obj)
    if what == "file":
        file = obj.shape.path
        state = file.stat()
        os.utime(file, ns=(state.st_atime_ns, state.st_mtime_ns + 1))
    changed = {
        "place": lambda: replace(obj, transform=affine(np.eye(3), np.array([1.0, 0.0, 0.0]))),
        "normals": lambda: replace(obj, shape=replace(obj.shape, smooth=True)),
        "subdivision": lambda: replace(obj, shape=replace(obj.shape, subdivide=1)),
    }.get(what, lambda: obj)()
    other = target(changed, glass=what == "glass")
    assert other is not first
    if what != "file":
        assert target(obj) is first


def test_large_scans_are_not_kept_and_the_oldest_makes_room(tmp_path, monkeypatch):
    """A cube has 12 triangles: one cube is too much, or two are."""
    obj = cube_in(tmp_path)
    moved = replace(obj, transform=affine(np.eye(3), np.array([1.0, 0.0, 0.0])))
    monkeypatch.setattr(mesh_kept, "_kept", mesh_kept._kept.__class__())
    monkeypatch.setattr(mesh_kept, "MOST", 11)
    assert target(obj) is not target(obj)
    monkeypatch.setattr(mesh_kept, "MOST", 23)
    first = target(obj)
    assert target(obj) is first
    target(moved)
    assert target(obj) is not first
