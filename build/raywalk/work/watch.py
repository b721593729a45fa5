"""Notices that files were saved, by scanning folders: needs no package, works on any disk."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Iterable, Iterator
from pathlib import Path

EVERY = 0.1  # seconds between two scans
AT_REST = 0.05  # seconds without a change: an editor that saves several files is done

Seen = dict[str, tuple[int, int]]  # path -> time of change, size


def changes(folders: Iterable[Path], quiet: float) -> Iterator[list[str]]:
    """The paths that changed, each time files were saved; nothing at once, and again whenever
    nobody saved anything for `quiet` seconds after that."""
    folders = list(folders)
    seen = scan(folders)
    yield []
    yielded = time.monotonic()
    while True:
        time.sleep(EVERY)
        now = scan(folders)
        if now == seen:
            if time.monotonic() - yielded > quiet:
                yield []
                yielded = math.inf
            continue
        while (later := _later(folders)) != now:
            now = later
        changed = {path for path, _ in now.items() ^ seen.items()}
        seen = now
        yield sorted(changed)
        yielded = time.monotonic()


def scan(folders: Iterable[Path]) -> Seen:
    """Every file below some folders, but for editors' swap files and other hidden ones."""
    seen: Seen = {}
    for folder in folders:
        _scan_into(str(folder), seen)
    return seen


def _scan_into(folder: str, seen: Seen) -> None:
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if entry.name.startswith(".") or entry.name.endswith("~"):
                    continue
                if entry.is_dir():
                    _scan_into(entry.path, seen)
                else:
                    state = entry.stat()
                    seen[entry.path] = (state.st_mtime_ns, state.st_size)
    except OSError:
        return  # gone between two scans


def _later(folders: list[Path]) -> Seen:
    time.sleep(AT_REST)
    return scan(folders)
