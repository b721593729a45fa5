"""Compiles a kernel once however many processes want it, and lets one at a time write its cache.

Numba's cache has an index a function and numbers the machine code of each signature. Two processes
that save two signatures of one function at once take the same number: then the index leads from
one signature to the other's code. And two that start together compile everything twice.
"""

from __future__ import annotations

import gc
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numba
from numba.core import sigutils, types
from numba.core.compiler_lock import global_compiler_lock

try:
    import fcntl
except ImportError:  # Windows: as numba does it
    fcntl = None  # type: ignore[assignment]

# While kernels are compiled: new objects between two of Python's searches for cycles, and how many
# searches of young objects there are to one of older and of all.
SELDOM = (200_000, 50, 100)
# Kernels whose lock this process has; a kernel may compile itself with other types.
_held: Counter[str] = Counter()
# Processor seconds that this process spent on compiling kernels and loading compiled ones.
_spent = 0.0


def seconds_spent() -> float:
    """Processor seconds so far; waiting for another process is not among them."""
    return _spent


def compiled_once(dispatcher: Any, for_constants: bool = False) -> Any:
    """The same numba dispatcher; it looks into the cache, compiles and saves while no other process
    does so for this function. Who waits finds the code in the cache afterwards.

    Processes do not wait for one another in a circle: a kernel's lock is kept while those it calls
    are compiled, and no two kernels call each other. Where numba is told to compile nothing
    (NUMBA_DISABLE_JIT), the kernel is the function itself. for_constants: it is compiled for each
    constant that a caller hands it.
    """
    if numba.config.DISABLE_JIT:  # type: ignore[attr-defined]
        return dispatcher
    compile_alone: Callable[..., Any] = dispatcher.compile
    name = f"{dispatcher.py_func.__module__}.{dispatcher.py_func.__qualname__}"

    def compile_in_turn(signature: Any) -> Any:
        # Numba's own lock first: two threads that took them in another order would wait for ever.
        with global_compiler_lock, _turn(name), _counted():
            return compile_alone(signature if for_constants else alike(signature))

    dispatcher.compile = compile_in_turn
    return dispatcher


def alike(signature: Any) -> Any:
    """One signature for calls that differ in a constant, or in the width of an index.

    Numba would compile a kernel for each of them: a fifth of all that a first build compiles.
    """
    given, returned = sigutils.normalize_signature(signature)
    widened = tuple(_widened(each) for each in given)
    return returned(*widened) if returned else widened


def _widened(kind: Any) -> Any:
    kind = types.unliteral(kind)
    return types.int64 if kind == types.int32 else kind


@contextmanager
def _counted() -> Iterator[None]:
    """Counts what the outermost kernel takes; those within are part of it. Numba builds large
    graphs, nearly all of which live until their kernel is done: looking through them for cycles as
    often as Python would is a seventh of all its time."""
    global _spent
    before, start, often = _spent, time.thread_time(), gc.get_threshold()
    gc.set_threshold(*SELDOM)
    try:
        yield
    finally:
        gc.set_threshold(*often)
        _spent = before + time.thread_time() - start


@contextmanager
def _turn(name: str) -> Iterator[None]:
    """Waits until no other process has this name's lock; it ends with the process at the latest."""
    folder = str(numba.config.CACHE_DIR)  # type: ignore[attr-defined]
    if fcntl is None or not folder or _held[name]:
        yield
        return
    try:
        Path(folder).mkdir(parents=True, exist_ok=True)
        file = (Path(folder) / f"{name}.lock").open("w")
    except OSError:  # a cache that cannot be written to: nothing to be kept apart
        yield
        return
    with file:
        fcntl.flock(file, fcntl.LOCK_EX)
        _held[name] += 1
        try:
            yield
        finally:
            _held[name] -= 1
