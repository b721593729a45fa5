"""A quick part of the stress matrix; `make stress` runs all of it with 10^6 rays a case."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.cases import EVERY, cases

from raywalk.bench import (
    stress_acne,
    stress_hits,
    stress_media,
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
from raywalk.bench.made_scenes import compiled_mesh, icosphere, placed, scene_of
from raywalk.bench.stress_shadows import visibility
from raywalk.geometry.compiled import rays_from
from raywalk.scene.model import Light, Scene
from raywalk.scene.read import read_scene
from raywalk.scene.shapes import Sphere
from raywalk.trace.tree import Visibility
from raywalk.trace.wavefront import Tracer

SEED = 20261122
SCENES = Path("scenes")


@pytest.mark.parametrize(
    ("subject", "rays"),
    [
        (stress_hits, 300),
        (stress_place, 5_000),
        (stress_silhouette, 20_000),
        (stress_mesh, 4_000),
        (stress_optics, 200),
        (stress_mirrors, 10_000),
        (stress_order, 10_000),
        (stress_media, 20_000),
        (stress_shadows, 10_000),
    ],
    ids=lambda value: value.__name__.split(".")[-1] if hasattr(value, "__name__") else str(value),
)
def test_the_bounds_of_a_subject_hold(subject, rays: int) -> None:
    """Every case of it, with fewer rays; a broken bound is named with its seed."""
    asked = list(subject.cases(rays if EVERY else rays // 3, SEED))
    assert asked
    refuse_broken(asked)


def test_rays_that_are_none_are_refused_or_answered() -> None:
    """Zero, NaN and infinite directions are named; lengths of 1e-30 and 1e30 do not matter."""
    refuse_broken([
        stress_runs.refused_rays(SEED),
        stress_runs.directions_of_length(1e-30, 300, SEED),
        stress_runs.directions_of_length(1e30, 300, SEED),
    ])  # fmt: skip


@pytest.mark.parametrize(
    "name", cases(["03-two-lights", "05-many-bounces", "07-bunny-near"], ["03-two-lights"])
)
def test_a_scene_looks_the_same_at_any_scale_and_place_and_twice(name: str) -> None:
    """No shadow changes at any decade from 1e-6 to 1e6 and as far out as 1e7, none falls on the
    surface it starts from, nothing is NaN, runs agree."""
    scene = read_scene(SCENES / name / "scene.toml")
    refuse_broken([
        *stress_acne.of_scene(scene, 33, SEED), stress_runs.same_twice(scene, SEED)
    ])  # fmt: skip


def test_a_scene_that_changes_is_noticed() -> None:
    """The same check fails for a lamp moved by a thousandth: it can fail."""
    scene = read_scene(SCENES / "03-two-lights" / "scene.toml")

    def seen(place: Scene) -> np.ndarray:
        return stress_acne.verdicts(Tracer(place).waves(np.arange(105 * 105), 105, 105)[0])

    one = seen(scene)
    assert (one == seen(stress_acne.elsewhere(scene, 1.0, 0.0))).all()
    x, y, z = scene.lights[0].position
    moved = replace(scene.lights[0], position=(x + 0.05, y, z))
    assert np.count_nonzero(one != seen(replace(scene, lights=(moved, *scene.lights[1:])))) > 0


def test_a_light_just_above_a_far_facet_is_not_blocked_by_its_neighbour() -> None:
    """Moved by 1e7, points are 1e-9 off their facets; a light 1e-5 over the plane of one lights
    it all the same, up to its edges: the rays start on the plane itself."""
    place = np.array([1e7, -1e7, 1e7])
    compiled = compiled_mesh(icosphere(2), placed(1.0, place))
    corners = compiled.meshes[0].corners
    rng = np.random.default_rng(SEED)
    for k in range(0, len(corners), 8):
        a, b, c = corners[k]
        normal = np.cross(b - a, c - a)
        normal /= np.linalg.norm(normal)
        share = rng.dirichlet((0.3, 0.3, 0.3), 200)  # many of them close to edges
        point = place + share @ corners[k]
        x, y, z = place + (a + b + c) / 3 + 6.0 * (b - a) / np.linalg.norm(b - a) + 1e-5 * normal
        rays = rays_from(point + 0.5 * normal, np.tile(-normal, (200, 1)))
        hits = compiled.hits(rays)
        scene = scene_of([Sphere((0.0, 0.0, 0.0), 1.0)], [Light("lamp", (x, y, z))])
        seen = visibility(scene, compiled, rays, hits)[:, 0]
        assert (seen[hits.triangle == k] == Visibility.REACHED).all()
