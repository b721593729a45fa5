"""Shadows, lights, checkers, backgrounds and scenes that lack something."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.geometry.by_hand import CHALK, CLEAR, SHAPES, moved, scene_of, unit

from raywalk.scene.model import Checker, Light, Material, Scene, SceneObject
from raywalk.scene.read import read_scene
from raywalk.scene.shapes import Box, Disc, Plane, Shape, Sphere, Triple
from raywalk.trace.tree import Visibility
from raywalk.trace.wave import Wave
from raywalk.trace.wavefront import Tracer, trace_scene

FLOOR = SceneObject("floor", Plane((0, 0, 0), (0, 1, 0)), 0)
LAMP = Light("lamp", (0.0, 4.0, 0.0))
GRID = 21


def from_above(
    objects: list[SceneObject], materials: list[Material], lights: list[Light], **render: Any
) -> Scene:
    """Seen from (0, 3, 3), looking at the origin."""
    return scene_of(
        objects, materials, lights, eye=(0.0, 3.0, 3.0), size=GRID, resolutions=(GRID,), **render
    )


def first_wave(scene: Scene) -> Wave:
    size = scene.render.size
    return Tracer(scene).waves(np.arange(size * size), size, size)[0]


def test_an_empty_scene_is_its_background() -> None:
    """No object, no light: every pixel is the background, 8-bit value round(255 c)."""
    result = trace_scene(scene_of(background=(0.2, 0.4, 1.0)))
    assert np.unique(result.picture.reshape(-1, 3), axis=0).tolist() == [[51, 102, 255]]
    assert (result.tree.object == -1).all()
    assert result.tree.visibility.shape[1] == 0


def test_without_lights_only_the_ambient_colour_is_left() -> None:
    """Objects are seen, by ka alone."""
    wave = first_wave(scene_of([Sphere((0, 0, 0), 1.0)]))
    met = wave.hits.object >= 0
    assert np.unique(wave.colour[met]).tolist() == [0.1]
    assert np.unique(wave.colour[~met]).tolist() == [0.0]


def test_a_scene_without_shadows_shoots_no_shadow_ray() -> None:
    """Every light counts as untested, and lights through a wall."""
    roof = SceneObject("roof", Box((-9, 2, -9), (9, 2.5, 1)), 0)
    wave = first_wave(from_above([FLOOR, roof], [CHALK], [LAMP], shadows=False))
    floor = wave.hits.object == 0
    assert floor.any()
    assert (wave.lighting.visibility[floor] == Visibility.UNTESTED).all()
    p = wave.hits.point[floor]
    cosine = 4.0 / np.sqrt(p[:, 0] ** 2 + p[:, 2] ** 2 + 16)
    np.testing.assert_allclose(wave.colour[floor, 0], 0.1 + cosine, rtol=0, atol=1e-15)


def test_light_falls_off_as_it_says() -> None:
    """A floor under a lamp at height 4, a = (1, 0.5, 0.25): 0.1 + cos / (1 + D/2 + D^2/4)."""
    lamp = replace(LAMP, intensity=3.0, attenuation=(1.0, 0.5, 0.25))
    wave = first_wave(from_above([FLOOR], [CHALK], [lamp]))
    met = wave.hits.object == 0
    p = wave.hits.point[met]
    far = np.sqrt(p[:, 0] ** 2 + p[:, 2] ** 2 + 16)
    expected = 0.1 + 3.0 * (4.0 / far) / (1 + far / 2 + far**2 / 4)
    np.testing.assert_allclose(wave.colour[met, 1], expected, rtol=0, atol=1e-15)


@pytest.mark.parametrize("normal", [(0, 1, 0), (0, -1, 0), (0.2, 1, -0.1), (1, 0.1, 0.3)])
def test_a_checker_has_its_squares_where_the_model_says(normal: Triple) -> None:
    """floor(u / size) + floor(v / size), u and v along the two axes left when the normal's largest
    component is dropped, each made perpendicular to the normal, in their order."""
    point = (0.3, -0.2, 0.1)
    floor = SceneObject("floor", Plane(point, normal), 0, checker=Checker(0.5, 1))
    wave = first_wave(from_above([floor], [CHALK, replace(CHALK, name="odd")], []))
    met = wave.hits.object == 0
    n = unit(np.array(normal, float))
    first, second = (k for k in range(3) if k != int(np.argmax(np.abs(n))))
    u = unit(np.eye(3)[first] - n[first] * n)
    v = np.eye(3)[second] - n[second] * n
    v = unit(v - (v @ u) * u)
    at = wave.hits.point[met] - point
    cells = np.floor(at @ u / 0.5) + np.floor(at @ v / 0.5)
    clear = np.abs(np.stack([at @ u, at @ v]) / 0.5 % 1 - 0.5).max(axis=0) < 0.5 - 1e-9
    assert clear.mean() > 0.95
    assert (wave.hits.material[met] == cells % 2)[clear].all()
    assert 0.2 < (cells % 2).mean() < 0.8


@pytest.mark.parametrize(("mode", "left"), [("opaque", 0.0), ("pass", 0.8**2)])
def test_glass_stops_light_or_lets_a_share_pass_each_surface(mode: str, left: float) -> None:
    """Under a glass plate with transmit 0.8 a floor gets nothing, or 0.8 squared of the lamp."""
    pane = replace(CLEAR, name="pane", transmit=0.8, fresnel=False)
    plate = SceneObject("plate", Box((-9, 3, -9), (9, 3.2, 9)), 1)
    scene = scene_of(
        [FLOOR, plate], [CHALK, pane], [LAMP], eye=(0.0, 2.0, 2.0), size=GRID, resolutions=(GRID,),
        glass_shadows=mode,
    )  # fmt: skip
    wave = first_wave(scene)
    met = wave.hits.object == 0
    p = wave.hits.point[met]
    expected = 0.1 + left * 4.0 / np.sqrt(p[:, 0] ** 2 + p[:, 2] ** 2 + 16)
    np.testing.assert_allclose(wave.colour[met, 0], expected, rtol=0, atol=1e-15)
    state = Visibility.REACHED if left else Visibility.BLOCKED
    assert (wave.lighting.visibility[met] == state).all()


def test_light_that_passed_glass_is_still_stopped_by_a_wall() -> None:
    """Floor, glass plate, wall, lamp: blocked by the wall, at the wall's share of the way."""
    wall = SceneObject("wall", Box((-9, 3.5, -9), (9, 3.6, 9)), 0)
    plate = SceneObject("plate", Box((-9, 3, -9), (9, 3.2, 9)), 1)
    scene = scene_of(
        [FLOOR, plate, wall], [CHALK, CLEAR], [LAMP], eye=(0.0, 2.0, 2.0), size=GRID,
        resolutions=(GRID,), glass_shadows="pass",
    )  # fmt: skip
    wave = first_wave(scene)
    met = wave.hits.object == 0
    assert (wave.lighting.blocker[met] == 2).all()
    np.testing.assert_allclose(wave.lighting.blocked_at[met], 3.5 / 4.0, rtol=1e-14)


SCENE = """
version = 1
title = "Area light"
teaches = "x"
[camera]
eye = [0, 3, 3]
target = [0, 0, 0]
[render]
size = 21
resolutions = [21]
[[objects]]
type = "plane"
point = [0, 0, 0]
normal = [0, 1, 0]
material = "white"
[[objects]]
type = "sphere"
center = [0, 1, 0]
radius = 0.5
material = "coloured"
"""


def test_an_area_light_is_the_sum_of_its_point_lights(tmp_path: Path) -> None:
    """A 3 x 2 grid over its parallelogram: the same picture, to rounding, as six lamps of a sixth
    of its intensity in the middles of the cells."""

    def colours(name: str, lights: str) -> np.ndarray:
        folder = tmp_path / name
        folder.mkdir()
        (folder / "scene.toml").write_text(SCENE + lights)
        return first_wave(read_scene(folder)).colour

    area = colours(
        "90-area",
        "[[lights]]\nposition = [-1, 4, -1]\nedges = [[2, 0, 0], [0, 0, 1]]\nsamples = [3, 2]\n"
        "intensity = 1.2\n",
    )
    middles = [(-1 + 2 * (i + 0.5) / 3, 4, -1 + (j + 0.5) / 2) for j in range(2) for i in range(3)]
    lamps = "".join(
        f"[[lights]]\nname = 'l{k}'\nposition = {list(p)}\nintensity = 0.2\n"
        for k, p in enumerate(middles)
    )
    np.testing.assert_allclose(area, colours("91-lamps", lamps), rtol=0, atol=1e-15)


@pytest.mark.parametrize(
    ("scale", "offset"), [(1e-4, 0.0), (1e-4, 1e3), (1.0, 0.0), (1.0, 1e7), (1e4, 0.0), (1e4, 1e7)]
)
def test_a_light_on_a_surface_shines_from_there(scale: float, offset: float) -> None:
    """A lamp exactly on top of a ball lights the plane above it, a lamp 1e-6 r below the top does
    not, one 1e-6 r above does, at any scale and place."""
    middle = np.array([offset, 0.0, -offset])

    def at(x: float, y: float, z: float) -> Triple:
        return (
            float(middle[0] + scale * x),
            float(middle[1] + scale * y),
            float(middle[2] + scale * z),
        )

    ball = SceneObject("ball", Sphere(at(0, 0, 0), scale), 0)
    ceiling = SceneObject("ceiling", Disc(at(0, 3, 0), (0, -1, 0), 2 * scale), 0)
    for height, lit in [(1.0, True), (1 + 1e-6, True), (1 - 1e-6, False)]:
        scene = scene_of(
            [ball, ceiling], [CHALK], [Light("lamp", at(0, height, 0))], eye=at(0, 1.5, 5),
            target=at(0, 2.5, 0), size=GRID, resolutions=(GRID,),
        )  # fmt: skip
        wave = first_wave(scene)
        met = wave.hits.object == 1
        assert met.any()
        expected = Visibility.REACHED if lit else Visibility.BLOCKED
        assert (wave.lighting.visibility[met] == expected).all(), height


def test_a_light_on_the_floor_lights_no_floor() -> None:
    """It lies in the plane: no point of the floor faces it, none is NaN, one may be the lamp's."""
    wave = first_wave(from_above([FLOOR], [CHALK], [Light("lamp", (0.0, 0.0, 0.0))]))
    met = wave.hits.object == 0
    assert np.abs(wave.hits.point[met]).sum(axis=1).min() < 1e-15  # the middle ray ends in the lamp
    assert np.isfinite(wave.colour).all()
    np.testing.assert_allclose(wave.colour[met], 0.1, rtol=0, atol=1e-12)


@pytest.mark.parametrize("seed", range(6), ids="seed {}".format)
def test_random_scenes_show_no_acne(seed: int) -> None:
    """Any shape at any scale and place, a lamp beside the eye: every point that is seen and faces
    the lamp is lit, but where another part of an open shape really stands between."""
    for kind, shape in SHAPES.items():
        rng = np.random.default_rng([seed, *kind.encode()])  # a new shape changes no other's rays
        scale, far = 10.0 ** rng.uniform(-6, 6), 10.0 ** rng.uniform(-3, 6)
        middle = scale * far * unit(rng.normal(size=3))

        def at(offset: np.ndarray, scale: float = scale, middle: np.ndarray = middle) -> Triple:
            x, y, z = middle + scale * offset
            return float(x), float(y), float(z)

        placed: Shape = moved(shape, scale, middle)
        eye = 6 * unit(rng.normal(size=3))
        scene = scene_of(
            [placed], [CHALK], [Light("lamp", at(eye))], eye=at(eye), target=at(np.zeros(3)),
            size=GRID, resolutions=(GRID,),
        )  # fmt: skip
        wave = first_wave(scene)
        met = wave.hits.object == 0
        facing = wave.lighting.visibility[met, 0] != Visibility.BEHIND
        assert facing.mean() > 0.95, kind  # the lamp is where the eye is
        assert (wave.lighting.visibility[met, 0] != Visibility.BLOCKED).all(), kind


def test_colours_are_clamped_and_rounded_at_the_end_only() -> None:
    """Two lamps of 0.7 straight above a point: 0.1 + 1.4 is 255, and 0.1 is 26 = round(25.5)."""
    lamps = [replace(LAMP, name=f"lamp {k}", intensity=0.7) for k in range(2)]
    result = trace_scene(from_above([FLOOR], [CHALK], lamps))
    middle = result.tree.colour[GRID * GRID // 2]
    assert middle[0] == pytest.approx(1.5, abs=1e-15)
    assert result.picture[GRID // 2, GRID // 2].tolist() == [255, 255, 255]
    dark = trace_scene(from_above([FLOOR], [CHALK], []))
    assert dark.picture[GRID // 2, GRID // 2].tolist() == [26, 26, 26]
    assert math.floor(255 * 0.1 + 0.5) == 26


@pytest.mark.parametrize("glass_shadows", ["block", "pass"])
def test_lights_asked_together_answer_as_one_by_one(
    glass_shadows: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Four lamps, of which a dark one is not asked: all at once, by twos, and one after the other,
    bit for bit."""
    ball = SceneObject("ball", Sphere((0.0, 1.0, 0.0), 0.7), 1)
    lamps = [
        replace(LAMP, position=(x, 4.0, z), intensity=bright)
        for x, z, bright in [(0.0, 1.0, 1.0), (2.0, 0.0, 0.0), (-2.0, 1.0, 0.5), (1.0, -2.0, 2.0)]
    ]
    scene = from_above([FLOOR, ball], [CHALK, CLEAR], lamps, glass_shadows=glass_shadows)
    found = []
    for pairs in (1 << 20, 2 * GRID * GRID, 1):
        monkeypatch.setattr("raywalk.trace.lighting.PAIRS", pairs)
        found.append(first_wave(scene))
    for other in found[1:]:
        for column in ("visibility", "blocker", "blocked_at", "passed", "diffuse", "specular"):
            mine, theirs = (getattr(wave.lighting, column) for wave in (found[0], other))
            np.testing.assert_array_equal(mine, theirs, err_msg=column)
        np.testing.assert_array_equal(found[0].colour, other.colour)
