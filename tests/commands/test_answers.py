"""The commands that answer for any scene file: check, probe, pixel."""

from __future__ import annotations

import json
import math
import shutil

import pytest

from raywalk.__main__ import main

SCENE = """
version = 1
title = "A ball over water"
teaches = "Nothing."
background = [0.25, 0.5, 0.75]
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[render]
depth = 3
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 1
material = { ambient = [0.1, 0.1, 0.1], diffuse = [1, 0, 0], reflect = 0.25 }
[[lights]]
name = "sun"
position = [0, 0, 10]
intensity = 0.5
"""


@pytest.fixture
def scene(tmp_path):
    """A file with one ball half way up the line of sight."""
    path = tmp_path / "scene.toml"
    path.write_text(SCENE, encoding="utf-8")
    return path


@pytest.fixture
def answer(capsys):
    """A function from a command's words to its exit code and what it printed."""

    def run(*words):
        code = main([str(word) for word in words])
        printed = capsys.readouterr()
        return code, printed.out, printed.err

    return run


def probe(answer, scene, tmp_path, rays):
    listed, out = tmp_path / "rays.json", tmp_path / "hits.json"
    listed.write_text(json.dumps(rays), encoding="utf-8")
    code, _, err = answer("probe", scene, "--rays", listed, "--out", out)
    return code, json.loads(out.read_text()) if out.exists() else None, err


def test_probe_answers_in_units_of_the_direction_and_with_null_for_a_miss(answer, scene, tmp_path):
    """A direction need not be unit: twice as long, half the t; the point is the same."""
    rays = [
        {"origin": [0, 0, 5], "direction": [0, 0, -1]},
        {"origin": [0, 0, 5], "direction": [0, 0, -2]},
        {"origin": [0, 0, 5], "direction": [0, 0, 1]},
        {"origin": [0, 0, 0], "direction": [0, 3, 4]},
    ]
    code, hits, _ = probe(answer, scene, tmp_path, rays)
    assert code == 0
    assert hits[0] == {
        "t": 4.0, "point": [0, 0, 1], "normal": [0, 0, 1], "object": "ball", "inside": False
    }  # fmt: skip
    assert hits[1] == {**hits[0], "t": 2.0}
    assert hits[2] is None
    # From the centre: the radius 1 is a fifth of the direction's length 5.
    assert math.isclose(hits[3]["t"], 0.2, rel_tol=1e-15)
    assert hits[3]["inside"] is True


@pytest.mark.parametrize("length", [1e-300, 1e-30, 1e30, 1e100])
def test_probe_takes_directions_of_any_length(answer, scene, tmp_path, length):
    """Their squares leave float64's range; the answer does not: t = 4 / length, a few roundings."""
    ray = {"origin": [0, 0, 5], "direction": [0, 0, -length]}
    _, hits, _ = probe(answer, scene, tmp_path, [ray])
    assert math.isclose(hits[0]["t"], 4.0 / length, rel_tol=1e-15)


@pytest.mark.parametrize(
    ("ray", "words"),
    [
        ({"origin": [0, 0, 0], "direction": [0, 0, 0]}, "[0].direction: has length 0"),
        ({"origin": [0, 0, 0]}, "[0].direction: "),
        ({"origin": [0, 0, math.nan], "direction": [0, 0, 1]}, "[0].origin: "),
        ({"origin": [0, 0, math.inf], "direction": [0, 0, 1]}, "[0].origin: "),
        ({"origin": [0, 0], "direction": [0, 0, 1]}, "[0].origin: "),
        ({"origin": "here", "direction": [0, 0, 1]}, "[0].origin: "),
        ([1, 2, 3], "[0].origin: "),
    ],
)
def test_probe_names_a_ray_that_is_none(answer, scene, tmp_path, ray, words):
    """Nothing is written, and the ray's place in the list is named."""
    code, hits, err = probe(answer, scene, tmp_path, [ray])
    assert (code, hits) == (1, None)
    assert words in err
    assert "Traceback" not in err


def test_probe_names_all_bad_rays_at_once(answer, scene, tmp_path):
    """Three mistakes in two rays are three errors in one run."""
    rays = [{"origin": [0], "direction": [0, 0, 0]}, {"origin": [0, 0, 0], "direction": None}]
    code, _, err = probe(answer, scene, tmp_path, rays)
    assert code == 1
    assert err.rstrip().endswith("3 errors; nothing was traced")


@pytest.mark.parametrize("text", ["", "{", '{"origin": 1}', "42"])
def test_probe_refuses_a_file_that_is_no_list(answer, scene, tmp_path, text):
    """JSON or not, an exit code of 1 and the file's name."""
    rays = tmp_path / "rays.json"
    rays.write_text(text, encoding="utf-8")
    code, _, err = answer("probe", scene, "--rays", rays)
    assert code == 1
    assert "rays.json" in err


def test_pixel_gives_the_linear_colour_and_the_whole_tree(answer, scene):
    """The middle of an odd picture looks straight at the ball: everything in closed form.

    n = e = l = (0, 0, 1), so n.l = 1: local = 0.1 + 0.5 * (1, 0, 0), share 1 - 0.25. The
    reflected ray goes straight back and brings the background. No highlight: ks = 0.
    """
    code, out, _ = answer("pixel", scene, "--size", 3, "--at", "1,1", "--json")
    tree = json.loads(out)["tree"]
    assert code == 0
    assert (tree["kind"], tree["object"], tree["t"], tree["weight"]) == ("camera", "ball", 4, 1)
    assert (tree["point"], tree["normal"], tree["inside"]) == ([0, 0, 1], [0, 0, 1], False)
    assert tree["local"] == [0.6, 0.1, 0.1]
    [light] = tree["lights"]
    assert (light["name"], light["visible"], light["blocker"]) == ("sun", True, None)
    [child] = tree["children"]
    assert (child["kind"], child["object"], child["t"]) == ("reflected", None, None)
    assert (child["weight"], child["colour"]) == (0.25, [0.25, 0.5, 0.75])
    expected = [0.75 * local + 0.25 * back for local, back in zip(
        tree["local"], child["colour"], strict=True
    )]  # fmt: skip
    assert json.loads(out)["colour"] == pytest.approx(expected, abs=1e-15)  # one rounding each
    assert [hit["t"] for hit in tree["hits"]] == [4, 6]


def test_pixel_takes_another_depth_and_another_shape(answer, scene):
    """--depth 0 sends no ray on; WxH is width times height."""
    _, out, _ = answer("pixel", scene, "--size", "5x3", "--at", "2,1", "--depth", 0, "--json")
    assert json.loads(out)["tree"]["children"] == []


def test_pixel_follows_a_thousand_bounces(answer, tmp_path):
    """Between parallel mirrors the tree is a path of a thousand rays inside one another."""
    path = tmp_path / "scene.toml"
    walls = "".join(
        f'[[objects]]\ntype = "plane"\npoint = [0, 0, {z}]\nnormal = [0, 0, {-z}]\n'
        f'material = "mirror"\n'
        for z in (-1, 1)
    )
    head = 'version = 1\ntitle = "Hall"\nteaches = "x"\n[camera]\neye = [0, 0, 0]\n'
    path.write_text(head + "target = [0, 0, -1]\n[render]\ndepth = 1000\n" + walls)
    code, out, _ = answer("pixel", path, "--size", 1, "--at", "0,0", "--json")
    assert code == 0
    assert out.count('"kind": "reflected"') == 1000


@pytest.mark.parametrize(
    "words",
    [
        ("--size", "0", "--at", "0,0"),
        ("--size", "3x", "--at", "0,0"),
        ("--size", "3", "--at", "1"),
        ("--size", "3", "--at", "-1,0"),
        ("--size", "3", "--at", "0,0", "--depth", "1001"),
    ],
)
def test_pixel_refuses_words_that_mean_nothing(scene, words, capsys):
    """Wrong usage ends with 2 and says what was expected."""
    with pytest.raises(SystemExit) as stopped:
        main(["pixel", str(scene), *words])
    assert stopped.value.code == 2
    assert "raywalk pixel: error" in capsys.readouterr().err


def test_pixel_outside_the_picture_is_named(answer, scene):
    """Rows and columns are counted from 0."""
    code, _, err = answer("pixel", scene, "--size", "5x3", "--at", "2,3")
    assert code == 1
    assert "columns 0 to 4, rows 0 to 2" in err


def test_check_names_the_mistakes_of_all_scenes_at_once(answer, scene, tmp_path):
    """Two bad files, one run, exit code 1."""
    other = tmp_path / "other.toml"
    other.write_text(SCENE.replace("radius = 1", "radius = -1"), encoding="utf-8")
    scene.write_text(SCENE.replace('type = "sphere"', 'type = "spere"'), encoding="utf-8")
    code, out, err = answer("check", scene, other)
    assert (code, out) == (1, "")
    assert "radius" in err
    assert 'did you mean "sphere"?' in err


def test_check_lists_what_is_in_order(answer, scene):
    """A line a scene."""
    code, out, _ = answer("check", scene)
    assert code == 0
    assert out.endswith("1 object, 1 light: in order\n")


def test_check_finds_a_camera_inside_an_opaque_mesh(answer, tmp_path):
    """Which only the triangles know: the Stanford bunny's middle is in the bunny."""
    folder = tmp_path / "bunny"
    folder.mkdir()
    (folder / "scene.toml").write_text(
        'version = 1\ntitle = "x"\nteaches = "x"\n[camera]\neye = [0, 0.8, 0]\n'
        'target = [0, 0.8, -5]\n[[objects]]\ntype = "mesh"\nfile = "bunny.ply"\n'
        'material = "white"\n'
    )
    shutil.copy("models/bunny.ply", folder)
    code, _, err = answer("check", folder)
    assert code == 1
    assert "camera.eye" in err
    assert 'lies inside the opaque "mesh 1"' in err


BALL = """
version = 1
title = "In a ball"
teaches = "Nothing."
[camera]
eye = [0, 0, 0]
target = [0, 0, -1]
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 5
material = "mirror"
[[lights]]
position = [0, 1, 0]
"""


def test_a_ray_that_starts_on_a_surface_does_not_hit_its_start(answer, tmp_path):
    """Inwards it meets the far side, outwards nothing; named, also from a billionth beside it."""
    path = tmp_path / "scene.toml"
    path.write_text(BALL, encoding="utf-8")
    inwards = {"origin": [3, 0, 4], "direction": [-3, 0, -4]}
    rays = [
        inwards,
        {"origin": [3, 0, 4], "direction": [3, 0, 4]},
        inwards | {"leaving": "ball"},
        {"origin": [3, 0, 4.000000001], "direction": [-3, 0, -4], "leaving": "ball"},
    ]
    _, hits, _ = probe(answer, path, tmp_path, rays)
    assert hits[0]["t"] == 2.0  # twice the radius, in lengths of 5
    assert hits[1] is None
    assert hits[2] == hits[0]
    assert math.isclose(hits[3]["t"], 2.0, rel_tol=1e-9)


@pytest.mark.parametrize(
    ("leaving", "words"),
    [
        ("bal", 'no object is named "bal"\n  did you mean "ball"?'),
        ("ball", 'is not on the surface of "ball"'),
        (3, "3 is not the name of an object"),
    ],
)
def test_what_a_ray_does_not_leave_is_named(answer, tmp_path, leaving, words):
    """An unknown object, a place beside it, and what is no name."""
    path = tmp_path / "scene.toml"
    path.write_text(BALL, encoding="utf-8")
    ray = {"origin": [3, 0, 4.1], "direction": [-3, 0, -4], "leaving": leaving}
    code, hits, err = probe(answer, path, tmp_path, [ray])
    assert (code, hits) == (1, None)
    assert f"[0].leaving: {words}" in err or words in err


def test_an_eye_may_be_in_a_mirrored_ball_but_in_no_matt_one(answer, tmp_path):
    """From within a mirror there is something to see."""
    path = tmp_path / "scene.toml"
    path.write_text(BALL, encoding="utf-8")
    assert answer("pixel", path, "--size", "5", "--at", "2,2")[0] == 0
    path.write_text(BALL.replace('"mirror"', '"white"'), encoding="utf-8")
    code, _, err = answer("check", path)
    assert code == 1
    assert 'is inside "ball", which is opaque' in err
