"""How far each stage is from what the processor could do: its time beside the least that its bytes
take at the memory's measured speed, and its arithmetic at the measured peak, in the same run."""

from __future__ import annotations

import json
import zlib
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from raywalk.bench.families import Pair, coherent, incoherent
from raywalk.bench.hardware_counters import NoCounters, counted
from raywalk.bench.made_scenes import bunny, compiled_mesh, scene_of, twenty_spheres
from raywalk.bench.peak import copied, multiply_add
from raywalk.bench.run_time import interleaved
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene
from raywalk.trace.lighting import light_hits
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.wavefront import STRIP, Tracer, trace_picture
from raywalk.trace_file.container import pack_texts
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of
from raywalk.trace_file.png import png
from raywalk.trace_file.webp import webp

# Of one bounding sphere: to its centre 3, along the ray 5, off it 6, that squared 5, beside r^2 1.
SPHERE_FLOPS = 20
RAY_BYTES = 2 * 3 * 8  # origin and direction
HIT_BYTES = 8 + 4 + 4 + 2 * 8  # t, object, triangle, (u, v)
LIT_BYTES = (
    RAY_BYTES + HIT_BYTES + 3 * 8 + 3 * 8
)  # what is lit reads a hit's normal, writes a colour
SIDE, QUICK_SIDE = 512, 128


class Stage(NamedTuple):
    """One thing the tracer does, to so many items."""

    name: str
    item: str
    action: Callable[[], object]
    items: int
    bytes: float  # an item: what must be read and written, however it is done
    flops: float | None = None  # an item, of the plain formula


def counters(course: Path, quick: bool, seed: int) -> dict[str, Any]:
    """Rows of the table, the two peaks, and what the counters say or why they do not."""
    side, rounds = (QUICK_SIDE, 3) if quick else (SIDE, 7)
    stages = [*_meetings(side, seed), *_made(read_scene(next(course.glob("05-*"))))]
    peaks, work = (partial(multiply_add), partial(copied)), [stage.action for stage in stages]
    times = [seconds for seconds, _ in interleaved([*peaks, *work], rounds, 0)]
    flops, bandwidth = peaks[0]() / times[0], peaks[1]() / times[1]
    refused = ""
    rows = []
    for stage, seconds in zip(stages, times[2:], strict=True):
        ns = 1e9 * seconds / stage.items
        memory = 1e9 * stage.bytes / bandwidth
        arithmetic = None if stage.flops is None else 1e9 * stage.flops / flops
        row = {"stage": stage.name, "item": stage.item, "ns": ns, "memory": memory,
               "arithmetic": arithmetic, "times": ns / max(memory, arithmetic or 0.0)}  # fmt: skip
        try:
            found = counted(stage.action)
            row["instructions"] = found["instructions"] / stage.items
            row["ipc"] = found["instructions"] / max(1, found["cycles"])
        except NoCounters as problem:
            refused = str(problem)
        rows.append(row)
    return {"rows": rows, "gflops": 1e-9 * flops, "gigabytes": 1e-9 * bandwidth,
            "refused": refused}  # fmt: skip


def _meetings(side: int, seed: int) -> Iterator[Stage]:
    """Rays and what they meet."""
    rng, count = np.random.default_rng(seed), side * side
    spheres = CompiledScene(scene_of(twenty_spheres(seed)))
    corners = bunny()
    mesh = compiled_mesh(corners - (corners.min(axis=(0, 1)) + corners.max(axis=(0, 1))) / 2)
    moved = RAY_BYTES + HIT_BYTES
    for name, compiled, away, reach, flops in (
        ("20 spheres", spheres, 7.0, 3.0, 20.0 * SPHERE_FLOPS),
        ("mesh", mesh, 2.5, 1.0, None),
    ):
        families = {
            "coherent": coherent(side, (0.0, 0.0, away), 0.45),
            "incoherent": incoherent(rng, count, reach),
        }
        for kind, rays in families.items():
            meet = partial(_meet, compiled, rays)
            yield Stage(f"meet {name}, {kind}", "ray", meet, count, moved, flops)


def _meet(compiled: CompiledScene, rays: Pair) -> None:
    for start in range(0, len(rays[0]), STRIP):
        strip = slice(start, start + STRIP)
        compiled.nearest(rays_from(rays[0][strip], rays[1][strip]))


def _made(scene: Scene) -> Iterator[Stage]:
    """Of a course scene's picture at a third: shading, encoding, deflating, pictures."""
    finest = 55
    scene = replace(scene, render=replace(scene.render, size=385, resolutions=(finest,)))
    tracer = Tracer(scene, least_share=LEAST_SHARE)
    traced = trace_picture(tracer, 1)
    pixels = np.arange(STRIP)
    wave = tracer.waves(pixels, 385, 385)[0]
    shade = partial(
        light_hits, scene, tracer.compiled, tracer.materials, tracer.lights, wave.rays, wave.hits,
        tracer.plan,
    )  # fmt: skip
    yield Stage("light and shade hits, shadow rays and all", "hit", shade, STRIP, LIT_BYTES)
    level = level_of(traced.tree, finest)
    text = encode(level, scene, traced.picture)
    columns = sum(map(len, json.loads(text)["columns"].values()))
    numbers = sum(value.nbytes for value in vars(level).values() if isinstance(value, np.ndarray))
    rays = len(level.kind)
    yield Stage("encode a grid", "ray", partial(encode, level, scene, traced.picture), rays,
                (numbers + columns) / rays)  # fmt: skip
    yield Stage("deflate a grid", "byte", partial(pack_texts, text), len(text), 2)
    picture, count = traced.picture, traced.picture.size
    yield Stage("deflate a picture's bytes", "byte", partial(zlib.compress, picture.tobytes(), 8),
                count, 2)  # fmt: skip
    yield Stage("PNG, filters and all", "byte", partial(png, picture), count, 2)
    yield Stage("lossless WebP", "byte", partial(webp, picture), count, 2)


HEAD = ("Stage", "ns", "of one", "memory alone, ns", "arithmetic alone, ns", "times the larger")
COUNTED = ("instructions", "a cycle")


def as_table(found: dict[str, Any]) -> Iterator[str]:
    """What was measured; the table itself is `rows_of`."""
    yield (
        f"  this thread copies {found['gigabytes']:.1f} GB/s and does {found['gflops']:.1f} "
        "thousand million float64 operations a second, products and sums apart"
    )
    if found["refused"]:
        yield f"  no hardware counters here ({found['refused']}): instructions are not told"
    for row in rows_of(found)["rows"]:
        yield "  " + ", ".join(f"{name} {cell}" for name, cell in zip(HEAD, row, strict=False))


def rows_of(found: dict[str, Any]) -> dict[str, Any]:
    """{"head", "rows"} in words, for the page."""
    has_counters = not found["refused"]
    rows = []
    for row in found["rows"]:
        arithmetic = "" if row["arithmetic"] is None else f"{row['arithmetic']:.3g}"
        cells = [row["stage"], f"{row['ns']:.3g}", row["item"], f"{row['memory']:.2g}", arithmetic,
                 f"{row['times']:.3g}"]  # fmt: skip
        if has_counters:
            cells += [f"{row['instructions']:.3g}", f"{row['ipc']:.2f}"]
        rows.append(cells)
    return {"head": [*HEAD, *(COUNTED if has_counters else ())], "rows": rows}
