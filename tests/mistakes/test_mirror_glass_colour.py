"""What mistakes with mirrors, glass and bytes do: each by what follows from it."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from tests.geometry.by_hand import CHALK, CLEAR, MIRROR, scene_of

from raywalk.mistakes.colour import to_bytes
from raywalk.mistakes.tracer import Wave, picture, trace
from raywalk.scene.model import Light, Material, Scene, SceneObject
from raywalk.scene.shapes import Box, Plane, Shape, Sphere
from raywalk.trace.tree import Kind

from .course import scene

N = 15
LAMP = Light("lamp", (-3.0, 4.0, 5.0))
BACK = SceneObject("back", Plane((0, 0, -3), (0, 0, 1)), 1)
INDEX = CLEAR.ior


def before_wall(shape: Shape, material: Material, **render: object) -> Scene:
    """It, in front of a wall of chalk."""
    things = [SceneObject("it", shape, 0), BACK]
    return scene_of(things, [material, CHALK], [LAMP], **render)  # type: ignore[arg-type]


def waves(one: Scene, *mistakes: str, n: int = N) -> list[Wave]:
    return trace(one, n, np.arange(n * n), frozenset(mistakes))[1]


def directions(one: Scene, *mistakes: str) -> np.ndarray:
    """(3, n) of what the camera rays' hits send on."""
    return waves(one, *mistakes)[1].sent.rays.direction


def colours(one: Scene, *mistakes: str) -> np.ndarray:
    return picture(one, N, frozenset(mistakes), least_share=0.0).linear


MIRROR_BALL = before_wall(Sphere((0.2, 0.1, 0), 0.8), MIRROR, depth=2)


def test_a_reversed_mirror_ray_goes_the_other_way() -> None:
    """Into the ball."""
    assert_array_equal(directions(MIRROR_BALL, "mirror-reversed"), -directions(MIRROR_BALL))


def test_mirrors_about_p_are_right_on_a_ball_about_the_origin() -> None:
    """There p - c is p; elsewhere it is not."""
    middle = before_wall(Sphere((0, 0, 0), 0.8), MIRROR, depth=1)
    wrong = directions(middle, "mirror-wrong-normal")
    assert_allclose(wrong, directions(middle), rtol=0, atol=1e-15)
    off = directions(MIRROR_BALL, "mirror-wrong-normal") - directions(MIRROR_BALL)
    assert np.abs(off).max() > 0.1


def test_one_bounce_more_or_less_is_another_limit() -> None:
    """Of two mirrors that face each other the deepest ray tells the limit."""
    facing = [SceneObject("near", Plane((0, 0, 6), (0, 0, -1)), 0), BACK]
    one = scene_of(facing, [MIRROR, MIRROR], depth=4)
    assert len(waves(one)) == 5
    assert len(waves(one, "depth-one-too-many")) == 6
    assert len(waves(one, "depth-one-too-few")) == 4
    assert (colours(one) == 0).all()
    assert (colours(one, "white-at-the-limit") == 1).all()
    none = replace(one, render=replace(one.render, depth=0))
    assert len(waves(none, "depth-one-too-few")) == 1


def test_a_mirrors_own_colour_is_added_in_full() -> None:
    """One that mirrors a third shows 1 of its colour for 2 / 3; a bare one that of plastic."""
    part = replace(CHALK, reflect=1 / 3)
    third = before_wall(Sphere((0.2, 0.1, 0), 0.8), part, depth=1)
    right, wrong = waves(third), waves(third, "mirror-adds-own-colour")
    on_it = right[0].hits.object == 0
    added = (wrong[0].colour - right[0].colour)[:, on_it]
    assert_allclose(added, right[0].lighting.local[:, on_it] / 3, rtol=0, atol=1e-15)
    bare = waves(MIRROR_BALL, "mirror-adds-own-colour")[0]
    assert (bare.lighting.local[:, bare.hits.object == 0] >= 0.1).all()


def test_mirror_acne_is_a_ball_that_half_of_its_rays_meet_again() -> None:
    """Rightly none does: it is convex. The same ones on every run."""
    met = [waves(MIRROR_BALL, *wrong, n=33)[1].hits.object for wrong in ([], ["mirror-acne"])]
    assert not (met[0] == 0).any()
    assert 0.3 < (met[1] == 0).mean() < 0.7
    assert_array_equal(waves(MIRROR_BALL, "mirror-acne", n=33)[1].hits.object, met[1])


GLASS_BALL = before_wall(Sphere((0.2, 0.1, 0), 0.8), CLEAR, depth=2)


def bent(one: Scene, depth: int, *mistakes: str) -> tuple[np.ndarray, np.ndarray]:
    """Sines of the angles before and behind the border at refracted rays of a depth (1: going in),
    whose parents were all refracted."""
    traced = waves(one, *mistakes)
    before, after = traced[depth - 1], traced[depth]
    rows = np.flatnonzero(after.sent.kind == Kind.REFRACTED)
    parent = after.sent.parent[rows]
    through = (before.sent.kind[parent] == Kind.REFRACTED) | (depth == 1)
    rows, parent = rows[through], parent[through]
    n = before.hits.outward[:, parent]
    sine = [
        np.linalg.norm(np.cross(d / np.linalg.norm(d, axis=0), n, axis=0), axis=0)
        for d in (before.sent.rays.direction[:, parent], after.sent.rays.direction[:, rows])
    ]
    return sine[0], sine[1]


@pytest.mark.parametrize(("mistake", "going_in", "coming_out"), [
    ((), 1 / INDEX, INDEX),
    (("not-bent-at-exit",), 1 / INDEX, 1.0),
    (("inside-not-told",), 1 / INDEX, 1 / INDEX),
    (("index-ratio-inverted",), INDEX, 1 / INDEX),
])  # fmt: skip
def test_snells_law_with_the_wrong_ratio(
    mistake: tuple[str, ...], going_in: float, coming_out: float
) -> None:
    """The sine behind the border over the one before it, both ways."""
    for depth, ratio in ((1, going_in), (2, coming_out)):
        before, behind = bent(GLASS_BALL, depth, *mistake)
        assert len(before) > 5
        assert_allclose(behind, ratio * before, rtol=0, atol=1e-12)


SLAB = before_wall(Box((-1.5, -1.0, -0.5), (1.5, 0.2, 0.5)), CLEAR, depth=4)


def kinds(*mistakes: str) -> np.ndarray:
    low = replace(SLAB, camera=replace(SLAB.camera, eye=(0.0, 1.5, 3.0)))
    return np.concatenate([wave.sent.kind for wave in waves(low, *mistakes)])


def test_total_reflection_brings_nothing_or_goes_straight_on() -> None:
    """Rightly it mirrors all."""
    assert (kinds() == Kind.TOTAL).any()
    assert not (kinds("total-black") == Kind.TOTAL).any()
    low = replace(SLAB, camera=replace(SLAB.camera, eye=(0.0, 1.5, 3.0)))
    traced = waves(low, "total-passed-on")
    straight = 0
    for before, after in pairwise(traced):
        passed = (after.sent.kind == Kind.REFRACTED) & (after.sent.weight == 1)
        parent = after.sent.parent[passed]
        wanted = before.sent.rays.direction[:, parent]
        assert_array_equal(after.sent.rays.direction[:, passed], wanted)
        straight += int(passed.sum())
    assert straight and not (kinds("total-passed-on") == Kind.TOTAL).any()


def reflected_share(*mistakes: str) -> np.ndarray:
    """Of the camera rays that meet the ball, with the sine of their angles."""
    wave = waves(GLASS_BALL, *mistakes)[1]
    return np.asarray(wave.sent.weight[wave.sent.kind == Kind.REFLECTED])


def test_without_fresnel_glass_mirrors_nothing_from_outside() -> None:
    """All goes through."""
    wave = waves(GLASS_BALL, "no-fresnel")[1]
    assert (wave.sent.kind == Kind.REFRACTED).all() and (wave.sent.weight == 1).all()


def test_fresnel_of_the_angle_behind_mirrors_less() -> None:
    """On the way in that angle is smaller: less is mirrored, most of all at the rim."""
    right, wrong = reflected_share(), reflected_share("fresnel-from-the-other-side")
    head_on = ((INDEX - 1) / (INDEX + 1)) ** 2
    assert (wrong <= right + 1e-15).all() and (wrong >= head_on - 1e-15).all()
    assert right.max() > 1.5 * wrong.max()


def test_glass_shadows_like_stone_are_another_scenes() -> None:
    """What the scene lets pass is stopped."""
    one = scene("08-glass")
    stone = replace(one, render=replace(one.render, glass_shadows="opaque"))
    assert_array_equal(colours(one, "glass-shadow-opaque"), colours(stone))


LINEAR = np.array([[-0.1, 0.0, 0.5], [0.999, 1.0, 1.1]])


def made(*mistakes: str) -> list[list[int]]:
    return to_bytes(LINEAR, frozenset(mistakes)).tolist()  # type: ignore[no-any-return]


def test_bytes() -> None:
    """255 c is 127.5 and 254.745: rounded, cut off, with gamma (255 x 0.5^(1 / 2.2) = 186.1),
    wrapped round (281 is 25, -25 is 231), and in the order blue, green, red."""
    assert made() == [[0, 0, 128], [255, 255, 255]]
    assert made("truncated") == [[0, 0, 127], [254, 255, 255]]
    assert made("gamma-applied") == [[0, 0, 186], [255, 255, 255]]
    assert made("not-clamped") == [[231, 0, 128], [255, 255, 25]]
    assert made("red-and-blue-swapped") == [[128, 0, 0], [255, 255, 255]]
    assert made("not-clamped", "truncated") == [[230, 0, 127], [254, 255, 24]]
