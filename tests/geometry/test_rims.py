"""Round shapes that share a rim leave nothing open between them."""

from __future__ import annotations

import numpy as np
import pytest
from tests.geometry.by_hand import unit

from raywalk.bench.made_scenes import placed, scene_of
from raywalk.bench.stress_rims import RIMS, lost_at_rims
from raywalk.geometry.compiled import CompiledScene, Rays, rays_from
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Cone, Cylinder, Disc, Shape

SHEAR = np.array([[1.0, 0.4, 0.1], [0.0, 1.3, 0.2], [0.3, 0.0, 0.7]])


@pytest.mark.parametrize("kind", RIMS)
def test_no_ray_passes_between_two_that_share_a_rim(kind: str) -> None:
    """2,000 rays aimed at the rims of ten pairs, from within and without: none is lost that a
    hundred digits have meet one of the two."""
    assert lost_at_rims(kind, 2_000, 10, seed=20261130) == 0


def can(rng: np.random.Generator, far: float) -> tuple[list[Shape], np.ndarray, np.ndarray, float]:
    """A tube or cone with two lids, all numbers rounded as an author's would be; centre, axis and
    radius of its upper rim."""
    start, axis = far * rng.normal(size=3), unit(rng.normal(size=(1, 3)))[0]
    end, radius, other = start + rng.uniform(0.5, 2.0) * axis, rng.uniform(0.3, 1.0), rng.uniform()
    low, top, up = (tuple(each.tolist()) for each in (start, end, axis))
    is_cone = other > 0.5
    below = float(other) * radius if is_cone else radius
    side: Shape = Cylinder(low, top, radius, capped=False)
    if is_cone:
        side = Cone(low, top, below, radius, capped=False)
    lids = [Disc(low, tuple((-axis).tolist()), below), Disc(top, up, radius)]
    return [side, *lids], end, axis, radius


@pytest.mark.parametrize("linear", [np.eye(3), SHEAR], ids=["as it is", "sheared"])
@pytest.mark.parametrize("far", [0.0, 50.0])
def test_no_ray_leaves_a_can_by_its_rim(
    rng: np.random.Generator, linear: np.ndarray, far: float
) -> None:
    """From free space and from its own wall across, though axis and place are rounded: the rims are
    one but for that."""
    for _ in range(10):
        shapes, middle, axis, radius = can(rng, far)
        compiled = CompiledScene(
            scene_of(
                [SceneObject(str(k), each, 0, placed(linear)) for k, each in enumerate(shapes)]
            )
        )
        out = unit(np.cross(axis, rng.normal(size=(300, 3))))
        depth = rng.uniform(0.05, 0.4, (300, 1))
        origin = (
            middle - depth * axis + 0.05 * radius * unit(rng.normal(size=(300, 3)))
        ) @ linear.T
        target = (middle - radius * out) @ linear.T
        hits = compiled.hits(rays_from(origin, unit(target - origin)))
        assert np.isfinite(hits.t).all()
        lower = unit((out - axis) @ linear.T)  # from the axis to the wall, or a lid: left out
        hits = compiled.hits(rays_from(origin, lower))
        wall = np.flatnonzero(hits.object == 0)
        from_wall = Rays(
            hits.point[wall], unit(target[wall] - hits.point[wall]), np.zeros(len(wall), np.int32),
            np.ones(len(wall), bool), np.full(len(wall), -1, np.int32),
        )  # fmt: skip
        assert np.isfinite(compiled.nearest(from_wall)[0]).all()


def edged(*shapes: Shape) -> list[int]:
    table = CompiledScene(scene_of(list(shapes))).primitives
    return sorted(table.object[table.is_edged].tolist())


def test_who_shares_no_rim_pays_for_none() -> None:
    """A disc inside of a tube, one beside it, one of another radius: none closes it. Nor does a
    cone's tip have a rim."""
    tube = Cylinder((0, 0, 0), (0, 2, 0), 1.0, capped=False)
    assert edged(tube, Disc((0, 1, 0), (0, 1, 0), 1.0), Disc((0, 2, 0), (0, 1, 0), 0.999)) == []
    assert edged(tube, Disc((0, 2, 0), (0, 1, 1e-9), 1.0)) == []
    assert edged(tube, Disc((0, 2, 0), (0, -7, 0), 1.0)) == [0, 1]
    assert edged(Cone((0, 0, 0), (0, 2, 0), 1.0), Cone((0, 4, 0), (0, 2, 0), 1.0)) == []
    assert edged(Cone((0, 0, 0), (0, 2, 0), 0.3, 0.1), Cylinder((0, 2, 0), (0, 3, 0), 0.1)) == [
        0,
        1,
    ]


def test_along_a_rim_s_plane_a_tube_is_met_and_a_disc_is_not() -> None:
    """A line that lies in the plane crosses it nowhere; the rim is part of the tube."""
    tube, lid = Cylinder((0, 0, 0), (0, 2, 0), 1.0, capped=False), Disc((0, 2, 0), (0, 1, 0), 1.0)
    rays = rays_from(np.array([[-3.0, 2.0, 0.5]]), np.array([[1.0, 0.0, 0.0]]))
    t, met, _, _ = CompiledScene(scene_of([lid, tube])).nearest(rays)
    assert met[0] == 1 and abs(t[0] - (3.0 - np.sqrt(0.75))) < 1e-15
