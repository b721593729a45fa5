"""How far a build is, as plain data: commands hand it on, the terminal draws it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

# Called while work goes on: the stage in one word, and the share of the work that is done, 0..1.
Report = Callable[[str, float], None]


@dataclass(frozen=True)
class Begin:
    """Pieces of work that follow, and how long each may take, in any unit."""

    costs: dict[str, float]


@dataclass(frozen=True)
class Progress:
    """How far one piece of work is."""

    of: str
    stage: str
    share: float  # 0..1


@dataclass(frozen=True)
class End:
    """All pieces of work are done."""


Message = Begin | Progress | End


def say_nothing(stage: str, share: float) -> None:
    """For work that nobody watches."""
