"""The flat drawing's outlines against what the tracer meets."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.cases import cases

from raywalk.scene.model import Scene
from raywalk.scene.read import read_scenes
from raywalk.trace.sections import APART, STEPS, sections_of
from raywalk.trace.wavefront import Tracer

SCENES = {scene.id: scene for scene in read_scenes(Path("scenes"))}
N = 15
CLOSED, OPEN, ELLIPSE = 0, 1, 2


def steps_from(outline: list[int], point: np.ndarray) -> float:
    """How far a point (2,), in steps, is from an outline."""
    _, kind, *numbers = outline
    pairs = np.array(numbers, float).reshape(-1, 2)
    if kind == ELLIPSE:
        angle = np.linspace(0, 2 * np.pi, 4001)
        on_it = pairs[0] + np.outer(np.cos(angle), pairs[1]) + np.outer(np.sin(angle), pairs[2])
    else:
        on_it = np.cumsum(pairs, axis=0)
        on_it = np.vstack([on_it, on_it[:1]]) if kind == CLOSED else on_it
    start, way = on_it[:-1], np.diff(on_it, axis=0)
    length = np.maximum((way**2).sum(axis=1), 1e-30)
    share = np.clip(((point - start) * way).sum(axis=1) / length, 0, 1)
    return float(np.linalg.norm(start + share[:, None] * way - point, axis=1).min())


def places(scene: Scene) -> tuple[Tracer, np.ndarray]:
    """Picture pixels (N, N) of the N x N frustum, row by row."""
    step = scene.render.size // N
    centres = np.arange(N) * step + step // 2
    return Tracer(scene), centres[:, None] * scene.render.size + centres


@pytest.mark.parametrize("name", cases(SCENES, set(SCENES) - {"09-dragon"}))
@pytest.mark.parametrize("direction", ["rows", "columns"])
def test_what_a_camera_ray_meets_lies_on_that_objects_outline(name: str, direction: str) -> None:
    """Of every row and column of a frustum, the nearest hits lie on the outlines.

    Allowed: half a step of rounding each for the point and both ends of a piece, and for a
    curve drawn as pieces the bulge over one: at most its own length of about APART steps, or
    1 - cos(pi / 96) = 5e-4 of a cylinder's radius, here below one step.
    """
    scene = SCENES[name]
    tracer, pixels = places(scene)
    sections = sections_of(tracer)
    right, up, forward = np.array(sections["frame"])
    across, along = (up, right) if direction == "rows" else (right, up)
    grid = pixels if direction == "rows" else pixels.T
    size, met = scene.render.size, 0
    for line in grid:
        at = line[0] // size if direction == "rows" else line[0] % size
        slope, outlines = sections[direction][str(at)]
        ahead = forward + slope * across
        axes = np.array([ahead / np.linalg.norm(ahead), along])
        hits = tracer.waves(line, size, size)[0].hits
        for point, thing in zip(hits.point, hits.object, strict=True):
            if thing < 0:
                continue
            flat = axes @ (point - sections["eye"]) / sections["step"]
            if np.abs(flat).max() > STEPS:
                continue  # a floor far behind everything that is drawn
            own = [each for each in outlines if each[0] == thing]
            assert own, f"{scene.objects[thing].name} has no outline"
            far = min(steps_from(each, flat) for each in own)
            assert far <= 2 + APART / 2
            met += 1
    assert met > N


@pytest.mark.parametrize("name", SCENES)
def test_sections_are_there_for_every_row_and_column_of_every_resolution(name: str) -> None:
    """Each resolution's tile centres are among the picture rows that have a section."""
    scene = SCENES[name]
    sections = sections_of(Tracer(scene))
    for n in scene.render.resolutions:
        step = scene.render.size // n
        needed = {str(k * step + step // 2) for k in range(n)}
        assert needed <= set(sections["rows"])
        assert needed <= set(sections["columns"])
