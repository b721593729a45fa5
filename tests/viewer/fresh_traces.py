"""python tests/viewer/fresh_traces.py SCENE ... : tiles traced anew for what-if switches, as JSON.

For every scene, level and set of switches the 8-bit tiles that the tracer gives for the scene
altered so, base64. what-if.test.mjs compares them with what the viewer recombines.
"""

from __future__ import annotations

import base64
import copy
import json
import os
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.scene.read import read_scenes
from raywalk.trace import wavefront
from raywalk.trace.bounce import bounce
from raywalk.trace.plan import LEAST_SHARE, plan_of
from raywalk.trace.tables import compile_lights, compile_materials
from raywalk.trace.tree import Kind, level_pixels
from raywalk.trace.wavefront import Tracer, eight_bit

SCENES = Path(os.environ.get("RAYWALK_SCENES", Path(__file__).parent.parent.parent / "scenes"))
EVERY = bool(os.environ.get("RAYWALK_EVERY_CASE"))
# Pixels of a grid that divides another by an odd number are among its pixels: 5 and 15 come with
# 15, 7 and 21 with 21, 11 and 33 with 33; and all but 11 and 33 with 105.
LEVELS = (15, 21, 33)
AT_STOPS = (15,)
FINE = (33, 105)
FINE_SCENES = ("05-many-bounces", "08-glass")  # the finest grid too, where rays are many
BLACK = (0.0, 0.0, 0.0)
Switches = dict[str, Any]


def all_switches(scene: Scene) -> Iterator[Switches]:
    """Every switch by itself, and some together."""
    as_traced: Switches = {"bounces": None, "lamps": [], "shadows": True, "without": []}
    depth, lights = scene.render.depth, len(scene.lights)
    for bounces in sorted({0, 1, 2, depth - 1} & set(range(depth))):
        yield as_traced | {"bounces": bounces}
    for k in range(lights):
        for factor in (0.0, 0.35, 2.0):
            yield as_traced | {"lamps": [factor if at == k else 1.0 for at in range(lights)]}
    yield as_traced | {"shadows": False}
    for part in ("ambient", "diffuse", "specular", "reflected", "refracted"):
        yield as_traced | {"without": [part]}
    dim = [0.6] * lights
    yield {"bounces": None, "lamps": dim, "shadows": False, "without": ["ambient"]}
    yield {"bounces": min(depth, 3), "lamps": dim, "shadows": True, "without": ["specular"]}
    yield as_traced | {"without": ["reflected", "refracted"]}
    yield as_traced | {"lamps": [0.0] * lights}


def altered(scene: Scene, switches: Switches) -> Scene:
    """The scene as its file would say it."""
    factors = switches["lamps"] or [1.0] * len(scene.lights)
    black = {
        part: BLACK for part in switches["without"] if part in ("ambient", "diffuse", "specular")
    }
    return replace(
        scene,
        render=replace(scene.render, shadows=scene.render.shadows and switches["shadows"]),
        lights=tuple(
            replace(light, intensity=light.intensity * factor)
            for light, factor in zip(scene.lights, factors, strict=True)
        ),
        materials=tuple(replace(material, **black) for material in scene.materials),
    )


def sending(without: list[str]) -> Any:
    """`bounce`, but what is switched off is not sent; all other shares stay as they are."""
    mirrors, refracts = "reflected" not in without, "refracted" not in without

    def sent(compiled, materials, ior_of, rays, hits, media, share, least):  # type: ignore[no-untyped-def]
        out = bounce(compiled, materials, ior_of, rays, hits, media, share, least)
        weight, material = out.weight.copy(), hits.material[out.parent]
        total = out.kind == Kind.TOTAL
        if not (mirrors and refracts):
            both = materials.reflect[material] * mirrors + materials.transmit[material] * refracts
            weight[total] = both[total]
        kept = share[out.parent] * weight > least
        kept &= mirrors | (out.kind != Kind.REFLECTED)
        kept &= refracts | (out.kind != Kind.REFRACTED)
        return out._replace(
            rays=out.rays.take(kept), parent=out.parent[kept],
            kind=out.kind[kept], weight=weight[kept],
            share=share[out.parent[kept]] * weight[kept], media=out.media[kept],
        )  # fmt: skip

    return sent


def tiles(tracer: Tracer, scene: Scene, switches: Switches, pixels: np.ndarray) -> np.ndarray:
    """(n * n, 3) uint8. The tracer's geometry is used again: no switch changes it."""
    fresh = copy.copy(tracer)
    fresh.scene = altered(scene, switches)
    fresh.lights, fresh.materials = compile_lights(fresh.scene), compile_materials(fresh.scene)
    fresh.plan = plan_of(fresh.scene, switches["bounces"])
    wavefront.bounce = sending(switches["without"])
    size = scene.render.size
    return eight_bit(fresh.waves(pixels, size, size)[0].colour)


def places(scene: Scene) -> Iterator[tuple[str, Scene]]:
    """The scene as it is, and at stops of its sweeps: the first and the last, where most is other,
    or at all of them."""
    yield "", scene
    for sweep in scene.sweeps:
        for k, stop in enumerate(sweep.stops):
            if k != sweep.own and (EVERY or k in (0, len(sweep.stops) - 1)):
                yield f"{sweep.id}:{k + 1}", stop


def main() -> None:
    for scene in read_scenes(SCENES):
        if scene.id not in sys.argv[1:]:
            continue
        for at, here in places(scene):
            tracer = Tracer(here, least_share=LEAST_SHARE)
            levels = FINE if scene.id in FINE_SCENES else LEVELS
            if at:
                levels = AT_STOPS
            for n in set(levels) & set(here.render.resolutions):
                pixels = level_pixels(here.render.size, n)
                for switches in all_switches(here):
                    fresh = tiles(tracer, here, switches, pixels)
                    text = base64.b64encode(fresh.tobytes()).decode()
                    found = {"scene": scene.id, "at": at, "n": n, "switches": switches}
                    print(json.dumps(found | {"tiles": text}))


if __name__ == "__main__":
    main()
