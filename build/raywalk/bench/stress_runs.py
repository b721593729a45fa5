"""Odd directions, and two runs of the project's scenes."""

from __future__ import annotations

import json
import math
import tempfile
import time
from collections.abc import Iterator
from dataclasses import fields, replace
from pathlib import Path

import numpy as np

from raywalk.bench.cases import Case, none_of
from raywalk.bench.families import around
from raywalk.bench.made_scenes import bunny, mesh_object, placed, scene_of
from raywalk.errors import SourceErrors
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.roots import NOWHERE
from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.read import read_own_scenes
from raywalk.scene.shapes import Shape, Sphere
from raywalk.trace.probe import probe, read_rays
from raywalk.trace.tree import RayTree
from raywalk.trace.wavefront import trace_scene


def cases(count: int, seed: int, scenes: Path = Path("scenes")) -> Iterator[Case]:
    """Directions, then every scene of the project that can be read."""
    yield refused_rays(seed)
    for length in (1e-30, 1e30):
        yield directions_of_length(length, count, seed)
    yield time_of_odd_directions(count, seed)
    for scene in read_own_scenes(scenes):
        yield same_twice(scene, seed)


def refused_rays(seed: int) -> Case:
    """Rays that are none must be refused by number before any is traced."""
    odd = [[0, 0, 0], [math.nan, 0, 1], [math.inf, 0, 1], [0, 0], ["x", 0, 1], None, [0, True, 1]]
    accepted = 0
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "rays.json"
        for direction in odd:
            for key in ("direction", "origin"):
                good = {"origin": [0.0, 0.0, 5.0], "direction": [0.0, 0.0, -1.0]}
                if key == "origin" and direction == [0, 0, 0]:
                    continue
                path.write_text(json.dumps([good, good | {key: direction}]), encoding="utf-8")
                try:
                    read_rays(path)
                    accepted += 1
                except SourceErrors as problems:
                    accepted += f"[1].{key}" not in str(problems)
    return Case(
        "odd directions", "zero, NaN, infinite, not numbers", "not refused by name, rays",
        0.0, float(accepted), 2 * len(odd) - 1, seed,
    )  # fmt: skip


def directions_of_length(length: float, count: int, seed: int) -> Case:
    """Results are those of unit directions, t in units of the direction."""
    rng = np.random.default_rng(seed)
    origin, direction = around(rng, min(count, 20_000))
    with tempfile.TemporaryDirectory() as folder:
        objects: list[SceneObject | Shape] = [
            mesh_object(Path(folder) / "bunny.ply", bunny(), placed(0.5)),
            Sphere((0.9, 0.0, 0.0), 0.6),
        ]
        scene = scene_of(objects)
        plain, other = probe(scene, origin, direction), probe(scene, origin, direction * length)
    wrong = 0
    for one, two in zip(plain, other, strict=True):
        if (one is None) != (two is None):
            wrong += 1
        elif one and two:
            wrong += one["object"] != two["object"] or abs(two["t"] * length / one["t"] - 1) > 1e-14
    return none_of(
        len(plain), wrong, seed, "odd directions", f"of length {length:g}",
        "hits unlike those of unit directions",
    )  # fmt: skip


def time_of_odd_directions(count: int, seed: int) -> Case:
    """Time that rays without a direction add to a batch, where Embree alone needs 600 us each."""
    rng = np.random.default_rng(seed)
    origin, direction = around(rng, min(count, 100_000))
    with tempfile.TemporaryDirectory() as folder:
        compiled = CompiledScene(scene_of([mesh_object(Path(folder) / "b.ply", bunny())]))
    odd = direction.copy()
    odd[::10] = [0.0, 0.0, 0.0]
    odd[5::10] = np.nan
    compiled.nearest(rays_from(origin, odd))
    took = []
    for rows in (direction, odd):
        best = np.inf
        for _ in range(3):
            start = time.perf_counter()
            met = compiled.nearest(rays_from(origin, rows))[1]
            best = min(best, time.perf_counter() - start)
        took.append(best)
    assert (met[::10] == NOWHERE).all()
    assert (met[5::10] == NOWHERE).all()
    micro = max(0.0, took[1] - took[0]) / (len(origin) / 5) * 1e6
    return Case(
        "odd directions", "zero and NaN in a batch", "time added by each, microseconds",
        1.0, micro, len(origin), seed, 600.0, "Embree, measured once",
    )  # fmt: skip


def same_twice(scene: Scene, seed: int) -> Case:
    """Picture and ray tree of two runs, with one worker and with two, byte for byte."""
    small = replace(scene, render=replace(scene.render, size=165, resolutions=(5, 11, 33)))
    one, two = trace_scene(small, threads=1), trace_scene(small, threads=2)
    differing = int((one.picture != two.picture).sum())
    for field in fields(RayTree):
        a, b = (np.asarray(getattr(traced.tree, field.name)) for traced in (one, two))
        differing += a.tobytes() != b.tobytes()
    return Case(
        "the project's scenes", f"{scene.id}, two runs, one worker and two",
        "bytes and columns that differ", 0.0, float(differing), 165 * 165, seed,
    )  # fmt: skip
