"""raywalk slides: what is asked for is written; what cannot be is named before anything is made."""

from __future__ import annotations

import pytest

from raywalk.__main__ import main

SCENE = """
version = 1
title = "Ball"
teaches = "One ball."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[render]
size = 21
resolutions = [7]
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "white"
[[lights]]
position = [1, 2, 3]
[[lesson]]
text = "A first step."
[[lesson]]
text = "A second step."
[[lesson]]
text = "A third one, with {word}."
"""


@pytest.fixture
def slides(tmp_path, capsys):
    """A function that runs the command on a small scene: exit code, what it said, its folder."""

    def run(*arguments: str, word: str = "words", scene: str = "01-ball"):
        place = tmp_path / "scenes" / "01-ball"
        place.mkdir(parents=True, exist_ok=True)
        (place / "scene.toml").write_text(SCENE.replace("{word}", word), encoding="utf-8")
        places = {"--scenes": "scenes", "--out": "out", "--work": "work"}
        folders = [str(x) for key, name in places.items() for x in (key, tmp_path / name)]
        try:
            code = main(["slides", scene, *arguments, *folders])
        except SystemExit as ended:
            code = ended.code
        said = capsys.readouterr()
        return code, said.out + said.err, tmp_path / "out"

    return run


def test_steps_format_aspect_and_palette_are_as_asked(slides):
    """Only the named steps' figures, and nothing else in the folder."""
    code, said, out = slides("--steps", "1,3-3", "--format", "svg,pdf", "--aspect", "4:3",
                             "--palette", "print")  # fmt: skip
    assert code == 0, said
    names = sorted(path.name for path in out.iterdir())
    assert names == ["01-ball-figure-01.svg", "01-ball-figure-02.svg", "01-ball.pdf"]
    assert all(name in said for name in names)


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (("--steps", "4"), 1, "has no step 4"),
        (("--steps", "3-1"), 2, "is no step"),
        (("--steps", "one"), 2, "is no step"),
        (("--format", "pfd"), 2, 'did you mean "pdf"?'),
        (("--aspect", "3:2"), 2, "invalid choice"),
    ],
)
def test_what_cannot_be_done_is_said_and_nothing_is_written(slides, arguments, code, words):
    """Exit code 1 for what the scene lacks, 2 for wrong usage; no traceback, no folder."""
    ended, said, out = slides(*arguments)
    assert ended == code and words in said and "Traceback" not in said
    assert not out.exists()


def test_an_unknown_scene_names_those_there_are(slides):
    code, said, out = slides(scene="01-bal")
    assert code == 1 and 'did you mean "01-ball"?' in said and not out.exists()


def test_letters_the_font_lacks_are_named_with_their_place(slides):
    """In PDF; as HTML the same lesson can be had."""
    code, said, _ = slides("--format", "pdf", word="光")
    assert code == 1
    assert (
        "step 3: " in said and "lesson[2].text" in said and "光 (U+5149)" in said and "html" in said
    )
    code, said, _ = slides("--format", "html", word="光")
    assert code == 0, said
