"""Closed meshes must hold water, broken triangles must not matter, slivers must be hit."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from raywalk.bench.cases import Case, none_of
from raywalk.bench.embree32 import Embree32
from raywalk.bench.families import around, directions, in_ball, unit_rows
from raywalk.bench.made_scenes import bunny, compiled_mesh, icosphere
from raywalk.geometry.compiled import rays_from

ASPECTS = (1e6, 1e8, 1e10)


def cases(count: int, seed: int) -> Iterator[Case]:
    """Holes (twice the rays: over 10^7 in all six cases of a full run), broken ones, slivers."""
    yield from holes("mesh of 1,280", icosphere(3), 0.3, np.zeros(3), 2 * count, seed)
    # This place in the bunny's chest is inside: checked by every ray that finds a way out.
    yield from holes("bunny", bunny(), 0.02, np.array([-0.2, 0.9, 0.0]), 2 * count, seed + 1)
    yield from broken_triangles(count, seed + 2)
    for place, aspect in enumerate(ASPECTS):
        yield sliver(aspect, count, seed + 3 + place)


def holes(
    name: str, corners: np.ndarray, reach: float, centre: np.ndarray, count: int, seed: int
) -> Iterator[Case]:
    """From inside a closed mesh each ray must meet it: at vertices, edges and anywhere."""
    rng = np.random.default_rng(seed)
    compiled, single = compiled_mesh(corners), Embree32(corners)
    for family in ("vertices", "edges", "anywhere"):
        open_ones = open32 = 0
        for share in np.array_split(np.arange(count), max(1, count // 262_144)):
            origin = centre + reach * in_ball(rng, len(share))
            target = aims(rng, corners, family, len(share))
            direction = directions(rng, len(share)) if target is None else target - origin
            rays = rays_from(origin, unit_rows(direction))
            open_ones += int(np.isinf(compiled.nearest(rays)[0]).sum())
            open32 += int((single.proposed(*rays[:2]) < 0).sum())
        yield none_of(
            count, open_ones, seed, "closed meshes", f"{name}, rays at {family}", "holes", open32,
            "Embree, robust",
        )  # fmt: skip


def aims(
    rng: np.random.Generator, corners: np.ndarray, family: str, count: int
) -> np.ndarray | None:
    """(n, 3) points of random vertices or edges; None for anywhere."""
    if family == "anywhere":
        return None
    face, corner = rng.integers(0, len(corners), count), rng.integers(0, 3, count)
    start, end = corners[face, corner], corners[face, (corner + 1) % 3]
    share = np.zeros(count) if family == "vertices" else rng.uniform(size=count)
    return np.asarray(start + share[:, None] * (end - start))


def broken_triangles(count: int, seed: int) -> Iterator[Case]:
    """Triangles that are NaN, infinite, at 1e30 or without area change no result."""
    rng = np.random.default_rng(seed)
    corners = icosphere(3)
    rays = rays_from(*around(rng, count))
    whole = compiled_mesh(corners).nearest(rays)
    added = {
        "NaN": np.full((1, 3, 3), np.nan),
        "infinite": np.array([[[np.inf, 0, 0], [0, 1, 0], [0, 0, 1]]]),
        "without area": np.array([[[0, 0, 0], [1, 1, 1], [2, 2, 2]], [[0, 0, 2]] * 3]) / 4,
        "twice the same": corners[:1],
        "at 1e30": np.array([[[1e30, 0, 0], [1e30, 1e29, 0], [1e30, 0, 1e29]]]),
    }
    for name, triangles in added.items():
        compiled = compiled_mesh(np.concatenate([corners, triangles]))
        reasons = compiled.meshes[0].triangles.dropped
        t, _, which, _ = compiled.nearest(rays)
        changed = (t != whole[0]) | (which != whole[2])
        note = ", ".join(f"{number} dropped: {reason}" for reason, number in reasons.items())
        yield none_of(
            count, changed, seed, "broken triangles", f"{name} added",
            "rays changed in t or triangle", note=note,
        )  # fmt: skip


def sliver(aspect: float, count: int, seed: int) -> Case:
    """One triangle of length 1 and width 1 / aspect, rays aimed well inside it."""
    rng = np.random.default_rng(seed)
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    corners = (np.array([[[0, 0, 0], [1, 0, 0], [0.4, 1 / aspect, 0]]]) - [0.5, 0, 0]) @ turn.T
    share = rng.dirichlet((1.0, 1.0, 1.0), count) * 0.7 + 0.1
    target = share @ corners[0]
    side = directions(rng, count)
    side *= np.sign(side @ turn[:, 2])[:, None]
    steep = unit_rows(side + turn[:, 2])  # not flat along it
    origin = target + 2.0 * steep
    rays = rays_from(origin, unit_rows(target - origin))
    missed = np.isinf(compiled_mesh(corners).nearest(rays)[0])
    missed32 = Embree32(corners).proposed(*rays[:2]) < 0
    return none_of(
        count, missed, seed, "slivers", f"aspect {aspect:g}", "rays inside that miss", missed32,
        "Embree",
    )  # fmt: skip
