"""Lesson 20 on paper: where it speaks of a shadow map, its figures are drawn by the page's one."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest
from tests.slides.course import ROOT

from raywalk.pipeline.sight_products import view_from
from raywalk.scene.read import read_scene
from raywalk.slides.layout import WIDE
from raywalk.stops.process import Stops
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.wavefront import Tracer

VISIBLE = 24  # of 255
DIST = ROOT / "dist" / "scenes"
RASTERISED = {(3, "step"), (4, "step"), (6, "question"), (6, "answer")}  # steps from 0
LESSON = [(0, "step"), (1, "step"), (2, "step"), (3, "step"), (4, "step"), (5, "step"),
          (6, "question"), (6, "answer"), (7, "question"), (7, "answer")]  # fmt: skip


def asked_of(lesson: str, base: str) -> dict[str, Any]:
    with Stops() as stops:
        answer: dict[str, Any] = json.loads(stops.ask({
            "do": "ask", "scene": str(DIST / lesson / "scene.js"),
            "base": str(DIST / base / "scene.js"), "traces": str(DIST / base),
            "size": {"width": WIDE.figure.width, "height": WIDE.figure.height},
        }))  # fmt: skip
    return answer


@pytest.fixture(scope="module")
def asked() -> dict[str, Any]:
    return asked_of("20-rasterised-shadows", "02-shadows")


@pytest.fixture(scope="module")
def tracer() -> Tracer:
    return Tracer(read_scene(ROOT / "scenes" / "02-shadows"), least_share=LEAST_SHARE)


def test_the_steps_that_speak_of_a_shadow_map_are_drawn_with_one(asked):
    at = {stop: asked["stops"][k]["viewpoint"] for k, stop in enumerate(LESSON)}
    assert len(asked["stops"]) == len(LESSON)
    assert {stop for stop in LESSON if "maps" in asked["viewpoints"][at[stop]]} == RASTERISED


def test_their_shadows_have_other_edges_than_the_traced_ones_and_all_else_is_as_traced(
    asked, tracer
):
    """The same views without maps are the traced ones. A map's pixel is 0.01 to 0.02 wide where it
    falls on the spheres: at most 24 of the nearest view's pixels, and 2 of the farthest."""
    views = [each for each in asked["viewpoints"] if "maps" in each]
    assert len(views) == 3  # all spheres, two of them, and a shadow's edge alone
    shares = []
    for each in views:
        traced = {name: value for name, value in each.items() if name != "maps"}
        stairs, smooth = (view_from(tracer, view).astype(int) for view in (each, traced))
        differ = np.abs(stairs - smooth).max(axis=2) > VISIBLE
        assert not (differ & ~beside_an_edge(smooth, 24)).any()
        shares.append(differ.mean())
    # Of the view that shows stairs alone one pixel in 50 is another, of the others hardly any.
    assert max(shares) > 0.02 and sorted(shares)[1] < 0.005


def beside_an_edge(view: np.ndarray, reach: int) -> np.ndarray:
    """(height, width) bool: at most `reach` pixels off a step in colour, along rows or columns."""
    near = np.zeros(view.shape[:2], bool)
    for axis in (0, 1):
        step = (np.abs(np.diff(view, axis=axis)) > VISIBLE / 2).any(axis=2)
        near |= np.pad(step, [(0, 1 - axis), (0, axis)])
    for axis in (0, 1):
        near = np.any([np.roll(near, k, axis) for k in range(-reach, reach + 1)], axis=0)
    return near


def test_where_mirrors_or_glass_need_more_tricks_views_stay_traced():
    for lesson, base in (
        ("21-rasterised-mirrors", "04-one-bounce"),
        ("22-rasterised-glass", "08-glass"),
    ):
        assert not any("maps" in each for each in asked_of(lesson, base)["viewpoints"])
