"""The vectors of a scene: every ray of every pixel of three small pictures, in full float64.

A ray's numbers are those of `raywalk pixel`. Pixels whose answer hangs on a rounding are left out
and listed: there right programs may differ (trace/conditioning.py).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from raywalk.homework.given import given
from raywalk.trace.conditioning import WITHIN_FLOAT32, is_steady
from raywalk.trace.pixel_tree import trees_at
from raywalk.trace.wavefront import Tracer, eight_bit

FORMAT, VERSION = "raywalk-homework", 1
GRIDS = (5, 15, 33)
# Camera rays times lights: of a lamp of 64 points a file of the finest grid would be 20 MB.
MOST_ANSWERS = 40_000
# A program of another order of arithmetic agrees to 1e-12; who writes b^2 - 4 a c, to this.
WITHIN = 1e-9
# Of a ray `raywalk pixel` says more: how it was found, and what follows from the rest.
KEYS = (
    "kind", "weight", "direction", "object", "inside", "t", "point", "normal", "local_weight",
    "local", "lights", "colour",
)  # fmt: skip
MEASURED = (
    "direction", "t", "point", "normal", "weight", "local_weight", "local", "colour", "diffuse",
    "specular",
)  # fmt: skip


def vectors_of(tracer: Tracer) -> dict[str, Any]:
    """All of a scene's file, as vectors.schema.json says."""
    scene = tracer.scene
    return {
        "format": FORMAT,
        "version": VERSION,
        "scene": scene.id,
        "title": scene.title,
        "given": given(scene),
        "tolerance": {
            name: {"float64": WITHIN, "float32": WITHIN_FLOAT32} for name in MEASURED
        },
        "grids": [grid_of(tracer, n) for n in GRIDS if n * n * len(scene.lights) <= MOST_ANSWERS],
    }  # fmt: skip


def grid_of(tracer: Tracer, n: int) -> dict[str, Any]:
    """An n x n picture's pixels in raster order, and those left out, each as [column, row]."""
    every = np.arange(n * n)
    steady = is_steady(tracer, n, every)
    trees = trees_at(tracer, every[steady], n, n)
    return {
        "n": n,
        "left_out": [place(pixel, n) for pixel in every[~steady].tolist()],
        "pixels": [
            {
                "pixel": place(pixel, n),
                "bytes": eight_bit(np.array(tree["colour"])).tolist(),
                "ray": ray_of(tree),
            }
            for pixel, tree in zip(every[steady].tolist(), trees, strict=True)
        ],
    }


def place(pixel: int, n: int) -> list[int]:
    """[column, row], counted from the top left."""
    return [pixel % n, pixel // n]


def ray_of(node: dict[str, Any]) -> dict[str, Any]:
    """A ray of `raywalk pixel` with the rays that it sends on; it starts where its parent ended."""
    return {key: node[key] for key in KEYS} | {
        "children": [ray_of(child) for child in node["children"]]
    }


def rays_in_order(ray: dict[str, Any]) -> Iterator[tuple[int, dict[str, Any]]]:
    """(place of the parent, ray) of a pixel's tree: a ray, then the first that it sends on with all
    of its own, then the second. The places count from 0, the camera ray's; its parent's is -1."""
    waiting, count = [(-1, ray)], 0
    while waiting:
        above, node = waiting.pop()
        yield above, node
        waiting += [(count, child) for child in reversed(node["children"])]
        count += 1
