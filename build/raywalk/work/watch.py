"""Notices that files were saved, by scanning folders: needs no package, works on any disk."""

from __future__ import annotations

import os
import time
from collections.abc import Iterable
from pathlib import Path
from threading import Condition, Thread

EVERY = 0.1  # seconds between two scans
AT_REST = 0.05  # seconds without a change: an editor that saves several files is done

Seen = dict[str, tuple[int, int]]  # path -> time of change, size


class Saves:
    """Paths below some folders that changed, as they are saved, whatever else goes on."""

    def __init__(self, folders: Iterable[Path]):
        self._folders, self._changed = list(folders), set[str]()
        self._news = Condition()
        self._seen = scan(self._folders)
        Thread(target=self._watch, daemon=True).start()

    @property
    def are_there(self) -> bool:
        """Whether there are any that nobody was told of."""
        return bool(self._changed)

    def wait(self, seconds: float) -> list[str]:
        """Those since it was asked last, as soon as there are any; none when the time is over."""
        with self._news:
            self._news.wait_for(lambda: self._changed, seconds)
            changed, self._changed = sorted(self._changed), set()
            return changed

    def _watch(self) -> None:
        while True:
            time.sleep(EVERY)
            now = scan(self._folders)
            if now == self._seen:
                continue
            while (later := _later(self._folders)) != now:
                now = later
            with self._news:
                self._changed |= {path for path, _ in now.items() ^ self._seen.items()}
                self._seen = now
                self._news.notify_all()


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
