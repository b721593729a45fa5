"""How kernels are compiled: cached on disk, without the interpreter lock, IEEE float64."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numba import njit


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """A numba kernel. No fastmath: it would reorder sums and drop NaN checks, and two
    machines would no longer write the same bytes. nogil: strips are traced in threads.
    """
    compiled: Callable[..., Any] = njit(cache=True, nogil=True, error_model="numpy")(function)
    return compiled
