"""What a person sees while a build runs."""

from __future__ import annotations

import io

import pytest

from raywalk.commands.terminal import Terminal
from raywalk.work.progress import Begin, End, Progress

STORY = [
    "tracing 2 of 2 scenes on 2 cores",
    Begin({"01-ball": 1.0, "02-[b]box": 3.0}),
    Progress("01-ball", "tracing", 0.5),
    Progress("02-[b]box", "grid 105", 0.5),
    Progress("01-ball", "", 1.0),
    "[1/2] 01-ball: 0.1 s",
    End(),
    "2 scenes: 2 traced, 0 unchanged",
]


class Screen(io.StringIO):
    """A stream that says it is a terminal, or that it is none."""

    def __init__(self, is_terminal: bool):
        super().__init__()
        self.is_terminal = is_terminal

    def isatty(self) -> bool:
        return self.is_terminal


def printed(monkeypatch, is_terminal: bool) -> str:
    screen = Screen(is_terminal)
    monkeypatch.setattr("sys.stdout", screen)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.delenv("NO_COLOR", raising=False)
    terminal = Terminal()
    for event in STORY:
        terminal.show(event)
        if terminal._bars:
            terminal._bars.refresh()
    terminal.close()
    return screen.getvalue()


def test_into_a_file_or_a_pipe_go_lines_only(monkeypatch):
    """No bar, no colour, no line that is drawn over."""
    lines = [event for event in STORY if isinstance(event, str)]
    assert printed(monkeypatch, is_terminal=False).splitlines() == lines


def test_a_terminal_shows_bars_with_stage_and_time_left_and_keeps_the_lines(monkeypatch):
    """Names are no markup: brackets in them are shown."""
    screen = printed(monkeypatch, is_terminal=True)
    for words in ("2 scenes", "02-[b]box", "grid 105", "50 %", "left"):
        assert words in screen
    for line in (event for event in STORY if isinstance(event, str)):
        assert line in screen


@pytest.mark.parametrize("stage", ["tracing", "grid 105"])
def test_the_bar_of_all_scenes_weighs_them_by_their_cost(monkeypatch, stage):
    """Half of a scene that costs three quarters is three eighths of all."""
    monkeypatch.setattr("sys.stdout", Screen(is_terminal=True))
    terminal = Terminal()
    terminal.show(Begin({"a": 1.0, "b": 3.0}))
    terminal.show(Progress("b", stage, 0.5))
    assert terminal._bars and terminal._bars.tasks[0].completed == 375.0
    terminal.close()
