"""Light in a glass mesh of several shells: what is inside is counted, not the last face's word."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from tests.geometry.by_hand import CLEAR, mesh_of, scene_of, unit
from tests.models.solids import cube, obj_text, triangles, written

from raywalk.errors import SourceErrors
from raywalk.geometry.compiled import CompiledScene
from raywalk.scene.model import Scene
from raywalk.trace.wavefront import Tracer


def glass(folder: Path, *cubes: np.ndarray, turned: int = -1) -> Scene:
    """A scene of one glass mesh of these cubes; one may be wound inside out."""
    text = "".join(
        obj_text(corners, triangles()[:, ::-1] if k == turned else triangles(), 8 * k + 1)
        for k, corners in enumerate(cubes)
    )
    return scene_of([mesh_of(written(folder / "made.obj", text))], (CLEAR,), depth=12)


def sines(scene: Scene, origin: tuple[float, ...], direction: np.ndarray) -> list[float]:
    """Sine before over sine after, at each face of a ray's strongest way through the scene."""
    rays = Tracer(scene).follow(np.array([origin], float), unit(direction[None]))
    found, row = [], 0
    for before, after in pairwise(rays):
        children = np.flatnonzero(after.parent == row)
        if not len(children):
            break
        row, last = int(children[after.weight[children].argmax()]), row
        normal = before.hits.normal[last]
        out = np.linalg.norm(np.cross(after.rays.direction[row], normal))
        found.append(float(np.linalg.norm(np.cross(before.rays.direction[last], normal)) / out))
    return found


SLANT = np.array([0.0645, -0.0323, -1.0])
IOR = 1.5168


def test_glass_in_glass_of_one_mesh_is_no_border(tmp_path: Path) -> None:
    """A cube in a cube, both outward: bent at the outer faces only, and parallel behind them. An
    error would be 0.66 at the third."""
    scene = glass(tmp_path, cube(), cube(0.3))
    assert sines(scene, (0.01, 0.02, 4), SLANT) == pytest.approx([IOR, 1, 1, 1 / IOR], abs=1e-12)


def test_a_hollow_in_glass_is_air(tmp_path: Path) -> None:
    """The inner cube wound inwards bounds a hollow: out of glass there, and into it again."""
    scene = glass(tmp_path, cube(), cube(0.3), turned=1)
    found = sines(scene, (0.01, 0.02, 4), SLANT)
    assert found == pytest.approx([IOR, 1 / IOR, IOR, 1 / IOR], abs=1e-12)


def test_overlapping_shells_are_one_body(tmp_path: Path) -> None:
    """Two cubes of which a part is in both: no border inside, however the ray goes."""
    scene = glass(tmp_path, cube(), cube(0.5, (0.1, 0.05, -0.4)))
    assert sines(scene, (0.01, 0.02, 4), SLANT) == pytest.approx([IOR, 1, 1, 1 / IOR], abs=1e-12)


def test_a_part_that_was_inside_out_bends_as_the_other(tmp_path: Path) -> None:
    """Two cubes one behind the other, the first wound inside out."""
    scene = glass(tmp_path, cube(at=(0, 0, 1)), cube(at=(0, 0, -1)), turned=0)
    found = sines(scene, (0.01, 0.02, 4), SLANT)
    assert found == pytest.approx([IOR, 1 / IOR, IOR, 1 / IOR], abs=1e-12)


def test_no_ray_keeps_glass_that_it_has_left(rng: np.random.Generator, tmp_path: Path) -> None:
    """2,000 rays through three cubes in one another and one across them, at edges and corners too:
    each that leaves the scene has an empty stack of media."""
    scene = glass(
        tmp_path, cube(), cube(0.4, (0.02, 0, 0.01)), cube(0.2), cube(0.45, (0.3, 0.2, 0.1))
    )
    corners = CompiledScene(scene).meshes[0].corners.reshape(-1, 3)
    target = corners[rng.integers(len(corners), size=2000)]
    target = np.where(rng.random((2000, 1)) < 0.5, target, rng.uniform(-0.6, 0.6, (2000, 3)))
    origin = 3 * unit(rng.normal(size=(2000, 3)))
    centre = CompiledScene(scene).meshes[0].centre
    for wave in Tracer(scene).follow(origin, unit(target + centre - origin)):
        gone = wave.hits.object < 0
        assert (wave.media[gone] == -1).all()


def test_open_glass_is_refused_with_where_it_is_open(tmp_path: Path) -> None:
    """How many edges, the place of one, and what helps."""
    faces = triangles()
    lid = (cube()[faces][:, :, 1] == 0.5).all(axis=1)
    text = obj_text(cube(), faces[~lid])
    scene = scene_of([mesh_of(written(tmp_path / "made.obj", text))], (CLEAR,))
    with pytest.raises(SourceErrors, match=r"4 open edges, the first at \[0, 0\.5, -0\.5\]"):
        CompiledScene(scene)
