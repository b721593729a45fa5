"""A store of finished work, addressed by what it was made from.

An entry is a folder of files with a manifest: what it was made from, and the files' hashes.
It is written beside and renamed, so an interrupted build leaves no half entry; a damaged one
is noticed and made again. Branches share the store: what any of them used lately is kept.
"""

from __future__ import annotations

import json
import os
import shutil
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from operator import itemgetter
from pathlib import Path
from typing import Any

from raywalk.work.digests import digest
from raywalk.work.leftovers import owned_name, remove_leftovers

MANIFEST = "manifest.json"
# What no build has used for so long goes, and beyond so many bytes what was used longest ago.
DAYS_KEPT = 30
MOST_BYTES = 2_000_000_000


@dataclass(frozen=True)
class Entry:
    """A finished entry's folder, and whether it was found or had to be made."""

    folder: Path
    was_found: bool

    def files(self) -> list[Path]:
        """Its files without the manifest, in order."""
        return sorted(path for path in self.folder.iterdir() if path.name != MANIFEST)


class Store:
    """Entries under one folder. explains: whether this build says why it makes what is not there
    (`making.reasons`)."""

    def __init__(self, folder: Path, explains: bool = False):
        self.folder = folder
        self.explains = explains

    def find(self, key: str) -> Entry | None:
        """The entry of a key, if it is there and undamaged; it counts as used from then on."""
        place = self.folder / key
        if damage_of(place) is not None:
            return None
        _touch(place)
        return Entry(place, was_found=True)

    def has(self, key: str) -> bool:
        """Whether there is an entry, damaged or not: of many large ones, in no time."""
        return (self.folder / key / MANIFEST).is_file()

    def get(self, key: str) -> Entry:
        """The entry of a key that is known to be there."""
        return Entry(self.folder / key, was_found=True)

    def entry(self, key: str, make: Callable[[Path], None], made_from: Any = None) -> Entry:
        """The entry of a key; `make` fills a new folder with its files if there is none."""
        place = self.folder / key
        if found := self.find(key):
            return found
        self.folder.mkdir(parents=True, exist_ok=True)
        fresh = Path(tempfile.mkdtemp(dir=self.folder, **owned_name(f"{key}.")))
        try:
            make(fresh)
            hashes = {path.name: digest(path) for path in sorted(fresh.iterdir())}
            # In a line: with an indent Python's own encoder would write it, not the one in C.
            manifest = json.dumps({"made_from": made_from, "files": hashes})
            (fresh / MANIFEST).write_text(manifest, encoding="utf-8")
            self._keep(fresh, place)
        finally:
            shutil.rmtree(fresh, ignore_errors=True)
        return Entry(place, was_found=False)

    def newest(self, what: str, of: str) -> Any:
        """What the newest entry of this kind and name was made from; None if there is none."""
        return self.newest_of(what).get(of)

    def all_of(self, what: str, of: str) -> list[Any]:
        """What each entry of this kind and name was made from, the one used last first."""
        found = [(_used(place), _made_from(place)) for place in self._places()]
        alike = [each for each in found if (each[1].get("what"), each[1].get("of")) == (what, of)]
        return [made_from for _, made_from in sorted(alike, key=itemgetter(0), reverse=True)]

    def newest_of(self, what: str) -> dict[str, Any]:
        """The same of every name of a kind: one look at the store, which may hold thousands."""
        newest: dict[str, tuple[float, Any]] = {}
        for place in self._places():
            made_from = _made_from(place)
            if made_from.get("what") == what:
                of, used = str(made_from.get("of")), _used(place)
                if of not in newest or newest[of][0] < used:
                    newest[of] = used, made_from
        return {of: made_from for of, (_, made_from) in newest.items()}

    def prune(self, keep: set[str], days: float = DAYS_KEPT, most: int = MOST_BYTES) -> int:
        """Removes what no build used lately, but never these keys; returns the bytes freed."""
        remove_leftovers(self.folder)
        freed, total, now = 0, 0, time.time()
        for place in sorted(self._places(), key=_used, reverse=True):
            size = sum(path.stat().st_size for path in place.iterdir())
            total += size
            is_old = now - _used(place) > days * 86_400
            if place.name not in keep and (is_old or total > most):
                shutil.rmtree(place, ignore_errors=True)
                total, freed = total - size, freed + size
        return freed

    def _places(self) -> list[Path]:
        if not self.folder.is_dir():
            return []
        return [path for path in self.folder.iterdir() if path in _known or is_entry(path)]

    def _keep(self, fresh: Path, place: Path) -> None:
        if damage_of(place) is None:
            return  # another build on the same tree was quicker, and may be reading it
        shutil.rmtree(place, ignore_errors=True)
        try:
            fresh.rename(place)
        except OSError:
            if damage_of(place) is not None:  # unless it came in between these two lines
                raise


# What entries were made from, once a process: an entry's name is the hash of that. Serving a site
# builds it again and again beside the same thousand entries, whose manifests take two seconds.
_known: dict[Path, dict[str, Any]] = {}


def _made_from(place: Path) -> dict[str, Any]:
    """Of an entry that is there, whole or not; finding it will tell."""
    if place not in _known:
        _known[place] = _manifest(place).get("made_from") or {}
    return _known[place]


def is_entry(place: Path) -> bool:
    """Whether a folder is one of ours: other programs have manifests too."""
    return {"made_from", "files"} <= _manifest(place).keys()


def damage_of(place: Path) -> str | None:
    """None for a whole entry, else what is wrong with it; "" if there is none at all."""
    if not place.is_dir():
        return ""
    files = _manifest(place).get("files")
    if not isinstance(files, dict):
        return MANIFEST
    for name, made in files.items():
        try:
            if digest(place / name) != made:
                return name
        except OSError:
            return name
    return None


def _manifest(place: Path) -> dict[str, Any]:
    try:
        manifest = json.loads((place / MANIFEST).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return manifest if isinstance(manifest, dict) else {}


def _used(place: Path) -> float:
    """When a build last used an entry, seconds."""
    try:
        return (place / MANIFEST).stat().st_mtime
    except OSError:
        return 0.0


def _touch(place: Path) -> None:
    try:
        os.utime(place / MANIFEST)
    except OSError:
        return  # a store that may only be read still serves
