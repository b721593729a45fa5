"""What a build reads of its sources, read once: the bytes that are hashed are the bytes used.

A template that is saved while a build runs is in none of its pages or in all of them, and never
in a page that is kept under the older text's hash. Worker processes are handed what was read.
Python's own sources and what node reads cannot come from here: their hashes are compared again
when the work is done (`making.py`). Outside of a build files are read as they are now.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

_held: dict[str, bytes] | None = None


@contextmanager
def one_build() -> Iterator[None]:
    """Until it ends each file is read once at most."""
    global _held
    before, _held = _held, {}
    try:
        yield
    finally:
        _held = before


def hold(files: dict[str, bytes] | None) -> None:
    """In a worker process: what its build has read."""
    global _held
    _held = files


def held() -> dict[str, bytes] | None:
    """What this build has read, by absolute path; None outside of a build."""
    return _held


def bytes_of(path: Path) -> bytes:
    """The file's bytes. Raises OSError."""
    if _held is None:
        return path.read_bytes()
    name = str(path.absolute())
    if name not in _held:
        _held[name] = path.read_bytes()
    return _held[name]


def text_of(path: Path) -> str:
    """The same as text, in UTF-8, each line ended by \\n; without the byte order mark that some
    editors begin with. Raises OSError, UnicodeDecodeError."""
    return bytes_of(path).decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")


def digest_of(path: Path) -> str:
    """SHA-256 of the bytes that `bytes_of` gives; "missing" where it cannot be read: that too is a
    state of the sources."""
    try:
        return hashlib.sha256(bytes_of(path)).hexdigest()
    except OSError:
        return "missing"
