"""What differs between two programs that are both right: noise, which no verdict may hang on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import DTypeLike


@dataclass(frozen=True)
class Habits:
    """How a program calculates. None of these is a mistake."""

    precision: DTypeLike = np.float64  # np.float32: of all arithmetic, from the scene's numbers on
    # A ray counts hits further away than this, world units. None: it knows which surface it leaves
    # and on which side, as the model says, and needs no such number.
    offset: float | None = None
    truncates: bool = False  # bytes are cut off, not rounded
    last_wins: bool = False  # of two hits at one distance the object that is listed later is met


EXACT = Habits()
