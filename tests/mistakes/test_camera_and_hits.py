"""What mistakes with camera rays, hits and normals do: each by what follows from it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from tests.geometry.by_hand import CHALK, CLEAR, scene_of

from raywalk.mistakes.camera import camera_directions, picture_span
from raywalk.mistakes.habits import Habits
from raywalk.mistakes.tracer import Wave, picture, trace
from raywalk.scene.model import Light, Scene
from raywalk.scene.shapes import Ellipsoid, Plane, Shape, Sphere
from raywalk.trace.tree import Visibility

from .course import scene

N = 15
MIDDLE = np.array([N * (N // 2) + N // 2])  # looks along -z exactly, from (0, 0, 5)
LAMP = Light("lamp", (-3.0, 4.0, 5.0))
BACK = Plane((0, 0, -3), (0, 0, 1))


def waves(one: Scene, *mistakes: str, pixels: np.ndarray = MIDDLE) -> list[Wave]:
    return trace(one, N, pixels, frozenset(mistakes))[1]


def first(objects: list[Shape], *mistakes: str, **more: Any) -> Wave:
    """The camera ray along -z into these shapes of chalk."""
    return waves(scene_of(objects, lights=[LAMP], **more), *mistakes)[0]


def shown(one: Scene, *mistakes: str) -> np.ndarray:
    return picture(one, 33, frozenset(mistakes)).bytes.astype(int)


def assert_alike(one: np.ndarray, other: np.ndarray) -> None:
    """But for pixels that hang on a rounding, such as those on scene 3's horizon."""
    assert (np.abs(one - other).max(axis=2) <= 1).mean() > 0.96


@pytest.mark.parametrize("name", ["02-shadows", "03-two-lights", "05-many-bounces"])
def test_a_wrong_way_of_counting_turns_the_picture(name: str) -> None:
    """Upside down, mirrored, and with rows for columns."""
    right = shown(scene(name))
    assert_alike(shown(scene(name), "upside-down"), right[::-1])
    assert_alike(shown(scene(name), "mirrored"), right[:, ::-1])


def test_rows_for_columns_is_the_transposed_picture() -> None:
    """The ray of (i, j) goes where that of (j, i) should; together with both flips it is turned."""
    right = shown(scene("01-shading"))
    swapped = shown(scene("01-shading"), "rows-and-columns-swapped")
    # Down and right change places: x grows downwards and y to the right, in the picture's plane.
    _, across, down = picture_span(scene("01-shading").camera, 33)
    wrong = picture_span(scene("01-shading").camera, 33, frozenset(["rows-and-columns-swapped"]))
    assert_array_equal(wrong.right, down)
    assert_array_equal(wrong.down, across)
    assert_alike(swapped, right.transpose(1, 0, 2))


def test_a_wrong_field_of_view_is_another_cameras() -> None:
    """tan(f) for tan(f / 2) sees twice the angle; degrees for radians what 22.5 radians see."""
    one = scene("01-shading")
    wide = replace(one, camera=replace(one.camera, fov=2 * one.camera.fov))
    assert_array_equal(shown(one, "fov-not-halved"), shown(wide))
    seen = 2 * np.degrees(np.arctan(np.tan(22.5)))
    odd = replace(one, camera=replace(one.camera, fov=float(seen)))
    assert_alike(shown(one, "fov-in-radians"), shown(odd))


def test_a_pixels_corner_is_half_a_pixel_up_and_left() -> None:
    """The first ray goes through the picture's corner."""
    camera = scene("01-shading").camera
    forward, right, down = picture_span(camera, N)
    corner = forward - right - down
    wrong = camera_directions(camera, N, np.array([0]), frozenset(["pixel-corner"]))[:, 0]
    assert_allclose(wrong, corner / np.linalg.norm(corner), rtol=0, atol=1e-15)


def test_a_wrong_aspect_stretches_sideways() -> None:
    """x / z is 4 / 3 of what it was, y / z is as before."""
    camera, pixels = scene("01-shading").camera, np.arange(N * N)
    right = camera_directions(camera, N, pixels)
    wrong = camera_directions(camera, N, pixels, frozenset(["aspect"]))
    assert_allclose(wrong[0] / wrong[2], 4 / 3 * right[0] / right[2], rtol=1e-13)
    assert_allclose(wrong[1] / wrong[2], right[1] / right[2], rtol=1e-13)


def test_directions_that_are_not_unit_make_balls_too_large() -> None:
    """|d|^2 is 1 + x^2 + y^2; b^2 - q takes it for 1, so rays beside a ball meet it."""
    camera, pixels = scene("01-shading").camera, np.arange(N * N)
    long = camera_directions(camera, N, pixels, frozenset(["direction-not-unit"]))
    assert_allclose(long[2], -1, rtol=0, atol=1e-15)
    ball = scene_of([Sphere((0, 0, 0), 1.0)], lights=[LAMP])
    right = waves(ball, pixels=pixels)[0].hits.object
    wrong = waves(ball, "direction-not-unit", pixels=pixels)[0].hits.object
    assert (wrong >= right).all() and (wrong > right).any()


def test_which_hit_is_taken() -> None:
    """Two balls and a wall behind one another, listed from back to front: 4 to the near ball's
    front, 6 to its back, 7 to the far one, 8 to the wall."""
    listed: list[Shape] = [BACK, Sphere((0, 0, -2.5), 0.5), Sphere((0, 0, 0), 1.0)]
    taken = {name: float(first(listed, *name.split()).hits.t[0]) for name in (
        "", "first-in-list", "farthest-hit", "far-root", "far-root farthest-hit",
    )}  # fmt: skip
    assert taken == {
        "": 4.0, "first-in-list": 8.0, "farthest-hit": 8.0, "far-root": 6.0,
        "far-root farthest-hit": 8.0,
    }  # fmt: skip
    assert first(listed[::-1], "first-in-list").hits.t[0] == 4.0  # from front to back it is right


def test_what_is_behind_the_eye_is_seen() -> None:
    """A ball 2 behind it at t = -3, before whatever is in front."""
    balls: list[Shape] = [Sphere((0, 0, 0), 1.0), Sphere((0, 0, 7), 1.0)]
    wave = first(balls, "behind-the-eye")
    assert (wave.hits.object[0], wave.hits.t[0]) == (1, -3.0)
    offset = trace(scene_of(balls, lights=[LAMP]), N, np.arange(N * N),
                   frozenset(["behind-the-eye"]), Habits(offset=1e-3))[1][0]  # fmt: skip
    assert (offset.lighting.visibility == Visibility.REACHED).any()  # its shadow rays look ahead


def test_t_of_another_scale_hides_what_is_flat() -> None:
    """An ellipsoid a tenth as thick, at t = 4.9: in its own coordinates, where it is a unit ball,
    that is 49, and the ball at 5.5 behind it wins."""
    flat, ball = Ellipsoid((0, 0, 0), (1, 1, 0.1)), Sphere((0, 0, -1.5), 1.0)
    assert first([flat, ball]).hits.object[0] == 0
    assert first([flat, ball], "t-of-own-scale").hits.object[0] == 1


def test_rays_inside_glass_find_no_way_out() -> None:
    """With the smaller root alone the ray that went in meets the wall next, at 4 + 4 = 8."""
    objects = [Sphere((0, 0, 0), 1.0), BACK]
    glass = scene_of(objects, [CLEAR], [LAMP], depth=1)
    inside = [wave.hits for wave in (waves(glass)[1], waves(glass, "inside-hits-lost")[1])]
    through = [hits.t[hits.inside | (hits.object == 1)] for hits in inside]
    assert_allclose([t[-1] for t in through], [2.0, 4.0], rtol=0, atol=1e-15)


ASKEW = np.array([N * 6 + 6])  # up and left of the middle


def normal(shape: Shape, *mistakes: str) -> tuple[np.ndarray, Wave]:
    wave = waves(scene_of([shape], lights=[LAMP]), *mistakes, pixels=ASKEW)[0]
    return wave.hits.normal[:, 0], wave


def test_normals_keep_a_balls_radius() -> None:
    """p - c is as long as the ball's radius, and so n.l is that much too large."""
    ball = Sphere((0, 0, 0), 0.8)
    (right, lit), (wrong, bright) = normal(ball), normal(ball, "normal-not-unit")
    assert_allclose(wrong, 0.8 * right, rtol=0, atol=1e-15)
    assert_allclose(bright.lighting.diffuse, 0.8 * lit.lighting.diffuse, rtol=1e-14)


def test_normals_turned_as_points_are_p_minus_c() -> None:
    """M M^-1 (p - c): right for a ball, and not for what is stretched."""
    egg = Ellipsoid((0.1, 0, 0), (1.0, 0.5, 0.8))
    wrong, wave = normal(egg, "normal-not-by-inverse-transpose")
    away = wave.hits.point[:, 0] - (0.1, 0, 0)
    assert_allclose(wrong, away / np.linalg.norm(away), rtol=0, atol=1e-15)
    assert np.abs(wrong - normal(egg)[0]).max() > 0.1
    ball = Ellipsoid((0.1, 0, 0), (0.7, 0.7, 0.7))
    turned = normal(ball, "normal-not-by-inverse-transpose")[0]
    assert_allclose(turned, normal(ball)[0], rtol=0, atol=1e-15)


def test_normals_inwards_leave_a_ball_dark() -> None:
    """They point away from the ray and from the lamp: a lit face is in its own shadow."""
    ball = Sphere((0, 0, 0), 1.0)
    (right, lit), (wrong, dark) = normal(ball), normal(ball, "normal-inwards")
    assert_array_equal(wrong, -right)
    assert lit.lighting.visibility[0, 0] == Visibility.REACHED
    assert dark.lighting.visibility[0, 0] == Visibility.BEHIND


def test_normals_that_are_not_turned_look_along_rays_inside_glass() -> None:
    """Outside nothing changes; inside d.n > 0."""
    glass = scene_of([Sphere((0, 0, 0), 1.0)], [CLEAR], [LAMP], depth=1)
    outside, inside = waves(glass, "normal-not-turned", pixels=ASKEW)
    assert_array_equal(outside.hits.normal, waves(glass, pixels=ASKEW)[0].hits.normal)
    is_in = inside.hits.inside
    along = (inside.sent.rays.direction * inside.hits.normal).sum(axis=0)
    assert is_in.any() and (along[is_in] > 0).all()
    assert CHALK.diffuse == (1.0, 1.0, 1.0)
