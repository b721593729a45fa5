"""Cones against closed forms, cylinders and 50 digits: tip, base edge, tangents, scales, glass."""

from __future__ import annotations

import math

import numpy as np
import pytest
from mpmath import mpf
from tests.geometry.by_hand import SHAPES, SOLIDS, affine, moved, random_affine, scene_of, unit

from raywalk.bench.truth import true_hits
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.containment import objects_around
from raywalk.geometry.cross_section import Cut, Sliced
from raywalk.scene.model import Material, SceneObject
from raywalk.scene.shapes import Cone, Cylinder
from raywalk.trace.wavefront import Tracer

WHOLE = Cone((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 1.0)  # its radius at height y is 1 - y
CONES = ("cone", "frustum", "open cone")


@pytest.mark.parametrize("transformed", [False, True], ids=["as it is", "transformed"])
@pytest.mark.parametrize("capped", [True, False], ids=["capped", "open"])
def test_equal_radii_make_a_cylinder_to_the_last_digit(
    rng: np.random.Generator, capped: bool, transformed: bool
) -> None:
    """All columns of 5000 hits are the same bits."""
    matrix = random_affine(rng) if transformed else np.eye(4)
    ends = (-0.3, -1.0, 0.2), (0.4, 0.9, -0.1)
    origin = matrix[:3, 3] + 4.0 * rng.normal(size=(5000, 3))
    rays = rays_from(origin, unit(matrix[:3, 3] + 0.5 * rng.normal(size=(5000, 3)) - origin))
    one, other = (
        CompiledScene(scene_of([SceneObject("it", shape, 0, matrix)])).hits(rays)
        for shape in (Cone(*ends, 0.7, 0.7, capped), Cylinder(*ends, 0.7, capped))
    )
    assert np.isfinite(one.t).sum() > 300
    assert all(a.tobytes() == b.tobytes() for a, b in zip(one, other, strict=True))


@pytest.mark.parametrize("height", [0.0, 0.25, 0.5, 1.0 - 2.0**-30])
def test_a_level_ray_meets_the_cone_where_its_radius_says(height: float) -> None:
    """From x = -4 at height y: t = 4 - (1 - y), and behind the axis 4 + (1 - y), exactly: all are
    binary fractions. The normal rises by 45 degrees."""
    compiled = CompiledScene(scene_of([WHOLE]))
    rays = rays_from(np.array([[-4.0, height, 0.0]]), np.array([[1.0, 0.0, 0.0]]))
    _, t, _ = compiled.crossings(rays)
    assert t.tolist() == [3.0 + height, 5.0 - height]
    if height > 0.0:
        normal = compiled.hits(rays).normal[0]
        np.testing.assert_allclose(normal, [-(0.5**0.5), 0.5**0.5, 0.0], rtol=0, atol=4e-16)


@pytest.mark.parametrize(
    "matrix", [np.eye(4), affine(2.0**40 * np.eye(3)), affine(np.eye(3) / 2.0**40)], ids=range(3)
)
def test_at_the_tip_the_normal_is_the_axis(matrix: np.ndarray) -> None:
    """The stated rule, from above and from the side; straight down the axis the cone is met at its
    tip, and left through the middle of its base."""
    compiled = CompiledScene(scene_of([SceneObject("cone", WHOLE, 0, matrix)]))
    size = matrix[0, 0]
    down = rays_from(size * np.array([[0.0, 3.0, 0.0]]), np.array([[0.0, -1.0, 0.0]]))
    hits = compiled.hits(down)
    assert hits.t[0] == 2.0 * size
    assert hits.normal[0].tolist() == [0.0, 1.0, 0.0]
    assert (compiled.crossings(down)[1] == size * np.array([2.0, 3.0])).all()


def test_rays_aimed_at_the_tip_enter_or_pass(rng: np.random.Generator) -> None:
    """Of 5000 rays aimed at the tip, those within the cone's angle enter and come out again, none
    is said to leave; those flatter than it pass within rounding, or touch."""
    compiled = CompiledScene(scene_of([WHOLE]))
    origin = np.array([0.0, 1.0, 0.0]) + 3.0 * unit(rng.normal(size=(5000, 3)))
    direction = unit([0.0, 1.0, 0.0] - origin)
    hits = compiled.hits(rays_from(origin, direction))
    steep = direction[:, 1] < -(0.5**0.5) - 1e-9
    assert np.isfinite(hits.t[steep]).all()
    assert not hits.inside[steep].any()
    start, _, _ = compiled.crossings(rays_from(origin, direction))
    assert (np.diff(start)[steep] == 2).all()
    flat = np.abs(direction[:, 1]) < 0.5**0.5 - 1e-9
    touching = flat & np.isfinite(hits.t)
    assert np.abs(hits.t[touching] - 3.0).max(initial=0.0) < 1e-7  # roots of a rounding: 1e-16^.5


@pytest.mark.parametrize("k", range(1, 15))
def test_tangent_rays_pass_or_meet_to_14_digits(k: int) -> None:
    """Level rays beside the axis by (1 - y) (1 - 10^-k) meet the cone, by (1 - y) (1 + 10^-k) they
    do not; at half height, so that float64 can state it."""
    compiled = CompiledScene(scene_of([WHOLE]))
    for sign in (-1.0, 1.0):
        origin = np.array([[-4.0, 0.5, 0.5 * (1.0 + sign * 10.0**-k)]])
        met = compiled.hits(rays_from(origin, np.array([[1.0, 0.0, 0.0]]))).object[0] >= 0
        assert met == (sign < 0.0)


@pytest.mark.parametrize("k", range(1, 15))
def test_the_base_ends_at_its_edge(k: int) -> None:
    """From below at distance 1 - 10^-k from the axis the base is met, at 1 + 10^-k nothing is."""
    compiled = CompiledScene(scene_of([WHOLE]))
    for sign in (-1.0, 1.0):
        origin = np.array([[1.0 + sign * 10.0**-k, -2.0, 0.0]])
        hits = compiled.hits(rays_from(origin, np.array([[0.0, 1.0, 0.0]])))
        assert (hits.object[0] >= 0) == (sign < 0.0)
        assert sign > 0.0 or (hits.t[0] == 2.0 and hits.normal[0].tolist() == [0.0, -1.0, 0.0])


@pytest.mark.parametrize("scale", [1e-6, 1e-3, 1e3, 1e6], ids="{:g}".format)
@pytest.mark.parametrize("kind", CONES)
def test_scale_costs_no_digit(rng: np.random.Generator, kind: str, scale: float) -> None:
    """t is within 8 ulp of the 50-digit truth where it is well conditioned, from a millionth to a
    million times the size, from outside and from inside."""
    obj = SceneObject(kind, moved(SHAPES[kind], scale, np.zeros(3)), 0)
    compiled = CompiledScene(scene_of([obj]))
    away = np.where(np.arange(200) % 4 == 0, 0.1, 4.0)[:, None]
    origin = scale * away * unit(rng.normal(size=(200, 3)))
    direction = unit(scale * 0.4 * rng.normal(size=(200, 3)) - origin)
    t = compiled.hits(rays_from(origin, direction)).t
    judged = 0
    for o, d, found in zip(origin, direction, t, strict=True):
        truth = true_hits(obj, o, d)
        if not truth or truth[0].t < scale:
            continue
        normal = unit(np.array([float(x) for x in truth[0].normal]))
        if abs(normal @ d) > 0.5:
            assert abs(float(truth[0].t - mpf(float(found)))) <= 8 * np.spacing(found)
            judged += 1
    assert judged > 20


def test_glass_cone_turns_a_level_ray_into_a_level_ray() -> None:
    """A side of 45 degrees bends a level ray down by d = 45 - asin(sin 45 / n). From height h it
    reaches the base at x = h - 1 + h / tan d, is reflected there (its angle 90 - d is beyond the
    critical one), and leaves the other side, by symmetry, level again."""
    n, h = 1.5, 0.2
    glass = Material("glass", transmit=1.0, ior=n)
    scene = scene_of([SceneObject("cone", WHOLE, 0)], [glass], eye=(-4.0, h, 0.0))
    waves = Tracer(scene).follow(np.array([[-4.0, h, 0.0]]), np.array([[1.0, 0.0, 0.0]]))
    down = math.pi / 4 - math.asin(math.sin(math.pi / 4) / n)
    base = h - 1.0 + h / math.tan(down)
    out = (1.0 + base * math.tan(down)) / (1.0 + math.tan(down))
    points = [[h - 1.0, h, 0.0], [base, 0.0, 0.0], [out, 1.0 - out, 0.0]]
    assert len(waves) == 4
    # A dozen roundings of lengths up to 4, bent twice.
    np.testing.assert_allclose([w.hits.point[0] for w in waves[:3]], points, rtol=0, atol=4e-15)
    assert [bool(w.hits.inside[0]) for w in waves[:3]] == [False, True, True]
    np.testing.assert_allclose(waves[3].rays.direction[0], [1.0, 0.0, 0.0], rtol=0, atol=4e-15)
    assert waves[3].hits.object[0] == -1


@pytest.mark.parametrize("kind", SOLIDS)
def test_a_solid_holds_what_lies_before_its_surface(rng: np.random.Generator, kind: str) -> None:
    """On a line from its middle: all up to a billionth before the surface, nothing beyond."""
    obj = SceneObject(kind, SHAPES[kind], 0, random_affine(rng))
    compiled = CompiledScene(scene_of([obj]))
    middle = compiled.primitives.centre[0]
    for direction in unit(rng.normal(size=(40, 3))):
        [hit] = true_hits(obj, middle, direction)
        for share in (0.3, 0.7, 1.0 - 1e-9):
            assert objects_around(compiled, middle + share * float(hit.t) * direction) == [0]
        assert objects_around(compiled, middle + (1.0 + 1e-9) * float(hit.t) * direction) == []


@pytest.mark.parametrize("kind", ["capped cylinder", "open cylinder", *CONES])
def test_outlines_hold_what_rays_in_their_plane_meet(rng: np.random.Generator, kind: str) -> None:
    """200 planes, a ray in each: its hits lie on the outline, but for the bulge of 96 corners over
    one piece, 1 - cos(pi / 96) = 5e-4 of radii up to 1.5 where the plane is slanted."""
    obj = SceneObject(kind, SHAPES[kind], 0)
    compiled, sliced, met = CompiledScene(scene_of([obj])), Sliced(obj), 0
    for _ in range(200):
        origin, across = 2.0 * unit(rng.normal(size=3)), unit(rng.normal(size=3))
        direction = unit(0.5 * rng.normal(size=3) - origin)
        across = unit(across - (across @ direction) * direction)
        cut = Cut(origin, np.array([direction, across]), 10.0)
        _, t, _ = compiled.crossings(rays_from(origin[None], direction[None]))
        outlines = sliced.outlines(cut)
        for place in t:
            far = [
                _distance(each.points, each.kind == "closed", np.array([place, 0.0]))
                for each in outlines
            ]
            assert min(far) < 2e-3
            met += 1
    assert met > 100


def _distance(points: np.ndarray, closed: bool, to: np.ndarray) -> float:
    chain = np.vstack([points, points[:1]]) if closed else points
    start, way = chain[:-1], np.diff(chain, axis=0)
    length = np.maximum((way**2).sum(axis=1), 1e-30)
    share = np.clip(((to - start) * way).sum(axis=1) / length, 0.0, 1.0)
    return float(np.linalg.norm(start + share[:, None] * way - to, axis=1).min())
