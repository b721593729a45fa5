"""Lesson 02's drawing and figure of a shadow ray that starts below its surface."""

from __future__ import annotations

from math import cos, hypot, pi, sin
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from raywalk.mistake_pages.buried import FILE, drawing, start_of, starts, way_to_surface
from raywalk.mistakes.tracer import trace
from raywalk.pipeline.figures import filled_here
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene
from raywalk.trace.tree import Visibility
from raywalk.work.store import Store

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def scene() -> Scene:
    return read_scene(ROOT / "scenes" / "02-shadows")


def test_half_of_all_lit_pixels_start_below_their_sphere_and_only_those_are_dark(scene) -> None:
    """As the lesson says; of almost 10,000 coins half fall on one side to 0.5 % (one sigma)."""
    n = 231
    depth, _, lit = starts(scene, n)
    wrong = trace(scene, n, np.arange(n * n), frozenset(["shadow-acne"]))[1][0]
    dark = wrong.lighting.visibility.reshape(-1) == int(Visibility.BLOCKED)
    assert lit.sum() > 9000
    assert ((depth[lit] > 0) == dark[lit]).all()
    assert abs(dark[lit].mean() - 0.5) < 0.015


def test_the_lessons_figure_is_that_of_a_program_which_does_so(scene, tmp_path) -> None:
    depth = start_of(scene).depth
    assert 1e-8 < depth < 1e-6
    texts = [step.text for step in filled_here(Store(tmp_path), scene).lesson]
    assert any(f" {depth:.8f} below its own sphere" in text for text in texts)


@pytest.mark.parametrize("below", [1e-7, 0.05, 0.3])
@pytest.mark.parametrize("turn", [0.0, 0.4, pi / 2 - 1e-3])
def test_a_buried_ray_ends_on_its_sphere(below: float, turn: float) -> None:
    way = way_to_surface(below, turn)
    assert way > 0
    end = hypot(way * sin(turn), 1 - below + way * cos(turn))
    assert abs(end - 1) < 1e-15 * 4  # a few roundings of numbers near 1


def test_the_drawing_is_of_what_was_measured(scene) -> None:
    """Edges may come out a little otherwise in another release of what draws them."""
    filed = np.asarray(Image.open(ROOT / FILE).convert("RGB"), int)
    drawn = np.asarray(drawing(start_of(scene)), int)
    assert filed.shape == drawn.shape
    assert np.abs(filed - drawn).mean() < 0.2  # of 255; 2 % more depth makes 0.21
