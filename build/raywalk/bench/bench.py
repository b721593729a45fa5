"""Run time against error, on the same rays in one run: what `make bench` measures."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from raywalk.bench.cases import Case, per_million
from raywalk.bench.contenders import Met, Method, for_mesh, for_spheres
from raywalk.bench.errors import Errors, Truth, errors_of, mesh_truth, sphere_truth
from raywalk.bench.families import Pair, coherent, in_ball, incoherent, towards
from raywalk.bench.made_scenes import bunny, twenty_spheres
from raywalk.bench.run_time import interleaved

SEED = 20_260
SIDE = 512  # rays: its square
ROUNDS = 9
SAMPLE = 1000  # rays of each task that mpmath judges
# Of our path, where the mesh stands near the origin.
BOUND = {"median": 1e-15, "largest": 1e-12, "wrong": 0.0}
# Of our path's time, over that of the peer that the goal was set by.
TIMES = {
    "spheres-coherent": ("Mitsuba 3, llvm (its own spheres)", 1.0),
    "spheres-incoherent": ("Mitsuba 3, llvm (its own spheres)", 0.9),
    "mesh-coherent": ("Embree float32, as is", 1.0),
    "mesh-incoherent": ("Embree float32, as is", 1.2),
    "mesh-vertices": ("Embree float32, as is", 4.0),
    "mesh-far": ("Embree float32, as is", 1.0),
}
FAR = 1e6  # where the moved mesh stands, in its own sizes
# Errors of t smaller than float64's own rounding count as equal.
ROUNDING = 2.0**-53


def tasks(side: int = SIDE, rounds: int = ROUNDS, seed: int = SEED) -> Iterator[dict[str, Any]]:
    """Six tasks: spheres and mesh, coherent and incoherent; mesh at its vertices, and far out."""
    rng = np.random.default_rng(seed)
    spheres = twenty_spheres(seed)
    methods, missing = for_spheres(spheres)
    truth = partial(sphere_truth, spheres)
    for key, rays in _rays(rng, side, 7.0, 3.0).items():
        about = f"20 spheres, {side * side:,} {key} rays"
        named = Named(f"spheres-{key}", f"Spheres, {key} rays", about, "Embree float32, level 64")
        yield task(named, methods, missing, rays, truth, rounds, rng)
    yield from mesh_tasks(rng, side, rounds)


def mesh_tasks(rng: np.random.Generator, side: int, rounds: int) -> Iterator[dict[str, Any]]:
    """The bunny in the middle, then far from it."""
    floor = "Embree float32, as is"
    corners = bunny()
    corners = corners - (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1))) / 2
    methods, missing = for_mesh(corners)
    for key, rays in _rays(rng, side, 2.5, 1.0).items():
        about = f"the bunny of {len(corners):,} triangles, {side * side:,} {key} rays"
        named = Named(f"mesh-{key}", f"Mesh, {key} rays", about, floor)
        yield task(named, methods, missing, rays, partial(mesh_truth, corners), rounds, rng)
    about = (
        f"the bunny, {side * side:,} rays from inside at its vertices: each must hit, the wrong "
        "ones are holes. Where a silhouette's vertex may be passed on either side, errors are not "
        "counted"
    )
    named = Named("mesh-vertices", "Mesh, rays at vertices", about, floor, all_hit=True)
    rays = at_vertices(rng, corners, side * side)
    yield task(named, methods, missing, rays, partial(mesh_truth, corners), rounds, rng)
    moved = corners + FAR  # rounded here: this is the mesh that the truth knows
    methods, missing = for_mesh(moved)
    origin, direction = coherent(side, (0.0, 0.0, 2.5), 0.45)
    about = f"the bunny moved by {FAR:g} along each axis, {side * side:,} coherent rays"
    named = Named("mesh-far", "Mesh far from the origin", about, floor)
    rays = (origin + FAR, direction)
    yield task(named, methods, missing, rays, partial(mesh_truth, moved), rounds, rng)


@dataclass(frozen=True)
class Named:
    """What a task is called, and beside which method times are given."""

    key: str
    title: str
    about: str
    floor: str
    all_hit: bool = False  # every ray hits by construction, so all are counted, not a sample


def at_vertices(rng: np.random.Generator, corners: np.ndarray, count: int) -> Pair:
    """From a ball in the bunny's chest, of which every way out crosses the mesh."""
    origin = np.array([-0.03, -0.2, 0.015]) + 0.02 * in_ball(rng, count)
    face, corner = rng.integers(0, len(corners), count), rng.integers(0, 3, count)
    return towards(origin, corners[face, corner])


def _rays(rng: np.random.Generator, side: int, away: float, reach: float) -> dict[str, Pair]:
    return {
        "coherent": coherent(side, (0.0, 0.0, away), 0.45),
        "incoherent": incoherent(rng, side * side, reach),
    }


def task(
    named: Named, methods: list[Method], missing: list[str], rays: Pair,
    truth_of: Callable[[np.ndarray, np.ndarray], Truth], rounds: int, rng: np.random.Generator,
) -> dict[str, Any]:  # fmt: skip
    """Every method timed and judged on the same rays, as plain data."""
    chosen = rng.choice(len(rays[0]), SAMPLE, replace=False)
    truth = truth_of(rays[0][chosen], rays[1][chosen])
    beside = next(k for k, method in enumerate(methods) if method.name == named.floor)
    times = interleaved([partial(method.hits, *rays) for method in methods], rounds, beside)
    rows = []
    for method, (seconds, ratio) in zip(methods, times, strict=True):
        met = method.hits(*rays)
        judged = Met(met.t[chosen], met.point[chosen], met.normal[chosen])
        errors = errors_of(judged, truth, either_way=named.all_hit)
        wrong = per_million(errors.wrong, SAMPLE)
        if named.all_hit:
            wrong = per_million(int(np.isinf(met.t).sum()), len(met.t))
        rows.append(row(method, errors, seconds / len(rays[0]), ratio, wrong))
    absent = f" Not installed, so not measured: {', '.join(missing)}." if missing else ""
    words = (
        f"{named.about}; each method gives distance, point and normal; errors of {SAMPLE:,} rays."
    )
    return {
        "key": named.key, "title": named.title, "floor": named.floor, "methods": rows,
        "about": words[0].upper() + words[1:] + absent,
    }  # fmt: skip


def row(
    method: Method, errors: Errors, seconds: float, ratio: float, wrong: float
) -> dict[str, Any]:
    """One line of the table; seconds a ray."""
    return {
        "name": method.name, "ours": method.ours, "nanoseconds": 1e9 * seconds,
        "rate": 1e-6 / seconds, "ratio": ratio, "median": errors.median,
        "largest": errors.largest, "point": errors.point, "normal": errors.normal, "wrong": wrong,
    }  # fmt: skip


def as_line(method: dict[str, Any]) -> str:
    """One method for the command line."""
    return (
        f"  {method['name']}: {method['nanoseconds']:.0f} ns ({method['ratio']:.2f}), error of t "
        f"{method['median']:.1e} median, {method['largest']:.1e} largest, {method['wrong']:.0f} "
        "ppm wrong"
    )


def bounds(task: dict[str, Any], seed: int) -> Iterator[Case]:
    """Our path's own bounds in one task."""
    ours = next(method for method in task["methods"] if method["ours"])
    floor = next(method for method in task["methods"] if method["name"] == task["floor"])
    words = {"median": "relative error of t, median", "largest": "relative error of t, max",
             "wrong": "wrong hits, ppm"}  # fmt: skip
    for which, bound in BOUND.items():
        yield Case(
            "time against error", task["title"], words[which], bound, ours[which], SAMPLE, seed,
            floor[which], floor["name"],
        )  # fmt: skip


def time_bounds(task: dict[str, Any], seed: int, rays: int) -> Iterator[Case]:
    """How long our path takes beside the task's peer, where that is installed."""
    name, bound = TIMES[task["key"]]
    ours = next(method for method in task["methods"] if method["ours"])
    for peer in task["methods"]:
        if peer["name"] == name:
            ratio = ours["nanoseconds"] / peer["nanoseconds"]
            metric = f"time over that of {name}"
            yield Case("time", task["title"], metric, bound, ratio, rays, seed)


def beats(method: dict[str, Any], ours: dict[str, Any]) -> bool:
    """Faster, and no error larger: below a rounding all errors are equal."""
    faster = method["nanoseconds"] < ours["nanoseconds"]
    exact = all(max(method[e], ROUNDING) <= max(ours[e], ROUNDING) for e in ("median", "largest"))
    return bool(faster and exact and method["wrong"] <= ours["wrong"])


def says(tasks: list[dict[str, Any]]) -> Iterator[str]:
    """Sentences on where our path stands, the unwelcome ones first."""
    winners = set()
    for task in tasks:
        ours = next(method for method in task["methods"] if method["ours"])
        for method in task["methods"]:
            if not method["ours"] and beats(method, ours):
                winners.add(method["name"])
                yield (
                    f"{task['title']}: {method['name']} is faster than our path "
                    f"({ours['nanoseconds'] / method['nanoseconds']:.2f} times) and as exact here "
                    f"(largest error {method['largest']:.1e} against {ours['largest']:.1e})."
                )
    yield from where_winners_fail(tasks, winners)
    where = ", ".join(task["title"].lower() for task in tasks if not any(
        beats(other, ours) for ours in task["methods"] if ours["ours"] for other in task["methods"]
    ))  # fmt: skip
    if where:
        yield f"Nothing measured is both faster and at least as exact as our path on: {where}."
    for task in tasks:
        yield fastest(task)


def where_winners_fail(tasks: list[dict[str, Any]], winners: set[str]) -> Iterator[str]:
    """The wrong hits of those methods on the other rays."""
    for name in sorted(winners):
        wrong = [
            f"{method['wrong']:,.0f} ppm on {task['title'].lower()}"
            for task in tasks for method in task["methods"]
            if method["name"] == name and method["wrong"] > 0
        ]  # fmt: skip
        if wrong:
            yield f"The same method, {name}, hits wrongly elsewhere: {', '.join(wrong)}; ours 0."


def fastest(task: dict[str, Any]) -> str:
    """Who is, and what that costs."""
    ours = next(method for method in task["methods"] if method["ours"])
    best = min(task["methods"], key=lambda method: method["nanoseconds"])
    if best["ours"]:
        return f"{task['title']}: our path is the fastest."
    powers = math.log10(max(best["median"], ROUNDING) / max(ours["median"], ROUNDING))
    return (
        f"{task['title']}: the fastest is {best['name']}, "
        f"{ours['nanoseconds'] / best['nanoseconds']:.1f} times as fast as our path; its median "
        f"error is 10^{powers:.0f} times ours, its wrong hits {best['wrong']:,.0f} ppm."
    )
