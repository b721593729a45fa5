"""Hundreds of bounces: inside a mirrored sphere, between parallel mirrors, through a shell."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from raywalk.bench.cases import Case, none_of
from raywalk.bench.families import directions, from_inside, perpendicular, unit_rows
from raywalk.bench.made_scenes import scene_of
from raywalk.bench.twofold import Twofold, columns, dot, sphere_roots
from raywalk.geometry.compiled import CompiledScene, Hits, Rays, rays_from
from raywalk.geometry.roots import NOWHERE
from raywalk.optics.scatter import mirror_directions
from raywalk.scene.model import Scene
from raywalk.scene.shapes import Plane, Sphere

# Bounces: bound of the point's median error in radii, and which share of the rays goes so far.
IN_SPHERE = {10: (8e-15, 1), 50: (3e-13, 5), 100: (1e-12, 10), 200: (1e-11, 20), 1000: (1e-10, 100)}
# No ray may be further off than this share of its way, after however many bounces.
BY_THE_WAY = 1e-12
# Bounces: bound of the point's error as a share of the way.
BETWEEN = {100: (3e-15, 10), 200: (1e-12, 20), 1000: (1e-13, 100)}
THICKNESS = (1e-4, 1e-5, 1e-6, 1e-7, 1e-8)
UNIT = Sphere((0.0, 0.0, 0.0), 1.0)


def cases(count: int, seed: int) -> Iterator[Case]:
    """Each long path against its closed form, to 32 digits."""
    for place, (bounces, (bound, share)) in enumerate(IN_SPHERE.items()):
        yield from mirrored_sphere(bounces, bound, max(count // share, 100), seed + place)
    for place, (bounces, (bound, share)) in enumerate(BETWEEN.items()):
        yield parallel_mirrors(bounces, bound, max(count // share, 100), seed + place)
    for place, thickness in enumerate(THICKNESS):
        yield glass_shell(thickness, count, seed + place)


def mirrored_sphere(bounces: int, bound: float, count: int, seed: int) -> Iterator[Case]:
    """Inside a sphere all chords turn by one angle about one axis: a power of a rotation."""
    origin, direction = from_inside(np.random.default_rng(seed), count, reach=0.9)
    hits = followed(scene_of([UNIT]), origin, direction, bounces)
    true = turned_on(origin, direction, bounces - 1)
    error = np.max([np.abs((hits.point[:, k] - true[k]).value()) for k in range(3)], axis=0)
    if (hits.object == NOWHERE).any():
        error = np.full(1, np.inf)
    yield Case(
        "mirrored sphere from inside", f"{bounces} bounces", "error of the point in radii, median",
        bound, float(np.median(error)), count, seed,
        float(np.median(sphere_path32(origin, direction, bounces, true))), "same formula",
    )  # fmt: skip
    chord = hits.t  # each is as long as the last
    yield Case(
        "mirrored sphere from inside", f"{bounces} bounces, worst",
        "error of the point by the way, max", BY_THE_WAY, float((error / (bounces * chord)).max()),
        count, seed, note=f"{error.max():.1e} radii",
    )  # fmt: skip


def followed(scene: Scene, origin: np.ndarray, direction: np.ndarray, bounces: int) -> Hits:
    """The hits after so many mirror hits, by the tracer's own steps."""
    compiled = CompiledScene(scene)
    rays = rays_from(origin, direction)
    hits = compiled.hits(rays)
    for _ in range(bounces - 1):
        away = mirror_directions(rays.direction, hits.normal, hits.geometric)
        rays = Rays(hits.point, away, hits.object, hits.inside, hits.triangle)
        hits = compiled.hits(rays)
    return hits


def turned_on(origin: np.ndarray, direction: np.ndarray, times: int) -> list[Twofold]:
    """Point of the first hit, turned `times` times by the angle of one chord.

    Two hits p1 and p2 = p1 + chord span the plane; with z = p1.p2 + i |p1 x p2| the later
    ones are Re(z^k) p1 + Im(z^k) e, e square to p1 in that plane.
    """
    _, far, _ = sphere_roots(origin, direction, np.zeros(3), 1.0)
    d = columns(direction)
    first = [o + far * x for o, x in zip(columns(origin), d, strict=True)]
    # The mirrored direction is in the plane of p1 and d; its chord has the same length.
    along, square = dot(first, d), dot(d, d)
    tangent = [x - along * p for x, p in zip(d, first, strict=True)]
    size = dot(tangent, tangent).sqrt()
    e = [x / size for x in tangent]
    # sin and cos of the turn: direction has parts -along (inwards) and size (across).
    real = (square - 2.0 * (along * along)) / square * (-1.0)
    imaginary = 2.0 * (along * size) / square
    # From p1 the chord leads to cos(turn) p1 + sin(turn) e with cos(turn) = 1 - 2 cos^2(angle).
    real, imaginary = power(-real, imaginary, times)
    return [real * p + imaginary * x for p, x in zip(first, e, strict=True)]


def power(real: Twofold, imaginary: Twofold, times: int) -> tuple[Twofold, Twofold]:
    """(real + i imaginary)^times by repeated squaring."""
    x, y = Twofold(np.ones_like(real.hi)), Twofold(np.zeros_like(real.hi))
    while times:
        if times & 1:
            x, y = x * real - y * imaginary, x * imaginary + y * real
        real, imaginary = real * real - imaginary * imaginary, 2.0 * (real * imaginary)
        times >>= 1
    return x, y


def sphere_path32(
    origin: np.ndarray, direction: np.ndarray, bounces: int, true: list[Twofold]
) -> np.ndarray:
    """Error of the same path in float32, with the usual start 1e-4 off the surface."""
    p, d = origin.astype(np.float32), direction.astype(np.float32)
    for _ in range(bounces):
        b, c = (p * d).sum(axis=1), (p * p).sum(axis=1) - np.float32(1)
        t = -b + np.sqrt(np.maximum(b * b - c, np.float32(0)))
        p = p + t[:, None] * d
        n = p / np.sqrt((p * p).sum(axis=1, keepdims=True))
        d = d - np.float32(2) * (d * n).sum(axis=1, keepdims=True) * n
        at, p = p, p - np.float32(1e-4) * n
    return np.asarray(np.max([np.abs(at[:, k] - true[k].value()) for k in range(3)], axis=0))


def parallel_mirrors(bounces: int, bound: float, count: int, seed: int) -> Case:
    """Unfolded, the path between the planes z = 0 and z = 1 is a straight line."""
    rng = np.random.default_rng(seed)
    origin, direction = rng.uniform(0.2, 0.8, (count, 3)), directions(rng, count)
    direction[:, 2] = np.where(direction[:, 2] < 0, -1.0, 1.0) * (np.abs(direction[:, 2]) + 0.1)
    direction = unit_rows(direction)
    floor, ceiling = (
        Plane((0.0, 0.0, 0.0), (0.0, 0.0, 1.0)),
        Plane((0.0, 0.0, 1.0), (0.0, 0.0, -1.0)),
    )
    hits = followed(scene_of([floor, ceiling]), origin, direction, bounces)
    upwards = direction[:, 2] > 0
    height = np.where(upwards, bounces - origin[:, 2], origin[:, 2] + (bounces - 1))
    # Exact in twofold: the heights are sums of a number and its distance to a whole one.
    start = Twofold(origin[:, 2])
    rise = Twofold(np.where(upwards, float(bounces), float(bounces - 1)))
    way = (rise + start * np.where(upwards, -1.0, 1.0)) / np.abs(direction[:, 2])
    error = np.max([
        np.abs((hits.point[:, k] - (way * direction[:, k] + origin[:, k])).value())
        for k in range(2)
    ], axis=0)  # fmt: skip
    lost = (hits.object == NOWHERE).any()
    relative = error / np.maximum(way.value(), height)
    return Case(
        "parallel mirrors", f"{bounces} bounces", "error of the point by the way, max",
        bound, np.inf if lost else float(relative.max()), count, seed,
    )  # fmt: skip


def glass_shell(thickness: float, count: int, seed: int) -> Case:
    """Straight through a shell: outer, inner, inner, outer; or outer twice beside the inner."""
    rng = np.random.default_rng(seed)
    inner = 1.0 - thickness
    scene = scene_of([Sphere((0.0, 0.0, 0.0), 1.0), Sphere((0.0, 0.0, 0.0), inner)])
    compiled = CompiledScene(scene)
    direction = directions(rng, count)
    off = np.sqrt(rng.uniform(0.0, 1.0, count)) * (1.0 - 1e-12)
    origin = off[:, None] * perpendicular(rng, direction) - 3.0 * direction
    depth = [sphere_roots(origin, direction, np.zeros(3), r)[2] for r in (1.0, inner)]
    clear = np.min(np.abs(depth), axis=0) > 1e-14
    through = depth[1] > 0
    expected = np.where(through[:, None], [0, 1, 1, 0, NOWHERE], [0, 0, NOWHERE, NOWHERE, NOWHERE])
    rays, wrong, going = rays_from(origin, direction), np.zeros(count, bool), np.arange(count)
    for step in range(5):
        hits = compiled.hits(rays)
        wrong[going] |= hits.object != expected[going, step]
        on = hits.object != NOWHERE
        going = going[on]
        rays = Rays(
            hits.point[on], rays.direction[on], hits.object[on], ~hits.inside[on], hits.triangle[on]
        )
    return none_of(
        clear, wrong, seed, "glass shell", f"thickness {thickness:g}", "wrong order of interfaces",
        shell32(origin, direction, inner) != through, "same formula",
    )  # fmt: skip


def shell32(origin: np.ndarray, direction: np.ndarray, inner: float) -> np.ndarray:
    """Whether float32 meets the inner sphere behind the outer one."""
    o, d = origin.astype(np.float32), direction.astype(np.float32)
    a, b, square = (d * d).sum(axis=1), (o * d).sum(axis=1), (o * o).sum(axis=1)
    with np.errstate(invalid="ignore"):
        first, second = (
            (-b - np.sqrt(b * b - a * (square - np.float32(r) ** 2))) / a for r in (1.0, inner)
        )
        return np.asarray(second > first)
