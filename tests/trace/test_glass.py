"""Glass against closed forms: slab, ball, glass in water, the eye under water, furnaces."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from tests.geometry.by_hand import CHALK, CLEAR, MIRROR, scene_of, unit

from raywalk.errors import SourceErrors
from raywalk.scene.model import Material, Scene, SceneObject
from raywalk.scene.shapes import Box, Cylinder, Ellipsoid, Plane, Shape, Sphere, Triple
from raywalk.trace.tree import Kind
from raywalk.trace.wave import Wave
from raywalk.trace.wavefront import Tracer

PLAIN = replace(CLEAR, name="glass without Fresnel", fresnel=False)
WATER = replace(PLAIN, name="water", ior=1.333)
N = PLAIN.ior


def follow(scene: Scene, origin: Triple, direction: np.ndarray) -> list[Wave]:
    """The waves of one ray that starts at the scene's eye."""
    ahead = (origin[0], origin[1], origin[2] - 1.0)
    tracer = Tracer(replace(scene, camera=replace(scene.camera, eye=origin, target=ahead)))
    return tracer.follow(np.array([origin]), direction[None])


def glassy(*shapes: Shape, material: Material = PLAIN, **render: Any) -> Scene:
    """A scene of these shapes, all of one glass."""
    named = [SceneObject(f"glass {k}", shape, 0) for k, shape in enumerate(shapes)]
    return scene_of(named, [material], **render)


@pytest.mark.parametrize("degrees", [0, 10, 30, 60, 85])
def test_a_slab_gives_back_a_parallel_ray(degrees: int) -> None:
    """A slab of thickness 1 leaves the direction and moves the ray aside by
    sin(i - r) / cos(r), r = asin(sin(i) / n)."""
    i = math.radians(degrees)
    d = np.array([math.sin(i), -math.cos(i), 0.0])
    waves = follow(glassy(Box((-50, -1, -50), (50, 0, 50))), (0.0, 2.0, 0.0), d)
    assert [w.kind[0] for w in waves] == [Kind.CAMERA, Kind.REFRACTED, Kind.REFRACTED]
    out = waves[2].rays
    assert np.abs(out.direction[0] - d).max() < 1e-15
    r = math.asin(math.sin(i) / N)
    aside = np.linalg.norm(np.cross(out.origin[0] - [0, 2, 0], d))
    assert aside == pytest.approx(math.sin(i - r) / math.cos(r), abs=1e-14 / math.cos(i))


@pytest.mark.parametrize("height", [0.0, 0.3, 0.7, 0.99])
def test_a_ball_turns_a_ray_by_twice_the_angles_difference(height: float) -> None:
    """At height h over the axis, r = 1: sin(i) = h, sin(r) = h / n, the ray is turned by
    2 (i - r) towards the axis, and leaves as far from the middle as it came."""
    waves = follow(glassy(Sphere((0, 0, 0), 1.0)), (-5.0, height, 0.0), np.array([1.0, 0.0, 0.0]))
    turned = 2 * (math.asin(height) - math.asin(height / N))
    out = waves[2].rays
    expected = [math.cos(turned), -math.sin(turned), 0.0]
    assert np.abs(out.direction[0] - expected).max() < 1e-14
    assert np.linalg.norm(np.cross(out.origin[0], out.direction[0])) == pytest.approx(
        height, abs=1e-14
    )


def test_a_glass_ball_in_water_refracts_by_both_indices() -> None:
    """Concentric balls, water r = 1 round glass r = 0.5: n times the distance of the ray's line
    from the middle is the same in every medium (Bouguer), so the lines pass at b, b / 1.333,
    b / 1.5168, b / 1.333 and b."""
    b = 0.4
    water = SceneObject("water", Sphere((0, 0, 0), 1.0), 0)
    scene = scene_of([water, SceneObject("glass", Sphere((0, 0, 0), 0.5), 1)], [WATER, PLAIN])
    waves = follow(scene, (-5.0, b, 0.0), np.array([1.0, 0.0, 0.0]))
    assert [int(w.hits.object[0]) for w in waves] == [0, 1, 1, 0, -1]
    lines = [np.linalg.norm(np.cross(w.rays.origin[0], w.rays.direction[0])) for w in waves]
    np.testing.assert_allclose(lines, [b, b / 1.333, b / N, b / 1.333, b], rtol=0, atol=1e-14)


@pytest.mark.parametrize("degrees", [10, 40, 48, 49, 60, 80])
def test_the_eye_under_water_sees_the_sky_in_a_window(degrees: int) -> None:
    """Below the plane y = 0 the eye is in water: up to asin(1 / 1.333) = 48.6 degrees it sees out,
    refracted by 1.333 to 1; beyond, the surface reflects all."""
    scene = scene_of(
        [SceneObject("lake", Plane((0, 0, 0), (0, 1, 0)), 0)], [WATER], background=(0.5, 0.5, 0.5)
    )
    i = math.radians(degrees)
    waves = follow(scene, (0.0, -1.0, 0.0), np.array([math.sin(i), math.cos(i), 0.0]))
    assert waves[0].hits.inside[0]
    if math.sin(i) * 1.333 < 1:
        assert waves[1].kind[0] == Kind.REFRACTED
        assert waves[1].rays.direction[0, 0] == pytest.approx(1.333 * math.sin(i), abs=1e-15)
    else:
        assert waves[1].kind[0] == Kind.TOTAL
        assert waves[1].rays.direction[0, 1] == pytest.approx(-math.cos(i), abs=1e-15)
        assert waves[1].weight[0] == 1.0


def test_an_eye_inside_something_opaque_is_refused() -> None:
    """With the object's name."""
    scene = scene_of([SceneObject("wall", Box((-1, -1, 4), (1, 1, 6)), 0)])
    with pytest.raises(SourceErrors, match='inside the opaque "wall"'):
        Tracer(scene)


def furnace(*, depth: int) -> Scene:
    """Lossless things only, under a sky of 1: glass, water in glass, mirrors, touching and
    overlapping."""
    mixed = replace(CLEAR, name="half mirror", reflect=0.3, transmit=0.7, fresnel=False)
    shapes: list[tuple[Shape, int]] = [
        (Sphere((-0.6, 0, 0.5), 0.8), 0), (Sphere((-0.6, 0.1, 0.5), 0.3), 1),
        (Ellipsoid((0.9, 0.3, 0.2), (0.3, 0.7, 0.4), (10.0, 20.0, 30.0)), 0),
        (Box((-0.2, -1.4, -0.5), (0.9, -0.9, 0.9)), 3), (Sphere((0.9, -0.3, -1.8), 0.8), 2),
        (Cylinder((-1.2, -1.2, 0.2), (-0.4, -1.0, 1.0), 0.3), 0), (Sphere((0.2, 0.0, 0.5), 0.2), 1),
    ]  # fmt: skip
    return scene_of(
        [SceneObject(f"thing {k}", shape, m) for k, (shape, m) in enumerate(shapes)],
        [CLEAR, replace(CLEAR, name="water", ior=1.333), MIRROR, mixed],
        background=(1.0, 1.0, 1.0),
        depth=depth,
    )


def missing_weight(tracer: Tracer, waves: list[Wave]) -> np.ndarray:
    """(n,) share of each camera ray's light that the bounce limit cut off."""
    lost = [np.zeros(len(w.parent)) for w in waves]
    if len(waves) == tracer.plan.depth + 1:
        lost[-1] = (waves[-1].hits.object >= 0).astype(float)
    for k in range(len(waves) - 1, 0, -1):
        np.add.at(lost[k - 1], waves[k].parent, waves[k].weight * lost[k])
    return lost[0]


@pytest.mark.parametrize("depth", [1, 4, 9])
def test_in_a_furnace_everything_is_as_bright_as_the_sky(depth: int) -> None:
    """Lossless glass and mirrors under a uniform sky of 1 show 1 everywhere: what is missing is
    what the bounce limit cut off, to 1e-12. So weights, sides and media lose nothing."""
    scene = furnace(depth=depth)
    tracer = Tracer(scene)
    waves = tracer.waves(np.arange(45 * 45), 45, 45)
    whole = waves[0].colour[:, 0] + missing_weight(tracer, waves)
    np.testing.assert_allclose(whole, 1.0, rtol=0, atol=1e-12)
    assert (waves[0].hits.object >= 0).mean() > 0.3
    if depth == 9:
        assert np.median(waves[0].colour[waves[0].hits.object >= 0, 0]) > 0.99


BODIES = [
    Sphere((0, 0, 0), 1.0),
    Ellipsoid((0, 0, 0), (1.2, 0.8, 1.0)),
    Box((-1, -1, -1), (1, 1, 1)),
    Cylinder((0, -1, 0), (0, 1, 0), 1.0),
]


@pytest.mark.parametrize("shape", BODIES, ids=lambda body: type(body).__name__)
def test_light_goes_the_same_way_back(rng: np.random.Generator, shape: Shape) -> None:
    """Helmholtz: the ray that came straight through, sent back, arrives where the first started,
    with the same share of the light."""
    scene = glassy(shape, material=CLEAR, depth=2)
    compared = 0
    for _ in range(60):
        start = 4 * unit(rng.normal(size=3))
        direction = unit(0.5 * rng.normal(size=3) - start)
        there = through(follow(scene, tuple(start), direction))
        if there is None:
            continue
        share, origin, onward = there
        turned = through(follow(scene, tuple(origin + 3 * onward), -onward))
        assert turned is not None
        back, end, home = turned
        assert back == pytest.approx(share, abs=1e-12)
        assert np.abs(home + direction).max() < 1e-11
        assert np.linalg.norm(np.cross(start - end, direction)) < 1e-11
        compared += 1
    assert compared > 10


def through(waves: list[Wave]) -> tuple[float, np.ndarray, np.ndarray] | None:
    """Share, origin and direction of the ray refracted twice, if it then leaves; away from the
    critical angle and from grazing, where the way back is ill-conditioned."""
    if len(waves) < 3:
        return None
    for k in range(len(waves[2].parent)):
        parent = waves[2].parent[k]
        twice = waves[2].kind[k] == Kind.REFRACTED and waves[1].kind[parent] == Kind.REFRACTED
        shares = waves[2].weight[k], waves[1].weight[parent]
        if twice and min(shares) > 0.7 and waves[2].hits.object[k] < 0:
            rays = waves[2].rays
            return float(np.prod(shares)), rays.origin[k], rays.direction[k]
    return None


def test_grazing_a_border_between_equal_media_is_no_nan() -> None:
    """A ray that touches a ball of index 1 exactly: 0 / 0 in Fresnel's equations."""
    air = replace(CLEAR, name="air", ior=1.0)
    scene = glassy(Sphere((0, 0, 0), 1.0), material=air, background=(1.0, 1.0, 1.0))
    waves = follow(scene, (-5.0, 1.0, 0.0), np.array([1.0, 0.0, 0.0]))
    assert waves[0].hits.object[0] == 0
    assert waves[0].colour[0].tolist() == [1.0, 1.0, 1.0]


def test_an_invisible_ball_changes_nothing() -> None:
    """Glass of index 1 over chalk: the same colours as without it, but for shadows."""
    floor = SceneObject("floor", Plane((0, -1, 0), (0, 1, 0)), 0)
    air = replace(CLEAR, name="air", ior=1.0)
    bare = scene_of([floor], [CHALK], shadows=False)
    covered = scene_of(
        [floor, SceneObject("ball", Sphere((0, -0.2, 0), 1.0), 1)], [CHALK, air], shadows=False
    )
    pixels = np.arange(30 * 30)  # an even number: no ray runs level, to a horizon of roundings
    a, b = (Tracer(scene).waves(pixels, 30, 30)[0].colour for scene in (bare, covered))
    np.testing.assert_allclose(a, b, rtol=0, atol=1e-12)
