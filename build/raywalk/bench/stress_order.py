"""Which of two close surfaces comes first: touching spheres, coincident and coplanar shapes."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from raywalk.bench.cases import Case, none_of
from raywalk.bench.embree32 import sphere_t
from raywalk.bench.families import around, directions, in_ball, towards
from raywalk.bench.made_scenes import scene_of
from raywalk.bench.twofold import nearest_root, sphere_roots
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.shapes import Box, Disc, Plane, Shape, Sphere, Triangle

CLOSE = (1e-3, 1e-4)  # of the contact: the spheres are about the square of this apart there

# Each pair shares a surface; object 0 is to win wherever both are met at one distance.
SHARED: dict[str, tuple[Shape, Shape]] = {
    "the same sphere twice": (Sphere((0.1, 0.2, 0.3), 0.8), Sphere((0.1, 0.2, 0.3), 0.8)),
    "the same triangle, corners turned": (
        Triangle((-0.8, -0.6, 0.1), (0.9, -0.5, 0.1), (0.1, 0.8, 0.1)),
        Triangle((0.9, -0.5, 0.1), (0.1, 0.8, 0.1), (-0.8, -0.6, 0.1)),
    ),
    "disc on a plane": (
        Disc((0.2, 0.1, 0.0), (0.0, 1.0, 0.0), 0.8), Plane((0.0, 0.1, 0.0), (0.0, 1.0, 0.0))
    ),
    "plane under a disc": (
        Plane((0.0, 0.1, 0.0), (0.0, 1.0, 0.0)), Disc((0.2, 0.1, 0.0), (0.0, 1.0, 0.0), 0.8)
    ),
    "box top and disc": (
        Disc((0.0, 0.25, 0.0), (0.0, 1.0, 0.0), 0.5), Box((-0.8, -0.5, -0.8), (0.8, 0.25, 0.8))
    ),
}  # fmt: skip


def cases(count: int, seed: int) -> Iterator[Case]:
    """Touching, then shared surfaces."""
    for place, close in enumerate(CLOSE):
        yield touching(close, count, seed + place)
    for place, name in enumerate(SHARED):
        yield from shared(name, count, seed + place)


def touching(close: float, count: int, seed: int) -> Case:
    """Unit spheres that touch at the origin, rays that pass this close to it."""
    rng = np.random.default_rng(seed)
    centres = (np.array([-1.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0]))
    target = close * in_ball(rng, count)
    origin, direction = towards(target + 3.0 * directions(rng, count), target)
    scene = scene_of([Sphere((-1.0, 0.0, 0.0), 1.0), Sphere((1.0, 0.0, 0.0), 1.0)])
    _, met, _, _ = CompiledScene(scene).nearest(rays_from(origin, direction))
    roots = [sphere_roots(origin, direction, centre, 1.0) for centre in centres]
    true = [nearest_root(near, far) for near, far, _ in roots]
    with np.errstate(invalid="ignore"):
        gap = ((true[0] - true[1].hi) - true[1].lo).value()
    first = np.where(true[0].hi == true[1].hi, gap > 0, true[0].hi > true[1].hi).astype(int)
    expected = np.where(np.isinf(true[0].hi) & np.isinf(true[1].hi), -1, first)
    sure = (np.abs(roots[0][2]) > 4e-15) & (np.abs(roots[1][2]) > 4e-15)
    sure &= ~(np.abs(gap) < 4e-15)
    t32 = [sphere_t(origin, direction, centre, 1.0) for centre in centres]
    met32 = np.where(np.isinf(t32[0]) & np.isinf(t32[1]), -1, t32[1] < t32[0])
    return none_of(
        sure, met != expected, seed, "touching spheres", f"rays within {close:g} of the contact",
        "wrong object", met32 != expected, "same formula",
    )  # fmt: skip


def shared(name: str, count: int, seed: int) -> Iterator[Case]:
    """The lower object wins a tie, and two runs agree."""
    rng = np.random.default_rng(seed)
    rays = rays_from(*around(rng, count, aim=0.6))
    compiled = CompiledScene(scene_of(SHARED[name]))
    t, met, _, _ = compiled.nearest(rays)
    alone = [CompiledScene(scene_of([shape])).nearest(rays)[0] for shape in SHARED[name]]
    with np.errstate(invalid="ignore"):
        tie = np.abs(alone[0] - alone[1]) <= 8 * np.spacing(alone[0])
    tie &= np.isfinite(alone[0])
    yield none_of(
        tie, met != 0, seed, "shared surfaces", name, "ties lost by the lower object",
        note=f"of them {int((alone[0] != alone[1])[tie].sum()):,} rounded apart",
    )  # fmt: skip
    again = CompiledScene(scene_of(SHARED[name])).nearest(rays)
    changed = int(((again[0] != t) | (again[1] != met)).sum())
    yield Case(
        "shared surfaces", f"{name}, twice", "changes between two runs, rays",
        0.0, float(changed), count, seed,
    )  # fmt: skip
