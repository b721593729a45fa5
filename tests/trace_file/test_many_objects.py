"""What a scene of many objects costs grows with what its rays meet, not with all pairs."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest
from tests.geometry.by_hand import CHALK, scene_of

from raywalk.geometry.cross_section import Cut, Outline, Sliced
from raywalk.scene.model import Light, Scene, SceneObject
from raywalk.scene.shapes import Sphere
from raywalk.trace.sections import sections_of
from raywalk.trace.wavefront import Tracer, trace_picture
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of

SIZE = 105


def cloud(count: int, seed: int) -> Scene:
    """So many small balls in a cube, which hide as much of one another however many they are."""
    rng = np.random.default_rng(seed)
    places = rng.uniform(-1.5, 1.5, (count, 3)).tolist()
    radius = 0.9 / np.sqrt(count)
    balls = [SceneObject(f"{k}", Sphere(tuple(at), radius), 0) for k, at in enumerate(places)]
    return scene_of(balls, [CHALK], [Light("lamp", (3, 5, 4))], size=SIZE, resolutions=(5, 35, 105))


def peak_of_a_file(count: int) -> tuple[int, int]:
    """Bytes that writing the finest trace file takes at most, and how many depth images it has."""
    scene = cloud(count, seed=20261129)
    traced = trace_picture(Tracer(scene), 1)
    level = level_of(traced.tree, SIZE)
    encode(level, scene, traced.picture)  # kernels are compiled
    images = len(set(zip(level.hits_object.tolist(), strict=True)))
    tracemalloc.start()
    encode(level, scene, traced.picture)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return peak, images


def test_memory_of_a_trace_file_does_not_grow_with_its_depth_images() -> None:
    """Twelve times as many objects in as many pixels: each was an image of all pixels once, and
    then it is ten times the memory."""
    small, few = peak_of_a_file(100)
    large, many = peak_of_a_file(1200)
    assert many > 6 * few
    assert large < 2.5 * small


@pytest.mark.parametrize("count", [100, 1200])
def test_a_plane_asks_only_objects_that_it_may_cut(
    monkeypatch: pytest.MonkeyPatch, count: int
) -> None:
    """A ball is within its radius of a plane: those that are asked are cut."""
    asked = cut = 0
    ask = Sliced.outlines

    def counted(self: Sliced, plane: Cut) -> list[Outline]:
        nonlocal asked, cut
        found = ask(self, plane)
        asked, cut = asked + 1, cut + len(found)
        return found

    monkeypatch.setattr(Sliced, "outlines", counted)
    sections_of(Tracer(cloud(count, seed=20261129)))
    assert cut > count
    assert asked <= 1.01 * cut
