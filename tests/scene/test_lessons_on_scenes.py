"""A lesson on a scene that is there: it shares all of it but id, key, chapter, words and steps."""

from pathlib import Path

import numpy as np
import pytest

from raywalk.errors import SourceErrors
from raywalk.pipeline.parts import trace_parts
from raywalk.scene.read import read_scene, read_scenes
from raywalk.scene.translation import read_spoken
from raywalk.work.digests import key_of

SCENES = Path(__file__).parents[2] / "scenes"

SCENE = """\
version = 1
key = "1"
title = "Three"
teaches = "Something."
{more}
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[[lights]]
name = "lamp"
position = [1, 1, 1]
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "white"
"""
LESSON = """\
version = 1
scene = "{of}"
{more}
title = "Again"
teaches = "Something else."
[[lesson]]
text = "Look."
view = {view}
"""


def put_scene(folder, name, more=""):
    (folder / name).mkdir()
    (folder / name / "scene.toml").write_text(SCENE.format(more=more), encoding="utf-8")


def put_lesson(folder, name, of, more="", view="{ resolution = 15 }"):
    (folder / name).mkdir()
    text = LESSON.format(of=of, more=more, view=view)
    (folder / name / "scene.toml").write_text(text, encoding="utf-8")


def messages(folder):
    with pytest.raises(SourceErrors) as caught:
        read_scenes(folder)
    return [(error.key, error.message, error.hint) for error in caught.value.errors]


def test_a_lesson_has_the_scene_s_world_and_words_of_its_own(tmp_path):
    """What is traced is the scene; nothing of it is traced again."""
    put_scene(tmp_path, "a")
    put_lesson(tmp_path, "b", "a")
    own, lesson = read_scenes(tmp_path)
    assert (lesson.id, lesson.key, lesson.title, lesson.traces) == ("b", "", "Again", "a")
    assert lesson.objects is own.objects and lesson.camera is own.camera
    assert lesson.base is own and own.traces == "a"
    assert key_of(trace_parts(lesson.base)) == key_of(trace_parts(own))


def test_a_lesson_alone_finds_its_scene(tmp_path):
    """As `raywalk check`, `pixel` and `slides` read one file."""
    put_scene(tmp_path, "a")
    put_lesson(tmp_path, "b", "a")
    assert read_scene(tmp_path / "b").base.id == "a"


def test_a_lesson_names_a_scene_that_is_there(tmp_path):
    put_scene(tmp_path, "shadows")
    put_lesson(tmp_path, "b", "shadow")
    [(key, message, hint)] = messages(tmp_path)
    assert (key, message) == ("scene", '"shadow": there is no such scene')
    assert hint == 'did you mean "shadows"?'


def test_a_lesson_is_not_on_another_lesson(tmp_path):
    """Then it would be a chain, at whose end nobody looks."""
    put_scene(tmp_path, "a")
    put_lesson(tmp_path, "b", "a")
    put_lesson(tmp_path, "c", "b")
    [(key, message, _)] = messages(tmp_path)
    assert (key, message) == ("scene", '"b": is no scene of its own, but a lesson too')


def test_its_views_show_what_the_scene_has(tmp_path):
    """Grids and lights are that scene's."""
    put_scene(tmp_path, "a")
    put_lesson(tmp_path, "b", "a", view="{ resolution = 16 }")
    put_lesson(tmp_path, "c", "a", view='{ switches = { lights = { "lmp" = 0 } } }')
    assert [key for key, _, _ in messages(tmp_path)] == [
        "lesson[0].view.resolution", "lesson[0].view.switches.lights.lmp",
    ]  # fmt: skip


def test_mistakes_of_the_scene_are_told_once(tmp_path):
    """However many lessons it has."""
    put_scene(tmp_path, "a", "autor = 1")
    put_lesson(tmp_path, "b", "a")
    put_lesson(tmp_path, "c", "a")
    assert [key for key, _, _ in messages(tmp_path)] == ["autor"]


def test_a_lesson_without_steps_is_refused(tmp_path):
    put_scene(tmp_path, "a")
    (tmp_path / "b").mkdir()
    head = LESSON.partition("[[lesson]]")[0].format(of="a", more="")
    (tmp_path / "b" / "scene.toml").write_text(head, encoding="utf-8")
    assert [key for key, _, _ in messages(tmp_path)] == ["lesson"]


def test_chapters_order_the_course(tmp_path):
    """First by chapter, then by folder; what has none comes last."""
    put_scene(tmp_path, "a")
    put_lesson(tmp_path, "b", "a", 'chapter = "pictures"')
    put_lesson(tmp_path, "c", "a", 'chapter = "rays"')
    put_lesson(tmp_path, "d", "a", 'chapter = "rays"')
    assert [scene.id for scene in read_scenes(tmp_path)] == ["c", "d", "b", "a"]


def test_a_chapter_that_there_is_not_is_refused(tmp_path):
    put_scene(tmp_path, "a", 'chapter = "lights"')
    [(key, message, _)] = messages(tmp_path)
    assert key == "chapter" and message.startswith('"lights" is not one of "rays", "light"')


@pytest.mark.parametrize(
    ("before", "order"),
    [
        ({"c": "a"}, "cabd"),
        ({"c": "a", "d": "a"}, "cdab"),  # several before one: by folder
        ({"d": "b", "b": "a"}, "dbac"),  # one before the other
    ],
)
def test_a_scene_can_stand_before_another_of_its_chapter(tmp_path, before, order):
    """Its folder's name, which is its address, stays as it is."""
    for name in "abcd":
        more = f'before = "{before[name]}"' if name in before else ""
        put_scene(tmp_path, name, f'chapter = "light"\n{more}')
        file = tmp_path / name / "scene.toml"
        file.write_text(file.read_text().replace('key = "1"\n', ""))
    assert "".join(scene.id for scene in read_scenes(tmp_path)) == order


def test_a_place_before_nothing_is_refused(tmp_path):
    """A slip, another chapter, a circle: each is told with what can be done."""
    put_scene(tmp_path, "light", 'chapter = "light"')
    put_lesson(tmp_path, "slip", "light", 'chapter = "light"\nbefore = "ligth"')
    put_lesson(tmp_path, "far", "light", 'chapter = "rays"\nbefore = "light"')
    put_lesson(tmp_path, "one", "light", 'chapter = "light"\nbefore = "two"')
    put_lesson(tmp_path, "two", "light", 'chapter = "light"\nbefore = "one"')
    put_lesson(tmp_path, "self", "light", 'chapter = "light"\nbefore = "self"')
    round_trip = "stands, by its own before, behind this one"
    assert messages(tmp_path) == [
        ("before", '"light": is in another chapter, "light"', ""),
        ("before", f'"two": {round_trip}', "leave out one of them"),
        ("before", '"self": this is the scene itself', ""),
        ("before", '"ligth": there is no such scene', 'did you mean "light"?'),
        ("before", f'"one": {round_trip}', "leave out one of them"),
    ]


def test_a_scene_with_mistakes_is_there_all_the_same(tmp_path):
    """Who stands before it is not told that it is missing."""
    put_scene(tmp_path, "a", "autor = 1")
    put_scene(tmp_path, "b", 'before = "a"')
    assert [key for key, _, _ in messages(tmp_path)] == ["autor"]


def test_the_course_begins_with_what_a_ray_is():
    """Scene 1 shades what rays meet: what a ray is comes first."""
    assert [scene.id for scene in read_scenes(SCENES)][:2] == ["11-what-is-a-ray", "01-shading"]


def test_the_ten_scenes_keep_their_order():
    """Chapters put lessons between them, and none of them elsewhere."""
    keys = [scene.key for scene in read_scenes(SCENES) if scene.key]
    assert keys == list("1234567890")


def test_names_are_translated_with_the_scene(tmp_path):
    """They stand once, beside the scene's own lesson."""
    put_scene(tmp_path, "a")
    put_lesson(tmp_path, "b", "a")
    words = 'title = "Drei"\nteaches = "Etwas."\n'
    names = '[names]\nball = "Ball"\nlamp = "Lampe"\n"ball, material" = "x"\n'
    spoken = 'title = "Nochmal"\nteaches = "Etwas."\n[[lesson]]\ntext = "Sieh hin."\n'
    scenes = read_scenes(tmp_path)
    material = scenes[0].materials[0].name
    names = names.replace("ball, material", material)
    (tmp_path / "a" / "lesson.de.toml").write_text(words + names, encoding="utf-8")
    (tmp_path / "b" / "lesson.de.toml").write_text(spoken, encoding="utf-8")
    _, lesson = read_spoken(scenes, "de")
    assert lesson.scene.title == "Nochmal" and lesson.scene.objects[0].name == "Ball"
    (tmp_path / "b" / "lesson.de.toml").write_text(
        spoken.replace("[[lesson]]", '[names]\nball = "Kugel"\n[[lesson]]'), encoding="utf-8"
    )
    with pytest.raises(SourceErrors) as caught:
        read_spoken(scenes, "de")
    assert [error.key for error in caught.value.errors] == ["names"]


@pytest.mark.parametrize(
    "scene", [each for each in read_scenes(SCENES) if each.base], ids=lambda s: s.id
)
def test_each_of_ours_asks_two_questions(scene):
    """A lesson in which nobody has to think is none."""
    assert len([step for step in scene.lesson if step.answer]) >= 2
    assert all(
        np.array_equal(a.transform, b.transform)
        for a, b in zip(scene.objects, scene.base.objects, strict=True)
    )
