"""The project's own tracer and the codec understand each other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from conftest import decode
from scenes_for_tests import glass, mirrors, random_scene

from raywalk.trace.wavefront import trace_scene
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of


@pytest.mark.parametrize("seed", [None, "mirrors", 1, 2, 4], ids=lambda seed: f"seed {seed}")
def test_traced_scenes_come_back_in_the_tracers_order(seed: int | str | None) -> None:
    """glass, mirrors and random scenes, two levels of one trace."""
    scene = glass(63) if seed is None else mirrors(63) if seed == "mirrors" else None
    scene = scene or random_scene(int(seed or 0), 63)
    scene = replace(scene, render=replace(scene.render, resolutions=(7, 21)))
    traced = trace_scene(scene)
    for n in (7, 21):
        level = level_of(traced.tree, n)
        trace = decode(encode(level, scene, traced.picture), scene.id, n)
        for name in ("kind", "parent", "object", "material", "inside", "depth"):
            np.testing.assert_array_equal(
                getattr(trace, name), getattr(level, name).astype(int), err_msg=name
            )
        assert np.abs(trace.colour - level.colour).max() <= trace.header["errors"]["colour"]
        step = 63 // n
        tiles = traced.picture[step // 2 :: step, step // 2 :: step]
        np.testing.assert_array_equal(trace.tiles, tiles.reshape(-1))


def test_light_through_glass_comes_back_with_what_the_glass_let_pass() -> None:
    """So that with shadows switched off the factors are those of a scene without shadows."""
    scene = glass(63)
    half = tuple(replace(m, transmit=0.5 * m.transmit, fresnel=False) for m in scene.materials)
    scene = replace(
        scene, materials=half,
        render=replace(scene.render, resolutions=(21,), glass_shadows="pass"),
    )  # fmt: skip
    bare = trace_scene(replace(scene, render=replace(scene.render, shadows=False)))
    traced = trace_scene(scene)
    level, lit = level_of(traced.tree, 21), level_of(bare.tree, 21)
    trace = decode(encode(level, scene, traced.picture), scene.id, 21)
    hit = level.object >= 0
    np.testing.assert_allclose(trace.passed[hit], level.passed[hit], rtol=1e-11)  # 12 digits kept
    assert (trace.passed < 1).any()
    shown = (level.local_weight > 0)[:, None] & (trace.passed < 1)
    for name in ("diffuse", "specular"):
        whole = (getattr(trace, name) / trace.passed)[shown]
        # A stored factor is off by half a step, 2.5e-4 at most.
        np.testing.assert_allclose(whole, getattr(lit, name)[shown], rtol=0, atol=2.6e-4)
