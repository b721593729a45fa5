"""Where a build's time goes: phases, their parts, and what make took before them."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from pathlib import Path

from raywalk.work import times
from raywalk.work.times import Spent, Stages

TIMED = Path("build/setup/timed.py")


def spend(seconds: float) -> None:
    """Processor time, on a busy machine too."""
    until = time.process_time() + seconds
    while time.process_time() < until:
        pass


def test_parts_stand_below_their_phase():
    """Though they are noted while it is under way, and another phase follows."""
    times.begin()
    with times.phase("trace"):
        times.note(Spent(2.0, {"tracing": 1.5}))
        times.note(Spent(1.0, {"tracing": 0.5, "grid": 0.25}))
    with times.phase("publish"):
        pass
    _, *lines = times.table(None)
    assert [line.split()[0] for line in lines] == ["trace", "tracing", "grid", "publish"]
    assert [line.split()[-1] for line in lines[1:3]] == ["2.0", "0.2"]


def test_a_stage_gets_what_was_spent_until_it_was_reported():
    """Processor time, all of it once: what has a clock of its own is taken out of the stages."""
    compiled = 0.0
    stages = Stages("compiling", lambda: compiled)
    heard = []
    report = stages.following(lambda stage, share: heard.append((stage, share)))
    spend(0.04)
    report("reading", 0.0)
    spend(0.04)
    compiled = 0.03
    report("grid 15", 0.9)
    report("grid 35", 1.0)
    spent = stages.spent("keeping").stages
    assert heard == [("reading", 0.0), ("grid 15", 0.9), ("grid 35", 1.0)]
    assert set(spent) == {"compiling", "reading", "grid", "keeping"}
    assert spent["reading"] >= 0.04
    assert spent["compiling"] == 0.03
    assert 0.01 <= spent["grid"] < spent["reading"]


def test_what_make_took_comes_first_and_once(tmp_path):
    """The next build's table does not begin with the same installation."""
    place = tmp_path / "work" / "make.jsonl"
    command = [sys.executable, TIMED, place, "make .venv", sys.executable, "-c", "exit(0)"]
    subprocess.run(command, check=True)
    assert json.loads(place.read_text())["processor"] > 0
    times.begin()
    with times.phase("read scenes"):
        pass
    assert [line.split()[0] for line in times.table(place)][1:] == ["make", "read"]
    assert [line.split()[0] for line in times.table(place)][1:] == ["read"]


def test_a_timed_command_fails_as_it_would_alone(tmp_path):
    """Else make would go on without its packages."""
    command = [sys.executable, TIMED, tmp_path / "x", "pip", sys.executable, "-c", "exit(3)"]
    assert subprocess.run(command, check=False).returncode == 3
