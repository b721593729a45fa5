"""Warnings that save an hour, and none where nothing is odd."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from raywalk.bench.made_scenes import placed, scene_of
from raywalk.commands.check import check_geometry
from raywalk.scene.model import Camera, Light, Material, Scene, SceneObject
from raywalk.scene.read import read_scenes
from raywalk.scene.shapes import Box, Cylinder, Disc, Plane, Shape, Sphere, Triangle
from raywalk.trace.scene_warnings import MOST_OBJECTS, no_lamp, scene_warnings
from raywalk.trace.wavefront import Tracer

CHALK = Material("chalk", (0.1, 0.1, 0.1), (0.8, 0.7, 0.6))
GLASS = Material("glass", transmit=1.0, ior=1.5, fresnel=True)
LAMP = Light("lamp", (2.0, 5.0, 6.0))
FLOOR = SceneObject("floor", Plane((0.0, -1.0, 0.0), (0.0, 1.0, 0.0)), 0)
BALL = SceneObject("ball", Sphere((0.0, 0.0, 0.0), 1.0), 0)


def warnings(objects: list[SceneObject], lights: tuple[Light, ...] = (LAMP,), **keys) -> list[str]:
    scene: Scene = scene_of(objects, lights, (CHALK, GLASS))
    return scene_warnings(Tracer(replace(scene, **keys)))


def thing(name: str, shape: Shape, material: int = 0) -> SceneObject:
    return SceneObject(name, shape, material)


def test_the_projects_scenes_are_not_warned_of() -> None:
    """All ten: boxes stand on floors, walls meet, lamps hang where they light something."""
    for scene in read_scenes(Path("scenes")):
        assert scene_warnings(Tracer(scene)) == []


UNIT = Box((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0))
PAIRS = {
    "rug on floor": (FLOOR.shape, Disc((0.0, -1.0, 0.0), (0.0, 1.0, 0.0), 0.5)),
    "rug upside down": (FLOOR.shape, Disc((0.0, -1.0, 0.0), (0.0, -1.0, 0.0), 0.5)),
    "equal boxes": (UNIT, UNIT),
    "flush box": (UNIT, Box((-0.5, 0.0, -0.5), (0.5, 1.0, 0.5))),
    "equal balls": (BALL.shape, BALL.shape),
    "two floors": (FLOOR.shape, Plane((3.0, -1.0, 2.0), (0.0, -2.0, 0.0))),
    "cap and lid": (Cylinder((0.0, -1.0, 0.0), (0.0, 0.0, 0.0), 1.0),
                    Disc((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.5)),
    "box sunk to its top": (FLOOR.shape, Box((-0.5, -3.0, -0.5), (0.5, -1.0, 0.5))),
    "triangles": (Triangle((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
                  Triangle((0.1, 0.1, 0.0), (1.0, 0.1, 0.0), (0.1, 1.0, 0.0))),
    "tubes": (Cylinder((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.5, False),
              Cylinder((0.0, 0.5, 0.0), (0.0, 2.0, 0.0), 0.5, False)),
}  # fmt: skip
APART = {
    "box on floor": (FLOOR.shape, Box((-0.5, -1.0, -0.5), (0.5, 0.0, 0.5))),
    "rug above floor": (FLOOR.shape, Disc((0.0, -0.999, 0.0), (0.0, 1.0, 0.0), 0.5)),
    "boxes side by side": (UNIT, Box((1.0, -1.0, -1.0), (3.0, 1.0, 1.0))),
    "ball on floor": (FLOOR.shape, BALL.shape),
    "two halves of a quad": (Triangle((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0)),
                             Triangle((0.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0))),
    "wall and floor": (FLOOR.shape, Plane((0.0, 0.0, -9.0), (0.0, 0.0, 1.0))),
}  # fmt: skip


def coincidences(shapes: tuple[Shape, Shape], materials: tuple[int, int] = (0, 0)) -> list[str]:
    named = [
        SceneObject(f"{k}", shape, material, placed(1.0, (0.3, 0.2, 0.1)))
        for k, (shape, material) in enumerate(zip(shapes, materials, strict=True))
    ]
    camera = Camera((3.0, 6.0, 9.0), (0.0, 0.0, 0.0))
    found = warnings([*named, thing("far", Sphere((0.0, 3.0, 0.0), 0.2))], camera=camera)
    return [each for each in found if "coincide" in each]


@pytest.mark.parametrize("name", PAIRS)
def test_surfaces_that_lie_in_one_another_are_named(name: str) -> None:
    """The first of the scene is seen; of glass and something opaque, that is."""
    [said] = coincidences(PAIRS[name])
    assert said.startswith('"0" and "1" coincide: where they do, "0" is seen and "1" is not')
    if "tube" not in name:
        closed = [k for k in (0, 1) if PAIRS[name][k].canonical.height is not None]
        if closed and closed[0] == 0:
            [said] = coincidences(PAIRS[name], (1, 0))
            assert said.startswith('"1" and "0" coincide')


@pytest.mark.parametrize("name", APART)
def test_surfaces_that_touch_or_are_apart_are_not(name: str) -> None:
    """What stands on something hides the place."""
    assert coincidences(APART[name]) == []


def test_a_lamp_in_a_body_and_one_that_lights_nothing_are_named() -> None:
    """Opaque, glass that throws whole shadows, behind a wall, of no strength; none at all."""
    said = warnings([FLOOR, BALL], (LAMP, Light("bulb", (0.0, 0.2, 0.0))))
    assert said == ['the lamp "bulb" is inside "ball", which is opaque']
    [said] = warnings([FLOOR, thing("shade", BALL.shape, 1)], (LAMP, Light("b", (0.0, 0.0, 0.0))))
    assert said.startswith('the lamp "b" is inside "shade", which lets no lamp shine through')
    for dark in (Light("x", (0.0, -5.0, 0.0)), Light("x", (1.0, 3.0, 2.0), intensity=0.0)):
        assert warnings([FLOOR, BALL], (LAMP, dark)) == [
            'the lamp "x" lights nothing that the picture shows'
        ]
    assert "there is no lamp" in warnings([FLOOR, BALL], ())[0]


def test_check_says_of_many_objects_what_a_build_says() -> None:
    """Most is not asked of them by either; a missing lamp is."""
    crowd = [thing(str(k), Sphere((3.0 * k, 0.0, 0.0), 1.0)) for k in range(MOST_OBJECTS + 1)]
    scene = scene_of(crowd, (), (CHALK, GLASS))
    assert check_geometry(scene) == scene_warnings(Tracer(scene)) == no_lamp(scene) != []


def test_a_camera_where_it_sees_nothing_is_named() -> None:
    """Under the floor that all stands on; on a surface."""
    under = Camera((0.0, -3.0, 5.0), (0.0, 0.0, 0.0))
    assert any(
        'the camera is under "floor"' in each for each in warnings([FLOOR, BALL], camera=under)
    )
    on = Camera((0.0, 0.0, 1.0), (0.0, 0.0, 9.0))
    said = warnings([FLOOR, BALL], camera=on)
    assert 'the camera\'s eye is on the surface of "ball"' in said


def test_an_object_that_no_ray_of_the_picture_meets_is_named() -> None:
    """Behind the eye, or beside the picture; not one that only throws its shadow into it."""
    behind = thing("behind", Sphere((0.0, 0.0, 9.0), 0.2))
    beside = thing("beside", Sphere((-40.0, 0.0, 0.0), 0.5))
    said = warnings([FLOOR, BALL, behind, beside])
    assert said == [
        f'"{name}" is outside the picture, and no ray of it meets it'
        for name in ("behind", "beside")
    ]
    over = thing("over", Sphere((1.0, 3.0, 3.6), 0.8))  # between the lamp and the floor
    assert warnings([FLOOR, BALL, over]) == []
