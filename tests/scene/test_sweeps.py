"""What is wrong with a sweep is said where it stands, all of it at once."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image
from tests.scene.conftest import CAMERA

from raywalk.errors import SourceErrors
from raywalk.pipeline.figures import filled_here
from raywalk.pipeline.filling import filled
from raywalk.pipeline.lesson_checks import figures_now
from raywalk.scene.translation import Spoken
from raywalk.site.scene_data import Display, scene_data
from raywalk.site.stop_data import stop_data
from raywalk.work.store import Store

SCENE = """
[render]
size = 165
resolutions = [15, 33]

[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "coloured"

[[lights]]
position = [-2, 1, 1]
"""
LAMP = """
[[sweeps]]
name = "lamp"
varies = 'lights."light 1".position'
from = [-2, 0, 1]
to = [-2, 2, 1]
stops = 3
"""


def errors_of(scene_from, tables):
    with pytest.raises(SourceErrors) as raised:
        scene_from(SCENE + tables)
    return [f"{each.key}: {each}" for each in raised.value.errors]


def test_steps_between_two_values_are_what_one_reads(scene_from):
    """Without a last digit that nobody wrote; whole numbers stay whole."""
    [sweep] = scene_from(SCENE + LAMP.replace("2, 1]\nstops = 3", "1.5, 1]\nstops = 16")).sweeps
    assert [value[1] for value in sweep.values][:4] == [0, 0.1, 0.2, 0.3]
    assert sweep.own == 10


@pytest.mark.parametrize(
    ("old", "new", "key", "said"),
    [
        ('"light 1"', '"lihgt 1"', "sweeps[0].varies", 'did you mean "light 1"?'),
        ("lights.", "lamps.", "sweeps[0].varies", "background, or one below camera, lights"),
        (".position", ".positon", "sweeps[0].varies", 'did you mean "position"?'),
        (".position", ".intensity", "sweeps[0].varies", "write the scene's own value there"),
        ("to = [-2, 2, 1]", "to = [-2, 2.5, 1]", "sweeps[0]", "is none of its 3 stops"),
        ("to = [-2, 2, 1]", "to = 2", "sweeps[0].to", "is not like [-2, 0, 1]"),
        ("stops = 3", "stops = 1", "sweeps[0].stops", "a whole number from 2 to 64"),
        ("stops = 3", "", "sweeps[0].stops", "missing"),
        ("stops = 3", "stops = 3\nvalues = [1, 2]", "sweeps[0].from", "stands beside values"),
        ("stops = 3", "stops = 3\nresolutions = [7]", "sweeps[0].resolutions", "the scene's"),
        ("to = [-2, 2, 1]", "to = [-2, 0, 1]", "sweeps[0].to", "is there twice"),
        ('name = "lamp"', 'nam = "lamp"', "sweeps[0].nam", 'did you mean "name"?'),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_where_it_stands(scene_from, old, new, key, said):
    found = errors_of(scene_from, LAMP.replace(old, new, 1))
    assert any(each.startswith(f"{key}: ") and said in each for each in found), found


def test_a_stop_that_is_no_scene_is_named_with_what_is_wrong_with_it(scene_from):
    """The camera looks at its own place at the second stop."""
    sweep = '\n[[sweeps]]\nname = "eye"\nvaries = "camera.eye"\nvalues = [[0, 0, 5], [0, 0, 0]]\n'
    found = errors_of(scene_from, sweep)
    assert all(each.startswith("sweeps[0]: ") for each in found)
    assert any("at stop 2, [0, 0, 0]: camera.target" in each for each in found), found


def test_a_lamp_may_have_more_or_fewer_points(scene_from):
    """Together as bright; how many each lamp has at most is told to who draws them."""
    lamp = '\nname = "lamp"\nedges = [[1, 0, 0], [0, 1, 0]]\nsamples = [2, 2]\n'
    other = '\n[[lights]]\nname = "spot"\nposition = [0, 2, 0]\n'
    scene = scene_from(SCENE + lamp + other + sweep_of_points("[[1, 1], [2, 2], [3, 1]]"))
    [sweep] = scene.sweeps
    assert [len(stop.lights) for stop in sweep.stops] == [2, 5, 4]
    assert {sum(each.intensity for each in stop.lights) for stop in sweep.stops} == {2}
    data = scene_data(scene, Display(np.zeros(3), 1.0, {}), {}, {}, "picture.png")
    assert data["sweeps"][0]["points"] == [4, 1]
    [found] = errors_of(scene_from, lamp + sweep_of_points("[[2, 2], [9, 9]]"))
    assert "at stop 2, [9, 9]: lights[0].samples" in found


def test_a_stop_that_goes_deeper_than_the_scene_is_told(scene_from):
    """A link may limit bounces to what only that stop has."""
    sweep = '\n[[sweeps]]\nname = "it"\nvaries = "render.depth"\nvalues = {}\n'
    for values, deepest in (("[0, 1, 6]", 6), ("[0, 1]", None)):
        scene = scene_from(SCENE.replace("[render]", "[render]\ndepth = 1") + sweep.format(values))
        data = scene_data(scene, Display(np.zeros(3), 1.0, {}), {}, {}, "picture.png")
        assert data.get("deepest") == deepest


def sweep_of_points(values):
    return f'\n[[sweeps]]\nname = "points"\nvaries = "lights.lamp.samples"\nvalues = {values}\n'


MORE = """colour = [1, 1, 1]

[materials.matt]
diffuse = [1, 0, 0]

[[objects]]
name = "floor"
type = "plane"
point = [0, -2, 0]
normal = [0, 1, 0]
material = "matt"
"""


def sweep_of(varies, values):
    return f"\n[[sweeps]]\nname = \"it\"\nvaries = '{varies}'\nvalues = {values}\n"


@pytest.mark.parametrize(
    ("varies", "values", "is_anew"),
    [
        ("materials.matt.diffuse", "[[1, 0, 0], [0, 1, 0]]", True),
        ("objects.floor.point", "[[0, -2, 0], [0, -3, 0]]", True),
        ('lights."light 1".colour', "[[1, 1, 1], [1, 0, 0]]", True),
        ('lights."light 1".position.1', "[1, 2]", False),
        ("background", "[[0, 0, 0], [0, 0.2, 0.4]]", False),
    ],
)
def test_colours_and_planes_may_change_and_the_stage_knows_what_it_cannot_move(
    scene_from, varies, values, is_anew
):
    """Tiles would show what the stage does not, otherwise."""
    at_top = "background = [0, 0, 0]\n" + CAMERA
    scene = scene_from(SCENE + MORE + sweep_of(varies, values), at_top)
    data = scene_data(scene, Display(np.zeros(3), 1.0, {}), {}, {}, "picture.png")
    assert data["sweeps"][0].get("anew", False) == is_anew
    [moved] = [stop_data(scene.sweeps[0].stops[1], scene, Display(np.zeros(3), 1.0, {}), "x.webp")]
    assert len(moved) == 2, "its picture, and what is other"


@pytest.mark.parametrize(
    ("varies", "said"),
    [
        ("background", 'the file gives no "background"'),
        ("materials.matt.like", 'the file gives no "like"'),
        ("materials.matt.shininess", "write the scene's own value there"),
    ],
)
def test_a_colour_that_cannot_vary_is_told_how_it_could(scene_from, varies, said):
    [found] = errors_of(scene_from, MORE + sweep_of(varies, "[[0, 0, 0], [1, 1, 1]]"))
    assert found.startswith("sweeps[0].varies: ") and said in found


def test_a_texture_is_drawn_once_and_so_no_sweep_changes_it(scene_from, tmp_path):
    """The stage has its picture from a file: tiles would show what it does not."""
    Image.new("RGB", (2, 2)).save(tmp_path / "wood.png")
    texture = '{ file = "wood.png", repeat = [2, 2] }'
    wood = MORE.replace('"matt"', f'{{ like = "matt", texture = {texture} }}')
    for varies, values in (
        ("objects.floor.material.texture.repeat", "[[2, 2], [3, 3]]"),
        ("objects.floor.point", "[[0, -2, 0], [0, -3, 0]]"),
    ):
        [found] = errors_of(scene_from, wood + sweep_of(varies, values))
        assert 'sweeps[0].varies: changes "floor", at stop 2: its' in found
        assert "an object without a texture" in found
    assert scene_from(SCENE + wood + sweep_of("objects.ball.center.0", "[0, 1]")).sweeps


def test_a_step_shows_a_stop_that_there_is(scene_from):
    """By its sweep's name and from 1."""
    step = '\n[[lesson]]\ntext = "Low."\nview = {{ sweep = {{ "{}" = {} }} }}\n'
    scene = scene_from(SCENE + LAMP + step.format("lamp", 1))
    assert scene.lesson[0].view["sweep"] == "lamp:1"
    assert scene.at_stop("lamp:1").lights[0].position == (-2.0, 0.0, 1.0)
    [found] = errors_of(scene_from, LAMP + step.format("lamp", 4))
    assert "4 is beyond its last stop" in found
    [found] = errors_of(scene_from, LAMP + step.format("lmap", 1))
    assert 'did you mean "lamp"?' in found


GRID = """
[[sweeps]]
name = "place"
varies = "objects.ball.center.0"
values = [-1, 0, 1]
across = { name = "depth", varies = "objects.ball.center.2", from = 0, to = 1, stops = 2 }
"""


def test_a_step_at_a_stop_shows_a_grid_that_the_stop_has(scene_from):
    """The scene has rays of 15, the sweep has none: the figure would have been of nothing."""
    lamp = LAMP + "resolutions = [33]\n"
    step = '[[lesson]]\ntext = "Look."\nview = {{ resolution = {n}, sweep = {{ "lamp" = 1 }} }}\n'
    [error] = errors_of(scene_from, lamp + step.format(n=15))
    assert 'lesson[0].view.resolution: stops of "lamp" have no rays of 15' in error
    assert "known: 33" in error
    assert scene_from(SCENE + lamp + step.format(n=33)).lesson[0].view["resolution"] == 33


STEP = """
[[lesson]]
text = "{angle.light 1 : 5} {lit} {discriminant.ball : 4} {1.5}"
view = { resolution = 15, pixel = [8, 6], sweep = { lamp = 1 } }
answer = "{angle.light 1 : 5} {t at 6,6 : 4}"
answer_view = { sweep = { lamp = 3 } }
"""


def told(scene, tmp_path):
    """Text and answer of its last step with their figures, as a build has them."""
    step = filled_here(Store(tmp_path / "work"), scene).lesson[-1]
    figures = figures_now(scene, [scene])  # as `check` has them
    checked = filled({"en": [Spoken(scene, True)]}, [figures])["en"][0].scene.lesson[-1]
    assert (step.text, step.answer) == (checked.text, checked.answer)
    return step.text, step.answer


def test_a_figure_of_a_step_at_a_stop_is_of_that_stop(scene_from, tmp_path):
    """What the scene would say whose file had the value: the text at one stop, its answer at
    another; in a step without a stop it is of the scene as it is."""
    at_stops = told(scene_from(SCENE + LAMP + STEP), tmp_path)
    without = STEP.replace(", sweep = { lamp = 1 }", "").replace("sweep = { lamp = 3 }", "")
    alone = {}
    for height in (0, 1, 2):
        there = SCENE.replace("position = [-2, 1, 1]", f"position = [-2, {height}, 1]")
        alone[height] = told(scene_from(there + without), tmp_path)
    assert at_stops == (alone[0][0], alone[2][1])
    assert len({text for text, _ in alone.values()}) == 3
    own = told(scene_from(SCENE + LAMP + without), tmp_path)
    assert own == alone[1]


def test_what_is_counted_over_the_whole_picture_is_asked_at_no_stop(scene_from):
    """A stop has no such picture."""
    step = '[[lesson]]\ntext = "So far: {said}."\nview = {{ sweep = {{ "lamp" = 1 }} }}\n'
    [error] = errors_of(scene_from, LAMP + step.format(said="{bouncing.1}"))
    assert "lesson[0].text: {bouncing.1}: bouncing is counted over the scene's own" in error
    [error] = errors_of(scene_from, LAMP + step.format(said="{t}"))
    assert "of which pixel?" in error
    for own in ("{0.5}", "{ior.glass in 08-glass}"):
        assert scene_from(SCENE + LAMP + step.format(said=own)).lesson


def test_a_grids_stops_are_numbered_in_rows(scene_from):
    """Stop (row - 1) * columns + column, from 1, has both values; `own` counts all of them."""
    [sweep] = scene_from(SCENE + GRID).sweeps
    centres = [[*each.objects[0].shape.center] for each in sweep.stops]
    assert centres == [[-1, 0, 0], [0, 0, 0], [1, 0, 0], [-1, 0, 1], [0, 0, 1], [1, 0, 1]]
    assert (sweep.own, sweep.values, sweep.across.values) == (1, (-1, 0, 1), (0, 1))
    assert sweep.shape == (3, 2)


@pytest.mark.parametrize(
    ("old", "new", "key", "said"),
    [
        ("center.2", "center.0", "sweeps[0].across.varies", '"objects.ball.center.0" already'),
        ("center.2", "center", "sweeps[0].across", "is none of its 2 stops"),
        ('center.2", from = 0, to = 1', 'center", from = [0, 0, 0], to = [1, 0, 0]',
         "sweeps[0].across.varies", "leaves as it is"),
        ("from = 0", "from = 0.5", "sweeps[0].across", "the scene's own value, 0, is none"),
        ("stops = 2", "stops = 22", "sweeps[0].across", "3 values with 22 each are 66 stops"),
        ("stops = 2", "stps = 2", "sweeps[0].across.stps", 'did you mean "stops"?'),
        ("center.2", "centre.2", "sweeps[0].across.varies", 'did you mean "center"?'),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_grid_is_said_where_it_stands(scene_from, old, new, key, said):
    found = errors_of(scene_from, GRID.replace(old, new, 1))
    assert any(each.startswith(f"{key}: ") and said in each for each in found), found


def test_a_grid_has_at_most_64_stops(scene_from):
    """8 x 8 are; 25 and 36 are well below."""
    eight = GRID.replace("[-1, 0, 1]", "[-3, -2, -1, 0, 1, 2, 3, 4]").replace(
        "stops = 2", "stops = 8"
    )
    [sweep] = scene_from(SCENE + eight).sweeps
    assert len(sweep.stops) == 64


def test_a_step_shows_a_grids_stop_by_its_number_or_by_column_and_row(scene_from):
    step = '\n[[lesson]]\ntext = "There."\nview = {{ sweep = {{ place = {} }} }}\n'
    for stop in ("6", "[3, 2]"):
        scene = scene_from(SCENE + GRID + step.format(stop))
        assert scene.lesson[0].view["sweep"] == "place:6"
    for stop, said in {
        "7": "allowed: 1 to 6", "[4, 1]": "columns 1 to 3, rows 1 to 2",
        "[1, 3]": "columns 1 to 3, rows 1 to 2", "[0, 1]": "[column, row]",
    }.items():  # fmt: skip
        [found] = errors_of(scene_from, GRID + step.format(stop))
        assert said in found, found
    step = '\n[[lesson]]\ntext = "There."\nview = { sweep = { lamp = [1, 1] } }\n'
    [found] = errors_of(scene_from, LAMP + step)
    assert "it has no rows: write the stop's number, 1 to 3" in found


ROUND = """
[[sweeps]]
name = "round the ball"
varies = "camera.eye"
about = [0, 0, 0]
from = -90
to = 90
stops = 3
"""


def test_a_place_goes_round_a_point_by_degrees(scene_from):
    """Right-handed about the upright axis: from in front, 90 degrees lead to the right, as seen by
    the camera. The scene's own place is 0, to the last digit."""
    [sweep] = scene_from(SCENE + ROUND).sweeps
    eyes = [each.camera.eye for each in sweep.stops]
    assert (sweep.values, sweep.own, sweep.is_turned) == ((-90, 0, 90), 1, True)
    assert eyes == [(-5, 0, 0), (0, 0, 5), (5, 0, 0)]
    lamp = ROUND.replace('"camera.eye"', "'lights.\"light 1\".position'") + 'axis = "z"\n'
    [sweep] = scene_from(SCENE + lamp).sweeps
    assert [each.lights[0].position for each in sweep.stops] == [(1, 2, 1), (-2, 1, 1), (-1, -2, 1)]


@pytest.mark.parametrize(
    ("old", "new", "key", "said"),
    [
        ("from = -90", "from = 10", "sweeps[0]", "the scene's own value, 0, is none"),
        ("from = -90", "from = [0, 0, 5]", "sweeps[0].from", "is not in degrees"),
        ("camera.eye", "objects.ball.radius", "sweeps[0].about", "is no place: 1"),
        ("about = [0, 0, 0]", 'axis = "y"', "sweeps[0].axis", "give about"),
        ("about = [0, 0, 0]", "about = [0, 0]", "sweeps[0].about", "three numbers"),
        ('"camera.eye"\nabout = [0, 0, 0]', '"camera.eye"\nabout = [0, 0, 5]', "sweeps[0].about",
         "is the place itself"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_a_circle_is_said_where_it_stands(scene_from, old, new, key, said):
    found = errors_of(scene_from, ROUND.replace(old, new, 1))
    assert any(each.startswith(f"{key}: ") and said in each for each in found), found


def test_a_lamp_grows_about_its_middle(scene_from):
    """Its points stay as many and as bright together; that is what the page's stage can follow."""
    lamp = '\nname = "lamp"\nedges = [[2, 0, 0], [0, 1, 0]]\nsamples = [2, 1]\nsize = 1\n'
    sweep = '\n[[sweeps]]\nname = "lamp"\nvaries = "lights.lamp.size"\nvalues = [0.5, 1, 2]\n'
    [sweep] = scene_from(SCENE + lamp + sweep).sweeps
    places = [[each.position[0] for each in stop.lights] for stop in sweep.stops]
    assert places == [[-1.25, -0.75], [-1.5, -0.5], [-2, 0]]
    assert {stop.lights[0].position[1:] for stop in sweep.stops} == {(1.5, 1.0)}
    assert {stop.lights[0].intensity for stop in sweep.stops} == {0.5}
    [found] = errors_of(scene_from, "size = 2\n")
    assert "only an area light has a size" in found


def test_two_sweeps_have_two_addresses(scene_from):
    """Two names that differ in spaces only have one."""
    found = errors_of(
        scene_from, LAMP + LAMP.replace('"lamp"', '"la mp"') + LAMP.replace('"lamp"', '"la-mp"')
    )
    assert any("has the address" in each for each in found), found


def test_no_sweep_takes_the_folder_of_a_lessons_pictures(scene_from):
    """Both stand in the scene's folder of the site."""
    [found] = errors_of(scene_from, LAMP.replace('"lamp"', '"Pictures"'))
    assert found.startswith("sweeps[0].name: ") and "a lesson's pictures" in found
