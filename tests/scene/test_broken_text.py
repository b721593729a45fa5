"""What is no TOML, or no text at all, is refused with its place."""

import pytest

from raywalk.errors import SourceErrors
from raywalk.scene.read import read_scene

SMALLEST = """\
version = 1
title = "Empty"
teaches = "Nothing is a scene too."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
"""


def errors_of(path):
    with pytest.raises(SourceErrors) as caught:
        read_scene(path)
    return caught.value.errors


def written(folder, content):
    path = folder / "scene.toml"
    path.write_bytes(content)
    return path


def test_broken_toml_is_refused_with_its_line_and_column(tmp_path):
    """The line is where an editor jumps to."""
    [error] = errors_of(written(tmp_path, SMALLEST.encode() + b"up = [0, @, 0]\n"))
    assert error.message.startswith("line 7, column 10: this is not TOML")


def test_text_that_is_not_utf8_is_refused(tmp_path):
    """An umlaut saved in an old encoding."""
    [error] = errors_of(written(tmp_path, SMALLEST.encode() + b"# K\xfcche\n"))
    assert error.message.startswith("is not UTF-8 text")
    assert error.hint == "save it as UTF-8"


def test_a_missing_file_is_refused(tmp_path):
    """A slip in a path."""
    [error] = errors_of(tmp_path / "scene.toml")
    assert error.message == "cannot be read: no such file or directory"


@pytest.mark.parametrize("value", ["1" * 5000, "[" * 5000], ids=["long number", "deep nesting"])
def test_what_no_parser_can_hold_is_refused_and_does_not_crash(value, tmp_path):
    """Limits of the language the program is written in are not the author's business."""
    [error] = errors_of(written(tmp_path, f"{SMALLEST}up = {value}\n".encode()))
    assert "too long" in error.message or "not TOML" in error.message


def test_an_integer_beyond_float64_is_refused_like_any_number(tmp_path):
    """10^400 is a fine TOML integer, but no length."""
    [error] = errors_of(written(tmp_path, f"{SMALLEST}fov = 1{'0' * 400}\n".encode()))
    assert error.key == "camera.fov"


@pytest.mark.parametrize(
    "content",
    [
        SMALLEST.encode(),
        b"\xef\xbb\xbf" + SMALLEST.encode(),
        SMALLEST.replace("\n", "\r\n").encode(),
    ],
    ids=["plain", "byte order mark", "CRLF"],
)
def test_the_smallest_scene_is_read_however_an_editor_saves_it(content, tmp_path):
    """No object, no light: black, and legal."""
    scene = read_scene(written(tmp_path, content))
    assert (scene.objects, scene.lights, scene.lesson, scene.key) == ((), (), (), "")
    assert scene.background == (0, 0, 0)
    assert scene.render.resolutions == (5, 7, 11, 15, 21, 33, 55, 77, 105)
    assert scene.id == tmp_path.name
