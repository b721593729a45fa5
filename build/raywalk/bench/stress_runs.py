"""Odd directions, NaN in outputs, and the project's scenes at other scales, places and runs."""

from __future__ import annotations

import json
import tempfile
import time
from collections.abc import Iterator
from dataclasses import fields, replace
from pathlib import Path

import numpy as np

from raywalk.bench.cases import Case, per_million
from raywalk.bench.families import around
from raywalk.bench.made_scenes import bunny, mesh_object, placed, scene_of
from raywalk.errors import SourceErrors
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.nearest import NOWHERE
from raywalk.scene import read_scenes
from raywalk.scene.model import Camera, Scene, SceneObject, Shape, Sphere
from raywalk.trace.probe import probe, read_rays
from raywalk.trace.tree import RayTree, Visibility
from raywalk.trace.wavefront import Tracer, trace_scene

SCALES = (1e-6, 1e-3, 1e3, 1e6)
OFFSETS = (1e4, 1e7)
GRID = 105


def cases(count: int, seed: int, scenes: Path = Path("scenes")) -> Iterator[Case]:
    """Directions, then every scene of the project that can be read."""
    yield refused_rays(seed)
    for length in (1e-30, 1e30):
        yield directions_of_length(length, count, seed)
    yield time_of_odd_directions(count, seed)
    for scene in read_scenes(scenes):
        grid = min(GRID, max(5, int(np.sqrt(count / 9))))
        yield from moved_and_scaled(scene, grid, seed)
        yield same_twice(scene, seed)


def refused_rays(seed: int) -> Case:
    """Rays that are none must be refused by number before any is traced."""
    odd = [
        [0, 0, 0],
        [float("nan"), 0, 1],
        [float("inf"), 0, 1],
        [0, 0],
        ["x", 0, 1],
        None,
        [0, True, 1],
    ]
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
                except SourceErrors as told:
                    accepted += f"[1].{key}" not in str(told)
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
    return Case(
        "odd directions", f"of length {length:g}", "hits unlike those of unit directions, ppm",
        0.0, per_million(wrong, len(plain)), len(plain), seed,
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
        1.0, micro, len(origin), seed, 600.0, "Embree, as ACCURACY.md measured it",
    )  # fmt: skip


def moved_and_scaled(scene: Scene, grid: int, seed: int) -> Iterator[Case]:
    """Shadows of the same pixels at other scales and places: any change is acne or a leak."""
    asked, changed, odd = 0, 0, 0
    base = looked_at(scene, grid)
    for scale, offset in [(s, 0.0) for s in SCALES] + [(1.0, o) for o in OFFSETS]:
        other = looked_at(elsewhere(scene, scale, offset), grid)
        asked += grid * grid
        changed += int((base[0] != other[0]).any(axis=1).sum())
        odd += other[1]
    yield Case(
        "the project's scenes", f"{scene.id}, x 1e-6 to 1e6, moved by 1e4 and 1e7",
        "pixels whose hits or shadows change", 0.0, float(changed), asked, seed,
    )  # fmt: skip
    yield Case(
        "the project's scenes", f"{scene.id}, the same", "NaN or infinity in outputs",
        0.0, float(base[1] + odd), asked, seed,
    )  # fmt: skip


def looked_at(scene: Scene, grid: int) -> tuple[np.ndarray, int]:
    """Per pixel the object met and each light's visibility and blocker; and what is not finite."""
    waves = Tracer(scene).waves(np.arange(grid * grid), grid, grid)
    first = waves[0]
    lighting = first.lighting
    # Behind or blocked by itself is the same darkness, seen from either side of a rounding.
    reached = lighting.visibility == Visibility.REACHED
    seen = np.column_stack([first.hits.object, reached])
    odd = 0
    for wave in waves:
        met = wave.hits.object != NOWHERE
        arrays = (
            wave.colour, wave.lighting.diffuse, wave.lighting.specular, wave.lighting.local,
            wave.weight, wave.rays.direction, wave.hits.point[met], wave.hits.t[met],
        )  # fmt: skip
        odd += sum(int((~np.isfinite(array)).sum()) for array in arrays)
    return seen, odd


def elsewhere(scene: Scene, scale: float, offset: float) -> Scene:
    """The scene scaled about the origin, then moved; light falls off over the scaled way."""
    moved = np.array([offset, -offset, offset])
    matrix = placed(scale, moved)

    def there(point: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = scale * np.array(point) + moved
        return float(x), float(y), float(z)

    camera: Camera = replace(
        scene.camera, eye=there(scene.camera.eye), target=there(scene.camera.target)
    )
    lights = tuple(
        replace(
            light, position=there(light.position),
            attenuation=(
                light.attenuation[0], light.attenuation[1] / scale, light.attenuation[2] / scale**2
            ),
        )
        for light in scene.lights
    )  # fmt: skip
    objects = tuple(replace(obj, transform=matrix @ obj.transform) for obj in scene.objects)
    return replace(scene, camera=camera, lights=lights, objects=objects)


def same_twice(scene: Scene, seed: int) -> Case:
    """Picture and ray tree of two runs, with one worker and with two, byte for byte."""
    small = replace(scene, render=replace(scene.render, size=165, resolutions=(5, 11, 33)))
    one, two = trace_scene(small, workers=1), trace_scene(small, workers=2)
    differing = int((one.picture != two.picture).sum())
    for field in fields(RayTree):
        a, b = (np.asarray(getattr(traced.tree, field.name)) for traced in (one, two))
        differing += a.tobytes() != b.tobytes()
    return Case(
        "the project's scenes", f"{scene.id}, two runs, one worker and two",
        "bytes and columns that differ", 0.0, float(differing), 165 * 165, seed,
    )  # fmt: skip
