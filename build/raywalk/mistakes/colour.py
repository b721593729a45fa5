"""From linear colours to bytes: cut to 0..1, times 255, rounded. No gamma."""

from __future__ import annotations

import numpy as np

from raywalk.mistakes.habits import EXACT, Habits
from raywalk.mistakes.table import Mistakes

GAMMA = 2.2


def to_bytes(
    linear: np.ndarray, mistakes: Mistakes = frozenset(), habits: Habits = EXACT
) -> np.ndarray:
    """(..., 3) uint8 of linear colours (..., 3)."""
    colour = np.clip(linear, 0, 1)
    if "not-clamped" in mistakes:
        colour = linear
    if "gamma-applied" in mistakes:
        colour = np.sign(colour) * np.abs(colour) ** (1 / GAMMA)
    steps = np.floor(255 * colour + 0.5)
    if "truncated" in mistakes or habits.truncates:
        steps = np.floor(255 * colour)
    # Bytes wrap round: 256 is 0 again. Without the mistake nothing is above 255.
    found = np.mod(steps, 256).astype(np.uint8)
    if "red-and-blue-swapped" in mistakes:
        found = found[..., ::-1]
    return found
