"""What word processors, web pages and other keyboards put into a scene: each named by its cause."""

from __future__ import annotations

from pathlib import Path

import pytest

from raywalk.errors import SourceError, SourceErrors
from raywalk.scene.read import read_scene
from raywalk.scene.typing_slips import slips_in

SCENE = """version = 1
title = "Typing"
teaches = "A scene typed by hand."
background = [0.5, 0.5, 0.5]
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
fov = 40
[[objects]]
name = "ball"
type = "sphere"
center = [0, -1, 0]
radius = 0.5
material = { like = "coloured", diffuse = [0.9, 0.2, 0.1] }
[[lights]]
position = [-3, 5, 4]
"""


def said_of(tmp_path, before, after):
    assert before in SCENE
    (tmp_path / "scene.toml").write_text(SCENE.replace(before, after), encoding="utf-8")
    with pytest.raises(SourceErrors) as caught:
        read_scene(tmp_path)
    return str(caught.value)


def test_the_scene_without_slips_is_in_order(tmp_path):
    (tmp_path / "scene.toml").write_text(SCENE)
    assert read_scene(tmp_path).title == "Typing" and not slips_in(SCENE)


@pytest.mark.parametrize(
    ("before", "after", "cause", "instead"),
    [
        ('"ball"', "„ball“", "line 10, column 8: „ (U+201E", 'straight quotes: "ball"'),
        ('"ball"', "“ball”", "“ (U+201C", 'straight quotes: "ball"'),
        ('"ball"', "«ball»", "« (U+00AB", 'straight quotes: "ball"'),
        ('"ball"', "‘ball’", "‘ (U+2018", 'straight quotes: "ball"'),
        ("fov = 40", "fov = 40,5", "40,5 has a decimal comma", "point: 40.5"),
        ("fov = 40", "fov = 40,5 # degrees", "40,5 has a decimal comma", "point: 40.5"),
        ("fov = 40", "fov = -0,5", "-0,5 has a decimal comma", "point: -0.5"),
        ("fov = 40", "fov = 1,5e1", "1,5e1 has a decimal comma", "point: 1.5e1"),
        ("fov = 40", "fov = ,5", ",5 has a decimal comma", "point: 0.5"),
        ("fov = 40", "fov = 1,000", "1,000 has a decimal comma", "1.000, or 1000 if thousands"),
        ("fov = 40", "fov = 1.000,5", "1.000,5 has its thousands set apart", "nothing: 1000.5"),
        ("fov = 40", "fov = -1.234.000,25", "thousands set apart", "nothing: -1234000.25"),
        ("fov = 40", "fov = 1,000.5", "1,000.5 has its thousands set apart", "nothing: 1000.5"),
        ("fov = 40", "fov = 1'000", "1'000 has its thousands set apart", "nothing: 1000"),
        ("fov = 40", "fov = 1 000,5", "1 000,5 has its thousands set apart", "nothing: 1000.5"),
        ("[0, -1, 0]", "[0, 1.000.000, 0]", "1.000.000 has its thousands", "nothing: 1000000"),
        ("fov = 40", "fov = 10³", "10³ has its power above the line", "write 1e3"),
        ("[0, -1, 0]", "[0, -10⁻², 0]", "-10⁻² has its power above", "write -1e-2"),
        ("fov = 40", "fov = 4 · 10¹", "4 · 10¹ has its power above", "write 4e1"),
        ("fov = 40", "fov = 6²", "6² has its power above the line", "write 36"),
        ("fov = 40", "fov = 10^2", "10^2 is not worked out", "write the result"),
        ("fov = 40", "fov = 6**2", "6**2 is not worked out", "write the result"),
        ("fov = 40", "fov = 2 × 20", "2 × 20 is not worked out", "write the result"),
        ("fov = 40", "fov = 20 + 20", "20 + 20 is not worked out", "write the result"),
        ("fov = 40", "fov = 045", "045 begins with a 0", "write 45"),
        ("[0, -1, 0]", "[0, - 1, 0]", "a space stands behind the - of 1", "write -1"),
        ("0.5\n", "½\n", "½ is no number to a program", "write 0.5"),
        ("fov = 40", "fov = ４０", "４０ is no number to a program", "keyboard: 40"),
        ("fov = 40", "fov = π", "π is no number to a program", "in digits"),
        ("[0, -1, 0]", "[0, −1, 0]", "− (U+2212, minus sign)", "type the - of the keyboard"),
        ("[0, -1, 0]", "[0, –1, 0]", "– (U+2013, en dash)", "type the - of the keyboard"),
        ("radius = ", "radius =\u00a0", "(U+00A0, no-break space)", "type a space"),
        ("radius = ", "radius\u202f= ", "(U+202F, narrow no-break space)", "type a space"),
        ("radius = ", "\u200bradius = ", "(U+200B, zero width space)", "type a space"),
        ("0.5\n", ".5\n", ".5 begins with its point", "before the point: 0.5"),
        ("[0, -1, 0]", "[0, -.5, 0]", "-.5 begins with its point", "before the point: -0.5"),
        ("0.5\n", "1.\n", "1. ends with its point", "behind the point: 1.0"),
        ('"sphere"', "sphere", "sphere is no value", 'in quotes: "sphere"'),
        ("0.5\n", "Yes\n", "Yes is no value", "true and false"),
        ("[0, -1, 0]", "[0; -1; 0]", "; separates nothing", "by commas"),
        ("[0, -1, 0]", "[0 -1 0]", "0 -1 has no comma between its numbers", "by commas"),
        ("fov = 40", "fov: 40", "a colon stands behind fov", "write fov = ..."),
        ("[0, -1, 0]", "(0, -1, 0)", "(0, -1, 0) stands in round", "write [0, -1, 0]"),
        ("[0, -1, 0]", "0, -1, 0", "0, -1, 0 stands in no brackets", "write [0, -1, 0]"),
        ("[0, -1, 0]", "[0，-1，0]", "， is no comma", "type the , of"),
        ("fov = 40", "fov = 40°", "40 has a unit, °", "write 40: lengths"),
        ("0.5\n", "0.5 cm\n", "0.5 has a unit, cm", "write 0.5: lengths"),
        ("0.5\n", "1/2\n", "1/2 is not worked out", "write the result"),
        ("[0.9, 0.2, 0.1]", "[90%, 20%, 10%]", "90% is no number", "a share of 1"),
        ("fov = 40", "fov = 40 // degrees", "// begins no comment", "begins with #"),
    ],
)
def test_a_slip_is_told_by_its_cause_and_with_what_to_type(tmp_path, before, after, cause, instead):
    """Where it stands, by line and column, and nothing of what a parser expected there."""
    said = said_of(tmp_path, before, after)
    assert cause in said and instead in said
    assert "line " in said and "this is not TOML" not in said and "expected" not in said


def test_all_slips_of_a_file_are_told_at_once(tmp_path):
    text = SCENE.replace('"ball"', "„ball“").replace("-1", "−1").replace("0.5\n", ".5\n")
    (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
    with pytest.raises(SourceErrors) as caught:
        read_scene(tmp_path)
    assert [error.message.partition(":")[0] for error in caught.value.errors] == [
        "line 10, column 8", "line 12, column 14", "line 13, column 10",
    ]  # fmt: skip


def test_texts_and_comments_may_hold_any_of_them(tmp_path):
    """„so“ is right in a title, and 40,5 in a comment."""
    text = SCENE.replace('"Typing"', '"„so“ – 40,5 .5 −1; \u00a0"') + "# „so“ 40,5 .5 −1;\n"
    text += '[[lesson]]\ntext = """\nA „line“,\n.5 = 40,5\n"""\n'
    (tmp_path / "scene.toml").write_text(text, encoding="utf-8")
    assert "„so“" in read_scene(tmp_path).title


def test_a_mistake_of_another_kind_keeps_the_parsers_words(tmp_path):
    assert "this is not TOML" in said_of(tmp_path, "[camera]", "[camera")
    said = said_of(tmp_path, "[0, -1, 0]", "[0, -1, 0")
    assert "unclosed array" in said and "on a line before is not closed" in said


@pytest.mark.parametrize(
    ("colour", "hint"),
    [
        ("[230, 51, 25]", "divided by 255 it is [0.902, 0.2, 0.098]"),
        ("[255, 255, 255]", "divided by 255 it is [1.0, 1.0, 1.0]"),
        ('"#e63319"', "divided by 255 it is [0.902, 0.2, 0.098]"),
        ('"#fff"', "divided by 255 it is [1.0, 1.0, 1.0]"),
        ("[0, 0,8, 5]", "decimals have a point: 0.8, for 0,8 is two numbers"),
    ],
)
def test_a_colour_of_a_picture_program_is_told_as_shares(tmp_path, colour, hint):
    said = said_of(tmp_path, "[0.9, 0.2, 0.1]", colour)
    assert "objects[0].material.diffuse: " in said and hint in said


def test_a_point_with_decimal_commas_is_told_so(tmp_path):
    said = said_of(tmp_path, "[0, 0, 5]", "[0, 0,8, 5]")
    assert "camera.eye: [0, 0, 8, 5] is not three numbers" in said
    assert "0,8 is two numbers" in said


def test_a_misspelt_type_is_named(tmp_path):
    said = said_of(tmp_path, 'type = "sphere"', 'Typ = "sphere"')
    assert 'objects[0].type: missing\n  "Typ" stands there  known: sphere' in said


def test_control_characters_are_shown_and_not_sent_to_the_terminal():
    """An escape sequence could clear the screen, or turn the direction of what follows."""
    said = str(SourceError(Path("a\x1b[2J.toml"), "key\x07", "\x9b31m \u202e is bad", hint="\r"))
    assert said == "a\\x1b[2J.toml: key\\x07: \\x9b31m \\u202e is bad\n  \\r"
