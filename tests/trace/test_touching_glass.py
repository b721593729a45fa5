"""Glass that touches something: no gap, no leak, whichever the scene names first."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.geometry.by_hand import CHALK, CLEAR, scene_of, unit

from raywalk.bench.glass_bodies import body
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.model import Light, SceneObject
from raywalk.scene.shapes import Box, Cylinder, Plane, Shape, Sphere
from raywalk.trace.pixel_tree import pixel_tree
from raywalk.trace.tree import Kind
from raywalk.trace.wavefront import Tracer

SIDE = 33  # odd: the middle row and column look along planes of symmetry
PIXELS = np.arange(SIDE * SIDE)
WATER = replace(CLEAR, name="water", ior=1.333)


def test_no_ray_slips_out_through_the_edge_of_a_glass_cube() -> None:
    """A cube before the camera's axis: rays of the picture's diagonals run into its edges. One that
    is reflected by one face there meets the other at once; the stack of media ends empty."""
    scene = scene_of([Box((-0.8, -0.8, -0.8), (0.8, 0.8, 0.8))], [WATER], depth=7)
    for wave in Tracer(scene).waves(PIXELS, SIDE, SIDE):
        outside = wave.hits.object < 0
        assert (wave.media[outside] == -1).all()
        # What still runs in the cube comes out of it, and no ray enters it from inside.
        within = (wave.media >= 0).any(axis=1)
        assert (wave.hits.inside[within & ~outside]).all()
        assert not wave.hits.inside[~within].any()


@pytest.mark.parametrize("glass_first", [False, True], ids=["floor first", "glass first"])
@pytest.mark.parametrize(
    "shape",
    [Box((-0.6, -1, -0.6), (0.6, 0.2, 0.6)), Cylinder((0, -1, 0), (0, 0.2, 0), 0.6)],
    ids=lambda shape: type(shape).__name__,
)
def test_glass_that_stands_on_a_floor_shows_the_floor(shape: Shape, glass_first: bool) -> None:
    """Through its bottom one sees the floor it stands on, not what lies below it: no refracted
    ray ever gets under y = -1."""
    floor = SceneObject("floor", Plane((0, -1, 0), (0, 1, 0)), 0)
    glass = SceneObject("glass", shape, 1)
    scene = scene_of(
        [glass, floor] if glass_first else [floor, glass], [CHALK, CLEAR],
        [Light("lamp", (1, 3, 2))], eye=(0.0, 1.5, 4.0), target=(0.0, -0.5, 0.0), depth=6,
    )  # fmt: skip
    waves = Tracer(scene).waves(PIXELS, SIDE, SIDE)
    assert len(waves) > 3
    for wave in waves:
        met = wave.hits.object >= 0
        assert wave.hits.point[met, 1].min(initial=0) > -1 - 1e-12
        down = (wave.rays.origin[:, 1] <= -1 + 1e-12) & (wave.rays.direction[:, 1] < 0)
        assert not down.any()


@pytest.mark.parametrize("order", [(0, 1), (1, 0)], ids=["near first", "far first"])
def test_two_slabs_that_share_a_face_are_one(order: tuple[int, int]) -> None:
    """Glass against glass of the same index: the border between them neither bends nor reflects,
    so the picture is that of one slab, to 1e-12."""
    slabs = [Box((-1, -1, 0), (1, 1, 0.7)), Box((-1, -1, -0.7), (1, 1, 0))]
    whole = scene_of([Box((-1, -1, -0.7), (1, 1, 0.7))], [CLEAR], eye=(2.0, 1.0, 4.0), depth=3)
    halves = replace(whole, objects=tuple(
        SceneObject(f"slab {k}", slabs[k], 0) for k in order
    ))  # fmt: skip
    straight = []
    for scene in (whole, halves):
        scene = replace(scene, render=replace(scene.render, depth=6))
        waves = Tracer(scene).waves(np.array([16 * SIDE + 16]), SIDE, SIDE)
        row, way = 0, []
        for wave in waves[1:]:  # refracted all the way
            on = np.flatnonzero((wave.parent == row) & (wave.kind == Kind.REFRACTED))
            if not len(on):
                break
            row = int(on[0])
            way.append((wave.rays.direction[row], wave.rays.origin[row]))
        straight.append(way)
    assert [len(way) for way in straight] == [2, 3]
    np.testing.assert_allclose(straight[0][1], straight[1][2], rtol=0, atol=1e-14)
    np.testing.assert_allclose(straight[1][0][0], straight[1][1][0], rtol=0, atol=1e-15)


@pytest.mark.parametrize("seed", range(12), ids="seed {}".format)
def test_media_are_left_as_often_as_they_are_entered(seed: int) -> None:
    """Glass things at random on a grid of tenths, so that many touch or share a face: every ray
    that leaves the scene travels in no medium."""
    rng = np.random.default_rng(seed)
    objects = []
    for k in range(4):
        c, r = np.round(rng.uniform(-1, 1, size=3), 1), float(rng.choice([0.3, 0.5, 0.8]))
        x, y, z = map(float, c)
        shapes: list[Shape] = [
            Sphere((x, y, z), r),
            Box((x - r, y - r, z - r), (x + r, y + r, z + r)),
            Box((x, y, z), (x + r, y + r, z + r)),
        ]
        objects.append(SceneObject(f"thing {k}", shapes[rng.integers(3)], int(rng.integers(2))))
    tracer = Tracer(scene_of(objects, [CLEAR, WATER], eye=(0.0, 0.0, 5.0), depth=6))
    for wave in tracer.waves(PIXELS, SIDE, SIDE):
        assert (wave.media[wave.hits.object < 0] == -1).all()


@pytest.mark.parametrize("inner_first", [False, True], ids=["outer first", "inner first"])
def test_behind_a_shared_face_light_is_in_the_inner_glass(inner_first: bool) -> None:
    """A glass block in a block of water, flush with its front: a ray at the shared face enters
    both at once, is bent by the glass alone, sin(i) / sin(r) = 1.5168, and comes out into water."""
    water = SceneObject("water", Box((-1, -1, -1), (1, 1, 1)), 0)
    glass = SceneObject("glass", Box((-0.5, -0.5, 0.2), (0.5, 0.5, 1.0)), 1)
    scene = scene_of([glass, water] if inner_first else [water, glass], [WATER, CLEAR], depth=4)
    outer, inner = (1, 0) if inner_first else (0, 1)
    direction = unit(np.array([0.3, 0.0, -1.0]))
    waves = Tracer(scene).follow(
        np.array([[0.0, 0.0, 5.0]]) - 4 * direction + [0, 0, -4], direction[None]
    )
    within = waves[1].kind == Kind.REFRACTED
    assert waves[1].media[within].tolist() == [[outer, inner]]
    assert waves[1].rays.direction[within, 0] == pytest.approx(direction[0] / 1.5168, abs=1e-15)
    back = waves[2].kind == Kind.REFRACTED
    assert waves[2].media[back].tolist() == [[outer, -1]]
    assert waves[2].rays.direction[back, 0] == pytest.approx(direction[0] / 1.333, abs=1e-15)


def test_of_equal_bodies_in_one_place_the_lower_counts() -> None:
    """Two equal balls of different glass: light that enters both is bent by the first's index, and
    an eye in both is in the first's glass."""
    balls = [SceneObject(f"ball {k}", Sphere((0, 0, 0), 1.0), k) for k in range(2)]
    scene = scene_of(balls, [WATER, CLEAR], depth=2)
    direction = np.array([[0.0, 0.0, -1.0]])
    waves = Tracer(scene).follow(np.array([[0.6, 0.0, 5.0]]), direction)
    into = waves[1].kind == Kind.REFRACTED
    sine = np.linalg.norm(np.cross(waves[1].rays.direction[into], waves[1].rays.origin[into]))
    assert sine == pytest.approx(0.6 / 1.333, abs=1e-15)
    under = replace(scene, camera=replace(scene.camera, eye=(0.0, 0.0, 0.1)))
    assert Tracer(under).eye_media == [1, 0]


def test_an_eye_under_water_looks_through_glass_half_out_of_it() -> None:
    """A lake made of a box, a ball half in it, a cube of glass with a ball of water on its floor:
    the pixel's tree bends at each border as the media say, and all rays that leave are in none."""
    lake = SceneObject("lake", Box((-4, -2, -4), (4, 0, 4)), 0)
    ball = SceneObject("ball", Sphere((0, 0, 0), 0.5), 1)
    cube = SceneObject("cube", Box((1, -2, -1), (2, -1, 0)), 1)
    bubble = SceneObject("bubble", Sphere((1.5, -1.75, -0.5), 0.25), 0)
    scene = scene_of(
        [lake, ball, cube, bubble], [WATER, CLEAR], eye=(0.5, -1.5, 3.0),
        target=(0.75, -1.0, 0.0), depth=6,
    )  # fmt: skip
    tracer = Tracer(scene)
    assert tracer.eye_media == [0]
    for wave in tracer.waves(PIXELS, SIDE, SIDE):
        assert (wave.media[wave.hits.object < 0] == -1).all()
    tree = pixel_tree(scene, SIDE, SIDE, 16, 16)["tree"]
    assert tree["inside"] or tree["object"] in ("ball", "cube")


@pytest.mark.parametrize("kind", ["mesh", "round mesh", "L mesh"])
@pytest.mark.parametrize("clear", [False, True], ids=["opaque", "glass"])
def test_at_an_outline_a_mesh_shows_its_front(
    rng: np.random.Generator, kind: str, clear: bool, tmp_path: Path
) -> None:
    """Rays from outside at corners and edges of outlines, where a front and a back face tie: none
    is said to come from inside. From inside glass none is said to come from outside,
    at the inner edge of an L neither."""
    one = body(kind, tmp_path)
    glass = SceneObject("glass", one.shape, 0)
    compiled = CompiledScene(scene_of([glass], [CLEAR if clear else CHALK]))
    target = one.marks()[rng.integers(0, len(one.marks()), 4000)]
    origin = 5 * unit(rng.normal(size=(4000, 3)))
    hits = compiled.hits(rays_from(origin, unit(target - origin)))
    # Rounding takes the others past the outline: decided exactly, about half of those aimed at it.
    assert (hits.object == 0).mean() > 0.7
    assert not hits.inside.any()
    if clear:
        origin = rng.uniform(-0.9, 0.9, size=(4000, 3))
        origin, aim = (rows[one.depth(origin) < -0.01] for rows in (origin, target))
        hits = compiled.hits(rays_from(origin, unit(aim - origin)))
        assert hits.inside.all()


def test_glass_apart_from_glass_is_not_asked_about_other_glass() -> None:
    """The plan knows from boxes which bodies can touch: of two pieces a gap apart neither is the
    other's neighbour; of two that touch each is, and of a floor all that stand on it."""
    near, far = Box((0, 0, 0), (1, 1, 1)), Box((1.001, 0, 0), (2, 1, 1))
    touching, floor = Sphere((1.5, 1.5, 0.5), 0.5), Plane((0, 0, 0), (0, 1, 0))
    named = [
        SceneObject(str(k), shape, k // 3) for k, shape in enumerate((near, far, touching, floor))
    ]
    compiled = CompiledScene(scene_of(named, [CLEAR, CHALK]))
    of = np.split(compiled.neighbours.object, compiled.neighbours.start[1:-1])
    assert [each.tolist() for each in of] == [[2], [2], [0, 1], [0, 1]]
