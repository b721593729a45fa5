"""Slots in a lesson's words: how they are read, what they ask, how the answer is written."""

from __future__ import annotations

import json
from math import degrees
from pathlib import Path

import numpy as np
import pytest

from raywalk.errors import SourceErrors
from raywalk.pipeline.figures import filled_here, wanted_pixels
from raywalk.pipeline.filling import Figures, filled, value_of, written
from raywalk.pipeline.lesson_checks import figures_now
from raywalk.scene.measures import Facts, SlotFault
from raywalk.scene.read import read_scene, read_scenes
from raywalk.scene.slots import filled_in, read_slot, slots_in
from raywalk.scene.translation import Spoken, read_spoken
from raywalk.trace.lesson_figures import FIGURES, write_figures
from raywalk.trace.pixel_tree import pixel_tree
from raywalk.words import read_words
from raywalk.work.store import Store

SCENES = Path(__file__).parents[2] / "scenes"
HALL = """
version = 1
title = "Hall"
teaches = "Something."
goals = ["Know that {camera-rays} rays are traced.", "Know the {camera-rays.15} of a grid."]
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[render]
size = 105
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "glass"
[[objects]]
name = "wall"
type = "plane"
point = [0, 0, -3]
normal = [0, 0, 1]
material = "white"
[[lights]]
name = "left lamp"
position = [-2, 0, 3]
[[lights]]
name = "right lamp"
position = [2, 0, 3]
[[lesson]]
headline = "{t} units"
text = "TEXT"
view = { resolution = 15, pixel = [7, 7] }
"""
GERMAN = """
title = "Halle"
teaches = "Etwas."
goals = ["{camera-rays} Strahlen kennen.", "Die {camera-rays.15} eines Gitters kennen."]
[names]
ball = "Kugel"
wall = "Wand"
"left lamp" = "linke Lampe"
"right lamp" = "rechte Lampe"
glass = "Glas"
white = "Weiß"
[[lesson]]
headline = "{t} Einheiten"
text = "TEXT"
"""


def hall(folder: Path, text: str):
    place = folder / "01-hall"
    place.mkdir(exist_ok=True)
    (place / "scene.toml").write_text(HALL.replace("TEXT", text), encoding="utf-8")
    return read_scene(place)


def said(folder: Path, text: str) -> str:
    return filled_here(Store(folder / "work"), hall(folder, text)).lesson[0].text


@pytest.mark.parametrize(
    ("slot", "words"),
    [
        ("{t}", "4.00"),
        ("{t : 0}", "4"),
        ("{t.refracted : 1}", "2.0"),  # through the ball
        ("{angle}", "0.0"),
        ("{weight.reflected}", "4.2\u202f%"),  # Fresnel, head-on: ((n - 1) / (n + 1))^2
        ("{weight.reflected : 2%}", "4.22\u202f%"),
        ("{weight.reflected : 4}", "0.0422"),
        ("{share.refracted.refracted / weight.refracted : 3}", "0.958"),
        ("{weight.refracted * weight.refracted : 3}", "0.917"),
        ("{1 / weight.reflected : 1}", "23.7"),
        ("{n.l.refracted.refracted.left lamp : 3}", "0.949"),  # 6 / sqrt(4 + 36)
        ("{n.l.refracted.refracted.light2 : 3}", "0.949"),
        ("{angle.refracted.refracted.right lamp}", "18.4"),
        ("{point.x}, {point.z}", "0.00, 1.00"),
        ("{normal.z : 0}", "1"),
        ("{direction.z : 0}", "\u22121"),
        ("{t at 0,0}", "9.12"),  # 8 sqrt(1 + 2 (14 / 15 tan 22.5)^2): it misses the ball
        ("{t at 0,0 of 5}", "8.83"),
        ("{ior.glass}", "1.517"),
        ("{critical.glass}", "41.2"),
        ("{head-on.glass}", "4.2\u202f%"),
        ("{kd.white.red : %}", "100\u202f%"),
        ("{camera-rays}", "11\u202f025"),
        ("{camera-rays.15 * ior.glass : 2}", "341.28"),
        ("{bouncing.0 : 0%}", "100\u202f%"),
        ("{crossing.1} and {crossing.2}", "4.00 and 6.00"),
        ("{\n t\n}", "4.00"),
        (r"\\{t} and `{t}` and {1, 2} and $x_{t}$", r"\{t} and `{t}` and {1, 2} and $x_{t}$"),
    ],
)
def test_a_slot_becomes_the_figure_it_asks_for(slot: str, words: str, tmp_path: Path) -> None:
    """Worked out by hand for a ball of glass that the ray meets head-on."""
    assert said(tmp_path, slot.replace("\n", "\\n")) == words


@pytest.mark.parametrize(
    ("slot", "words"),
    [
        ("{t.reflected.refracted}", ["sends no refracted ray on", "it sends on: none"]),
        ("{t.total}", ["of pixel 7,7 of 15 sends no total ray on", "reflected, refracted"]),
        ("{angle.middle lamp}", ['no light "middle lamp"', "known: left lamp, right lamp"]),
        ("{n.l.refracted.refracted}", ["of which light?", "left lamp"]),
        ("{diffuse.left lamp}", ['"ball" has no own colour']),
        ("{departure}", ["starts at the eye"]),
        ("{triangles.ball}", ['no mesh "ball"', "the scene has none"]),
        ("{ior.white}", ["lets no light through"]),
        ("{kd.wite.red}", ['no material "wite"', 'did you mean "white"?']),
        ("{crossing.9}", ["no surface number 9", "allowed: 1 to"]),
    ],
)
def test_what_only_rays_tell_is_named_with_file_step_and_slot(
    slot: str, words: list[str], tmp_path: Path
) -> None:
    with pytest.raises(SourceErrors) as raised:
        said(tmp_path, f"It is {slot}.")
    message = str(raised.value)
    assert f"01-hall/scene.toml: lesson[0].text: {slot}: " in message
    for each in words:
        assert each in message


FAR = HALL.replace("[0, 0, 5]", "[0, 0, 6]").replace("size = 105", "size = 315")


@pytest.mark.parametrize(
    ("slot", "words"),
    [
        ("{t in 02-far}", "5.00"),
        ("{t at 0,0 in 02-far}", "10.26"),  # 9 sqrt(1 + 2 (14 / 15 tan 22.5)^2)
        ("{t at 2,2 of 5 in 02-far : 1}", "5.0"),
        ("{t in 02-far / t : 2}", "1.25"),
        ("{lights.refracted.refracted in 02-far}", "2"),
        ("{ior.glass in 02-far}", "1.517"),
    ],
)  # fmt: skip
def test_a_slot_may_ask_another_scene(slot: str, words: str, tmp_path: Path) -> None:
    """Of the same pixel unless it names one; only scenes beside its own."""
    beside(tmp_path)
    assert said(tmp_path, slot) == words


@pytest.mark.parametrize(
    ("slot", "words"),
    [
        ("{t in 03-none}", ['there is no scene "03-none" beside this one']),
        ("{t at 0,15 in 02-far}", ["pixel 0,15 is outside the grid"]),
        ("{t at 0,0 of 17 in 02-far}", ["17 is not one of the scene's resolutions"]),
        ("{bouncing.1 in 02-far}", ["counted for the lesson's own scene only"]),
        ("{lights in 02-far}", ['"ball" has no own colour']),
        ("{angle.ball in 02-far}", ['no light "ball"', "left lamp"]),
    ],
)
def test_what_another_scene_has_not_is_named(slot: str, words: list[str], tmp_path: Path) -> None:
    beside(tmp_path)
    with pytest.raises(SourceErrors) as raised:
        said(tmp_path, slot)
    for each in words:
        assert each in str(raised.value)


def beside(folder: Path) -> None:
    """A second hall, whose camera stands a unit farther away."""
    (folder / "02-far").mkdir()
    (folder / "02-far" / "scene.toml").write_text(FAR.replace("TEXT", "x"), encoding="utf-8")


def test_all_slots_that_are_wrong_are_named_at_once(tmp_path: Path) -> None:
    with pytest.raises(SourceErrors) as raised:
        said(tmp_path, "{t.total} {departure}")
    assert len(raised.value.errors) == 2


def test_each_language_writes_numbers_its_own_way(tmp_path: Path) -> None:
    """Slots name what scene.toml names, whatever the translation calls it."""
    scene = hall(tmp_path, "{t}")
    slot = "{n.l.refracted.refracted.left lamp}"
    (scene.path.parent / "lesson.de.toml").write_text(GERMAN.replace("TEXT", slot), "utf-8")
    [spoken] = read_spoken([scene], "de")
    write_figures(scene, wanted_pixels([scene, spoken.scene])[0], tmp_path)
    figures = figures_in(tmp_path)
    [told] = filled({"en": [Spoken(scene, True)], "de": [spoken]}, [figures])["de"]
    assert (told.scene.lesson[0].headline, told.scene.lesson[0].text) == ("4,00 Einheiten", "0,949")
    assert told.scene.goals[0] == f"{read_words('de').numbers.grouped(11025)} Strahlen kennen."


def test_a_scene_without_slots_traces_nothing_for_them(tmp_path: Path) -> None:
    scene = hall(tmp_path, "x")
    plain = [f"{step.text}" for step in scene.lesson]
    assert wanted_pixels([scene]) is not None  # its headline has one
    assert plain == ["x"]
    toml = scene.path.read_text("utf-8")
    for slot in ("{t}", "{camera-rays}", "{camera-rays.15}"):
        toml = toml.replace(slot, "0")
    scene.path.write_text(toml, "utf-8")
    assert wanted_pixels([read_scene(scene.path)]) is None


def figures_in(folder: Path) -> Figures:
    found = json.loads((folder / FIGURES).read_text("utf-8"))
    return Figures({tuple(at): ray for at, ray in found["pixels"]}, Facts(found["meshes"], None))


@pytest.fixture(scope="module", params=[path.name for path in sorted(SCENES.glob("[0-9]*"))])
def lesson(request):
    """One of our scenes and the figures of its lesson."""
    scene = read_scene(SCENES / request.param)
    return scene, figures_now(scene, [scene])


def test_figures_are_what_raywalk_pixel_prints(lesson) -> None:
    """To the last digit, ray by ray, of the picture's pixel at the tile's centre; and of the
    grid's own pixel but for a few roundings in its direction."""
    scene, figures = lesson
    for (n, column, row), ray in figures.trees.items():
        k = scene.render.size // n
        size, at = scene.render.size, [place * k + k // 2 for place in (column, row)]
        _same(ray, pixel_tree(scene, size, size, *at)["tree"], 0.0)
        _same(ray, pixel_tree(scene, n, n, column, row)["tree"], 1e-9)


def _same(one, other, bound) -> None:
    assert (one["kind"], one["object"]) == (other["kind"], other["object"])
    for key in ("t", "point", "normal", "direction", "weight", "local_weight"):
        if one[key] is not None:
            np.testing.assert_allclose(one[key], other[key], rtol=bound, atol=bound)
    others = {child["kind"]: child for child in other["children"]}
    for child in one["children"]:  # without those that are too faint to be followed
        _same(child, others[child["kind"]], bound)


def test_every_figure_of_our_lessons_is_a_slot_that_is_filled(lesson) -> None:
    """In full precision it is what its own formula gives; here of angles and their cosines."""
    scene, figures = lesson
    numbers = read_words().numbers
    for step in scene.lesson:
        for text, view in step.said().values():
            own = (view["resolution"], *view["pixel"])
            for _, slot in slots_in(text):
                assert not isinstance(slot, SlotFault)
                if "bouncing" in slot.typed:
                    continue  # asks the whole picture
                value = value_of(slot, scene, figures, own)
                assert np.isfinite(value)
                assert written(slot, scene, figures, own, numbers)
                if slot.typed.startswith("angle.light 1"):
                    cosine = value_of(read_slot("n.l.light 1"), scene, figures, own)
                    assert value == pytest.approx(degrees(np.arccos(cosine)), abs=1e-9)


def test_slots_are_all_filled_or_left_alone() -> None:
    text = r"{t} of \{t} and `{t}`, {1; 2}, $\frac{a}{b}$ and {t : 1}"
    assert filled_in(text, lambda slot: "#") == r"# of \{t} and `{t}`, {1; 2}, $\frac{a}{b}$ and #"


def test_our_lessons_have_headlines_and_goals_in_every_language() -> None:
    """At most 8 words a headline, 2 to 4 goals: slides are made of them."""
    scenes = read_scenes(SCENES)
    for all_scenes in (scenes, [each.scene for each in read_spoken(scenes, "de")]):
        for scene in all_scenes:
            assert 2 <= len(scene.goals) <= 4
            assert all(step.headline for step in scene.lesson)
