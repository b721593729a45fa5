"""What a thread of this machine can do at most, in numba as our kernels are compiled."""

from __future__ import annotations

from functools import cache

import numpy as np

from raywalk.optics.compiled import kernel

LANES, ROUNDS, STEPS = 256, 20_000, 8  # stays in registers and the first cache
COPIED = 64 * 2**20  # bytes: larger than caches


@kernel
def _multiply_add(values: np.ndarray, rounds: int) -> None:
    """x c + d eight times to each value, `rounds` times; products and sums are not fused, as they
    are in no kernel of ours: fused they round otherwise. Written out, so that lanes are values."""
    for _ in range(rounds):
        for k in range(values.shape[0]):
            x = values[k]
            x = x * 0.999 + 0.001
            x = x * 0.999 + 0.001
            x = x * 0.999 + 0.001
            x = x * 0.999 + 0.001
            x = x * 0.999 + 0.001
            x = x * 0.999 + 0.001
            x = x * 0.999 + 0.001
            x = x * 0.999 + 0.001
            values[k] = x


def multiply_add() -> float:
    """Float64 operations done."""
    _multiply_add(np.ones(LANES), ROUNDS)
    return float(2 * STEPS * LANES * ROUNDS)


@cache
def _arrays() -> tuple[np.ndarray, np.ndarray]:
    return np.zeros(COPIED // 8), np.ones(COPIED // 8)


def copied() -> float:
    """Bytes read and written."""
    to, source = _arrays()
    np.copyto(to, source)
    return 2.0 * COPIED
