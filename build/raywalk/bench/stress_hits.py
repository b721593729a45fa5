"""Hit distances of every shape against 50 digits, and hits and misses at its edges."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from raywalk.bench.cases import Case, per_million
from raywalk.bench.families import Pair, around, axis_parallel, from_inside, grazing
from raywalk.bench.made_scenes import scene_of
from raywalk.bench.truth import TrueHit, nearest_hit
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.model import (
    Box,
    Cylinder,
    Disc,
    Ellipsoid,
    Plane,
    Scene,
    Shape,
    Sphere,
    Triangle,
)

SUBJECT = "hit distances"
# Well conditioned: rounding the inputs themselves, half an ulp each, moves t by 2 ulp at most.
WELL_CONDITIONED = 4.0
NEAR_BOUND = 8.0  # ulp of t
# From a thousand sizes away every dot product rounds a thousand sizes, before they cancel.
FAR_BOUND = 16.0
# Elsewhere: t is the exact answer for inputs at most this many ulp away.
BACKWARD_BOUND = 8.0
# A shape's numbers are rounded once or twice before tracing (1 / r, a unit axis), and so is
# the ray: a ray within this share of a shape's size of its edge may be seen either way.
MARGIN = 4e-15
# Rays whose verdict changes when the shape grows or shrinks by this are looked at one by one.
SUSPECT = 1e-6

SHAPES: dict[str, Shape] = {
    "sphere": Sphere((0.1, -0.2, 0.05), 0.9),
    "ellipsoid": Ellipsoid((0.1, 0.0, -0.1), (0.9, 0.5, 0.7), (20.0, 35.0, -50.0)),
    "cylinder": Cylinder((-0.3, -0.6, 0.2), (0.4, 0.7, -0.1), 0.6),
    "open cylinder": Cylinder((-0.3, -0.6, 0.2), (0.4, 0.7, -0.1), 0.6, capped=False),
    "box": Box((-0.6, -0.7, -0.5), (0.8, 0.4, 0.6)),
    "disc": Disc((0.1, 0.0, 0.2), (0.3, 0.5, 0.9), 0.9),
    "triangle": Triangle((-0.8, -0.6, 0.1), (0.9, -0.5, -0.2), (0.1, 0.8, 0.3)),
    "plane": Plane((0.0, -0.3, 0.0), (0.2, 0.9, 0.1)),
}


FAMILIES: dict[str, Callable[[np.random.Generator, int], Pair]] = {
    "random": around,
    "grazing": grazing,
    "axis-parallel": axis_parallel,
    "from inside": from_inside,
    "from a thousand sizes away": lambda rng, count: around(rng, count, 1e3, 1.0),
}
FAR = "from a thousand sizes away"
SAMPLE = 1000  # of each shape and family, judged by mpmath


def cases(count: int, seed: int) -> Iterator[Case]:
    """Four cases a shape: error of t near, far and badly conditioned; wrong verdicts."""
    for place, (name, shape) in enumerate(SHAPES.items()):
        yield from of_shape(name, shape, count // len(FAMILIES), seed + place)


def of_shape(name: str, shape: Shape, count: int, seed: int) -> Iterator[Case]:
    """All families' rays at one shape."""
    scene, wrong, looked_at = scene_of([shape]), 0, 0
    errors: dict[str, tuple[np.ndarray, np.ndarray]] = {}
    for k, (family, rays) in enumerate(FAMILIES.items()):
        rng = np.random.default_rng([seed, k])
        origin, direction = rays(rng, count)
        t = nearest_t(scene, origin, direction)
        asked = np.sort(rng.choice(count, min(count, SAMPLE), replace=False))
        errors[family] = judged(shape, origin, direction, t, asked)
        suspects = np.union1d(asked[::5], suspected(shape, origin, direction, t)[:SAMPLE])
        wrong += sum(is_wrong(scene, origin[k], direction[k], t[k]) for k in suspects)
        looked_at += len(suspects)
    for where, bound in (("near", NEAR_BOUND), ("from a thousand sizes away", FAR_BOUND)):
        chosen = [errors[family] for family in FAMILIES if (family == FAR) == (bound == FAR_BOUND)]
        well = np.concatenate([error[kappa <= WELL_CONDITIONED] for error, kappa in chosen])
        yield Case(
            SUBJECT, f"{name}, {where}", "error of t where well conditioned, ulp", bound,
            largest(well), len(well), seed,
            note=f"median {np.median(well):.2f} ulp" if len(well) else "",
        )  # fmt: skip
    backward = np.concatenate([error / kappa for error, kappa in errors.values()])
    yield Case(
        SUBJECT, f"{name}, all rays", "error of t by its condition number, ulp",
        BACKWARD_BOUND, largest(backward), len(backward), seed,
    )  # fmt: skip
    yield Case(
        SUBJECT, f"{name}, hit or miss", f"wrong beyond {MARGIN:g} of its edge, ppm",
        0.0, per_million(wrong, count * len(FAMILIES)), count * len(FAMILIES), seed,
        note=f"{looked_at:,} of them judged by mpmath",
    )  # fmt: skip


def nearest_t(scene: Scene, origin: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """(n,) by the tracer's own door."""
    return CompiledScene(scene).nearest(rays_from(origin, direction))[0]


def judged(
    shape: Shape, origin: np.ndarray, direction: np.ndarray, t: np.ndarray, asked: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Errors in ulp and condition numbers of the asked rays that hit by truth and by t."""
    scene = scene_of([shape])
    true = [(k, nearest_hit(scene, origin[k], direction[k])) for k in asked]
    met = [(k, hit) for k, hit in true if hit and np.isfinite(t[k])]
    errors = np.array([error_in_ulp(t[k], hit) for k, hit in met])
    return errors, np.array([condition(shape, origin[k], direction[k], hit) for k, hit in met])


def largest(values: np.ndarray) -> float:
    """NaN if there is none, which breaks every bound."""
    return float(values.max()) if len(values) else np.nan


def error_in_ulp(t: float, hit: TrueHit) -> float:
    """|t - truth| in steps of float64 at the truth."""
    return float(abs(hit.t - t)) / float(np.spacing(float(hit.t)))


def condition(shape: Shape, origin: np.ndarray, direction: np.ndarray, hit: TrueHit) -> float:
    """By how much t magnifies a relative error of its inputs, lengths taken from the shape.

    sum_k |n_k| (|o_k - c_k| + t |d_k| + |p_k - c_k|) / (t |n.d|): t moves by (n.e) / (n.d)
    when origin, direction or surface move by e.
    """
    n, t = np.array([float(x) for x in hit.normal]), float(hit.t)
    from_centre = np.abs(origin - middle_of(shape))
    on_surface = np.abs(origin + t * direction - middle_of(shape))
    moved = np.abs(n) @ (from_centre + t * np.abs(direction) + on_surface)
    return float(moved / (t * abs(n @ direction)))


def suspected(shape: Shape, origin: np.ndarray, direction: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Rays whose verdict changes for a shape a millionth larger or smaller."""
    changed = np.zeros(len(t), bool)
    for share in (-SUSPECT, SUSPECT):
        other = nearest_t(scene_of([grown(shape, 1.0 + share)]), origin, direction)
        changed |= np.isinf(other) != np.isinf(t)
    return np.flatnonzero(changed)


def is_wrong(scene: Scene, origin: np.ndarray, direction: np.ndarray, t: float) -> bool:
    """Hit or miss against the truth, where the margin leaves no choice."""
    less, more = (nearest_hit(scene, origin, direction, g) for g in (-MARGIN, MARGIN))
    certain = (less is None) == (more is None)
    return certain and (less is None) != bool(np.isinf(t))


def middle_of(shape: Any) -> np.ndarray:
    match shape:
        case Cylinder():
            return (np.array(shape.start) + shape.end) / 2
        case Box():
            return (np.array(shape.minimum) + shape.maximum) / 2
        case Triangle():
            return (np.array(shape.a) + shape.b + shape.c) / 3
        case Plane():
            return np.array(shape.point)
    return np.array(shape.center)


def grown(shape: Any, factor: float) -> Shape:
    """The shape larger by a factor about its middle."""

    def away(point: tuple[float, float, float]) -> Any:
        middle = middle_of(shape)
        return tuple(middle + factor * (np.array(point) - middle))

    match shape:
        case Sphere() | Disc():
            return replace(shape, radius=shape.radius * factor)
        case Ellipsoid():
            x, y, z = shape.radii
            return replace(shape, radii=(x * factor, y * factor, z * factor))
        case Cylinder():
            ends = {"start": away(shape.start), "end": away(shape.end)}
            return replace(shape, radius=shape.radius * factor, **ends)
        case Box():
            return Box(away(shape.minimum), away(shape.maximum))
        case Triangle():
            return Triangle(away(shape.a), away(shape.b), away(shape.c))
    return shape
