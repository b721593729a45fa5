"""Time a ray over the number of primitives: incoherent rays in a cube full of spheres."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np

from raywalk.bench.cases import Case
from raywalk.bench.families import incoherent
from raywalk.bench.made_scenes import scene_of
from raywalk.bench.run_time import interleaved
from raywalk.bench.speed_triangles import slope
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.nearest import nearest_primitive
from raywalk.geometry.sphere_tree import MANY
from raywalk.scene.shapes import Sphere

COUNTS = (100, 1_000, 4_000, 16_000)
RAYS = 16_384
# Exponent of the growth from the first count that has a tree on; 1 would be asking every sphere. A
# line through n equal spheres of a full cube comes near the cube root of n of them.
GROWTH = 0.6
# Of a tree's time over that of asking all, at the largest count; as eight spheres are asked at a
# time, the tree has to spare far more than it costs.
GAIN = 0.5


def full_cube(count: int, seed: int) -> list[Sphere]:
    """So many spheres in a cube of side 4, which fill as much of it whatever their number."""
    rng = np.random.default_rng(seed)
    radius = 1.6 / np.cbrt(count)
    return [
        Sphere((x, y, z), radius * size)
        for x, y, z, size in np.column_stack(
            [rng.uniform(-2.0, 2.0, (count, 3)), rng.uniform(0.5, 1.0, count)]
        ).tolist()
    ]


def primitives(rounds: int, seed: int, counts: Sequence[int] = COUNTS) -> list[dict[str, Any]]:
    """Of each count: its time a ray over the first's, and over that of asking every sphere."""
    origin, direction = incoherent(np.random.default_rng(seed), RAYS)
    rays = rays_from(origin, direction)
    scenes = [CompiledScene(scene_of(full_cube(count, seed))) for count in counts]
    limit = np.full(RAYS, np.inf)
    columns = rays.origin, rays.direction, rays.leaving, rays.inner, limit
    actions = [partial(scene.nearest, rays, limit) for scene in scenes]
    times = interleaved(actions, rounds, 0)
    rows = []
    for count, scene, (_, ratio) in zip(counts, scenes, times, strict=True):
        every = partial(nearest_primitive, scene.primitives, *columns)
        of_all = interleaved([partial(scene.nearest, rays, limit), every], 3, 1)[0][1]
        rows.append({"spheres": count, "ratio": ratio, "of all": of_all})
    return rows


def as_table(rows: Sequence[dict[str, Any]]) -> Iterator[str]:
    """Ratios only: seconds are of one machine."""
    for row in rows:
        yield (
            f"  {row['spheres']:,} spheres: {row['ratio']:.2f} times the time a ray, "
            f"{row['of all']:.2f} of asking every sphere"
        )


def primitive_cases(rows: Sequence[dict[str, Any]], seed: int) -> Iterator[Case]:
    """Far less than in proportion where there is a tree, and there for a reason."""
    grown = [row for row in rows if row["spheres"] > MANY]
    name = f"{grown[0]['spheres']:,} to {grown[-1]['spheres']:,} spheres"
    exponent = slope([(row["spheres"], row["ratio"]) for row in grown])
    yield Case(
        "primitives",
        name,
        "time a ray grows as spheres to the power of",
        GROWTH,
        exponent,
        RAYS,
        seed,
    )
    name = f"{grown[-1]['spheres']:,} spheres"
    share = "time with the tree over that of asking all"
    yield Case("primitives", name, share, GAIN, grown[-1]["of all"], RAYS, seed)
