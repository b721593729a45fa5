"""One stop of a sweep as files: the ray trees of its grids, and a smaller picture."""

from __future__ import annotations

from pathlib import Path

from raywalk.scene.model import Scene
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.relighting import KnownPaths
from raywalk.trace.tree import level_pixels
from raywalk.trace.wavefront import Threads, Tracer, trace_coarse
from raywalk.trace_file.container import pack_texts, write_beside
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of
from raywalk.trace_file.webp import webp

# Of seven scenes' stops 3.5 % more bytes than at 4, in 2.5 times less time: there are many.
METHOD = 2


def write_stop(
    scene: Scene, resolutions: tuple[int, ...], side: int, folder: Path, threads: Threads,
    known: KnownPaths | None = None,
) -> None:  # fmt: skip
    """<n>.json.gz of each resolution, byte for byte those of the scene's own trace;
    picture.webp: pixels of its picture, side x side. known: of stops that differ in light."""
    tracer = Tracer(scene, least_share=LEAST_SHARE, known=known)
    traced = trace_coarse(tracer, resolutions, side, threads)
    for n in resolutions:
        level = level_of(traced.tree, n)
        write_beside(folder / f"{n}.json.gz", pack_texts(encode(level, scene, traced.picture)))
    flat = traced.picture.reshape(-1, 3)
    picture = flat[level_pixels(scene.render.size, side)].reshape(side, side, 3)
    write_beside(folder / "picture.webp", webp(picture, METHOD))
