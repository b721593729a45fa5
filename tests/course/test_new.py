"""A course of one's own begins by `raywalk new`, and is in order from its first line on."""

from __future__ import annotations

from pathlib import Path

import pytest

from raywalk.__main__ import main
from raywalk.home import HOME
from raywalk.scene.read import read_scene, read_scenes

OURS = sorted(path.parent.name for path in HOME.glob("scenes/*/scene.toml"))
OBJ = """mtllib colours/pot.mtl
o pot
v 0 0 0
v 200 0 0
v 0 200 0
v 0 0 200
usemtl red
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""


@pytest.fixture
def course(tmp_path, monkeypatch, capsys) -> Path:
    """A new one, in whose folder commands run."""
    monkeypatch.chdir(tmp_path)
    assert main(["new", "my-course"]) == 0
    assert "cd my-course" in capsys.readouterr().out
    monkeypatch.chdir(tmp_path / "my-course")
    return tmp_path / "my-course"


def test_a_new_course_has_one_scene_that_is_in_order(course):
    """It has what it teaches: a step, a question, a material, a slider."""
    [scene] = read_scenes("scenes")
    assert scene.lesson and any(step.choices for step in scene.lesson)
    assert scene.materials and scene.sweeps and scene.objects and scene.lights


def test_what_its_question_says_is_what_the_tracer_finds(course, capsys):
    """Its choices are of the pixel that the step shows."""
    [scene] = read_scenes("scenes")
    [asked] = [step for step in scene.lesson if step.choices]
    [right] = [choice for choice in asked.choices if choice.right]
    column, row = asked.view["pixel"]
    size = str(asked.view["resolution"])
    assert main(["pixel", scene.id, "--size", size, "--at", f"{column},{row}"]) == 0
    assert "camera ray hits floor" in (said := capsys.readouterr().out)
    assert "blocked by ball" in said and "the ball is in the way" in right.text


def test_every_line_of_it_that_sets_something_is_told_or_speaks_for_itself(course):
    """A comment for each table."""
    text = (course / "scenes/01-my-first-scene/scene.toml").read_text(encoding="utf-8")
    blocks = [block for block in text.split("\n\n") if block.lstrip().startswith(("#", "["))]
    for head in ("[camera]", "[materials.red]", "[[objects]]", "[[lesson]]", "[[sweeps]]"):
        first = next(block for block in blocks if head in block)
        assert "#" in first, head


def test_its_editor_and_its_author_find_every_key_beside_the_scenes(course):
    """As in the checkout: the first line of a scene leads to the schema."""
    for name in ("README.md", "scene.schema.json", "lesson.schema.json"):
        ours = HOME / "scenes" / name
        assert (course / "scenes" / name).read_bytes() == ours.read_bytes()


def test_a_folder_that_holds_something_is_left_alone(course, capsys):
    before = sorted(path for path in course.rglob("*"))
    assert main(["new", str(course)]) == 1
    assert "is not empty" in capsys.readouterr().err
    assert sorted(path for path in course.rglob("*")) == before


def test_scenes_are_numbered_on_and_their_keys_are_free(course):
    assert main(["new", "scene", "lamps"]) == 0
    assert main(["new", "scene", "07-glass"]) == 0
    assert main(["new", "scene", "more"]) == 0
    scenes = read_scenes("scenes")  # refuses two of one key
    assert [each.id for each in scenes] == ["01-my-first-scene", "02-lamps", "07-glass", "08-more"]
    assert [each.key for each in scenes] == ["1", "2", "3", "4"]


def test_any_scene_of_ours_can_be_taken_over(course):
    """With its words in German and its pictures. One that speaks of another wants that first."""
    waiting = list(OURS)
    for _ in OURS:
        waiting = [name for name in waiting if main(["new", "scene", name, "--from", name])]
    assert not waiting
    assert {each.id for each in read_scenes("scenes")} == {"01-my-first-scene", *OURS}
    for name in OURS:
        ours = {path.name for path in (HOME / "scenes" / name).iterdir()}
        assert {path.name for path in (course / "scenes" / name).iterdir()} == ours


def test_a_scene_that_speaks_of_another_says_which_is_wanted_first(course, capsys):
    assert main(["new", "scene", "large", "--from", "16-soft-shadows-large"]) == 1
    said = capsys.readouterr().err
    assert "raywalk new scene 15-soft-shadows-64 --from 15-soft-shadows-64" in said
    assert not list(course.glob("scenes/*large*"))


def test_a_misspelt_scene_is_told_what_is_there(course, capsys):
    assert main(["new", "scene", "mine", "--from", "02-shadws"]) == 1
    assert 'did you mean "02-shadows"?' in capsys.readouterr().err


def test_a_model_is_copied_with_what_it_names_and_stands_in_the_picture(course, tmp_path, capsys):
    """200 units of a file in millimetres: as it is, it would not be seen."""
    (tmp_path / "colours").mkdir()
    (tmp_path / "colours/pot.mtl").write_text("newmtl red\nKd 1 0 0\n")
    (tmp_path / "pot.obj").write_text(OBJ)
    assert main(["new", "scene", "my-pot", "--model", str(tmp_path / "pot.obj")]) == 0
    scene = read_scene("scenes/02-my-pot")
    assert (scene.title, scene.objects[0].name) == ("My pot", "my-pot")
    assert (course / "scenes/02-my-pot/colours/pot.mtl").is_file()
    capsys.readouterr()
    assert main(["pixel", "02-my-pot", "--size", "15", "--at", "6,8"]) == 0
    assert "camera ray hits my-pot" in capsys.readouterr().out


def test_a_damaged_model_is_refused_and_nothing_is_written(course, tmp_path, capsys):
    (tmp_path / "bad.ply").write_text("ply\nformat ascii 1.0\nelement vertex many\nend_header\n")
    assert main(["new", "scene", "bad", "--model", str(tmp_path / "bad.ply")]) == 1
    assert "bad.ply" in capsys.readouterr().err
    assert not list(course.glob("scenes/*bad*"))


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["new", "one", "two"], "raywalk new COURSE"),
        (["new", "mine", "--from", "02-shadows"], "raywalk new scene NAME"),
        (["new", "scene", "a b"], "no name of a scene"),
        (["new", "scene", "01-my-first-scene"], "is there already"),
        (["new", "scene", "x", "--scenes", "elsewhere"], "raywalk new NAME makes one"),
    ],
)
def test_what_cannot_be_meant_is_refused_with_what_can(course, capsys, words, said):
    assert main(words) == 1
    assert said in capsys.readouterr().err


def test_build_is_another_word_for_site(course, capsys):
    """As a course's author says it."""
    for word in ("site", "build"):
        with pytest.raises(SystemExit):
            main([word, "--help"])
        assert "where the site goes" in capsys.readouterr().out
