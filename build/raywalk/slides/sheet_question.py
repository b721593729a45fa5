"""A worksheet's question."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from raywalk.slides.choices import ChoiceWords
from raywalk.slides.stops import Stop

Fact = dict[str, Any]  # one of trace/sheet_pixels.py


@dataclass(frozen=True, eq=False)
class Question:
    asks: str
    answer: str
    fact: Fact | None = None  # of one that the trace answers
    choices: tuple[ChoiceWords, ...] = ()
    stop: Stop | None = None  # of one of the lesson's: what "this pixel" is
