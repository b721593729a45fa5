"""Counts what bounding volumes spare: not needed for tracing, but a lesson."""

from __future__ import annotations

from raywalk.geometry.roots import passes_by
from raywalk.optics.compiled import kernel


@kernel
def tests_saved(primitives, origin, direction):
    """How many exact tests n rays are saved by the spheres round the primitives.

    origin, direction: (n, 3) world.
    """
    saved = 0
    for i in range(origin.shape[0]):
        ox, oy, oz = origin[i, 0], origin[i, 1], origin[i, 2]
        dx, dy, dz = direction[i, 0], direction[i, 1], direction[i, 2]
        dd = dx * dx + dy * dy + dz * dz
        for k in range(primitives.shape.shape[0]):
            if passes_by(primitives, k, ox, oy, oz, dx, dy, dz, dd):
                saved += 1
    return saved
