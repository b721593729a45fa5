"""What mistakes with light and shadows do: each by what follows from it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from tests.geometry.by_hand import scene_of

from raywalk.mistakes.habits import EXACT, Habits
from raywalk.mistakes.tracer import Wave, picture, trace
from raywalk.scene.model import Light, Material, Scene, SceneObject
from raywalk.scene.shapes import Disc, Plane, Sphere
from raywalk.trace.tree import Visibility

N = 33
SHINY = Material("shiny", (0.1, 0.2, 0.3), (0.5, 0.6, 0.7), (1.0, 0.8, 0.6), 20.0)
BALL = Sphere((0, 0, 0), 1.0)
LAMP = Light("lamp", (-3.0, 4.0, 5.0), intensity=0.7)
BEHIND = Light("second", (4.0, 1.0, -2.0), intensity=0.4)


def ball(*lights: Light, shadows: bool = False) -> Scene:
    """A shiny ball before nothing."""
    return scene_of([BALL], [SHINY], lights or (LAMP,), shadows=shadows)


class Lit:
    """The hits on the ball, with what the formulas speak of."""

    def __init__(self, one: Scene, *mistakes: str, habits: Habits = EXACT):
        self.wave: Wave = trace(one, N, np.arange(N * N), frozenset(mistakes), habits)[1][0]
        rows = np.flatnonzero(self.wave.hits.object >= 0)
        hits, light = self.wave.hits.take(rows), self.wave.lighting
        self.diffuse, self.specular = light.diffuse[0, rows], light.specular[0, rows]
        self.visibility, self.local = light.visibility[:, rows], light.local[:, rows]
        self.blocker, self.at = light.blocker[:, rows], light.blocked_at[:, rows]
        way = np.array(one.lights[0].position)[:, None] - hits.point
        self.far = np.sqrt((way**2).sum(axis=0))
        self.n, self.l, self.e = (
            hits.normal,
            way / self.far,
            -self.wave.sent.rays.direction[:, rows],
        )
        self.object = hits.object


def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.asarray((a * b).sum(axis=0))


def unit(a: np.ndarray) -> np.ndarray:
    return np.asarray(a / np.sqrt(dot(a, a)))


def assert_factors(mistake: str, diffuse: object, specular: object) -> None:
    """I times these two functions of n, l, e and D."""
    found = Lit(ball(), mistake)
    n, l, e, far = found.n, found.l, found.e, found.far
    assert_allclose(found.diffuse, 0.7 * diffuse(n, l, e, far), rtol=0, atol=1e-12)  # type: ignore[operator]
    wanted = 0.7 * specular(n, l, e, far)  # type: ignore[operator]
    assert_allclose(found.specular, wanted, rtol=1e-12, atol=1e-12)


def lambert(n: np.ndarray, l: np.ndarray, e: np.ndarray, far: np.ndarray) -> np.ndarray:
    return np.maximum(0, dot(n, l))


def shine(n: np.ndarray, h: np.ndarray, s: float = 20.0) -> np.ndarray:
    return np.maximum(0, dot(n, h)) ** s


def blinn(n: np.ndarray, l: np.ndarray, e: np.ndarray, far: np.ndarray) -> np.ndarray:
    return shine(n, unit(l + e))


@pytest.mark.parametrize(("mistake", "diffuse", "specular"), [
    ("cosine-not-clamped", lambda n, l, e, far: dot(n, l), blinn),
    ("cosine-absolute", lambda n, l, e, far: np.abs(dot(n, l)), blinn),
    ("light-reversed", lambda n, l, e, far: np.maximum(0, -dot(n, l)),
     lambda n, l, e, far: shine(n, unit(e - l))),
    ("light-not-unit", lambda n, l, e, far: far * lambert(n, l, e, far),
     lambda n, l, e, far: shine(n, unit(far * l + e))),
    ("view-reversed", lambert, lambda n, l, e, far: shine(n, unit(l - e))),
    ("phong-for-blinn", lambert, lambda n, l, e, far: shine(e, 2 * dot(n, l) * n - l)),
    ("half-not-unit", lambert, lambda n, l, e, far: np.minimum(1000, shine(n, l + e))),
    ("exponent-wrong", lambert, lambda n, l, e, far: shine(n, unit(l + e), 5.0)),
    ("exponent-forgotten", lambert, lambda n, l, e, far: shine(n, unit(l + e), 1.0)),
])  # fmt: skip
def test_light_factors_follow_the_wrong_formula(
    mistake: str, diffuse: object, specular: object
) -> None:
    """Of a ball without shadows; the highlight of a half vector left long is cut at 1000."""
    assert_factors(mistake, diffuse, specular)


def colours(one: Scene, *mistakes: str) -> np.ndarray:
    return picture(one, N, frozenset(mistakes)).linear


def with_material(one: Scene, **keys: object) -> Scene:
    return replace(one, materials=(replace(SHINY, **keys),))  # type: ignore[arg-type]


def test_colours_left_out_or_added_twice_are_another_materials() -> None:
    """Ambient, highlights and their product with the diffuse colour."""
    one, two = ball(), ball(LAMP, BEHIND)
    black = (0.0, 0.0, 0.0)
    same = {
        "ambient-forgotten": with_material(one, ambient=black),
        "highlight-forgotten": with_material(one, specular=black),
        "specular-times-diffuse": with_material(one, specular=(0.5, 0.8 * 0.6, 0.6 * 0.7)),
    }
    for mistake, other in same.items():
        assert_allclose(colours(one, mistake), colours(other), rtol=0, atol=1e-15)
    twice = with_material(two, ambient=(0.2, 0.4, 0.6))
    assert_allclose(colours(two, "ambient-once-a-light"), colours(twice), rtol=0, atol=1e-15)


def test_intensities_left_out_or_averaged_are_other_lamps() -> None:
    """1 for 0.7 and 0.4, and half of each."""
    two = ball(LAMP, BEHIND)
    for mistake, strengths in {
        "intensity-forgotten": (1.0, 1.0),
        "lights-averaged": (0.35, 0.2),
    }.items():
        lamps = [
            replace(lamp, intensity=x) for lamp, x in zip((LAMP, BEHIND), strengths, strict=True)
        ]
        assert_allclose(colours(two, mistake), colours(ball(*lamps)), rtol=0, atol=1e-15)


def test_highlights_on_faces_turned_away() -> None:
    """There n.l is below 0 and (n.h)^s is not: with the mistake it is seen, and nothing else is."""
    one = with_material(ball(BEHIND, shadows=True), shininess=2.0)
    right, wrong = Lit(one), Lit(one, "highlight-turned-away")
    away = dot(right.n, right.l) < 0
    assert (right.visibility[0, away] == Visibility.BEHIND).all()
    added = wrong.local - right.local
    assert_allclose(added[:, ~away], 0, rtol=0, atol=1e-15)
    ks = np.array(SHINY.specular)[:, None]
    assert_allclose(added[:, away], ks * right.specular[away], rtol=0, atol=1e-15)
    assert added[0, away].max() > 0.01


def test_acne_is_a_ball_that_shades_half_of_itself() -> None:
    """Rounded to float32, about half of the starts lie below the surface. Rightly none is blocked:
    there is nothing else."""
    right, wrong = Lit(ball(shadows=True)), Lit(ball(shadows=True), "shadow-acne")
    facing = right.visibility[0] == Visibility.REACHED
    blocked = wrong.visibility[0] == Visibility.BLOCKED
    assert not (right.visibility[0] == Visibility.BLOCKED).any()
    assert 0.3 < blocked[facing].mean() < 0.7
    assert (wrong.blocker[0, blocked] == 0).all() and not blocked[~facing].any()
    floats = Habits(offset=1e-3)  # whoever makes this mistake has no offset
    again = Lit(ball(shadows=True), "shadow-acne", habits=floats)
    assert_array_equal(again.visibility, wrong.visibility)  # the same speckles on every run


def test_a_surface_in_its_own_light_is_black_but_for_ambient() -> None:
    """t >= 0 finds the surface itself, at the start of every shadow ray."""
    found = Lit(ball(shadows=True), "shadow-of-own-surface")
    facing = dot(found.n, found.l) > 0
    assert (found.visibility[0, facing] == Visibility.BLOCKED).all()
    assert (found.at[0, facing] == 0).all()
    assert_allclose(found.local, np.tile(np.array(SHINY.ambient)[:, None], found.local.shape[1]))


FLOOR = SceneObject("floor", Plane((0, -1, 0), (0, 1, 0)), 0)
ABOVE = Light("above", (0.0, 2.0, 0.0))


def room(*objects: SceneObject, lights: tuple[Light, ...] = (ABOVE,)) -> Scene:
    """A floor, seen from (0, 0, 5), under a lamp."""
    return scene_of([FLOOR, *objects], [SHINY], lights)


def blocked(one: Scene, *mistakes: str) -> np.ndarray:
    """(L,) share of the floor's hits where each light is."""
    found = Lit(one, *mistakes)
    return np.asarray((found.visibility[:, found.object == 0] == Visibility.BLOCKED).mean(axis=1))


def test_what_is_beyond_the_light_blocks_it() -> None:
    """A ceiling above the lamp puts the floor into the dark."""
    ceiling = SceneObject("ceiling", Plane((0, 3, 0), (0, -1, 0)), 0)
    assert blocked(room(ceiling)) == 0
    assert blocked(room(ceiling), "shadow-beyond-the-light") == 1


def test_what_is_behind_the_hit_blocks_the_light_that_comes_from_there() -> None:
    """A cellar's floor below: asked from the lamp on, it stands behind every hit."""
    cellar = SceneObject("cellar", Plane((0, -3, 0), (0, 1, 0)), 0)
    assert blocked(room(cellar)) == 0
    assert blocked(room(cellar), "shadow-from-the-light") == 1
    offset = Lit(room(), "shadow-from-the-light", habits=Habits(offset=1e-3))
    assert not (offset.visibility == Visibility.BLOCKED).any()  # not by the floor itself


def test_far_too_large_an_offset_loses_what_is_near() -> None:
    """A disc 0.1 above the floor casts no shadow on it; one at 0.3 does."""
    for height, is_lost in ((0.1, True), (0.3, False)):
        disc = SceneObject("disc", Disc((0, height - 1, 0), (0, 1, 0), 1.0), 0)
        shadow = blocked(room(disc))[0]
        assert shadow > 0.005
        assert (blocked(room(disc), "shadow-offset-too-large")[0] < shadow / 2) == is_lost


def test_full_shadow_takes_the_ambient_colour_away() -> None:
    """Where no light arrives, all is black; elsewhere nothing changes."""
    one = room(SceneObject("ball", Sphere((0, 0, 0), 0.6), 0))
    right, wrong = Lit(one), Lit(one, "shadow-darkens-ambient")
    dark = right.visibility[0] != Visibility.REACHED
    assert dark.any() and (wrong.local[:, dark] == 0).all()
    assert_array_equal(wrong.local[:, ~dark], right.local[:, ~dark])


def test_shadow_rays_to_the_first_light_or_to_none() -> None:
    """The others light everything, unasked."""
    ball_above = SceneObject("ball", Sphere((0, 0, 0), 0.6), 0)
    one = room(ball_above, lights=(ABOVE, replace(ABOVE, position=(0.5, 2.0, 0.0))))
    first = Lit(one, "shadow-of-first-light-only").visibility
    assert_array_equal(first[0], Lit(one).visibility[0])
    assert (first[1] == Visibility.UNTESTED).all()
    assert (Lit(one, "shadows-forgotten").visibility == Visibility.UNTESTED).all()
    unshaded = replace(one, render=replace(one.render, shadows=False))
    assert_array_equal(colours(one, "shadows-forgotten"), colours(unshaded))
