"""A folder of scenes: their order, and errors across files."""

from pathlib import Path

import pytest

from raywalk.errors import SourceErrors
from raywalk.scene.read import read_scenes

SCENE = """\
version = 1
title = "A scene"
teaches = "Something."
{more}
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
"""


def put(folder, name, more="", file="scene.toml"):
    (folder / name).mkdir()
    (folder / name / file).write_text(SCENE.format(more=more), encoding="utf-8")


def errors_of(folder):
    with pytest.raises(SourceErrors) as caught:
        read_scenes(folder)
    return caught.value


def test_scenes_are_ordered_by_folder_name(tmp_path):
    """Whatever order the file system lists them in."""
    for name in ("10-b", "02-a", "01-z"):
        put(tmp_path, name)
    assert [scene.id for scene in read_scenes(tmp_path)] == ["01-z", "02-a", "10-b"]


def test_errors_of_all_scenes_are_told_at_once(tmp_path, monkeypatch):
    """Two broken scenes make one run of repairs, not two."""
    put(tmp_path, "a", "autor = 1")
    put(tmp_path, "b")
    put(tmp_path, "c", "key = 3")
    monkeypatch.chdir(tmp_path)
    text = str(errors_of(Path(".")))
    assert text.splitlines()[0] == "a/scene.toml: autor: unknown key"
    assert 'c/scene.toml: key: 3 is not one of "0", "1"' in text
    assert text.endswith("\n2 errors; nothing was traced")


def test_two_scenes_may_not_share_a_key(tmp_path, monkeypatch):
    """A key selects one scene; the error names the other and the free keys."""
    put(tmp_path, "a", 'key = "1"')
    put(tmp_path, "b", 'key = "1"')
    monkeypatch.chdir(tmp_path)
    assert str(errors_of(Path("."))) == (
        'b/scene.toml: key: "1" already selects a/scene.toml\n'
        "  free: 2, 3, 4, 5, 6, 7, 8, 9, 0\n"
        "1 error; nothing was traced"
    )


def test_a_scene_file_of_another_name_is_not_passed_over(tmp_path):
    """A scene that silently does not appear is hard to find."""
    put(tmp_path, "a", file="scenes.toml")
    [error] = errors_of(tmp_path).errors
    assert error.message == "has no scene.toml, only scenes.toml"


def test_folders_without_toml_are_no_scenes(tmp_path):
    """Pictures and notes may lie beside scenes."""
    put(tmp_path, "a")
    (tmp_path / "notes").mkdir()
    assert len(read_scenes(tmp_path)) == 1


def test_a_missing_folder_is_refused(tmp_path):
    """A slip in a path is an error, not an empty site."""
    [error] = errors_of(tmp_path / "nowhere").errors
    assert error.message == "is not a folder of scenes"


def test_a_broken_catalogue_of_models_is_told_once(tmp_path):
    """Scenes that name its models are not blamed for it."""
    (tmp_path / "models").mkdir()
    (tmp_path / "models/models.toml").write_text('[bunny]\nfiel = "bunny.ply"\n')
    mesh = '[[objects]]\ntype = "mesh"\nmodel = "bunny"\nmaterial = "white"'
    (scenes := tmp_path / "scenes").mkdir()
    for name in ("a", "b"):
        put(scenes, name)
        with (scenes / name / "scene.toml").open("a") as file:
            file.write(mesh)
    errors = errors_of(scenes).errors
    assert {error.file.name for error in errors} == {"models.toml"}
    assert [error.key for error in errors].count("bunny.fiel") == 1
