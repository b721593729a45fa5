"""A store of finished work, addressed by what it was made from.

An entry is a folder of files with a manifest of their hashes. It is written beside and
renamed, so an interrupted build leaves no half entry; a damaged one is noticed and made
again.
"""

from __future__ import annotations

import hashlib
import json
import shutil
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

MANIFEST = "manifest.json"


@dataclass(frozen=True)
class Entry:
    """A finished entry's folder, and whether it was found or had to be made."""

    folder: Path
    was_found: bool

    def files(self) -> list[Path]:
        """Its files without the manifest, in order."""
        return sorted(path for path in self.folder.iterdir() if path.name != MANIFEST)


class Store:
    """Entries under one folder."""

    def __init__(self, folder: Path):
        self.folder = folder

    def find(self, key: str) -> Entry | None:
        """The entry of a key, if it is there and undamaged."""
        place = self.folder / key
        return Entry(place, was_found=True) if _is_whole(place) else None

    def get(self, key: str) -> Entry:
        """The entry of a key that is known to be there."""
        return Entry(self.folder / key, was_found=True)

    def entry(self, key: str, make: Callable[[Path], None]) -> Entry:
        """The entry of a key; `make` fills a new folder with its files if there is none."""
        place = self.folder / key
        if found := self.find(key):
            return found
        self.folder.mkdir(parents=True, exist_ok=True)
        fresh = Path(tempfile.mkdtemp(prefix=f"{key}.", suffix=".partial", dir=self.folder))
        try:
            make(fresh)
            hashes = {path.name: _digest(path) for path in sorted(fresh.iterdir())}
            (fresh / MANIFEST).write_text(json.dumps(hashes, indent=1), encoding="utf-8")
            self._keep(fresh, place)
        finally:
            shutil.rmtree(fresh, ignore_errors=True)
        return Entry(place, was_found=False)

    def _keep(self, fresh: Path, place: Path) -> None:
        if _is_whole(place):
            return  # another build on the same tree was quicker, and may be reading it
        shutil.rmtree(place, ignore_errors=True)
        try:
            fresh.rename(place)
        except OSError:
            if not _is_whole(place):  # unless it came in between these two lines
                raise


def _is_whole(place: Path) -> bool:
    try:
        hashes = json.loads((place / MANIFEST).read_text(encoding="utf-8"))
        return all(_digest(place / name) == digest for name, digest in hashes.items())
    except (OSError, ValueError, AttributeError):
        return False


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()
