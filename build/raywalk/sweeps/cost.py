"""What a sweep will cost, told before it is traced: from the scene's own rays, which are few."""

from __future__ import annotations

import json
from dataclasses import dataclass

from raywalk.scene.model import Scene, Sweep
from raywalk.trace.wavefront import Tracer, trace_coarse
from raywalk.trace_file.container import pack_texts
from raywalk.trace_file.encode import encode
from raywalk.trace_file.level import level_of


@dataclass(frozen=True)
class Cost:
    """About as much as this; other stops have other rays."""

    pictures: float  # as often as the scene's own picture is traced
    rays: int  # of all stops' grids and pictures
    bytes: int  # of the grids, at most: what stops have in common is stored once


def cost_of(scene: Scene, sweep: Sweep, tracer: Tracer) -> Cost:
    """tracer: of the scene. Its finest grid of those that stops have is traced, in a moment."""
    finest, size = max(sweep.resolutions), scene.render.size
    traced = trace_coarse(tracer, sweep.resolutions, finest)
    packed = {
        n: len(pack_texts(encode(level_of(traced.tree, n), scene, traced.picture)))
        for n in sweep.resolutions
    }
    pixels = sweep.picture**2 + sum(n * n for n in sweep.resolutions)
    rays_each = len(level_of(traced.tree, finest).kind) / finest**2
    stops = len(sweep.stops)
    return Cost(
        stops * pixels / size**2, round(stops * pixels * rays_each), stops * sum(packed.values())
    )


def cost_line(scene: Scene, sweep: Sweep, tracer: Tracer) -> str:
    """A sentence for `raywalk check`."""
    cost = cost_of(scene, sweep, tracer)
    side = sweep.picture
    grids = " and ".join(f"{n} x {n}" for n in sweep.resolutions)
    return (
        f"sweep {json.dumps(sweep.name, ensure_ascii=False)}: {len(sweep.stops)} stops at {grids}, "
        f"about {cost.rays:,} rays, {cost.pictures:.1f} times the scene's own picture; at most "
        f"{cost.bytes:,} bytes of rays, and a picture of {side} x {side} each"
    )
