"""What the speed parts of the bench measure; how long things take is not asserted here."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from tests.cases import cases

from raywalk.bench import check_work, look, speed
from raywalk.bench.bench import TIMES, time_bounds
from raywalk.bench.made_scenes import icosphere, write_ply
from raywalk.bench.picture_error import pictures
from raywalk.bench.speed_many import write_scenes
from raywalk.bench.speed_primitives import primitive_cases
from raywalk.bench.speed_rebuild import rebuild_cases, turned, with_red, with_words
from raywalk.bench.speed_skips import SKIPS, measured, quarter, skip_cases
from raywalk.bench.speed_sweeps import as_table as sweep_table
from raywalk.bench.speed_sweeps import sweep_cases
from raywalk.bench.speed_triangles import Fineness, triangle_cases, triangles
from raywalk.commands.bench import PARTS
from raywalk.scene.read import read_scene, read_scenes
from raywalk.trace.plan import plan_of

FOLDER = Path(__file__).parents[2] / "scenes"
# Between them they have something to leave out for every skip.
NAMES = ("01-shading", "05-many-bounces", "06-bunny-far", "08-glass")


def small(name: str):
    scene = read_scene(FOLDER / name)
    return replace(scene, render=replace(scene.render, size=105, resolutions=(5, 15)))


@pytest.mark.parametrize("name", cases(NAMES, NAMES[:3]))
def test_no_skip_changes_a_picture(name):
    """Each is measured beside doing what it leaves out: the same pixels come out."""
    scene = small(name)
    rows = [measured(scene, skip, 1) for skip in SKIPS if skip.needed(plan_of(scene), scene)]
    assert rows
    changed = [case for case in skip_cases(rows, 0) if "8-bit" in case.metric and not case.holds]
    assert not changed


def test_a_skip_that_brings_time_by_chance_only_breaks_its_bound():
    """The best median of many scenes is above 1 by chance; what most rounds reach is not."""
    by_chance = [0.97, 0.98, 0.99, 1.0, 1.01, 1.02, 1.05, 1.06, 1.09]
    assert quarter(by_chance) < 1.0 < quarter([ratio + 0.1 for ratio in by_chance])
    row = {"skip": SKIPS[0].key, "surely": quarter(by_chance), "steps": 0}
    assert [case.holds for case in skip_cases([row], 0)] == [True, False]


def test_every_skip_has_a_scene_that_it_is_for():
    """One that never has anything to leave out would be dead code."""
    scenes = [small(name) for name in NAMES]
    for skip in SKIPS:
        assert any(skip.needed(plan_of(scene), scene) for scene in scenes), skip.key


def test_the_scenes_that_are_built_by_the_dozen_are_in_order_and_all_different(tmp_path):
    """Equal ones would be traced once."""
    write_scenes(tmp_path, 3)
    radii = {scene.objects[0].shape.radius for scene in read_scenes(tmp_path)}
    assert len(radii) == 3


def test_what_stops_cost_is_a_share_of_their_scenes_and_can_break_its_bound():
    """All scenes together are held to it, with their traces' own time in both."""
    cheap = {"scene": "a", "stops": 9, "trace": 3.0, "sweeps": 3.0}
    dear = {"scene": "b", "stops": 30, "trace": 1.0, "sweeps": 6.0}
    assert [each.measured for each in sweep_cases([cheap, dear], 0)] == [13 / 4]
    assert [each.holds for each in sweep_cases([cheap, dear], 0)] == [True]
    assert [each.holds for each in sweep_cases([dear], 0)] == [False]
    assert [*sweep_table([dear])] == ["  b: 7.00 times with 30 stops"]


def test_every_part_of_the_bench_can_be_measured_alone():
    """The command offers what there is, and no more."""
    assert set(PARTS) == set(speed.PARTS)


def test_a_scene_whose_look_is_too_far_from_its_picture_breaks_its_bound():
    """What was painted before is told, and breaks none."""
    row = {"scene": "04-one-bounce", "shown": 11.9, "painted": 100.0, "most": 12}
    assert [case.holds for case in look.look_cases([row, row | {"shown": 12.1}], 0)] == [
        True,
        False,
    ]
    assert list(look.as_table([row])) == ["  04-one-bounce: 11.9 of 255; painted, 100.0"]
    assert "not measured" in next(look.as_table([]))


def test_a_build_that_takes_long_or_traces_too_much_breaks_the_bounds():
    """A second for nothing at a start of 30 ms, one scene too many, a file of another scene."""
    good = {
        "nothing": 5.0, "words": 40.0, "grids": 30.0, "whole": 90.0, "colour": 90.0, "beside": 30.0,
        "traced": 1, "differ": 0,
    }  # fmt: skip
    assert all(case.holds for case in rebuild_cases(good, 0))
    broken = {
        "nothing": 33.0, "words": 81.0, "grids": 61.0, "whole": 161.0, "colour": 161.0,
        "beside": 61.0, "traced": 2, "differ": 1,
    }  # fmt: skip
    for key, bad in broken.items():
        assert [case.holds for case in rebuild_cases(good | {key: bad}, 0)].count(False) == 1


def test_what_the_rebuild_changes_is_one_lesson_and_one_scene(tmp_path):
    """Words are put before a lesson's first step, once, and the next words in their place."""
    text = '[[lesson]]\ntext = """\nOne ray.\n"""\n[[lesson]]\ntext = """\nTwo.\n"""\n'
    once = with_words(text, "Measured 1.")
    assert once == text.replace("One", "Measured 1. One")
    assert with_words(once, "Measured 2.") == text.replace("One", "Measured 2. One")


def test_what_it_paints_and_turns_is_one_material_and_the_camera():
    """Of the first scene there is; all else stays."""
    materials = "[materials.a]\ndiffuse = [1, 0, 0]\n[materials.b]\ndiffuse = [1, 1, 0]\n"
    text = f"[camera]\neye = [0, 0, 5]\n{materials}"
    assert with_red(text, 0.5) == text.replace("[1, 0, 0]", "[0.5, 0, 0]")
    assert turned(text, "0.1") == text.replace("eye", "up = [0.1, 1, 0]\neye")


def test_each_mesh_is_traced_with_all_its_triangles_and_the_same_rays(tmp_path):
    """Loop subdivision makes four of each; a picture's camera rays and most others stay."""
    write_ply(tmp_path / "ball.ply", icosphere(1))
    rows = triangles([Fineness(tmp_path / "ball.ply", rounds) for rounds in (0, 1)], 1, 15)
    assert [row["triangles"] for row in rows] == [80, 320]
    assert rows[0]["ratio"] == 1.0
    # Subdivision rounds the ball: its outline moves by less than a tenth of its radius.
    assert rows[1]["rays"] == pytest.approx(rows[0]["rays"], rel=0.1)


@pytest.mark.parametrize(
    ("exponent", "holds"), [(0.2, True), (0.49, True), (0.51, False), (1, False)]
)
def test_time_that_grows_with_the_triangles_breaks_its_bound(exponent, holds):
    """Testing every triangle has exponent 1; a tree's logarithm stays far below the bound."""
    counts = [16_000, 64_000, 256_000, 1_024_000]
    rows = [
        {"triangles": count, "rays": 1, "ratio": (count / counts[0]) ** exponent}
        for count in counts
    ]
    (case,) = triangle_cases(rows, 0)
    assert case.measured == pytest.approx(exponent)
    assert case.holds is holds


def test_primitives_that_take_as_long_as_asking_all_break_the_bounds():
    """In proportion to their number, and with the tree: both are said."""
    slow = [{"spheres": n, "ratio": n / 100.0, "of all": 1.0} for n in (100, 1_000, 10_000)]
    assert [case.holds for case in primitive_cases(slow, 0)] == [False, False]
    quick = [{"spheres": n, "ratio": n**0.4, "of all": 0.2} for n in (100, 1_000, 10_000)]
    assert [case.holds for case in primitive_cases(quick, 0)] == [True, True]


def test_a_path_slower_than_its_peer_breaks_the_bound_of_time():
    """And nothing is claimed where the peer is not installed."""
    ours = {"name": "ours, float64", "ours": True, "nanoseconds": 40.0}
    peer = {"name": TIMES["spheres-coherent"][0], "ours": False, "nanoseconds": 50.0}
    task = {"key": "spheres-coherent", "title": "Spheres", "methods": [ours, peer]}
    assert [case.holds for case in time_bounds(task, 0, 1)] == [True]
    task["methods"] = [ours, peer | {"nanoseconds": 30.0}]
    assert [case.holds for case in time_bounds(task, 0, 1)] == [False]
    task["methods"] = [ours]
    assert list(time_bounds(task, 0, 1)) == []


@pytest.mark.slow
def test_whole_pictures_of_all_methods_are_made_and_ours_is_right():
    """Once a new question to a scene was asked that Embree's scene did not know."""
    made = pictures(1, 1, 48)
    assert len(made["methods"]) >= 2
    ours = next(method for method in made["methods"] if method["ours"])
    assert ours["wrong"] == 0


def test_a_check_that_takes_too_long_breaks_its_bound():
    """By its multiple of the floor: a slow machine makes both slow."""
    row = {"scene": "08-glass", "size": 512, "floor": 10.0}
    times = {which: 10.0 * check_work.MOST[which, 512] for which in ("atOnce", "first", "again")}
    assert all(case.holds for case in check_work.check_cases([row | times], 0))
    slow = {which: 1.01 * time for which, time in times.items()}
    assert not any(case.holds for case in check_work.check_cases([row | slow], 0))
    assert "not measured" in next(check_work.as_lines([]))
