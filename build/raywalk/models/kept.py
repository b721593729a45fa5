"""Models that were read and cleaned, kept for a while: a scene's objects often are parts of one."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from raywalk.models.clean import Cleaned, clean
from raywalk.models.read import read_model

FILES = 3


def read_cleaned(path: Path, weld: float | None = None) -> Cleaned:
    """A file's triangles, made fit; read anew once the file was changed. Raises ModelFault."""
    try:
        state = path.stat()
    except (OSError, ValueError):
        return clean(read_model(path), weld)  # which says what is wrong with the file
    return _kept(path, state.st_mtime_ns, state.st_size, weld)


@lru_cache(FILES)
def _kept(path: Path, changed: int, size: int, weld: float | None) -> Cleaned:
    return clean(read_model(path), weld)
