"""Scenes 1 to 7 have the course's numbers: those of the well-known pictures."""

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from raywalk.scene.read import read_scenes
from raywalk.scene.shapes import Ellipsoid, Mesh, Plane, Sphere

SCENES = Path(__file__).parents[2] / "scenes"
RED, GREEN, BLUE, WHITE = (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)
COLOURED = {"ambient": (0.1, 0.1, 0.1), "specular": (1, 1, 0.5), "shininess": 100}
MATTE = {"ambient": (0.1, 0.1, 0.1), "specular": (0, 0, 0)}

THREE_SPHERES = [
    ("red sphere", Sphere((-0.5, -1, 1), 1), RED),
    ("green sphere", Sphere((0.5, -1, -1), 1), GREEN),
    ("blue sphere", Sphere((0, 1, 0), 1), BLUE),
]
MIRRORS = [
    ("red sphere", Sphere((0.5, -0.7, 0.5), 0.3), RED),
    ("blue sphere", Sphere((1, -0.7, 0), 0.3), BLUE),
    ("floor", Plane((0, -1, 0), (0, 1, 0)), WHITE),
    ("back wall", Plane((0, 0, -3), (0, 0, 1)), WHITE),
    ("mirror A", Sphere((-0.5, 0, -0.5), 1), "mirror"),
    ("mirror B", Sphere((1.5, 0, -1.5), 1), "mirror"),
]
OBJECTS = {
    "1": THREE_SPHERES,
    "2": THREE_SPHERES,
    "3": [
        ("red ellipsoid", Ellipsoid((0.5, 0, 0.5), (0.5, 0.6, 0.2)), RED),
        ("green sphere", Sphere((-0.5, 0, -0.5), 1), GREEN),
        ("floor", Plane((0, -1, 0), (0, 1, 0)), WHITE),
    ],
    "4": MIRRORS,
    "5": MIRRORS,
}
LIGHTS = {
    "1": [((-2, 1, 1), 1.0)],
    "2": [((-2, 1, 1), 1.0)],
    "3": [((1, 2, 2), 0.5), ((-1, 2, -1), 0.5)],
    "4": [((-1, 2, 1), 0.5), ((0.5, -0.5, 0), 0.5)],
    "5": [((-1, 2, 1), 0.5), ((0.5, -0.5, 0), 0.5)],
    "6": [((-1, 1, 1), 1.0)],
    "7": [((1, 1, 2), 1.0)],
}
SHADOWS_AND_DEPTH = {
    "1": (False, 0),
    "2": (True, 0),
    "3": (True, 0),
    "4": (True, 1),
    "5": (True, 10),
    "6": (True, 0),
    "7": (True, 0),
}


@cache
def course_scenes():
    return {scene.key: scene for scene in read_scenes(SCENES) if scene.key in set("1234567")}


@pytest.fixture(params="1234567")
def scene(request):
    return course_scenes()[request.param]


def test_the_camera_is_the_courses(scene):
    """At (0, 0, 5), looking along -z, 45 degrees high; what leaves the scene is black."""
    camera = scene.camera
    assert (camera.eye, camera.up, camera.fov) == ((0, 0, 5), (0, 1, 0), 45)
    assert camera.target[:2] == (0, 0) and camera.target[2] < 5
    assert scene.background == (0, 0, 0)
    assert scene.render.size == 1155


def test_rays_are_those_of_the_table(scene):
    """Shadow rays from scene 2 on; bounces only where mirrors are the subject."""
    assert (scene.render.shadows, scene.render.depth) == SHADOWS_AND_DEPTH[scene.key]


def test_lights_are_those_of_the_table(scene):
    """White point lights that do not fade, named for people to talk about."""
    assert [(light.position, light.intensity) for light in scene.lights] == LIGHTS[scene.key]
    for number, light in enumerate(scene.lights, start=1):
        assert light.name == f"light {number}"
        assert (light.colour, light.attenuation) == ((1, 1, 1), (1, 0, 0))


@pytest.mark.parametrize("key", sorted(OBJECTS))
def test_objects_are_those_of_the_table(key):
    """Names, places, sizes and materials, in the table's order."""
    scene = course_scenes()[key]
    assert [(o.name, o.shape) for o in scene.objects] == [(n, s) for n, s, _ in OBJECTS[key]]
    for obj, (_, _, look) in zip(scene.objects, OBJECTS[key], strict=True):
        check_material(scene.materials[obj.material], look)
        assert_allclose(obj.transform, np.eye(4), rtol=0, atol=0)


def check_material(material, look):
    if look == "mirror":
        assert (material.reflect, material.transmit) == (1, 0)
        return
    assert (material.diffuse, material.reflect, material.transmit) == (look, 0, 0)
    for key, value in (MATTE if look == WHITE else COLOURED).items():
        assert getattr(material, key) == value


@pytest.mark.parametrize("key", ["6", "7"])
def test_the_bunny_is_blue_and_smooth(key):
    """One mesh with smooth normals, coloured blue."""
    [bunny] = course_scenes()[key].objects
    assert isinstance(bunny.shape, Mesh)
    assert bunny.shape.smooth is not False
    check_material(course_scenes()[key].materials[bunny.material], BLUE)


def test_the_near_bunny_is_the_far_one_moved_by_t_rx_s():
    """T(0.3, -1.5, 0) Rx(20 deg) S(1.5), written out."""
    cos, sin = np.cos(np.radians(20)), np.sin(np.radians(20))
    expected = [
        [1.5, 0, 0, 0.3],
        [0, 1.5 * cos, -1.5 * sin, -1.5],
        [0, 1.5 * sin, 1.5 * cos, 0],
        [0, 0, 0, 1],
    ]
    [far], [near] = course_scenes()["6"].objects, course_scenes()["7"].objects
    assert far.shape == near.shape
    assert_allclose(near.transform, np.array(expected) @ far.transform, rtol=0, atol=1e-15)


@pytest.mark.parametrize("rounds", [0, 1])
def test_the_bunny_stands_where_the_course_put_it(rounds):
    """Base height and the box's centre agree; sizes to 2 %, also as subdivided for tracing."""
    trimesh = pytest.importorskip("trimesh")
    [bunny] = course_scenes()["6"].objects
    mesh = trimesh.load(bunny.shape.path, process=False)
    assert bunny.shape.subdivide == 1
    low, high = (mesh.subdivide_loop(rounds) if rounds else mesh).bounds
    course_low = np.array([-0.944, 0.333, -0.617])
    course_high = np.array([0.608, 1.870, 0.587])
    assert_allclose(high - low, course_high - course_low, rtol=0.02)
    assert abs(low[1] - 0.333) < 1e-3
    assert_allclose((low + high)[[0, 2]] / 2, (-0.168, -0.015), rtol=0, atol=4e-3)


def test_every_scene_has_a_lesson_that_asks_and_answers(scene):
    """Six to twelve steps; two or three, the last among them, ask and hold an answer."""
    steps = scene.lesson
    # A slot becomes a few digits, however much is typed for it.
    texts = [re.sub(r"\{[^{}]*\}", "0.885", text) for step in steps for text, _ in step.stops()]
    assert 6 <= len(steps) <= 12
    asking = [step for step in steps if step.answer]
    assert steps[-1].answer and 2 <= len(asking) <= 3
    assert all(step.text.startswith("**Predict.**") == bool(step.answer) for step in steps)
    assert all(len(text) < 450 for text in texts)  # short enough to be read aloud


def test_each_course_scene_has_its_key_and_its_files_name_in_order():
    """Key n selects the n-th folder."""
    assert [scene.id[:2] for scene in course_scenes().values()] == [f"0{n}" for n in range(1, 8)]
    assert list(course_scenes()) == list("1234567")
