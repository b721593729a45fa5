"""Where a build's time goes: what each phase took, and each part of the work done in it.

Seconds pass on the clock; processor seconds are spent by this process and those it waited for, on
all cores together. On two cores a phase without gaps spends twice the seconds that pass.
"""

from __future__ import annotations

import json
import os
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from raywalk.work.progress import Report


@dataclass(frozen=True)
class Row:
    """One line of the table; of a part of a phase only processor seconds are known."""

    name: str
    processor: float
    seconds: float | None = None


@dataclass(frozen=True)
class Spent:
    """What a task took, and the processor seconds of its stages."""

    seconds: float
    stages: dict[str, float] = field(default_factory=dict)


# Of the build that this process makes, and where the rows of its open phases begin; `begin` empties
# them.
_rows: list[Row] = []
_open: list[int] = []


def begin() -> None:
    """Another build."""
    _rows.clear()
    _open.clear()


@contextmanager
def phase(name: str) -> Iterator[None]:
    """A line for what is done within; lines noted meanwhile are its parts and stand below it."""
    place, start, used = len(_rows), time.monotonic(), _processor()
    _open.append(place)
    try:
        yield
    finally:
        del _open[-1:]
        seconds, processor = time.monotonic() - start, _processor() - used
        _rows.insert(place, Row(name, processor, seconds))


def note(task: Spent) -> None:
    """The stages of a task, added up with those of other tasks, as parts of the phase that is under
    way."""
    begins = _open[-1] if _open else 0
    for name, processor in task.stages.items():
        parts = (k for k in range(begins, len(_rows)) if _is_part(_rows[k], name))
        k = next(parts, None)
        if k is None:
            _rows.append(Row(name, processor))
        else:
            _rows[k] = Row(name, _rows[k].processor + processor)


def _is_part(row: Row, name: str) -> bool:
    return row.name == name and row.seconds is None


class Stages:
    """Splits a task's processor time by the stages that it reports, and what goes on in all of them
    apart from these: apart, a name and a clock of its own."""

    def __init__(self, apart: str, clock: Callable[[], float]):
        self._apart, self._clock = apart, clock
        self._start = time.monotonic()
        self._used, self._besides = time.process_time(), clock()
        self.stages = {apart: 0.0}

    def following(self, report: Report) -> Report:
        """The same report, listened to. What is reported of a stage was spent on it."""

        def listening(stage: str, share: float) -> None:
            self._add(stage.split()[0])  # all grids are one
            report(stage, share)

        return listening

    def spent(self, last: str) -> Spent:
        """All of it; last: the stage that nothing was reported of."""
        self._add(last)
        return Spent(time.monotonic() - self._start, dict(self.stages))

    def _add(self, stage: str) -> None:
        used, besides = time.process_time(), self._clock()
        self.stages[self._apart] += besides - self._besides
        self.stages.setdefault(stage, 0.0)
        self.stages[stage] += used - self._used - (besides - self._besides)
        self._used, self._besides = used, besides


def undivided() -> Stages:
    """Of a task in which nothing goes on apart: it compiles no kernel."""
    return Stages("compiling kernels", lambda: 0.0)


def table(of_make: Path | None) -> Iterator[str]:
    """A line a phase and a part of one, after those that a file holds (build/setup/timed.py), which
    is used up."""
    before = _from_file(of_make) if of_make else []
    yield f"{'':34}{'seconds':>9}{'processor':>11}"
    for row in [*before, *_rows]:
        name = row.name if row.seconds is not None else f"  {row.name}"
        passed = "" if row.seconds is None else f"{row.seconds:.1f}"
        yield f"{name:34}{passed:>9}{row.processor:11.1f}"


def _from_file(place: Path) -> list[Row]:
    if not place.is_file():
        return []
    lines = place.read_text(encoding="utf-8").splitlines()
    place.unlink()
    return [
        Row(each["name"], each["processor"], each["seconds"]) for each in map(json.loads, lines)
    ]


def _processor() -> float:
    used = os.times()
    return used.user + used.system + used.children_user + used.children_system
