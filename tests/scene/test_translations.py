"""A scene's words in another language are complete, or every mistake is named."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from raywalk.errors import SourceErrors
from raywalk.scene.read import read_scene, read_scenes
from raywalk.scene.translation import missing_translations, read_spoken
from raywalk.site.scene_data import scene_words
from raywalk.words import languages

SCENES = Path(__file__).parent.parent.parent / "scenes"
OTHERS = [code for code in languages() if code != "en"]
SCENE = """
version = 1
title = "Ball"
teaches = "Something."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "white"
[[lights]]
name = "lamp"
position = [1, 2, 3]
[[lesson]]
text = "Look."
[[lesson]]
text = "What?"
answer = "That."
"""
NAMES = '[names]\nball = "Ball"\nlamp = "Lampe"\nwhite = "Weiß"\n'
FIRST, SECOND = '[[lesson]]\ntext = "Da."\n', '[[lesson]]\ntext = "Was?"\nanswer = "Das."\n'
HEAD = 'title = "Ball"\nteaches = "Etwas."\n'


def spoken(folder: Path, translation: str | None, scene: str = SCENE):
    place = folder / "01-ball"
    place.mkdir()
    (place / "scene.toml").write_text(scene, encoding="utf-8")
    if translation is not None:
        (place / "lesson.de.toml").write_text(translation, encoding="utf-8")
    return read_spoken([read_scene(place)], "de")


@pytest.mark.parametrize("code", OTHERS)
def test_every_scene_is_told_in_every_language(code: str) -> None:
    """Title, lesson, names: nothing is left in English."""
    in_german = read_spoken(read_scenes(SCENES), code)
    assert not missing_translations(in_german, code)
    for own, each in zip(read_scenes(SCENES), in_german, strict=True):
        assert each.scene.teaches != own.teaches
        lamps = {re.sub(r" \d+/\d+$", "", light.name) for light in each.scene.lights}
        for step, said in zip(own.lesson, each.scene.lesson, strict=True):
            assert said.text != step.text and shown(said.view) == shown(step.view)
            assert bool(said.answer) == bool(step.answer)
            switched = said.answer_view.get("switches", {}).get("lights") or {}
            assert set(switched) <= lamps, "a view names the lights as the language does"


def shown(view: dict) -> dict:
    """A view without what it names."""
    return {key: value for key, value in view.items() if key not in ("highlight", "labels")}


def test_what_the_viewer_reads_in_a_language_switches_lights_by_their_names(tmp_path: Path) -> None:
    """Once a German page's step left the light on that its English one puts out."""
    view = 'view = { resolution = 7, switches = { lights = { "lamp" = 0 } } }'
    scene = SCENE.replace('text = "Look."', f'text = "Look."\n{view}')
    [in_german] = spoken(tmp_path, HEAD + NAMES + FIRST + SECOND, scene)
    words = scene_words(in_german.scene)
    assert words["lights"] == ["Lampe"]
    assert words["lesson"][0]["view"]["switches"]["lights"] == {"Lampe": 0}


def test_what_a_view_points_at_is_named_as_the_language_does(tmp_path: Path) -> None:
    """The viewer finds objects and lamps by the names that its page has."""
    view = (
        'view = { highlight = ["ball", "lamp"], labels = { "lamp" = "left", "camera" = "above" } }'
    )
    scene = SCENE.replace('text = "Look."', f'text = "Look."\n{view}')
    [in_german] = spoken(tmp_path, HEAD + NAMES + FIRST + SECOND, scene)
    view_of = scene_words(in_german.scene)["lesson"][0]["view"]
    assert view_of["highlight"] == ["Ball", "Lampe"]
    assert view_of["labels"] == {"Lampe": "left", "camera": "above"}


def test_a_scene_in_another_language_has_its_words_and_keeps_all_else(tmp_path: Path) -> None:
    [each] = spoken(tmp_path, HEAD + NAMES + FIRST + SECOND)
    assert each.is_translated
    scene = each.scene
    assert (scene.title, scene.teaches) == ("Ball", "Etwas.")
    assert (scene.objects[0].name, scene.lights[0].name) == ("Ball", "Lampe")
    assert [(step.text, step.answer) for step in scene.lesson] == [("Da.", ""), ("Was?", "Das.")]
    assert scene.camera.eye == (0, 0, 5)


def test_a_scene_without_a_translation_stays_as_it_is_and_is_named(tmp_path: Path) -> None:
    in_german = spoken(tmp_path, None)
    assert in_german[0].scene.teaches == "Something."
    assert missing_translations(in_german, "de") == [
        "de: 1 of 1 scene not translated (lesson.de.toml is missing), so the words stay as in "
        "scene.toml: 01-ball"
    ]


def test_many_scenes_without_a_translation_are_one_line(tmp_path: Path) -> None:
    """A course in one language is not told so once a scene; who translates sees what is left."""
    for name in ("untold", "told"):
        (tmp_path / name).mkdir()
    [untold] = spoken(tmp_path / "untold", None)
    [told] = spoken(tmp_path / "told", HEAD + NAMES + FIRST + SECOND)
    [line] = missing_translations([told, *[untold] * 30], "de")
    assert line.startswith("de: 30 of 31 scenes not translated")
    assert line.endswith("01-ball and 22 more")


@pytest.mark.parametrize(
    ("translation", "words"),
    [
        (HEAD + NAMES + FIRST, ["lesson[1]: missing: scene.toml has 2 steps, this 1"]),
        (HEAD + NAMES + FIRST + SECOND + FIRST, ["lesson[2]: too many"]),
        (HEAD + NAMES + FIRST + FIRST, ["lesson[1].answer: missing: this step is a question"]),
        (HEAD + NAMES + SECOND + SECOND, ["lesson[0].answer: this step is no question"]),
        (HEAD + FIRST + SECOND, ["names: missing: ball", "lamp", "white"]),
        (HEAD + NAMES + 'bal = "x"\n' + FIRST + SECOND, ["names.bal", 'did you mean "ball"?']),
        (NAMES + FIRST + SECOND, ["title: missing", "teaches: missing"]),
        (HEAD + 'key = "1"\n' + NAMES + FIRST + SECOND, ["key: unknown key", "allowed: title"]),
        (HEAD + NAMES + '[[lesson]]\ntext = ""\n' + SECOND, ["lesson[0].text"]),
        ("title = ", ["not TOML"]),
    ],
)
def test_mistakes_are_named_with_file_and_key(
    tmp_path: Path, translation: str, words: list[str]
) -> None:
    with pytest.raises(SourceErrors) as raised:
        spoken(tmp_path, translation)
    said = str(raised.value)
    assert "01-ball/lesson.de.toml" in said
    for each in words:
        assert each in said
