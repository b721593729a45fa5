"""A scene's id: its folder's name, fit for addresses and file names everywhere."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from raywalk.errors import SourceErrors
from raywalk.scene.address import LONGEST, address_of
from raywalk.scene.read import read_scenes

#: Of URLs (RFC 3986, unreserved without ~) and of file names on Linux, macOS and Windows.
FIT = re.compile(r"[A-Za-z0-9_][A-Za-z0-9._-]*(?<![.])")
STRANGE = [
    "folder name #1", "50 %", "%41", "why?", "a&b", "it's", 'say "hi"', "<b>", "back\\slash", "a:b",
    "a*b|c", "tab\there", "line\nbreak", "日本語", "😀", "..", "...", "-", "-rf", " ", "con",
    "NUL.txt", "index", "course", "end.", "x" * 250, "\udcff", "e\u0301\u200b", "a;b=c,d+e@f$g!(h)",
]  # fmt: skip


@pytest.mark.parametrize(
    "name", sorted(path.parent.name for path in Path("scenes").glob("*/scene.toml"))
)
def test_a_name_that_fits_everywhere_is_the_id_as_it_is(name):
    assert address_of(name) == name


@pytest.mark.parametrize(
    ("name", "id"),
    [
        ("Zwei Kugeln", "Zwei-Kugeln"), ("Größe", "Groesse"), ("Gro\u0308ße", "Groesse"),
        ("Ålesund", "Aalesund"), ("naïve café", "naive-cafe"), ("a_b.c", "a_b.c"),
    ],
)  # fmt: skip
def test_spaces_and_letters_with_marks_are_spelt_out(name, id):
    assert address_of(name) == id


@pytest.mark.parametrize("name", STRANGE, ids=ascii)
def test_any_other_name_has_an_id_that_fits(name):
    assert FIT.fullmatch(address_of(name)) and len(address_of(name)) <= LONGEST + 7


def test_names_that_differ_in_what_does_not_fit_have_different_ids():
    assert len({address_of(name) for name in ["a#1", "a?1", "a%1", "a 1", *STRANGE]}) == 4 + len(
        STRANGE
    )


def test_two_folders_of_one_address_are_named(
    tmp_path,
):
    text = Path("scenes/01-shading/scene.toml").read_text().replace('key = "1"', "")
    for name in ("a ball", "A-Ball"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "scene.toml").write_text(text)
    with pytest.raises(SourceErrors, match=r'has the address "a-ball" that .*A-Ball has\n  rename'):
        read_scenes(tmp_path)


def test_a_hidden_folder_is_no_scene(tmp_path):
    (tmp_path / ".ipynb_checkpoints").mkdir()
    (tmp_path / ".ipynb_checkpoints" / "scene.toml").write_text("no scene at all")
    assert read_scenes(tmp_path) == []
