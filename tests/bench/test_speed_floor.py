"""The floor that a scene's making is measured against: it can tell a slow stage, and must."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from raywalk.bench.speed_floor import FLOOR, GOAL, as_table, floor_cases, floors
from raywalk.geometry.compiled import CompiledScene
from raywalk.pipeline import trace_products as products
from raywalk.scene.read import read_scene

FOLDER = Path(__file__).parents[2] / "scenes"
MUCH = 10  # times as long as all the rest: a busy machine does not hide it


def small(name: str):
    scene = read_scene(FOLDER / name)
    return replace(scene, render=replace(scene.render, size=105, resolutions=(5, 15)))


def looking_away():
    """No ray of it meets anything: the camera looks up, and floor and ball are below."""
    scene = small("01-shading")
    x, y, z = scene.camera.eye
    camera = replace(scene.camera, target=(x, y + 10.0, z), up=(0.0, 0.0, 1.0), fov=10.0)
    return replace(scene, camera=camera)


def slowed(work: Callable[..., Any], seconds: float) -> Callable[..., Any]:
    """The same, after so many seconds of a processor's time in this thread."""

    def slow(*given: Any, **named: Any) -> Any:
        start = time.thread_time()
        while time.thread_time() - start < seconds:
            pass
        return work(*given, **named)

    return slow


@pytest.mark.parametrize(
    "scene", [small("05-many-bounces"), small("07-bunny-near"), looking_away()],
    ids=["primitives", "mesh", "nothing met"],
)  # fmt: skip
def test_the_floor_is_a_part_of_the_whole(scene):
    """Meeting, shading and deflating take time, and the making that holds them takes no less."""
    (row,) = floors([scene], 1)
    assert row["meet"] > 0
    assert row["shade"] > 0
    assert row["deflate"] > 0
    assert row["floor"] == row["meet"] + row["shade"] + row["deflate"]
    assert row["all"] > row["meet"] + row["shade"]
    assert row["ratio"] == row["all"] / row["floor"]


@pytest.mark.parametrize("stage", ["write_display", "write_level", "sections_of", "trace_picture"])
def test_a_stage_made_slow_raises_the_ratio(stage, monkeypatch):
    """Whatever is neither meeting, shading nor deflating stands above the floor."""
    scene = small("01-shading")
    (usual,) = floors([scene], 1)
    monkeypatch.setattr(products, stage, slowed(getattr(products, stage), MUCH * usual["all"]))
    (slow,) = floors([scene], 1)
    # MUCH times the whole was added. Half of it leaves room for a floor measured in a bad moment.
    assert slow["ratio"] > MUCH / 2 * usual["ratio"]


def test_meeting_made_slow_counts_as_floor(monkeypatch):
    """If intersecting were all there is, the ratio would be 1: it falls towards it."""
    scene = small("01-shading")
    (usual,) = floors([scene], 1)
    own = CompiledScene._unrefined
    monkeypatch.setattr(CompiledScene, "_unrefined", slowed(own, usual["all"]))
    (slow,) = floors([scene], 1)
    assert 1 < slow["ratio"] < usual["ratio"]


def test_the_clock_is_taken_off_again():
    """Measuring leaves the tracer as it was."""
    own = [getattr(place, name) for parts in FLOOR.values() for place, name in parts]
    list(floors([small("01-shading")], 1))
    assert own == [getattr(place, name) for parts in FLOOR.values() for place, name in parts]


@pytest.mark.parametrize(("over", "holds"), [(0.96, True), (1.04, False)])
def test_all_scenes_together_keep_the_goal_or_break_it(over, holds):
    """A small scene far above its floor counts by its time."""
    rows = [
        {"scene": "long", "all": over * GOAL * 10.0, "floor": 10.0, "meet": 9.0, "ratio": 0.0},
        {"scene": "short", "all": 0.05, "floor": 0.01, "meet": 0.005, "ratio": 5.0},
    ]
    (case,) = floor_cases(rows, 0)
    assert case.holds is holds
    assert "long" in next(as_table(rows))
