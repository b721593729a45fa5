"""`raywalk check` on a lesson's words: figures typed by hand, rounded figures that contradict one
another, names of what a step does not show. Warnings: a course with them still builds."""

from __future__ import annotations

from pathlib import Path

import pytest

from raywalk.__main__ import main
from raywalk.pipeline.agreeing_figures import disagreements
from raywalk.pipeline.filling import Figures
from raywalk.pipeline.lesson_checks import lesson_warnings
from raywalk.pipeline.shown_names import unseen
from raywalk.pipeline.typed_figures import typed_figures
from raywalk.scene.measures import Facts
from raywalk.scene.read import read_scene, read_scenes
from raywalk.scene.translation import Spoken, read_spoken
from raywalk.trace.pixel_tree import pixel_tree
from raywalk.trace.wavefront import Tracer
from raywalk.words import read_words

SCENES = Path(__file__).parents[2] / "scenes"
HALL = """
version = 1
title = "Hall"
teaches = "Something."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[render]
depth = 3
[[objects]]
name = "red ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "white"
[[objects]]
name = "blue ball"
type = "sphere"
center = [0, 0, 9]
radius = 1
material = "white"
[[lights]]
name = "lamp 1"
position = [3, 3, 3]
[[lights]]
name = "far lamp"
position = [0, 0, 30]
[[lesson]]
text = "TEXT"
view = { resolution = 15, pixel = [7, 7], rays = [], observer = "camera" }
"""


def hall(folder: Path, text: str = "Look."):
    folder.mkdir(exist_ok=True)
    (folder / "scene.toml").write_text(HALL.replace("TEXT", text), encoding="utf-8")
    return read_scene(folder)


@pytest.mark.parametrize(
    ("text", "typed"),
    [
        ("It has 14,696 triangles.", ["14,696"]),
        ("It has 14\u202f696 of them, or 5.9 %.", ["14\u202f696", "5.9"]),
        ("At 49.6 degrees, and **30.2** inside.", ["49.6", "30.2"]),
        ("Scanned in 1994, shown in 2026.", []),
        ("On a grid of 15 × 15 or 33 x 33 tiles.", []),
        ("Of 15 tiles the one at 7, 7 has 3 bounces left.", []),  # what the view and scene set
        ("lamp 1 is not lamp 2.", ["2"]),
        ("As in scene 2 and Scene 5, step 3.", []),
        ("Two balls and ten rays.", []),
        ("It runs {t} units: $x = 4.5$ and `3.2`.", []),
        ("A point at {1.5} is moved.", []),
        ("[Here](https://a.example/42) it is.", []),
    ],
)
def test_figures_that_were_typed_are_found(text: str, typed: list[str], tmp_path: Path) -> None:
    scene = hall(tmp_path)
    assert typed_figures(text, [scene.lesson[0].view], scene, read_words()) == typed


def test_in_german_decimals_have_a_comma(tmp_path: Path) -> None:
    scene = hall(tmp_path)
    words, view = read_words("de"), scene.lesson[0].view
    text = "Unter 49,6 Grad, in Szene 2, Schritt 3, mit 3 Spiegelungen."
    assert typed_figures(text, [view], scene, words) == ["49,6"]


@pytest.fixture(scope="module")
def glass():
    """Scene 8's ray through the big ball: 49.63 degrees outside, 30.15 inside, 94.06 % go in."""
    scene = read_scene(SCENES / "08-glass")
    return scene, Figures({(15, 8, 11): pixel_tree(scene, 15, 15, 8, 11)["tree"]}, Facts({}, None))


INTO, OUT = "weight.refracted", "weight.refracted.refracted"
BOTH = "share.refracted.refracted"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        # Once in print: 49.6 and 30.2 give 1.514, and 0.941 x 0.941 is 0.885, not 0.88.
        ("{angle : 1} and {angle.refracted : 1}: {sine / sine.refracted : 3}", "it is 1.514"),
        ("{angle : 2} and {angle.refracted : 2}: {sine / sine.refracted : 3}", ""),
        ("{angle : 1} and {angle.refracted : 1}: about {sine / sine.refracted : 3}", ""),
        (f"{{{INTO} : 3}}, {{{OUT} : 3}}: {{{BOTH} : 4}}", "it is 0.8855"),
        (f"{{{INTO} : 4}}, {{{OUT} : 4}}: {{{BOTH} : 3}}", ""),
        ("{weight.reflected} and {weight.refracted}", ""),
        ("0.941 times 0.941 is 0.88", "it is 0.89"),
        ("0.941 × 0.941 = 0.885", ""),
        ("50 % + 20 % = 80 %", "it is 0.70"),
        ("7 − 2 = 5 and 7 / 2 = 3.5", ""),
    ],
)  # fmt: skip
def test_rounded_figures_must_agree_when_they_are_recomputed(text: str, said: str, glass) -> None:
    scene, figures = glass
    found = disagreements(text, scene, figures, (15, 8, 11), read_words().numbers)
    assert (len(found) == 1 and said in found[0]) if said else found == []


TURNED = {"observer": {"eye": [0, 0, 5], "target": [0, 0, 20]}}
AWAY = {"observer": {"eye": [0, 0, 5], "target": [5, 9, 5]}, "resolution": 15, "pixel": [7, 7]}


@pytest.mark.parametrize(
    ("text", "view", "missing"),
    [
        ("The red ball.", {"observer": "camera"}, []),
        ("The blue ball.", {"observer": "camera"}, ["blue ball"]),  # behind the camera
        ("The blue ball.", {"observer": "start"}, []),
        ("The blue balls.", TURNED, []),
        ("The red ball.", TURNED, ["red ball"]),
        ("The red ball.", AWAY, ["red ball"]),
        ("The red ball.", AWAY | {"rays": ["pixel"]}, []),  # the ray shown meets it
        ("The red ball.", AWAY | {"highlight": ["red ball"]}, []),
        ("The far lamp.", {"observer": "camera"}, ["far lamp"]),
        ("The far lamp.", AWAY | {"rays": ["pixel"]}, []),  # its hit asks it
        ("The far lamp and lamp 1.", TURNED, ["lamp 1"]),
        ("Nothing.", TURNED, []),
    ],
)
def test_what_a_step_names_it_shows(
    text: str, view: dict, missing: list[str], tmp_path: Path
) -> None:
    scene = hall(tmp_path)
    found = unseen(text, view, scene, Tracer(scene), "en")
    assert [said.split('"')[1] for said in found] == missing


def test_boxes_are_drawn_where_they_are_spoken_of() -> None:
    scene = read_scene(SCENES / "06-bunny-far")
    tracer, view = Tracer(scene), dict(scene.lesson[0].view)
    assert unseen("Boxes in boxes.", view, scene, tracer, "en")
    assert unseen("Quader in Quadern.", view, scene, tracer, "de")
    for shown in ({"boxes": True}, {"colours": "tests"}, {"works": "tree"}):
        assert not unseen("Boxes in boxes.", view | shown, scene, tracer, "en")


def test_a_warning_names_file_step_and_words(tmp_path: Path) -> None:
    scene = hall(tmp_path / "01-hall", "The blue ball is at 9 units.")
    said = lesson_warnings(Tracer(scene), {"en": Spoken(scene, True)})
    assert [line.split("01-hall/")[1] for line in said] == [
        'scene.toml: lesson[0].text: warning: the figure "9" is typed: a slot, {t} say, stays '
        "right when the scene changes",
        'scene.toml: lesson[0].text: warning: "blue ball" is named, but neither met by the rays '
        "shown nor seen",
    ]


def test_warnings_do_not_stop_a_check(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = hall(tmp_path / "01-hall", "It is at 9 units.")
    assert main(["check", str(scene.path)]) == 0
    assert "is typed" in capsys.readouterr().out


@pytest.mark.parametrize("id", [scene.id for scene in read_scenes(SCENES)])
def test_our_lessons_have_none(id: str) -> None:
    """In every language: no figure is typed, none contradicts another, what is named is shown."""
    scene = read_scene(SCENES / id)
    spoken = {"en": Spoken(scene, True), "de": read_spoken([scene], "de")[0]}
    assert lesson_warnings(Tracer(scene), spoken) == []
