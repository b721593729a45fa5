"""Scenes written as text in a test."""

import pytest

from raywalk.scene.read import read_scene

TOP = """\
version = 1
title = "A test"
teaches = "Something."
"""
CAMERA = """
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
"""


@pytest.fixture
def scene_from(tmp_path):
    """A function from the tables of a scene, without the top and the camera, to the scene."""

    def read(tables, camera=CAMERA):
        path = tmp_path / "scene.toml"
        path.write_text(TOP + camera + tables, encoding="utf-8")
        return read_scene(path)

    return read
