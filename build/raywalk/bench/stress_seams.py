"""Seams between objects, open meshes seen flat, thin shapes: nothing may be lost that is there."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np

from raywalk.bench.cases import Case
from raywalk.bench.families import directions, unit_rows
from raywalk.bench.made_scenes import icosphere, mesh_object, placed, scene_of
from raywalk.bench.stress_rims import RIMS, lost_at_rims
from raywalk.bench.truth import triangle_meets
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Box, Cone, Disc, Ellipsoid, Shape, Sphere, Triangle

KINDS = ("triangle, triangle", "mesh, mesh", "triangle, mesh", "box, triangle", "box, mesh")
FLAT = ("triangle", "one triangle as a mesh", "flat sheet")
COSINES = (1e-2, 1e-3, 1e-5, 1e-7, 1e-9, 1e-12)
PAIRS = 100  # of objects, turned anew each
# Of float64's own errors of o + t d: of shapes as thin as can be; and of those sheared by 30, whose
# inverse cancels (condition 900), the bound of all hits: one in 160,000 that grazes at a cosine of
# 0.01 is 4.1 off.
THIN_BOUND, SHEARED_BOUND = 4.0, 8.0
HALF = 2.0**-53
SIDES = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]


def cases(count: int, seed: int) -> Iterator[Case]:
    """Seams and rims of each kind, flat rays, outlines of a closed mesh, thin shapes."""
    lost = "lost that rationals hit, rays"
    for place, kind in enumerate(KINDS):
        name = f"{kind}: at shared edges and corners"
        measured = lost_at_seams(kind, count, PAIRS, seed + place)
        yield Case("seams", name, lost, 0.0, float(measured), count, seed + place)
    for place, kind in enumerate(RIMS):
        measured = lost_at_rims(kind, count, PAIRS, seed + 40 + place)
        name = f"{kind}: at shared rims"
        yield Case("seams", name, "lost that are there, rays", 0.0, float(measured), count, seed)
    rays = max(300, count // 50)  # aimed so that most are hits, or judged one by one
    for kind in FLAT:
        measured = sum(lost_grazing(kind, cosine, rays, seed + 10) for cosine in COSINES)
        name, many = f"{kind}: at cosines of 1e-2 to 1e-12", rays * len(COSINES)
        yield Case("seams", name, lost, 0.0, float(measured), many, seed + 10)
    name, measured = "outlines of 20,480 triangles", lost_at_outlines(rays, seed + 20)
    yield Case("seams", name, lost, 0.0, float(measured), rays, seed + 20)
    for name, things, bound in (
        ("thin shapes", thin_shapes(), THIN_BOUND),
        ("sheared shapes", sheared_shapes(), SHEARED_BOUND),
    ):
        metric = f"more than {bound:g} roundings off o + t d, rays"
        off, many = off_their_rays(things, bound, rays, seed + 30), rays * len(things)
        yield Case("seams", name, metric, 0.0, float(off), many, seed + 30)


def lost_at_seams(kind: str, count: int, pairs: int, seed: int) -> int:
    """Rays aimed at the edge that two objects share, and at its ends, that meet neither though
    rationals meet one."""
    rng, lost = np.random.default_rng(seed), 0
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(pairs):
            objects, triangles, start, end = _pair(kind, rng, Path(folder))
            share = rng.uniform(size=(max(1, count // pairs), 1))
            share[::10], share[5::10] = 0.0, 1.0
            origin = start + 4.0 * rng.normal(size=(len(share), 3))
            direction = unit_rows(start + share * (end - start) - origin)
            lost += _lost(CompiledScene(scene_of(objects)), triangles, origin, direction)
    return lost


def _pair(
    kind: str, rng: np.random.Generator, folder: Path
) -> tuple[list[SceneObject | Shape], np.ndarray, np.ndarray, np.ndarray]:
    """Two objects, all their triangles, and the ends of the edge that they share."""
    a, b, c, d = rng.normal(size=(4, 3)) + rng.choice([0.0, 100.0]) * rng.normal(size=3)
    first: SceneObject | Shape
    if kind.startswith("box"):
        b = a + rng.uniform(0.5, 2.0, 3)
        corners = np.array([np.where([k & 1, k & 2, k & 4], b, a) for k in range(8)])
        start, end, first = corners[1], corners[3], Box(_triple(a), _triple(b))
        triangles = [corners[[p, q, r]] for p, q, r, _ in SIDES]
        triangles += [corners[[p, r, s]] for p, _, r, s in SIDES]
        second = np.array([start, end, start + rng.normal(size=3)])
    else:
        start, end, triangles = a, c, [np.array([a, b, c])]
        second = np.array([a, c, d])
        first = Triangle(*map(_triple, triangles[0]))
        if kind.startswith("mesh"):
            first = mesh_object(folder / "one.ply", triangles[0][None])
    other: SceneObject | Shape = Triangle(*map(_triple, second))
    if kind.endswith("mesh"):
        other = mesh_object(folder / "two.ply", second[None])
    return [first, other], np.array([*triangles, second]), start, end


def _lost(
    compiled: CompiledScene, triangles: np.ndarray, origin: np.ndarray, direction: np.ndarray
) -> int:
    """Rays that meet nothing, and in rationals one of these triangles."""
    t = compiled.nearest(rays_from(origin, direction))[0]
    return sum(
        any(
            (met := triangle_meets(each, origin[k], direction[k])) and met > 0 for each in triangles
        )
        for k in np.flatnonzero(np.isinf(t))
    )


def lost_grazing(kind: str, cosine: float, count: int, seed: int) -> int:
    """Rays along something flat and open, at this cosine to its normal, at its inside and edges."""
    rng = np.random.default_rng(seed)
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    corners = _sheet() @ turn if kind == "flat sheet" else rng.normal(size=(1, 3, 3))
    a, b, c = corners[0]
    normal = np.cross(b - a, c - a) / np.linalg.norm(np.cross(b - a, c - a))
    share = rng.dirichlet((1.0, 1.0, 1.0), count)
    share[::2, 0] = 0.0
    share /= share.sum(axis=1, keepdims=True)
    target = (share[:, :, None] * corners[rng.integers(0, len(corners), count)]).sum(axis=1)
    side = rng.choice([-1.0, 1.0], (count, 1))
    flat = unit_rows(np.cross(normal, directions(rng, count)))
    direction = unit_rows(flat - cosine * side * normal)
    with tempfile.TemporaryDirectory() as folder:
        mesh: SceneObject | Shape = mesh_object(Path(folder) / "flat.ply", corners)
        thing = Triangle(*map(_triple, corners[0])) if kind == "triangle" else mesh
        compiled = CompiledScene(scene_of([thing]))
    return _lost(compiled, corners, target - 3.0 * direction, direction)


def _sheet() -> np.ndarray:
    """(72, 3, 3) triangles of a square in y = 0."""
    places = np.linspace(0.0, 1.0, 7)
    grid = np.array([[[x, 0.0, z] for z in places] for x in places])
    a, b, c, d = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
    halves = [np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)]
    return np.concatenate([half.reshape(-1, 3, 3) for half in halves])


def lost_at_outlines(count: int, seed: int) -> int:
    """Rays that pass an edge of a fine closed mesh just inside of it, along the surface."""
    rng = np.random.default_rng(seed)
    corners = icosphere(5)
    face, side = rng.integers(0, len(corners), count), rng.integers(0, 3, count)
    a, b = corners[face, side], corners[face, (side + 1) % 3]
    share = rng.uniform(size=(count, 1))
    target = (share * a + (1.0 - share) * b) * (1.0 - 10.0 ** rng.uniform(-12, -6, (count, 1)))
    out = unit_rows(a + b)
    direction = unit_rows(
        unit_rows(np.cross(out, directions(rng, count)))
        + out * rng.uniform(-0.02, 0.02, (count, 1))
    )
    origin = target - 3.0 * direction
    with tempfile.TemporaryDirectory() as folder:
        compiled = CompiledScene(scene_of([mesh_object(Path(folder) / "ball.ply", corners)]))
    t = compiled.nearest(rays_from(origin, direction))[0]
    middle, lost = corners.mean(axis=1), 0
    for k in np.flatnonzero(np.isinf(t)):
        near = np.linalg.norm(middle - target[k], axis=1) < 0.3
        lost += _lost(compiled, corners[near], origin[k : k + 1], direction[k : k + 1])
    return lost


def thin_shapes() -> list[SceneObject]:
    """A million times as wide as they are thick."""
    return [
        SceneObject("thin", shape, 0)
        for shape in (
            Ellipsoid((0.0, 0.0, 0.0), (1.0, 1.0, 1e-6)),
            Ellipsoid((0.3, 0.2, 0.1), (1.0, 1.0, 1e-6), (30.0, 40.0, 50.0)),
            Ellipsoid((0.0, 0.0, 0.0), (1e-6, 1e-6, 1.0)),
            Cone((0.0, 0.0, 0.0), (0.0, 1e-6, 0.0), 1.0, 0.2),
        )
    ]


def sheared_shapes() -> list[SceneObject]:
    """Leaning thirty times as far as they are high; one a million times as flat besides."""
    shear = np.array([[1.0, 30.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    flat = np.diag([1.0, 1e-6, 1.0])
    shapes: list[tuple[Shape, np.ndarray]] = [
        (Sphere((0.0, 0.0, 0.0), 1.0), flat @ shear),
        (Box((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0)), shear),
        (Cone((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 1.0, 0.3), shear),
        (Disc((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 1.0), shear[[2, 0, 1]][:, [2, 0, 1]]),
    ]
    return [SceneObject("sheared", shape, 0, placed(linear)) for shape, linear in shapes]


def off_their_rays(things: list[SceneObject], bound: float, count: int, seed: int) -> int:
    """Hits further from o + t d than so many times its own error in float64: half a step for o,
    two for t d."""
    rng, off = np.random.default_rng(seed), 0
    for thing in things:
        compiled = CompiledScene(scene_of([thing]))
        to_world, centre = compiled.primitives.to_world[0], compiled.primitives.centre[0]
        target = rng.uniform(-0.7, 0.7, (count, 3)) @ to_world.T + centre
        origin = 3.0 * directions(rng, count)
        direction = unit_rows(target - origin)
        hits = compiled.hits(rays_from(origin, direction))
        for k in np.flatnonzero(np.isfinite(hits.t)):
            away, own = [], []
            for o, d, p in zip(origin[k], direction[k], hits.point[k], strict=True):
                exact = Fraction(o) + Fraction(float(hits.t[k])) * Fraction(d)
                away.append(float(Fraction(p) - exact))
                own.append(HALF * (abs(o) + 2.0 * abs(hits.t[k] * d)))
            off += bool(np.linalg.norm(away) > bound * np.linalg.norm(own))
    return off


def _triple(v: np.ndarray) -> tuple[float, float, float]:
    x, y, z = map(float, v)
    return x, y, z
