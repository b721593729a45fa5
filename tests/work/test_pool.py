"""How cores are shared: among scenes, and within the last ones when others are done."""

from __future__ import annotations

import threading
import time
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import pytest
from tests.cases import cases

from raywalk.bench.speed_cores import GOAL, as_table, core_cases
from raywalk.pipeline.trace_products import write_products
from raywalk.scene.read import read_scene
from raywalk.trace.wavefront import in_order
from raywalk.work import pool

PATIENCE = 600.0  # seconds until what does not come counts as never coming
FOLDER = Path(__file__).parents[2] / "scenes"


class Counted:
    """Work that knows how many of it ran at once."""

    def __init__(self):
        self.lock, self.running, self.most = threading.Lock(), 0, 0

    def __call__(self, k: int) -> int:
        with self.lock:
            self.running += 1
            self.most = max(self.most, self.running)
        time.sleep(0.02)  # long enough for others to begin meanwhile, on a busy machine too
        with self.lock:
            self.running -= 1
        return k


@pytest.mark.parametrize(("left", "cores", "share"), [(9, 4, 1), (3, 4, 1), (2, 4, 2), (1, 4, 4)])
def test_the_tasks_that_are_left_share_the_cores(left, cores, share, monkeypatch):
    """A core whose process has nothing more to do serves those that have."""
    monkeypatch.setattr(pool, "cores", lambda: cores)
    monkeypatch.setattr(pool, "_left", SimpleNamespace(value=left))
    assert pool._share_of_cores() == share


@pytest.mark.parametrize("allowed", [1, 2])
def test_no_more_work_runs_at_once_than_is_allowed(allowed, monkeypatch):
    """Nor when asked each time; and results come in their order."""
    monkeypatch.setattr("os.cpu_count", lambda: 4)
    for threads in (allowed, lambda: allowed):
        work = Counted()
        assert list(in_order(work, 20, threads)) == list(range(20))
        assert work.most <= allowed


class Awaited(Counted):
    """From one piece of work on each waits until three run: they do, or it never ends."""

    def __init__(self, first: int):
        super().__init__()
        self.first, self.three = first, threading.Barrier(3)

    def __call__(self, k: int) -> int:
        if self.first <= k < self.first + 3:
            self.three.wait(PATIENCE)
        return super().__call__(k)


def test_threads_join_in_when_more_are_allowed(monkeypatch):
    """The second half may use three."""
    monkeypatch.setattr("os.cpu_count", lambda: 3)
    work, done = Awaited(30), []
    for k in in_order(work, 40, lambda: 3 if len(done) >= 20 else 1):
        done.append(k)
        if len(done) == 19:
            assert work.most == 1
    assert done == list(range(40))
    assert work.most <= 3


@pytest.mark.parametrize("name", cases(["06-bunny-far", "08-glass"], ["06-bunny-far"]))
def test_every_byte_is_the_same_with_any_number_of_threads(name, tmp_path):
    """One, two, and one that are joined by others."""
    scene = read_scene(FOLDER / name)
    scene = replace(scene, render=replace(scene.render, size=315, resolutions=(5, 15, 21)))
    asked: list[int] = []

    def more_and_more() -> int:
        asked.append(0)
        return min(3, 1 + len(asked) // 4)

    made = []
    for k, threads in enumerate((1, 2, more_and_more)):
        folder = tmp_path / str(k)
        folder.mkdir()
        write_products(scene, folder, threads)
        made.append({path.name: path.read_bytes() for path in folder.iterdir()})
    assert made[0].keys() == made[1].keys() == made[2].keys()
    differ = {name for name in made[0] if not made[0][name] == made[1][name] == made[2][name]}
    # A zip archive notes when it was written; its arrays are compared below.
    assert differ <= {"display.npz"}  # an archive notes when it was written


@pytest.mark.parametrize(("two", "holds"), [(0.98, True), (1.02, False)])
def test_a_second_core_of_little_use_breaks_the_bound(two, holds):
    """At the goal's share of the time on one core, a little less and a little more."""
    row = {"scenes": 10, "one": 10.0, "two": two * 10.0 / GOAL}
    (case,) = core_cases(row, 0)
    assert case.holds is holds
    assert "10 scenes" in next(as_table(row))


def test_a_machine_with_one_core_measures_nothing_and_says_so():
    """It breaks no bound."""
    assert not list(core_cases(None, 0))
    assert "two cores" in next(as_table(None))
