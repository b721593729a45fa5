"""How kernels are compiled: cached on disk, without the interpreter lock, IEEE float64."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba

PACKAGE = Path(__file__).parent.parent
# Folders whose kernels are compiled into one another.
FOLDERS = ("optics", "geometry", "trace", "trace_file")


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """A numba kernel. No fastmath: it would reorder sums and drop NaN checks, and two
    machines would no longer write the same bytes. nogil: strips are traced in threads.
    """
    compiled: Callable[..., Any] = numba.njit(cache=True, nogil=True, error_model="numpy")(function)
    return compiled


def inlined(function: Callable[..., Any]) -> Callable[..., Any]:
    """A kernel that is always copied into its callers: for the innermost loops, where handing
    over a table of arrays costs several times the arithmetic done with it."""
    compiled: Callable[..., Any] = numba.njit(
        cache=True, nogil=True, error_model="numpy", forceinline=True
    )(function)
    return compiled


def _use_cache_of_these_sources() -> None:
    """Numba asks only whether a kernel's own file changed, not the files of the kernels that
    were compiled into it, and would go on using the old ones. So each state of the sources
    has a cache of its own. Where the package cannot be written to, numba's default stays.
    """
    digest = hashlib.sha256()
    for folder in FOLDERS:
        for file in sorted((PACKAGE / folder).glob("*.py")):
            digest.update(file.read_bytes())
    cache = PACKAGE / "__pycache__" / f"kernels-{digest.hexdigest()[:16]}"
    config: Any = numba.config  # its attributes come from the environment, unseen by mypy
    if not config.CACHE_DIR and os.access(PACKAGE, os.W_OK):
        config.CACHE_DIR = str(cache)


_use_cache_of_these_sources()
