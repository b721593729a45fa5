"""How kernels are compiled: cached on disk, without the interpreter lock, IEEE float64."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba

from raywalk.optics.compiling import compiled_once

PACKAGE = Path(__file__).parent.parent
IMPORTED = re.compile(r"^\s*from (raywalk[\w.]*) import ([\w, ]*)", re.MULTILINE)


def kernel(function: Callable[..., Any]) -> Callable[..., Any]:
    """A numba kernel. No fastmath: it would reorder sums and drop NaN checks, and two
    machines would no longer write the same bytes. nogil: strips are traced in threads.
    """
    return _compiled(function)


def lean(function: Callable[..., Any]) -> Callable[..., Any]:
    """A kernel that makes no array and returns none. Of those it is handed numba then counts no
    references: two locked instructions an array and call, more than asking a triangle takes."""
    return _compiled(function, counts=False)


def inlined(function: Callable[..., Any]) -> Callable[..., Any]:
    """A kernel that is always copied into its callers: for the innermost loops, where handing
    over a table of arrays costs several times the arithmetic done with it, and where loops of a
    known length fill vectors. Makes no array."""
    return _compiled(function, forceinline=True, counts=False)


def _compiled(
    function: Callable[..., Any], forceinline: bool = False, counts: bool = True
) -> Callable[..., Any]:
    """Without the second entry that numba makes for C code, which takes a tenth of its time.
    counts: it counts references, as it must where arrays are made."""
    # Unknown to numba's types.
    options: Any = {"forceinline": forceinline, "no_cfunc_wrapper": True, "_nrt": counts}
    made: Callable[..., Any] = compiled_once(
        numba.njit(cache=True, nogil=True, error_model="numpy", **options)(function),
        for_constants=forceinline,
    )
    return made


def _use_cache_of_these_sources() -> None:
    """Numba asks only whether a kernel's own file changed, not the files of the kernels that
    were compiled into it, and would go on using the old ones. So each state of the sources
    has a cache of its own. Where the package cannot be written to, numba's default stays.
    """
    digest = hashlib.sha256()
    for text in _sources_of_kernels():
        digest.update(text.encode())
    cache = PACKAGE / "__pycache__" / f"kernels-{digest.hexdigest()[:16]}"
    config: Any = numba.config  # its attributes come from the environment, unseen by mypy
    if not config.CACHE_DIR and os.access(PACKAGE, os.W_OK):
        config.CACHE_DIR = str(cache)


def _sources_of_kernels() -> list[str]:
    """Of the modules that hold kernels, and of all of ours that these import."""
    texts = {
        ".".join(file.relative_to(PACKAGE.parent).with_suffix("").parts): file.read_text("utf-8")
        for file in PACKAGE.rglob("*.py")
    }
    waiting = [name for name, text in texts.items() if "raywalk.optics.compiled import" in text]
    found: set[str] = set()
    while waiting:
        if (name := waiting.pop()) in texts and name not in found:
            found.add(name)
            for module, names in IMPORTED.findall(texts[name]):
                waiting += [module, *(f"{module}.{each.strip()}" for each in names.split(","))]
    return [texts[name] for name in sorted(found)]


_use_cache_of_these_sources()
