"""Time of several methods on the same rays: interleaved rounds, medians of times and of ratios."""

from __future__ import annotations

import gc
import statistics
import time
from collections.abc import Callable, Sequence


def interleaved(
    actions: Sequence[Callable[[], object]], rounds: int, beside: int
) -> list[tuple[float, float]]:
    """(median seconds, median ratio to action number `beside` in the same round) of each.

    Each round runs every action once, starting with another one each time: what else the
    machine does then falls on all alike, and the ratios hold where the seconds do not.
    """
    for action in actions:
        action()  # compiled, and everything in its place
    seconds: list[list[float]] = [[] for _ in actions]
    gc.disable()
    try:
        for turn in range(rounds):
            for place in range(len(actions)):
                k = (place + turn) % len(actions)
                start = time.perf_counter()
                actions[k]()
                seconds[k].append(time.perf_counter() - start)
    finally:
        gc.enable()
    ratios = [[a / b for a, b in zip(own, seconds[beside], strict=True)] for own in seconds]
    return [
        (statistics.median(own), statistics.median(ratio))
        for own, ratio in zip(seconds, ratios, strict=True)
    ]
