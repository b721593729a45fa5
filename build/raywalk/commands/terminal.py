"""Lines, and on a terminal bars below them: one for all, one for each piece of work under way."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from raywalk.errors import visible
from raywalk.work.progress import Begin, End, Message, Progress

if TYPE_CHECKING:
    from rich.progress import Progress as Bars
    from rich.progress import TaskID

ALL = "all"
PRECISION = 1000.0  # steps of a bar


class Terminal:
    """Prints what a command says. Where nobody watches, into a file or a pipe: lines only."""

    def __init__(self) -> None:
        self._bars: Bars | None = None
        self._of: dict[str, TaskID] = {}
        self._costs: dict[str, float] = {}
        self._shares: dict[str, float] = {}

    def show(self, message: str | Message) -> None:
        match message:
            case str():
                self._line(message)
            case Begin(costs) if sys.stdout.isatty():
                self._begin(costs)
            case Progress() if self._bars:
                self._progress(self._bars, message)
            case End():
                self.close()

    def close(self) -> None:
        """Takes the bars away; the lines stay."""
        if self._bars:
            self._bars.stop()
        self._bars = None

    def _line(self, text: str) -> None:
        text = visible(text)
        if self._bars:
            self._bars.console.print(text, markup=False, highlight=False, soft_wrap=True)
        else:
            print(text, flush=True)

    def _begin(self, costs: dict[str, float]) -> None:
        self.close()
        self._costs, self._shares, self._of = costs, dict.fromkeys(costs, 0.0), {}
        self._bars = _bars()
        self._of[ALL] = self._bars.add_task(f"{len(costs)} scenes", total=PRECISION, stage="")
        self._bars.start()

    def _progress(self, bars: Bars, message: Progress) -> None:
        self._shares[message.of] = message.share
        if message.of not in self._of:
            self._of[message.of] = bars.add_task(message.of, total=PRECISION, stage=message.stage)
        done = message.share >= 1.0
        bars.update(
            self._of[message.of],
            completed=PRECISION * message.share,
            stage=message.stage,
            visible=not done,
        )
        whole = sum(self._costs.values())
        so_far = sum(self._costs.get(name, 0.0) * share for name, share in self._shares.items())
        bars.update(self._of[ALL], completed=PRECISION * so_far / whole if whole else 0.0)


def _bars() -> Any:
    # Only here: a build that nobody watches, or with nothing to do, does not pay for it.
    from rich.progress import BarColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bars

    def text(shown: str) -> TextColumn:
        return TextColumn(shown, markup=False)  # a scene's name may hold brackets

    return Bars(
        text("{task.description}"), BarColumn(bar_width=20), text("{task.percentage:>3.0f} %"),
        text("left"), TimeRemainingColumn(), text("{task.fields[stage]}"),
        transient=True,
    )  # fmt: skip
