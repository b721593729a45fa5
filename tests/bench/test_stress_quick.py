"""A quick part of the stress matrix; `make stress` runs all of it with 10^6 rays a case."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from raywalk.bench import (
    stress_hits,
    stress_mesh,
    stress_mirrors,
    stress_optics,
    stress_order,
    stress_place,
    stress_runs,
    stress_shadows,
    stress_silhouette,
)
from raywalk.bench.cases import refuse_broken
from raywalk.scene import read_scene

SEED = 20261122
SCENES = Path("scenes")


@pytest.mark.parametrize(
    ("subject", "rays"),
    [
        (stress_hits, 800),
        (stress_place, 5_000),
        (stress_silhouette, 20_000),
        (stress_mesh, 10_000),
        (stress_optics, 200),
        (stress_mirrors, 10_000),
        (stress_order, 10_000),
        (stress_shadows, 10_000),
    ],
    ids=lambda value: value.__name__.split(".")[-1] if hasattr(value, "__name__") else str(value),
)
def test_the_bounds_of_a_subject_hold(subject, rays: int) -> None:
    """Every case of it, with fewer rays; a broken bound is named with its seed."""
    cases = list(subject.cases(rays, SEED))
    assert cases
    refuse_broken(cases)


def test_rays_that_are_none_are_refused_or_answered() -> None:
    """Zero, NaN and infinite directions are named; lengths of 1e-30 and 1e30 do not matter."""
    refuse_broken([
        stress_runs.refused_rays(SEED),
        stress_runs.directions_of_length(1e-30, 300, SEED),
        stress_runs.directions_of_length(1e30, 300, SEED),
    ])  # fmt: skip


@pytest.mark.parametrize("name", ["03-two-lights", "05-many-bounces", "07-bunny-near"])
def test_a_scene_looks_the_same_at_any_scale_and_place_and_twice(name: str) -> None:
    """No shadow changes from 1e-6 to 1e6 and as far out as 1e7, nothing is NaN, runs agree."""
    scene = read_scene(SCENES / name / "scene.toml")
    refuse_broken([
        *stress_runs.moved_and_scaled(scene, 33, SEED), stress_runs.same_twice(scene, SEED)
    ])  # fmt: skip


def test_a_scene_that_changes_is_noticed() -> None:
    """The same check fails for a lamp moved by a thousandth: it can fail."""
    scene = read_scene(SCENES / "03-two-lights" / "scene.toml")
    one, _ = stress_runs.looked_at(scene, 105)
    other, _ = stress_runs.looked_at(stress_runs.elsewhere(scene, 1.0, 0.0), 105)
    assert (one == other).all()
    x, y, z = scene.lights[0].position
    moved = stress_runs.replace(scene.lights[0], position=(x + 0.05, y, z))
    other, _ = stress_runs.looked_at(
        stress_runs.replace(scene, lights=(moved, *scene.lights[1:])), 105
    )
    assert np.count_nonzero(one != other) > 0
