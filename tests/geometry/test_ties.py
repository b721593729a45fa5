"""Where two surfaces are one: coplanar faces, and the edges at which faces meet."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from tests.geometry.by_hand import affine, scene_of, unit

from raywalk.geometry.compiled import TIE, CompiledScene, order_ties, rays_from
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Box, Cone, Cylinder, Disc, Plane, Shape, Triangle

RAYS = 5000
# All hold the square |x|, |z| <= 1 of the plane y = 0, from below.
COPLANAR: dict[str, Shape] = {
    "plane": Plane((0.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "disc": Disc((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 2.5),
    "box": Box((-3.0, -1.0, -3.0), (2.7, 0.0, 2.3)),
    "triangle": Triangle((-3.0, 0.0, -2.0), (4.0, 0.0, -3.0), (0.3, 0.0, 5.0)),
    "cylinder": Cylinder((0.1, -2.0, 0.2), (0.1, 0.0, 0.2), 3.0),
    "cone": Cone((0.1, 0.0, 0.2), (0.1, -2.0, 0.2), 3.0),
}


def rotation(rng: np.random.Generator) -> np.ndarray:
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    return np.asarray(turn * np.sign(np.linalg.det(turn)))


def down_on_the_square(
    rng: np.random.Generator, matrix: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Rays from above, steep and grazing, onto the common square, all moved by a matrix."""
    origin = rng.normal(size=(RAYS, 3)) * 3
    origin[:, 1] = np.abs(origin[:, 1]) + 10.0 ** rng.uniform(-3, 1, size=RAYS)
    target = np.stack([rng.uniform(-1, 1, RAYS), np.zeros(RAYS), rng.uniform(-1, 1, RAYS)], axis=1)
    origin, target = (p @ matrix[:3, :3].T + matrix[:3, 3] for p in (origin, target))
    return origin, unit(target - origin)


@pytest.mark.parametrize("place", ["as they are", "turned", "turned and far out"])
@pytest.mark.parametrize("pair", list(itertools.permutations(COPLANAR, 2)), ids=" over ".join)
def test_a_tie_goes_to_the_lowest_object(
    rng: np.random.Generator, pair: tuple[str, str], place: str
) -> None:
    """Coplanar faces do not flicker, whatever rounding says: of 5000 rays all meet the one that
    the scene names first, in every run."""
    matrix = np.eye(4) if place == "as they are" else affine(rotation(rng), (0.1, 0.2, 0.3))
    matrix[:3, 3] *= 1e7 if place == "turned and far out" else 1.0
    compiled = CompiledScene(
        scene_of([SceneObject(kind, COPLANAR[kind], 0, matrix) for kind in pair])
    )
    rays = rays_from(*down_on_the_square(rng, matrix))
    first = compiled.nearest(rays)
    assert (first[1] == 0).all()
    second = compiled.nearest(rays)
    assert all((a == b).all() for a, b in zip(first, second, strict=True))


@pytest.mark.parametrize("gap", [1e-3, 1e-6, 1e-9, 1e-12])
def test_surfaces_that_are_not_one_keep_their_order(rng: np.random.Generator, gap: float) -> None:
    """A disc that floats 1e-12 above a floor named before it is still met first: 1e-12 is 300
    times the error bound of a hit point there."""
    compiled = CompiledScene(scene_of([COPLANAR["plane"], Disc((0, gap, 0), (0, 1, 0), 2.5)]))
    origin, direction = down_on_the_square(rng, np.eye(4))
    near = np.abs(origin).max(axis=1) < 20
    assert (compiled.nearest(rays_from(origin[near], direction[near]))[1] == 1).all()


@pytest.mark.parametrize("turned", [False, True], ids=["as it is", "turned"])
@pytest.mark.parametrize("kind", ["box", "cylinder"])
def test_rays_at_an_edge_know_on_which_side_they_are(
    rng: np.random.Generator, kind: str, turned: bool
) -> None:
    """Rays from outside aimed exactly at edges and corners enter: none is said to leave,
    and the normal is that of a face the ray can have met."""
    matrix = affine(rotation(rng), (0.1, 0.2, 0.3)) if turned else np.eye(4)
    if kind == "box":
        shape: Shape = Box((-1.0, -0.5, -0.7), (0.8, 0.9, 0.6))
        ends = np.array([[-1.0, -0.5, -0.7], [0.8, 0.9, 0.6]])
        point = rng.uniform(ends[0], ends[1], size=(RAYS, 3))
        free = rng.integers(4, size=RAYS)  # 3: a corner
        for axis in range(3):
            fixed = free != axis
            point[fixed, axis] = ends[rng.integers(2, size=RAYS), axis][fixed]
    else:
        shape = Cylinder((0.0, -1.0, 0.0), (0.0, 1.0, 0.0), 1.0)
        turn = rng.uniform(0, 2 * np.pi, size=RAYS)
        point = np.stack([np.cos(turn), rng.choice([-1.0, 1.0], size=RAYS), np.sin(turn)], axis=1)
    origin = 5 * unit(rng.normal(size=(RAYS, 3)))
    point, origin = (p @ matrix[:3, :3].T + matrix[:3, 3] for p in (point, origin))
    direction = unit(point - origin)
    compiled = CompiledScene(scene_of([SceneObject(kind, shape, 0, matrix)]))
    hits = compiled.hits(rays_from(origin, direction))
    met = hits.object >= 0
    assert met.mean() > 0.5  # at silhouettes rounding may decide for a miss
    assert not hits.inside[met].any()
    assert ((hits.normal * direction).sum(axis=1)[met] < 0).all()


@pytest.mark.parametrize("t", [1e-6, 1.0, 1e6])
def test_crossings_tie_by_a_share_of_their_distance(t: float) -> None:
    """However near or far: half of TIE apart the lower rank comes first, twice TIE apart not."""
    rank = np.array([0, 1])
    for gap, order in ((0.5, [0, 1]), (2.0, [1, 0])):
        distances = np.array([t, t * (1.0 + gap * TIE)])
        for rays, expected in (([0, 0], order), ([0, 1], [1, 0])):  # two rays never tie
            met = np.array([1, 0], np.int32)
            order_ties(np.array(rays, np.int32), distances, met, rank)
            assert met.tolist() == expected
