"""What the slides' figures need of the tracer, as files: shaded views, hidden stretches."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from raywalk.scene.model import Scene
from raywalk.slides.layout import Layout
from raywalk.slides.placing import read_placed
from raywalk.slides.sights import ANSWERS, requests, stops_seen
from raywalk.slides.what_if import Switches, switched_scene
from raywalk.trace.observer_view import Observer, hidden_points, hidden_stretches, shaded_view
from raywalk.trace.wavefront import Tracer

# The view lies pale behind the lines: what adds less than 1/16 to a pixel is not seen there,
# nor are mirrors within mirrors deeper than this.
LEAST_SHARE = 1 / 16
DEEPEST = 2


def write_sights(scene: Scene, traced: Path, layout: Layout, folder: Path) -> None:
    """view-<k>.png and sights.json for a scene's lesson. traced: what write_products wrote."""
    asked = requests(stops_seen(read_placed(scene, traced / "display.npz"), traced, layout))
    tracer = Tracer(scene, min(scene.render.depth, DEEPEST), LEAST_SHARE)
    observers = [_observer(look) for look in asked["looks"]]
    for k, (look, observer) in enumerate(zip(asked["looks"], observers, strict=True)):
        lit = _lit(tracer, scene, look["switches"])
        Image.fromarray(shaded_view(lit, observer)).save(folder / f"view-{k}.png")
    steps = [_answer(tracer, observers[step["look"]].eye, step) for step in asked["steps"]]
    (folder / ANSWERS).write_text(json.dumps({"steps": steps}, sort_keys=True), encoding="utf-8")


def _lit(tracer: Tracer, scene: Scene, switches: Switches) -> Tracer:
    """The tracer of the scene as a step's switches light it; the same where nothing is switched."""
    if not switches.is_set:
        return tracer
    altered = switched_scene(scene, switches)
    return Tracer(altered, min(altered.render.depth, DEEPEST), LEAST_SHARE)


def _answer(tracer: Tracer, eye: np.ndarray, step: dict[str, Any]) -> dict[str, Any]:
    lines = np.array(step["chosen"] + step["thin"], float).reshape(-1, 2, 3)
    hidden = [
        [[round(a, 6), round(b, 6)] for a, b in stretches]
        for stretches in hidden_stretches(tracer, eye, lines)
    ]
    tiles = np.flatnonzero(hidden_points(tracer, eye, np.array(step["tiles"], float)))
    first = len(step["chosen"])
    return {
        "look": step["look"],
        "chosen": hidden[:first],
        "thin": hidden[first:],
        "tiles": tiles.tolist(),
    }


def _observer(look: dict[str, Any]) -> Observer:
    vectors = {key: np.array(look[key], float) for key in ("eye", "right", "up", "forward")}
    return Observer(**vectors, focal=look["focal"], width=look["width"], height=look["height"])
