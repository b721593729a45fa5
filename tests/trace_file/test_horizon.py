"""Rays that run along an endless plane, but for rounding, and meet it as far out as numbers go."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conftest import decode
from scenes_for_tests import MIRROR, RED
from tiny_tracer import make_scene

from raywalk.scene.model import Camera, Light, Material
from raywalk.scene.shapes import Plane, Sphere
from raywalk.trace.wavefront import trace_scene
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of


@pytest.mark.parametrize("material", [RED, MIRROR], ids=["matt", "mirror"])
@pytest.mark.parametrize("roll", [0.0, 0.1, 1.0, -0.3])
def test_a_camera_rolled_over_a_floor_makes_a_trace(roll: float, material: Material) -> None:
    """Its horizon passes through pixels: once a division by zero, and an index out of bounds."""
    floor, ball = Plane((0.0, -1.0, 0.0), (0.0, 1.0, 0.0)), Sphere((0.3, 0.0, 0.0), 0.8)
    scene = make_scene([(floor, 0), (ball, 0)], [material], [Light("lamp", (2, 3, 4))], size=105)
    camera = Camera((0.0, 0.0, 5.0), (0.0, 0.0, 0.0), (roll, 1.0, 0.0), 45.0)
    render = replace(scene.render, size=105, resolutions=(21, 105))
    traced = trace_scene(replace(scene, camera=camera, render=render), threads=1)
    for n in (21, 105):
        tree = level_of(traced.tree, n)
        trace = decode(encode(tree, replace(scene, camera=camera, render=render), traced.picture))
        assert np.isfinite(trace.point).all()
        near = (np.abs(tree.point).max(axis=1) < 1e3) & (tree.object >= 0)
        assert near.sum() > n
        np.testing.assert_array_equal(trace.object, tree.object)
        # Along the floor a step of 1 / z is the longer the farther out; 1e3 is 200 times the scene.
        off = np.linalg.norm(trace.point - tree.point, axis=1)
        assert off[near].max() < 1.0
        assert off[near & (np.abs(tree.point).max(axis=1) < 20.0)].max() < 5e-3
