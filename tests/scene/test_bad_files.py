"""Every bad file in bad/ is refused with exactly the text beside it."""

import os
from pathlib import Path

import pytest

from raywalk.errors import SourceErrors
from raywalk.scene.read import read_scene

BAD = Path(__file__).parent / "bad"
FILES = sorted(BAD.glob("*.toml"))


def refusal_of(path):
    with pytest.raises(SourceErrors) as caught:
        read_scene(path)
    return str(caught.value)


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_a_bad_file_is_refused_in_these_words(file, monkeypatch):
    """To see the words of a new file, run with RAYWALK_WRITE_EXPECTED=1 and read what it wrote."""
    monkeypatch.chdir(BAD)
    text = refusal_of(Path(file.name)) + "\n"
    expected = file.with_suffix(".txt")
    if os.environ.get("RAYWALK_WRITE_EXPECTED"):
        expected.write_text(text, encoding="utf-8")
    assert text == expected.read_text(encoding="utf-8")


def test_no_expected_text_is_left_without_its_file():
    """Each .txt belongs to a .toml."""
    assert {path.stem for path in BAD.glob("*.txt")} == {path.stem for path in FILES}


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_no_refusal_speaks_in_the_librarys_words(file):
    """A lecturer need not know which library reads the file."""
    text = refusal_of(file)
    for word in ("pydantic", "Input should", "https://", "type=", "None", "tuple", "dict", "str_"):
        assert word not in text


def test_a_path_below_the_current_directory_is_shown_from_there(monkeypatch):
    """The path in an error can be pasted after the name of an editor."""
    monkeypatch.chdir(BAD.parent)
    assert refusal_of(BAD / "number-nan.toml").startswith("bad/number-nan.toml: objects[0].center")


def test_a_path_elsewhere_is_shown_in_full(monkeypatch, tmp_path):
    """A relative path with many .. would be harder to find."""
    monkeypatch.chdir(tmp_path)
    file = BAD / "number-nan.toml"
    assert refusal_of(file).startswith(f"{file.as_posix()}: objects[0].center")
