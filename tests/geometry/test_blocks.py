"""Blocks of rays: what eight at a time give is, bit for bit, what one ray's formulas give."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from tests.geometry.by_hand import SHAPES, random_affine, scene_of, unit

from raywalk.geometry.blocks import (
    BLOCK,
    BLOCK_SIZE,
    CONES,
    GROUP,
    GROUPS,
    fill_block,
    find_cones,
    list_marked,
    mark_groups,
    mark_rays,
)
from raywalk.geometry.compiled import CompiledScene, Rays, rays_from
from raywalk.geometry.faces import is_solid, on_surface
from raywalk.geometry.nearest import nearest_primitive
from raywalk.geometry.primitives import Primitives
from raywalk.geometry.refine import from_close_up, refined
from raywalk.geometry.roots import NOWHERE, passes_by, settled_roots
from raywalk.geometry.sphere_tree import MANY
from raywalk.optics.compiled import kernel
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Box, Plane, Shape, Sphere

HOW = ["free", "from far", "along axes", "tangent", "leaving it", "leaving another there"]


@dataclass(frozen=True)
class Shot:
    """Rays at one primitive: columns as in Rays."""

    origin: np.ndarray
    direction: np.ndarray
    leaving: np.ndarray
    inner: np.ndarray


def shot(rng: np.random.Generator, compiled: CompiledScene, how: str, count: int) -> Shot:
    """Rays at the one object of a scene, which stands near the origin."""
    origin = rng.normal(size=(count, 3)) * (1e4 if how == "from far" else 3.0)
    direction = unit(rng.normal(size=(count, 3)) * 0.7 - origin)
    if how == "along axes":
        direction = np.eye(3)[rng.integers(3, size=count)] * rng.choice([-1.0, 1.0], (count, 1))
    if how == "tangent":
        direction = unit(2.0 * unit(rng.normal(size=(count, 3))) - origin)
    leaving, inner = np.full(count, NOWHERE, np.int32), np.zeros(count, bool)
    if how.startswith("leaving"):
        hits = compiled.hits(rays_from(origin, direction))
        met = hits.object != NOWHERE
        origin = np.where(met[:, None], hits.point, origin)
        direction = unit(rng.normal(size=(count, 3)))
        leaving[met] = 0 if how == "leaving it" else 7
        inner = rng.random(count) < 0.5
    return Shot(origin, direction, leaving, inner)


@kernel
def one_by_one(primitives, origin, direction, leaving, inner):  # type: ignore[no-untyped-def]
    """The first root of row 0 with each ray."""
    t = np.empty(origin.shape[0])
    for i in range(origin.shape[0]):
        t[i], _ = settled_roots(
            primitives, 0, origin[i, 0], origin[i, 1], origin[i, 2],
            direction[i, 0], direction[i, 1], direction[i, 2],
            primitives.object[0] == leaving[i], inner[i], leaving[i] != NOWHERE,
        )  # fmt: skip
    return t


def compiled_of(rng: np.random.Generator, shape: Shape, transformed: bool) -> CompiledScene:
    matrix = random_affine(rng) if transformed else np.eye(4)
    return CompiledScene(scene_of([SceneObject("it", shape, 0, matrix)]))


@pytest.mark.parametrize("how", HOW)
@pytest.mark.parametrize("transformed", [False, True], ids=["as it is", "transformed"])
@pytest.mark.parametrize("kind", SHAPES)
def test_a_block_finds_the_roots_that_one_ray_finds(
    rng: np.random.Generator, kind: str, transformed: bool, how: str
) -> None:
    """Whether by formulas for eight or by one's: equal to the last bit, misses as infinities."""
    compiled = compiled_of(rng, SHAPES[kind], transformed)
    rays = shot(rng, compiled, how, 700)
    limit = np.full(700, np.inf)
    columns = (rays.origin, rays.direction, rays.leaving, rays.inner)
    t, met = nearest_primitive(compiled.primitives, *columns, limit)
    expected = one_by_one(compiled.primitives, *columns)
    assert np.array_equal(t, expected)
    assert np.array_equal(met == 0, np.isfinite(expected))
    if how in ("free", "from far"):
        assert np.isfinite(expected).sum() > 50, "the rays that were to meet it do"


@pytest.mark.parametrize("count", [1, 7, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK + 88])
def test_where_blocks_end_changes_nothing(rng: np.random.Generator, count: int) -> None:
    """Of any number of rays, each meets what it meets alone."""
    compiled = CompiledScene(scene_of(list(SHAPES.values())))
    origin = rng.normal(size=(count, 3)) * 4
    direction = unit(rng.normal(size=(count, 3)) * 0.6 - origin)
    together = compiled.hits(rays_from(origin, direction))
    for i in range(0, count, 1 + count // 40):
        alone = compiled.hits(rays_from(origin[i : i + 1], direction[i : i + 1]))
        for name, column in zip(alone._fields, alone, strict=True):
            if column is not None:
                assert np.array_equal(column[0], getattr(together, name)[i], equal_nan=True), name


def test_a_mark_is_left_out_just_where_a_ray_passes_by(rng: np.random.Generator) -> None:
    """mark_rays and passes_by are one rule; listed are the marked, in order, none beyond the
    block's rays."""
    table = CompiledScene(scene_of(list(SHAPES.values()))).primitives
    size = BLOCK - 3
    origin = rng.normal(size=(size, 3)) * 5
    direction = rng.normal(size=(size, 3)) * 0.7 - origin
    block, marks = np.empty(BLOCK_SIZE), np.empty(BLOCK, np.uint8)
    fill_block(
        block,
        origin,
        direction,
        np.full(size, NOWHERE, np.int32),
        np.zeros(size, bool),
        np.full(size, np.inf),
        0,
        size,
    )
    for k in range(len(table.shape)):
        listed = marked(block, table, k, marks, size)
        expected = [
            j
            for j in range(size)
            if not passes_by(table, k, *origin[j], *direction[j], direction[j] @ direction[j])
        ]
        assert listed.tolist() == expected
        assert 0 < len(expected)


@kernel
def marked(block, primitives, k, marks, size):  # type: ignore[no-untyped-def]
    """The columns that may meet row k."""
    listed, c = np.empty(BLOCK + 1, np.int64), primitives.centre
    mark_rays(block, BLOCK, c[k, 0], c[k, 1], c[k, 2], primitives.reach_sq[k], marks)
    return listed[: list_marked(marks, size, listed, 0)]


@kernel
def groups_near(origin, direction, centre, reach):  # type: ignore[no-untyped-def]
    """Of each sphere, whether the cone of the first group of rays may meet it."""
    block, cones, near = np.empty(BLOCK_SIZE), np.empty(CONES), np.empty(GROUPS, np.uint8)
    count, out = origin.shape[0], np.empty(centre.shape[0], np.bool_)
    nowhere, far = np.full(count, NOWHERE, np.int32), np.full(count, np.inf)
    fill_block(block, origin, direction, nowhere, np.zeros(count, np.bool_), far, 0, count)
    find_cones(block, cones)
    for k in range(centre.shape[0]):
        mark_groups(cones, centre[k, 0], centre[k, 1], centre[k, 2], reach[k], near)
        out[k] = near[0] != 0
    return out


@pytest.mark.parametrize("spread", [0.0, 1e-9, 1e-3, 0.1, 0.7, 1.5])
@pytest.mark.parametrize("apart", [0.0, 1e-3, 1.0])
def test_a_cone_leaves_out_no_sphere_that_one_of_its_rays_may_meet(
    rng: np.random.Generator, spread: float, apart: float
) -> None:
    """Spheres all round, most of which a ray touches but for a little; narrow cones are of use."""
    fan = np.linspace(-1.0, 1.0, GROUP)[:, None]
    axis, side, step = unit(rng.normal(size=(3, 3)))
    direction = unit(axis + spread * fan * side)
    origin = rng.normal(size=3) + apart * (fan * step + 0.1 * rng.normal(size=(GROUP, 3)))
    centre, reach = 4.0 * rng.normal(size=(4000, 3)), rng.uniform(0.0, 1.0, 4000)
    along = np.einsum("kd,rd->kr", centre, direction) - (origin * direction).sum(axis=1)
    foot = origin + np.maximum(along, 0.0)[:, :, None] * direction
    away = np.linalg.norm(centre[:, None] - foot, axis=2).min(axis=1)
    touches = rng.random(4000) < 0.7
    reach[touches] = away[touches] * (1.0 + rng.choice([1e-6, 1e-3, -1e-3], touches.sum()))
    near = groups_near(origin, direction, centre, reach)
    assert near[reach >= away].all()
    if spread < 0.2 and apart < 0.5:
        assert near[~touches].mean() < 0.5, "a narrow cone is of use"


def test_the_order_in_which_rays_come_changes_nothing(rng: np.random.Generator) -> None:
    """Neighbours, which narrow cones hold, and the same rays shuffled, which none does."""
    compiled = CompiledScene(scene_of(list(SHAPES.values())))
    row, column = np.divmod(np.arange(4096), 64)
    aim = np.stack([(column - 31.5) / 16.0, (row - 31.5) / 16.0, np.full(4096, -6.0)], axis=1)
    origin = np.tile([0.0, 0.0, 6.0], (4096, 1))
    rays = rays_from(origin, unit(aim))
    for first in (rays, mirrored(compiled, rays)):
        shuffled = rng.permutation(len(first.origin))
        together, apart = compiled.hits(first), compiled.hits(first.take(shuffled))
        assert 0.05 < (together.object != NOWHERE).mean() < 0.95
        for name, column in zip(together._fields, together, strict=True):
            assert np.array_equal(column[shuffled], getattr(apart, name), equal_nan=True), name


def mirrored(compiled: CompiledScene, rays: Rays) -> Rays:
    """Those that the hits of rays would send on if all were mirrors."""
    hits = compiled.hits(rays)
    met = np.flatnonzero(hits.object != NOWHERE)
    hits, came = hits.take(met), rays.direction[met]
    sent = came - 2.0 * (came * hits.normal).sum(axis=1)[:, None] * hits.normal
    return Rays(hits.point, unit(sent), hits.object, hits.inside, hits.triangle)


@kernel
def landed_alone(table: Primitives, origin, direction, t, leaves, again):  # type: ignore[no-untyped-def]
    """t and canonical foot of hits of row 0, by one ray's formulas."""
    out = np.empty((origin.shape[0], 4))
    shape = table.shape[0]
    for i in range(origin.shape[0]):
        x, y, z, dx, dy, dz = from_close_up(
            table.centre, table.centre_rest, table.to_local, table.to_local_rest, table.is_skewed,
            0, origin[i, 0], origin[i, 1], origin[i, 2],
            direction[i, 0], direction[i, 1], direction[i, 2], t[i],
        )  # fmt: skip
        better = t[i]
        if not again[i]:
            better = refined(t[i], shape, x, y, z, dx, dy, dz)
        step = better - t[i]
        x, y, z = x + step * dx, y + step * dy, z + step * dz
        out[i, 0] = better
        out[i, 1], out[i, 2], out[i, 3], _, _, _ = on_surface(shape, x, y, z, dx, dy, dz, leaves[i])
    return out


# A flat shape is met by hardly a ray that starts on it.
LANDS = [
    (kind, how)
    for kind in ("sphere", "plane", "box", "capped cylinder", "cone", "disc")
    for how in HOW
    if not how.startswith("leaving") or kind not in ("plane", "disc")
]


@pytest.mark.parametrize(("kind", "how"), LANDS, ids=lambda word: word)
def test_a_block_lands_hits_where_one_ray_lands(
    rng: np.random.Generator, kind: str, how: str
) -> None:
    """Distance and point, to the last bit."""
    compiled = compiled_of(rng, SHAPES[kind], transformed=False)
    table = compiled.primitives
    rays = shot(rng, compiled, how, 700)
    columns = (rays.origin, rays.direction, rays.leaving, rays.inner)
    t, met = nearest_primitive(table, *columns, np.full(700, np.inf))
    hit = np.flatnonzero(met == 0)
    assert len(hit) > 10
    first = rays_from(rays.origin[hit], rays.direction[hit])._replace(
        leaving=rays.leaving[hit], inner=rays.inner[hit]
    )
    found = compiled.hits(first)
    leaves = found.inside & is_solid(table.shape[0])
    again = rays.leaving[hit] == 0
    alone = landed_alone(table, rays.origin[hit], rays.direction[hit], t[hit], leaves, again)
    m, (x, y, z) = table.to_world[0], alone[:, 1:].T
    away = x[:, None] * m[:, 0] + y[:, None] * m[:, 1] + z[:, None] * m[:, 2]
    assert np.array_equal(found.t, alone[:, 0])
    assert np.array_equal(found.point, table.centre[0] + (table.centre_rest[0] + away))


@pytest.mark.parametrize("how", ["free", "leaving"])
def test_a_tree_over_many_primitives_changes_no_answer(rng: np.random.Generator, how: str) -> None:
    """Of spheres and boxes that overlap, touch and coincide, with planes between them."""
    count = MANY + 100
    shapes: list[Shape] = []
    for k in range(count):
        x, y, z = rng.uniform(-2.0, 2.0, 3).round(1).tolist()
        ball, cube = Sphere((x, y, z), 0.2), Box((x, y, z), (x + 0.2, y + 0.2, z + 0.2))
        shapes.append(
            Plane((0.0, y, 0.0), (0.0, 1.0, 0.0)) if k % 200 == 7 else (ball, cube)[k % 2]
        )
    compiled = CompiledScene(scene_of(shapes))
    assert compiled.tree is not None
    origin = rng.normal(size=(900, 3)) * 3
    rays = rays_from(origin, unit(rng.normal(size=(900, 3)) - origin))
    if how == "leaving":
        hits = compiled.hits(rays)
        rays = Rays(
            hits.point, unit(rng.normal(size=(900, 3))), hits.object, hits.inside, hits.triangle
        )
        rays = rays.take(hits.object != NOWHERE)
    limit = np.where(rng.random(len(rays.origin)) < 0.5, np.inf, 2.0)
    columns = (rays.origin, rays.direction, rays.leaving, rays.inner, limit)
    t, met = nearest_primitive(compiled.primitives, *columns)
    found, _, _, _ = compiled.nearest(rays, limit)
    assert np.array_equal(found, t)
    assert np.array_equal(compiled.nearest(rays, limit)[1], met)
    assert np.isfinite(t).mean() > 0.5
