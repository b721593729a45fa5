"""Glass that touches something: no gap, no leak, whichever the scene names first."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from tests.geometry.by_hand import CHALK, CLEAR, scene_of

from raywalk.scene.model import Box, Cylinder, Light, Plane, SceneObject, Shape, Sphere
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
            on = np.flatnonzero((wave.parent == row) & (wave.branch == 1))
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
