"""Hit distances of every shape against 50 digits, and hits and misses at its edges."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from raywalk.bench.cases import Case, none_of
from raywalk.bench.families import (
    Pair,
    around,
    axis_parallel,
    directions,
    from_inside,
    grazing,
    in_ball,
    towards,
)
from raywalk.bench.glass_bodies import SOLIDS
from raywalk.bench.made_scenes import nearest_t, placed, scene_of
from raywalk.bench.truth import TrueHit, nearest_hit
from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.placement import placement
from raywalk.scene.shapes import Box, Cylinder, Disc, Ellipsoid, Plane, Sphere, Triangle

SUBJECT = "hit distances"
# Well conditioned: rounding the inputs themselves, half an ulp each, moves t by 2 ulp at most.
WELL_CONDITIONED = 4.0
BOUND = 8.0  # ulp of t, near and far
# Elsewhere: t is the exact answer for inputs at most this many ulp away.
BACKWARD_BOUND = 8.0
# A shape's numbers are rounded once or twice before tracing (1 / r, a unit axis), and so is
# the ray: a ray within this share of a shape's size of its edge may be seen either way.
MARGIN = 4e-15
# Rays whose verdict changes when the shape grows or shrinks by this are looked at one by one.
SUSPECT = 1e-6

SHEAR = [[1.1, 0.4, -0.3], [0.2, 0.7, 0.5], [-0.6, 0.1, 1.3]]
OBJECTS: dict[str, SceneObject] = {
    obj.name: obj
    for obj in (
        SceneObject("sphere", Sphere((0.1, -0.2, 0.05), 0.9), 0),
        SceneObject(
            "ellipsoid", Ellipsoid((0.1, 0.0, -0.1), (0.9, 0.5, 0.7), (20.0, 35.0, -50.0)), 0
        ),
        SceneObject(
            "needle 1:1000", Ellipsoid((0.1, 0.0, 0.0), (1e-3, 1e-3, 1.0), (20.0, 35.0, -50.0)), 0
        ),
        SceneObject(
            "flat ellipsoid 1:1000", Ellipsoid((0.1, 0.0, 0.0), (1, 1e-3, 1), (20.0, 35.0, 0.0)), 0
        ),
        SceneObject("cylinder", Cylinder((-0.3, -0.6, 0.2), (0.4, 0.7, -0.1), 0.6), 0),
        SceneObject("pin 1:1000", Cylinder((-0.6, -0.5, 0.2), (0.7, 0.4, -0.1), 1e-3), 0),
        SceneObject("open cylinder", Cylinder((-0.3, -0.6, 0.2), (0.4, 0.7, -0.1), 0.6, False), 0),
        SceneObject("box", Box((-0.6, -0.7, -0.5), (0.8, 0.4, 0.6)), 0),
        SceneObject("disc", Disc((0.1, 0.0, 0.2), (0.3, 0.5, 0.9), 0.9), 0),
        SceneObject("triangle", Triangle((-0.8, -0.6, 0.1), (0.9, -0.5, -0.2), (0.1, 0.8, 0.3)), 0),
        SceneObject("plane", Plane((0.0, -0.3, 0.0), (0.2, 0.9, 0.1)), 0),
        *(
            SceneObject(f"sheared {kind}", make()[0], 0, placed(SHEAR))
            for kind, make in SOLIDS.items()
        ),
    )
}  # fmt: skip

FAMILIES: dict[str, Callable[[np.random.Generator, int], Pair]] = {
    "random": around,
    "grazing": grazing,
    "axis-parallel": axis_parallel,
    "from inside": from_inside,
}
# Rays at the object itself, thin ones too, from this many sizes.
DISTANCES = (4.0, 1e3, 1e5, 1e7)
FAR = DISTANCES[1:]
SAMPLE = 500  # of each object and family, judged by mpmath


def cases(count: int, seed: int) -> Iterator[Case]:
    """Four cases an object: error of t near, far and badly conditioned; wrong verdicts."""
    for place, obj in enumerate(OBJECTS.values()):
        yield from of_object(obj, count // (len(FAMILIES) + len(DISTANCES)), seed + place)


def of_object(obj: SceneObject, count: int, seed: int) -> Iterator[Case]:
    """All families' rays at one object."""
    name, scene, wrong, looked_at = obj.name, scene_of([obj]), 0, 0
    errors: dict[str | float, tuple[np.ndarray, np.ndarray]] = {}
    families: list[str | float] = [*FAMILIES, *DISTANCES]
    for k, family in enumerate(families):
        rng = np.random.default_rng([seed, k])
        if isinstance(family, str):
            origin, direction = FAMILIES[family](rng, count)
        else:
            origin, direction = at_object(rng, count, obj, family)
        t = nearest_t([obj], origin, direction)
        asked = np.sort(rng.choice(count, min(count, SAMPLE), replace=False))
        errors[family] = judged(obj, origin, direction, t, asked)
        suspects = np.union1d(asked[::5], suspected(obj, origin, direction, t)[:SAMPLE])
        wrong += sum(is_wrong(scene, origin[k], direction[k], t[k]) for k in suspects)
        looked_at += len(suspects)
    for where in ("near", "from 1e3 to 1e7 sizes away"):
        chosen = [
            error[kappa <= WELL_CONDITIONED]
            for family, (error, kappa) in errors.items()
            if (family in FAR) == (where != "near")
        ]
        well = np.concatenate(chosen)
        yield Case(
            SUBJECT, f"{name}, {where}", "error of t where well conditioned, ulp", BOUND,
            largest(well), len(well), seed,
            note=f"median {np.median(well):.2f} ulp" if len(well) else "",
        )  # fmt: skip
    backward = np.concatenate([error / kappa for error, kappa in errors.values()])
    yield Case(
        SUBJECT, f"{name}, all rays", "error of t by its condition number, ulp",
        BACKWARD_BOUND, largest(backward), len(backward), seed,
    )  # fmt: skip
    yield none_of(
        count * len(errors), wrong, seed, SUBJECT, f"{name}, hit or miss",
        f"wrong beyond {MARGIN:g} of its edge", note=f"{looked_at:,} of them judged by mpmath",
    )  # fmt: skip


def at_object(rng: np.random.Generator, count: int, obj: SceneObject, distance: float) -> Pair:
    """Rays from around at points within the object, however thin it is."""
    linear, centre = placement(obj)
    return towards(distance * directions(rng, count), centre + in_ball(rng, count) @ linear.T)


def judged(
    obj: SceneObject, origin: np.ndarray, direction: np.ndarray, t: np.ndarray, asked: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Errors in ulp and condition numbers of the asked rays that hit by truth and by t."""
    scene = scene_of([obj])
    true = [(k, nearest_hit(scene, origin[k], direction[k])) for k in asked]
    met = [(k, hit) for k, hit in true if hit and np.isfinite(t[k])]
    errors = np.array([error_in_ulp(t[k], hit) for k, hit in met])
    return errors, np.array([condition(obj, origin[k], direction[k], hit) for k, hit in met])


def largest(values: np.ndarray) -> float:
    """NaN if there is none, which breaks every bound."""
    return float(values.max()) if len(values) else np.nan


def error_in_ulp(t: float, hit: TrueHit) -> float:
    """|t - truth| in steps of float64 at the truth."""
    return float(abs(hit.t - t)) / float(np.spacing(float(hit.t)))


def condition(obj: SceneObject, origin: np.ndarray, direction: np.ndarray, hit: TrueHit) -> float:
    """By how much t magnifies a relative error of its inputs, lengths taken from the shape.

    sum_k |n_k| (|o_k - c_k| + t |d_k| + |p_k - c_k|) / (t |n.d|): t moves by (n.e) / (n.d)
    when origin, direction or surface move by e.
    """
    n, t = np.array([float(x) for x in hit.normal]), float(hit.t)
    middle = middle_of(obj)
    from_centre = np.abs(origin - middle)
    on_surface = np.abs(origin + t * direction - middle)
    moved = np.abs(n) @ (from_centre + t * np.abs(direction) + on_surface)
    return float(moved / (t * abs(n @ direction)))


def suspected(
    obj: SceneObject, origin: np.ndarray, direction: np.ndarray, t: np.ndarray
) -> np.ndarray:
    """Rays whose verdict changes for a shape a millionth larger or smaller."""
    changed = np.zeros(len(t), bool)
    for share in (-SUSPECT, SUSPECT):
        other = nearest_t([grown(obj, 1.0 + share)], origin, direction)
        changed |= np.isinf(other) != np.isinf(t)
    return np.flatnonzero(changed)


def is_wrong(scene: Scene, origin: np.ndarray, direction: np.ndarray, t: float) -> bool:
    """Hit or miss against the truth, where the margin leaves no choice."""
    less, more = (nearest_hit(scene, origin, direction, g) for g in (-MARGIN, MARGIN))
    certain = (less is None) == (more is None)
    return certain and (less is None) != bool(np.isinf(t))


def middle_of(obj: SceneObject) -> np.ndarray:
    """(3,) world."""
    linear, centre = placement(obj)
    is_triangle = isinstance(obj.shape, Triangle)  # its canonical one has a corner at the origin
    return centre + linear @ (np.array([1.0, 1.0, 0.0]) / 3) if is_triangle else centre


def grown(obj: SceneObject, factor: float) -> SceneObject:
    """The object larger by a factor about its middle."""
    larger = placed(factor, (1.0 - factor) * middle_of(obj))
    return replace(obj, transform=larger @ obj.transform)
