"""Warnings that save an hour, and none where nothing is odd."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from raywalk.bench.made_scenes import placed, scene_of
from raywalk.geometry.boxes import boxes_of, touching
from raywalk.geometry.compiled import CompiledScene
from raywalk.scene.model import Camera, Light, Material, Scene, SceneObject
from raywalk.scene.read import read_scenes
from raywalk.scene.shapes import Box, Cylinder, Disc, Mesh, Plane, Shape, Sphere, Triangle
from raywalk.trace.scene_warnings import MOST_SAID, no_lamp, scene_warnings
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


MANY = 1_500


def test_of_many_objects_everything_is_asked_too() -> None:
    """And said by `check` as by a build: a rug among 1,500 balls, a lamp in one of them, the eye
    on another, and one behind it; of many sentences of a kind the first, and how many more."""
    crowd = [
        thing(str(k), Sphere((3.0 * (k % 40) - 60.0, 0.0, -3.0 * (k // 40)), 1.0))
        for k in range(MANY)
    ]
    odd = [thing("rug", Disc((-0.5, -1.0, 3.0), (0.0, 1.0, 0.0), 0.5)),
           thing("here", Sphere((0.0, 0.0, 6.0), 1.0)),
           thing("behind", Sphere((0.0, 0.0, 90.0), 1.0))]  # fmt: skip
    lamps = (LAMP, Light("bulb", crowd[700].shape.center))
    scene = scene_of([FLOOR, *crowd, *odd], lamps, (CHALK, GLASS))
    said = scene_warnings(Tracer(scene))
    assert scene_warnings(Tracer(scene)) == said
    assert said == [
        'the lamp "bulb" is inside "700", which is opaque',
        '"floor" and "rug" coincide: where they do, "floor" is seen and "rug" is not; '
        "moving one by 0.1 shows which",
        'the camera\'s eye is on the surface of "here"',
        *(line for line in said if "outside the picture" in line),
        said[-1],
    ]
    assert sum("outside the picture" in line for line in said) == MOST_SAID
    assert said[-1].endswith("more warnings like the last")
    assert no_lamp(replace(scene, lights=())) != []


def test_glass_among_many_is_asked_of_its_neighbours_only() -> None:
    """Pairs in a row of 3,000 balls: of which all overlap the next, and the first 20 are named."""
    row = [thing(str(k), Sphere((1.5 * k, 0.0, 0.0), 1.0), 1) for k in range(2 * MANY)]
    said = [each for each in warnings(row) if "both clear" in each or "more" in each]
    assert said[0].startswith('"0" and "1" are both clear and overlap')
    assert said[MOST_SAID] == f"{2 * MANY - 1 - MOST_SAID:,} more warnings like the last"


def test_pairs_found_by_sweeping_are_those_of_comparing_all(rng: np.random.Generator) -> None:
    """Boxes at random, some endless, asked of some: the sweep finds each pair that touches once."""
    count = 300
    shapes: list[Shape] = [
        Sphere(tuple(rng.uniform(-3, 3, 3)), float(rng.uniform(0.05, 0.9))) for _ in range(count)
    ]
    shapes += [Plane((0.0, -1.0, 0.0), tuple(rng.normal(size=3))) for _ in range(3)]
    compiled = CompiledScene(scene_of(shapes))
    boxes, asked = boxes_of(compiled.primitives, []), rng.random(count + 3) < 0.3
    met = (boxes[:, None, 0] <= boxes[None, :, 1]).all(axis=2)
    met &= met.T
    for k in range(count, count + 3):
        row = compiled.primitives.row_of[k]
        level = boxes[:count].mean(axis=1) - compiled.primitives.centre[row]
        level = np.abs(level @ compiled.primitives.to_local[row, 1])
        reach = (boxes[:count, 1] - boxes[:count, 0]) / 2
        met[:count, k] = level <= reach @ np.abs(compiled.primitives.to_local[row, 1]) + 1e-8
    met &= asked[:, None] | asked[None, :]
    expected = np.argwhere(np.triu(met, 1)).tolist()
    pairs, is_all = touching(compiled.primitives, boxes, asked, 10**6)
    assert is_all and pairs.tolist() == expected
    some, is_all = touching(compiled.primitives, boxes, asked, 50)
    assert not is_all and {*map(tuple, some.tolist())} < {*map(tuple, expected)}


def test_a_camera_where_it_sees_nothing_is_named() -> None:
    """Under the floor that all stands on; on a surface."""
    under = Camera((0.0, -3.0, 5.0), (0.0, 0.0, 0.0))
    assert any(
        'the camera is under "floor"' in each for each in warnings([FLOOR, BALL], camera=under)
    )
    on = Camera((0.0, 0.0, 1.0), (0.0, 0.0, 9.0))
    said = warnings([FLOOR, BALL], camera=on)
    assert 'the camera\'s eye is on the surface of "ball"' in said


FLOORS = {
    "box": [Box((-4.0, -1.3, -4.0), (4.0, -1.0, 4.0))],
    "disc": [Disc((0.0, -1.0, 0.0), (0.0, 1.0, 0.0), 6.0)],
    "two triangles": [Triangle((-6.0, -1.0, -6.0), (-6.0, -1.0, 6.0), (6.0, -1.0, -6.0)),
                      Triangle((6.0, -1.0, 6.0), (6.0, -1.0, -6.0), (-6.0, -1.0, 6.0))],
    "tiles": [Box((x, -1.1, z), (x + 2.99, -1.0, z + 2.99)) for x in (-6, -3, 0, 3)
              for z in (-6, -3, 0, 3)],
}  # fmt: skip


@pytest.mark.parametrize("kind", FLOORS)
@pytest.mark.parametrize("wall", [False, True], ids=["free", "before a wall"])
def test_a_camera_under_any_floor_is_named(kind: str, wall: bool) -> None:
    """From above nothing is said; nor of a table that stands over something else, nor of a glass
    floor, nor where what is on the floor is seen past its edge."""
    floor = [thing(f"floor {k}", shape) for k, shape in enumerate(FLOORS[kind])]
    walls = [thing("wall", Plane((0.0, 0.0, -9.0), (0.0, 0.0, 1.0)))] if wall else []
    scene = [*floor, *walls, BALL, thing("block", Box((1.5, -1.0, 0.0), (2.0, 0.0, 0.5)))]
    under, above = (Camera((0.0, y, 2.5), (0.0, 0.0, 0.0)) for y in (-4.0, 3.0))

    def said(objects: list[SceneObject], camera: Camera) -> list[str]:
        return [each for each in warnings(objects, camera=camera) if "camera is" in each]

    [sentence] = said(scene, under)
    assert sentence.startswith('the camera is under "floor')
    assert said(scene, above) == []
    on_the_ground = thing("cat", Sphere((0.0, -3.0, 0.0), 0.5))
    assert said([*scene, on_the_ground], under) == []
    assert said([thing("table", BALL.shape), on_the_ground], under) == []
    if kind == "box":  # an open surface is never glass
        assert said([thing("pane", floor[0].shape, 1), *scene[1:]], under) == []
    beside = Camera((0.0, -2.0, 20.0), (0.0, 0.0, 0.0), fov=8.0)
    assert said(scene, beside) == []


def test_a_camera_under_a_mesh_is_named(tmp_path: Path) -> None:
    path = tmp_path / "ground.off"
    path.write_text("OFF\n4 2 0\n-6 -1 -6\n-6 -1 6\n6 -1 -6\n6 -1 6\n3 0 1 2\n3 3 2 1\n")
    ground = thing("ground", Mesh("ground.off", path))
    said = warnings([ground, BALL], camera=Camera((0.0, -4.0, 2.5), (0.0, 0.0, 0.0)))
    assert 'the camera is under "ground": everything else is above it' in said


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
