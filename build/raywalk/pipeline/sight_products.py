"""What a lesson's figures need of the tracer, as files: shaded views, hidden stretches, the rays of
the pixels whose numbers are printed, in all digits, and what its worksheet asks."""

from __future__ import annotations

import copy
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from raywalk.scene.model import Scene
from raywalk.slides.formats import SIGHTS
from raywalk.trace.observer_view import Observer, hidden_points, hidden_stretches, shaded_view
from raywalk.trace.plan import LEAST_SHARE, plan_of
from raywalk.trace.record import assemble, record
from raywalk.trace.shadow_maps import ShadowMaps
from raywalk.trace.sheet_pixels import sheet_facts
from raywalk.trace.tables import compile_lights, compile_materials
from raywalk.trace.tree import level_pixels
from raywalk.trace.wavefront import Threads, Tracer, in_order

# The view lies pale behind the lines: what adds less than 1/16 to a pixel is not seen there,
# nor are mirrors within mirrors deeper than this.
PALE_SHARE = 1 / 16
DEEPEST = 2
# Columns of ExactRays (viewer/stops/exact.ts), by the trace's names and by the viewer's.
ROWS = ("parent", "kind", "object")
COLUMNS = {
    "t": "t", "point": "point", "normal": "normal", "weight": "weight",
    "local_weight": "localWeight", "blocked_at": "blockedAt", "passed": "passed",
    "diffuse": "diffuse", "specular": "specular", "base": "base",
}  # fmt: skip


def write_sights(scene: Scene, asked: dict[str, Any], folder: Path, threads: Threads = 1) -> None:
    """view-<k>.png and SIGHTS for what a lesson asks: Asked in viewer/stops/asked.ts."""
    viewpoints = asked["viewpoints"]
    named = {each.get("sweep", "") for each in viewpoints} | {""}
    tracers = {stop: Tracer(scene.at_stop(stop), least_share=LEAST_SHARE) for stop in sorted(named)}

    def at(of: dict[str, Any]) -> Tracer:
        return tracers[of.get("sweep", "")]

    def write_view(k: int) -> None:
        view = view_from(at(viewpoints[k]), viewpoints[k])
        # Slides are made of its pixels: how small the file is matters to nobody.
        Image.fromarray(view).save(folder / f"view-{k}.png", compress_level=1)

    for _ in in_order(write_view, len(viewpoints), threads):
        pass
    eyes = [np.array(viewpoint["eye"], float) for viewpoint in viewpoints]
    answers = {
        "stops": [
            _hidden(at(viewpoints[stop["viewpoint"]]), eyes[stop["viewpoint"]], stop)
            for stop in asked["stops"]
        ],
        "exact": [_exact(at(each), each) for each in asked["exact"]],
        "worksheet": sheet_facts(tracers[""], **asked["worksheet"]),
    }
    (folder / SIGHTS).write_text(json.dumps(answers, sort_keys=True), encoding="utf-8")


def view_from(tracer: Tracer, viewpoint: dict[str, Any]) -> np.ndarray:
    """(height, width, 4) uint8: what lies behind a stop's lines."""
    lit, maps = viewpoint["lit"], _maps(viewpoint)
    pale = _pale(tracer, lit | {"shadows": False} if maps else lit)
    return shaded_view(pale, _observer(viewpoint), maps)


def _pale(tracer: Tracer, lit: dict[str, Any]) -> Tracer:
    """The tracer of the same bodies as a stop's switches light them, no deeper than a pale view
    shows."""
    scene, fresh = tracer.scene, copy.copy(tracer)
    fresh.scene = replace(
        scene,
        render=replace(scene.render, shadows=lit["shadows"]),
        lights=tuple(
            replace(light, intensity=intensity)
            for light, intensity in zip(scene.lights, lit["intensities"], strict=True)
        ),
        materials=tuple(
            replace(material, ambient=ambient, diffuse=diffuse, specular=specular)
            for material, (ambient, diffuse, specular) in zip(
                scene.materials, lit["paints"], strict=True
            )
        ),
    )
    fresh.lights, fresh.materials = compile_lights(fresh.scene), compile_materials(fresh.scene)
    fresh.plan = plan_of(fresh.scene, min(lit["depth"], DEEPEST))
    fresh.least_share = PALE_SHARE
    return fresh


def _hidden(tracer: Tracer, eye: np.ndarray, stop: dict[str, Any]) -> dict[str, Any]:
    """Stretches of the stop's lines and tiles of its grid that are not seen from the eye."""
    tiles = stop["tiles"]
    lines = np.array(stop["lines"], float).reshape(-1, 2, 3)
    row, column = np.divmod(np.arange(tiles["n"] ** 2)[:, None], tiles["n"])
    across, down = np.array(tiles["across"]), np.array(tiles["down"])
    centres = tiles["origin"] + ((column + 0.5) * across + (row + 0.5) * down) / tiles["n"]
    return {
        "hidden": [
            [[round(a, 6), round(b, 6)] for a, b in stretches]
            for stretches in hidden_stretches(tracer, eye, lines)
        ],
        "tiles": np.flatnonzero(hidden_points(tracer, eye, centres)).tolist(),
    }


def _exact(tracer: Tracer, asked: dict[str, Any]) -> dict[str, Any]:
    """The rays of a grid that are asked for, and at which stop of a sweep where it is one."""
    rays = exact_rays(tracer, asked["n"], asked["pixels"])
    return rays | {key: asked[key] for key in ("sweep",) if key in asked}


def exact_rays(tracer: Tracer, n: int, pixels: list[int]) -> dict[str, Any]:
    """ExactRays of some pixels (row * n + column) of the n x n grid, traced as the picture was."""
    size = tracer.scene.render.size
    places = level_pixels(size, n)[pixels]
    waves = tracer.waves(places, size, size)
    kept = np.isin(np.arange(size * size), places)
    tree = assemble(tracer, [record(tracer, waves, places, kept)], size)
    in_grid = dict(zip(places.tolist(), pixels, strict=True))
    t = np.where(np.isfinite(tree.t), tree.t, 0.0)  # a leaving ray's, which nobody reads
    given = {"t": t, "base": np.ones_like(tree.point) if tree.base is None else tree.base}
    return {
        "n": n,
        "pixel": [in_grid[place] for place in tree.pixel.tolist()],
        **{name: getattr(tree, name).tolist() for name in ROWS},
        "columns": {
            column: given.get(name, getattr(tree, name)).reshape(-1).tolist()
            for name, column in COLUMNS.items()
        },
        "hitsStart": tree.hits_start.tolist(),
        "hitsT": tree.hits_t.tolist(),
    }


def _observer(viewpoint: dict[str, Any]) -> Observer:
    vectors: dict[str, Any] = {
        key: np.array(viewpoint[key], float) for key in ("eye", "right", "up", "forward")
    }
    seen: dict[str, Any] = {key: viewpoint[key] for key in ("focal", "width", "height")}
    return Observer(**seen, **vectors)


def _maps(viewpoint: dict[str, Any]) -> ShadowMaps | None:
    """The shadow maps of a view that is not to be traced but rasterised."""
    if "maps" not in viewpoint:
        return None
    given = dict(viewpoint["maps"])
    return ShadowMaps(
        normal_bias=given.pop("normalBias"), lamps=tuple(given.pop("lamps")),
        casts=tuple(given.pop("casts")), **given,
    )  # fmt: skip
