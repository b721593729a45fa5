"""Every primitive against 50-digit truth (bench/truth.py), for random and for awkward rays."""

from __future__ import annotations

import mpmath  # type: ignore[import-untyped]
import numpy as np
import pytest
from mpmath import mpf
from tests.geometry.by_hand import SHAPES, random_affine, scene_of, unit

from raywalk.bench.truth import TrueHit, true_hits
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Sphere

EPS = np.finfo(float).eps
# A hit or miss counts as decided where a shape 1e-12 larger or smaller agrees: 4,500 roundings
# of its size, what is left of the digits after a transform of condition 10 at 10 sizes' distance.
DECIDED = 1e-12
# t is off by at most this many roundings of |o| + |c| + t, over the cosine between ray and
# normal (a surface shifted by h is met h / cosine earlier), times the transform's condition.
ROUNDINGS = 8.0


def awkward_rays(
    rng: np.random.Generator, placed: SceneObject, count: int
) -> tuple[np.ndarray, np.ndarray]:
    """Origins and directions (n, 3): at random, along axes, tangent, from inside, from far, not
    of unit length. Axes and distances are those before the object's transform."""
    origin = rng.normal(size=(count, 3)) * 4
    target = rng.normal(size=(count, 3)) * 0.6
    kind = rng.integers(6, size=count)
    origin[kind == 1] = rng.normal(size=((kind == 1).sum(), 3)) * 0.3
    origin[kind == 2] *= 10.0 ** rng.integers(1, 5, size=((kind == 2).sum(), 1))
    axes = np.eye(3)[rng.integers(3, size=count)]
    origin[kind == 3] = (target + 4 * axes)[kind == 3]
    target[kind == 4] = (2.2 * unit(rng.normal(size=(count, 3))))[kind == 4]
    linear, offset = placed.transform[:3, :3], placed.transform[:3, 3]
    origin, target = origin @ linear.T + offset, target @ linear.T + offset
    direction = unit(target - origin)
    direction[kind == 5] *= 10.0 ** rng.integers(-3, 4, size=((kind == 5).sum(), 1))
    return origin, direction


def cosine(hit: TrueHit, direction: np.ndarray) -> float:
    normal = unit(np.array([float(x) for x in hit.normal]))
    return float(normal @ unit(direction))


def is_undecided(placed: SceneObject, origin: np.ndarray, direction: np.ndarray) -> bool:
    """Whether growing the shape by DECIDED changes how often the ray meets it."""
    larger = true_hits(placed, origin, direction, DECIDED)
    return len(larger) != len(true_hits(placed, origin, direction, -DECIDED))


@pytest.mark.parametrize("transformed", [False, True], ids=["as it is", "transformed"])
@pytest.mark.parametrize("kind", SHAPES)
def test_hits_are_those_of_50_digits(
    rng: np.random.Generator, kind: str, transformed: bool
) -> None:
    """As many hits as there are, at the true distances, with the true normals and sides."""
    matrix = random_affine(rng) if transformed else np.eye(4)
    placed = SceneObject(kind, SHAPES[kind], 0, matrix)
    condition = np.linalg.cond(matrix[:3, :3])
    compiled = CompiledScene(scene_of([placed]))
    origin, direction = awkward_rays(rng, placed, 400)
    rays = rays_from(origin, direction)
    hits = compiled.hits(rays)
    start, every_t, _ = compiled.crossings(rays)
    undecided, well_conditioned = 0, 0
    for i in range(len(origin)):
        truth = true_hits(placed, origin[i], direction[i])
        found = every_t[start[i] : start[i + 1]]
        if len(found) != len(truth):
            assert is_undecided(placed, origin[i], direction[i]), (origin[i], direction[i])
            undecided += 1
            continue
        length = np.linalg.norm(direction[i])
        reach = np.abs(origin[i]).sum() + np.abs(compiled.primitives.centre[0]).sum()
        for t, hit in zip(found, truth, strict=True):
            error = abs(float(mpf(float(t)) - hit.t))
            across = abs(cosine(hit, direction[i]))
            unit_error = EPS * (reach / length + t) * condition
            assert error <= ROUNDINGS * unit_error / across + 1e-7 * (across < 1e-7)
            if across > 0.5 and reach < 2 * t * length and not transformed:
                assert error <= 8 * np.spacing(t)
                well_conditioned += 1
        if len(truth):
            assert hits.t[i] == found[0]
            side = cosine(truth[0], direction[i])
            if abs(side) < 1e-6:
                continue  # tangent: the side is rounding
            assert hits.inside[i] == (side > 0)
            true_point = [float(mpf(float(o)) + truth[0].t * mpf(float(d)))
                          for o, d in zip(origin[i], direction[i], strict=True)]  # fmt: skip
            slack = 32 * EPS * (reach + t * length) * condition / abs(side)
            assert np.abs(hits.point[i] - true_point).max() <= slack
            normal = unit(np.array([float(x) for x in truth[0].normal])) * -np.sign(side)
            # The normal turns with the point: slack over the smallest radius, 0.2 transformed.
            assert np.abs(hits.normal[i] - normal).max() <= 10 * slack + 8 * EPS * condition
    assert undecided < 4  # rays on the border are rare: the margin hides nothing
    assert transformed or well_conditioned > 20


@pytest.mark.parametrize("kind", SHAPES)
def test_hit_points_lie_on_the_surface(rng: np.random.Generator, kind: str) -> None:
    """A hit point is off its surface by a dozen roundings at most, from near and far: round
    shapes move it onto the surface, so that the error of o + t d does not show."""
    placed = SceneObject(kind, SHAPES[kind], 0)
    compiled = CompiledScene(scene_of([placed]))
    origin, direction = awkward_rays(rng, placed, 200)
    hits = compiled.hits(rays_from(origin, direction))
    met = np.flatnonzero(hits.object >= 0)[:60]
    beside = 0
    for i in met:
        # From a little above the point straight down on it, the surface is met at that height.
        above = hits.point[i] + 0.01 * hits.normal[i]
        heights = [abs(float(hit.t) - 0.01) for hit in true_hits(placed, above, -hits.normal[i])]
        if not heights or min(heights) > 1e-3:
            beside += 1  # at an edge straight down may run beside the shape
        else:
            assert min(heights) < 16 * EPS * 4  # of coordinates up to 4
    assert beside <= 0.1 * len(met)


@pytest.mark.parametrize("k", range(1, 16))
def test_tangent_rays_pass_or_meet_to_15_digits(rng: np.random.Generator, k: int) -> None:
    """A ray at distance r (1 - 10^-k) from a sphere's centre meets it, one at r (1 + 10^-k)
    does not. Axis-parallel rays, whose distance float64 can state to k = 15."""
    centre = rng.integers(-4, 5, size=3).astype(float)
    compiled = CompiledScene(scene_of([Sphere(tuple(centre), 2.0)]))
    for sign in (-1, 1):
        for axis in range(3):
            off = np.zeros(3)
            off[(axis + 1) % 3] = 2.0 * (1.0 + sign * 10.0**-k)
            origin = np.array([centre + off - 8 * np.eye(3)[axis]])
            exact = mpf(float(origin[0, (axis + 1) % 3])) - mpf(float(centre[(axis + 1) % 3]))
            rays = rays_from(origin, np.eye(3)[[axis]])
            met = compiled.hits(rays).object[0] >= 0
            assert met == (exact <= 2), (sign, axis)


@pytest.mark.parametrize(
    ("distance", "bound"), [(1e3, 1.2e-13), (1e5, 1.5e-11), (1e7, 1.9e-9)], ids="{:g}".format
)
def test_a_small_sphere_far_away_is_met_where_it_is(
    rng: np.random.Generator, distance: float, bound: float
) -> None:
    """Seen from 1e3, 1e5, 1e7 radii: t is the float64 next to the truth or, at most, the one
    after it (1e-13, 1.5e-11, 1.9e-9); the textbook formula is off by 6e-6 at 1e5."""
    ball = SceneObject("ball", Sphere((0.0, 0.0, 0.0), 1.0), 0)
    compiled = CompiledScene(scene_of([ball]))
    origin = unit(rng.normal(size=(300, 3))) * distance
    direction = unit(rng.normal(size=(300, 3)) * 0.3 - origin)
    t = compiled.hits(rays_from(origin, direction)).t
    errors = []
    for o, d, found in zip(origin, direction, t, strict=True):
        truth = true_hits(ball, o, d)
        if truth and abs(cosine(truth[0], d)) > 0.5:
            errors.append(abs(float(truth[0].t - mpf(float(found)))))
    assert len(errors) > 100
    assert np.median(errors) <= np.spacing(distance)
    assert max(errors) <= bound  # 1 ulp


def test_a_tiny_and_a_huge_sphere_are_as_exact(rng: np.random.Generator) -> None:
    """Scale alone costs nothing: relative errors of t stay below 8 ulp from 1e-6 to 1e6."""
    for scale in 10.0 ** np.arange(-6, 7, 3):
        ball = SceneObject("ball", Sphere((scale, -scale, 0.5 * scale), 1.3 * scale), 0)
        compiled = CompiledScene(scene_of([ball]))
        origin = rng.normal(size=(50, 3)) * 4 * scale
        direction = unit(rng.normal(size=(50, 3)) * 0.3 * scale - origin)
        t = compiled.hits(rays_from(origin, direction)).t
        for o, d, found in zip(origin, direction, t, strict=True):
            truth = true_hits(ball, o, d)
            if truth and abs(cosine(truth[0], d)) > 0.5 and truth[0].t > scale:
                assert abs(float(truth[0].t - mpf(float(found)))) <= 8 * np.spacing(found)


@pytest.mark.parametrize("length", [1e-30, 1e-3, 1e3, 1e30], ids="{:g}".format)
def test_t_is_in_units_of_the_direction(rng: np.random.Generator, length: float) -> None:
    """A direction of any length meets the same points, at 1 / length of the distance."""
    for kind, shape in SHAPES.items():
        compiled = CompiledScene(scene_of([SceneObject(kind, shape, 0)]))
        origin = rng.normal(size=(200, 3)) * 4
        direction = unit(rng.normal(size=(200, 3)) * 0.6 - origin)
        one = compiled.hits(rays_from(origin, direction))
        other = compiled.hits(rays_from(origin, direction * length))
        assert (one.object == other.object).all()
        met = one.object >= 0
        np.testing.assert_allclose(other.t[met] * length, one.t[met], rtol=1e-13)
        np.testing.assert_allclose(other.point[met], one.point[met], rtol=0, atol=1e-12)


@pytest.mark.parametrize("bad", [np.nan, np.inf, 0.0])
def test_directions_that_are_none_meet_nothing(bad: float) -> None:
    """NaN, infinite and zero directions are misses; their neighbours are not disturbed."""
    for kind, shape in SHAPES.items():
        compiled = CompiledScene(scene_of([SceneObject(kind, shape, 0)]))
        origin = np.tile([0.1, 0.2, 5.0], (3, 1))
        direction = np.array([[0.0, 0.0, -1.0], [bad, bad, bad], [0.0, 0.0, -1.0]])
        hits = compiled.nearest(rays_from(origin, direction))
        assert hits[1].tolist()[1] == -1
        assert hits[0][0] == hits[0][2]


def test_the_truth_itself_keeps_its_digits() -> None:
    """A sphere seen along the x axis from 10: t = 9 and 11, to 45 digits."""
    first, second = true_hits(SceneObject("s", Sphere((0, 0, 0), 1), 0), (-10, 0, 0), (1, 0, 0))
    assert abs(first.t - 9) < mpf(10) ** -45
    assert abs(second.t - 11) < mpf(10) ** -45
    assert mpmath.mp.dps == 50
