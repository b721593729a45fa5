"""One measured figure with its bound, and the error that a broken bound raises."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from raywalk.errors import UserError
from raywalk.site.reports import shown

Which = np.ndarray | int  # rays: which of all, as bool, or how many


@dataclass(frozen=True)
class Case:
    """One row of the stress table. It holds if measured <= bound; NaN never does."""

    subject: str  # row of the stress matrix
    name: str  # what was varied
    metric: str  # what is counted or measured, with its unit
    bound: float
    measured: float
    rays: int  # how many stand behind the figure
    seed: int
    float32: float | None = None  # the same metric by float32, measured in the same run
    float32_by: str = ""  # how: "Embree" or "same formula"
    note: str = ""

    @property
    def holds(self) -> bool:
        return bool(self.measured <= self.bound)

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON; figures that are not finite become words."""
        columns = {key: getattr(self, key) for key in self.__dataclass_fields__}
        return {key: plain(value) for key, value in columns.items()} | {"holds": self.holds}

    def as_line(self) -> str:
        verdict = "holds " if self.holds else "BROKEN"
        beside = "" if self.float32 is None else f"  (float32 {shown(self.float32)})"
        return (
            f"  {verdict} {self.name}: {self.metric} {shown(self.measured)}, "
            f"bound {shown(self.bound)}{beside}"
        )


class BrokenBounds(UserError):
    """Stated bounds that a measurement broke; str() is what the command line prints."""

    def __init__(self, broken: Iterable[str]):
        self.broken = list(broken)
        super().__init__(self.broken)

    def __str__(self) -> str:
        count = f"{len(self.broken)} bound{'s' if len(self.broken) != 1 else ''} broken"
        return "\n".join([*self.broken, count])


def refuse_broken(cases: Iterable[Case]) -> None:
    """Raises BrokenBounds if any case does not hold."""
    broken = [
        f"{case.subject}, {case.name}: {case.metric} is {shown(case.measured)}, "
        f"bound {shown(case.bound)} (seed {case.seed}, {case.rays:,} rays)"
        for case in cases
        if not case.holds
    ]
    if broken:
        raise BrokenBounds(broken)


def per_million(wrong: int, rays: int) -> float:
    """ppm; NaN if there were no rays, which breaks every bound."""
    return 1e6 * wrong / rays if rays else math.nan


def none_of(
    among: Which, wrong: Which, seed: int, subject: str, name: str, metric: str,
    float32: Which | None = None, float32_by: str = "", note: str = "",
) -> Case:  # fmt: skip
    """No ray may be wrong. among: those that count; float32: those that are wrong there."""
    count = int(np.sum(among))

    def share(of: Which) -> float:
        is_row = isinstance(of, np.ndarray) and isinstance(among, np.ndarray)
        return per_million(int(np.sum(of & among if is_row else of)), count)

    beside = None if float32 is None else share(float32)
    measured, metric = share(wrong), f"{metric}, ppm"
    return Case(subject, name, metric, 0.0, measured, count, seed, beside, float32_by, note)


def plain(value: Any) -> Any:
    """A value JSON can hold: infinities and NaN as words."""
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value
