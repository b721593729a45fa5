"""Whole pictures: time against wrong pixels, and error against resolution."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from raywalk.bench.cases import Case
from raywalk.bench.contenders import tessellated
from raywalk.bench.embree32 import Embree32
from raywalk.bench.made_scenes import scene_of, twenty_spheres
from raywalk.bench.picture_truth import TruePicture
from raywalk.bench.run_time import interleaved
from raywalk.geometry.compiled import Hits, Rays
from raywalk.geometry.roots import NOWHERE
from raywalk.scene.model import Camera, Light, Material, Scene, SceneObject
from raywalk.scene.shapes import Sphere
from raywalk.trace.wavefront import STRIP, Tracer, eight_bit

SIZE = 400
EVERY = 16  # pixels between two that mpmath judges, along rows and columns
LEVELS = (16, 64, 128)
DEPTH = 5
FULL = 1155  # the project's picture: resolutions are its divisors
GRIDS = (5, 11, 21, 55, 105, 231, 385, 1155)
SAMPLES = 3  # along each side of a pixel of the supersampled reference


def picture(scene: Scene, tracer: Tracer, size: int) -> np.ndarray:
    """(size * size, 3) linear colours, by the tracer's own strips, one thread."""
    strips = np.array_split(np.arange(size * size), max(1, size * size // STRIP))
    return np.concatenate([tracer.waves(pixels, size, size)[0].colour for pixels in strips])


def mirrors_and_shadows(seed: int) -> Scene:
    """The twenty spheres, every third a mirror, under two lamps."""
    rng = np.random.default_rng(seed)
    colours = rng.uniform(0.2, 0.9, (5, 3))
    materials = [
        Material(f"paint {k}", (0.05, 0.05, 0.05), tuple(c), (0.4, 0.4, 0.4), 30.0)
        for k, c in enumerate(colours)
    ]
    mirror = Material("mirror", diffuse=(0.2, 0.2, 0.2), reflect=0.8)
    objects = [
        SceneObject(f"ball {k}", ball, 5 if k % 3 == 0 else k % 5)
        for k, ball in enumerate(twenty_spheres(seed))
    ]
    lights = [
        Light("left", (-6.0, 5.0, 6.0), intensity=0.6),
        Light("right", (6.0, 3.0, 4.0), intensity=0.4),
    ]
    scene = scene_of(
        objects, lights, [*materials, mirror], Camera((0.0, 0.0, 8.0), (0.0, 0.0, 0.0)), depth=DEPTH
    )
    return replace(scene, background=(0.1, 0.2, 0.3))


def pictures(rounds: int, seed: int, size: int = SIZE) -> dict[str, Any]:
    """Ours beside float32 Embree on tessellated spheres, same camera, same shading."""
    scene = mirrors_and_shadows(seed)
    tracers = {"ours, float64": Tracer(scene)}
    material = np.array([obj.material for obj in scene.objects], np.int32)
    balls = twenty_spheres(seed)
    for level in LEVELS:
        tracer = Tracer(scene)
        tracer.compiled = TessellatedScene(balls, level, material)  # type: ignore[assignment]
        tracers[f"Embree float32, level {level}"] = tracer
    times = interleaved(
        [partial(picture, scene, tracer, size) for tracer in tracers.values()], rounds, 0
    )
    columns, rows = np.meshgrid(*2 * [np.arange(EVERY // 2, size, EVERY)])
    asked = (rows * size + columns).ravel()
    true = TruePicture(scene)
    truth = np.array([true.pixel(size, k % size, k // size) for k in asked.tolist()])
    methods = []
    for (name, tracer), (seconds, ratio) in zip(tracers.items(), times, strict=True):
        got = picture(scene, tracer, size)[asked]
        error = np.abs(got - truth)
        wrong = (eight_bit(got) != eight_bit(truth)).any(axis=1).mean()
        methods.append({
            "name": name, "ours": tracer is tracers["ours, float64"], "seconds": seconds,
            "ratio": ratio, "wrong": float(wrong), "mean": float(error.mean()),
            "largest": float(error.max()),
        })  # fmt: skip
    return {
        "about": f"20 spheres, mirrors, shadows, {DEPTH} bounces, {size} x {size} pixels, one "
        f"thread; {len(asked):,} pixels against 50 digits. All are shaded by the same stages.",
        "methods": methods, "pixels": len(asked),
    }  # fmt: skip


def picture_cases(measured: dict[str, Any], seed: int) -> Iterator[Case]:
    """No 8-bit pixel wrong, and colours to 1e-9 at worst (grazing mirrors magnify rounding)."""
    ours = next(method for method in measured["methods"] if method["ours"])
    other = next(method for method in measured["methods"] if method["name"].endswith("level 64"))
    for key, words, bound in (
        ("wrong", "share of 8-bit pixels wrong", 0.0), ("mean", "error of colour, mean", 1e-12),
        ("largest", "error of colour, max", 1e-9),
    ):  # fmt: skip
        yield Case(
            "whole pictures", "20 spheres against 50 digits", words, bound, ours[key],
            measured["pixels"], seed, other[key], other["name"],
        )  # fmt: skip


def resolution(seed: int, full: int = FULL, samples: int = SAMPLES) -> dict[str, Any]:
    """Mean error of each grid's picture against the supersampled one, at every full pixel."""
    scene = mirrors_and_shadows(seed)
    tracer = Tracer(scene, least_share=1.0 / 4096.0)
    fine = np.clip(picture(scene, tracer, full * samples), 0.0, 1.0)
    truth = fine.reshape(full, samples, full, samples, 3).mean(axis=(1, 3))
    rows = []
    for grid in (n for n in GRIDS if full % n == 0):
        coarse = np.clip(picture(scene, tracer, grid), 0.0, 1.0).reshape(grid, grid, 3)
        tile = full // grid
        error = np.abs(np.repeat(np.repeat(coarse, tile, axis=0), tile, axis=1) - truth)
        rows.append({
            "size": grid, "error": float(255.0 * error.mean()),
            "off": float((error.max(axis=2) > 0.5 / 255.0).mean()),
        })  # fmt: skip
    return {
        "about": f"A picture of few pixels is wrong by its coarseness, not by its arithmetic: each "
        f"grid's tiles against {full} x {full} pixels of {samples * samples} samples each.",
        "rows": rows,
    }  # fmt: skip


LIFT = np.float32(1e-4)  # a usual choice; smaller brings acne, larger brings gaps


class TessellatedScene:
    """The tracer on float32 Embree: tessellated spheres, rays lifted by a fixed offset. Answers as
    a CompiledScene does, so that the same wavefront shades its hits."""

    def __init__(self, spheres: Sequence[Sphere], level: int, material: np.ndarray):
        corners = tessellated(spheres, level)
        self.facets, self.material = len(corners) // len(spheres), material
        self.embree = Embree32(corners)

    def nearest(self, rays: Rays, t_max: np.ndarray | None = None) -> tuple[np.ndarray, ...]:
        t, met, _ = self._met(rays)
        if t_max is not None:
            met = np.where(t < t_max, met, NOWHERE).astype(np.int32)
            t = np.where(t < t_max, t, np.inf)
        return t, met, np.full(len(t), -1, np.int32), np.zeros((len(t), 2))

    def beyond(self, *_: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Nothing: these scenes have no glass."""
        return np.zeros(0, np.int32), np.zeros(0, np.int32), np.zeros(0, bool)

    def base_colours(self, hits: Hits) -> None:
        """None anywhere: these scenes have no textures."""

    def hits(self, rays: Rays) -> Hits:
        t, met, normal = self._met(rays)
        length = np.linalg.norm(normal, axis=1, keepdims=True)
        normal /= np.where(length > 0, length, 1.0)
        inside = (normal * rays.direction).sum(axis=1) > 0
        normal[inside] *= -1.0
        with np.errstate(invalid="ignore"):
            point = rays.origin + t[:, None] * rays.direction
        point[met == NOWHERE] = 0.0
        material = np.where(met != NOWHERE, self.material[met], -1).astype(np.int32)
        nothing = np.full(len(t), -1, np.int32)
        return Hits(t, met, nothing, point, normal, normal, inside, material)

    def _met(self, rays: Rays) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        start, toward = rays.origin.astype(np.float32), rays.direction.astype(np.float32)
        lifted = np.where((rays.leaving != NOWHERE)[:, None], start + LIFT * toward, start)
        t, who, normal = self.embree.nearest(lifted, rays.direction)
        met = np.where(np.isinf(t), NOWHERE, who // self.facets).astype(np.int32)
        return t.astype(float), met, normal.astype(float)
