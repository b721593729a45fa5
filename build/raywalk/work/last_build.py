"""What the last build into a folder read and wrote: if nothing of it changed, nothing is to do.

Then a build ends after hashing the files, without reading a scene or importing what does.
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
import zlib
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

from raywalk.work.digests import digest, digest_or_missing, digests
from raywalk.work.packages import installed
from raywalk.work.snapshot import digest_of

PACKAGE = Path(__file__).resolve().parent.parent
FORMAT = 1


class LastBuild:
    """The record of one output folder, kept in the work folder."""

    def __init__(self, work: Path, out: Path):
        name = hashlib.sha256(str(out.absolute()).encode()).hexdigest()[:16]
        self.file = work / "builds" / f"{name}.json"
        self.out = out

    def said(self, inputs: dict[str, str]) -> dict[str, Any] | None:
        """What the last build said, if it read the same inputs and its output is as it left it."""
        try:
            record = json.loads(self.file.read_text(encoding="utf-8"))
            is_same = record["inputs"] == inputs | also_read(record["also"])
            if is_same and record["outputs"] == outputs_of(self.out):
                said: dict[str, Any] = record["said"]
                return said
        except (OSError, ValueError, KeyError, TypeError):
            pass
        return None

    def keep(self, inputs: dict[str, str], also: Iterable[Path], said: dict[str, Any]) -> None:
        """Notes a build that ended well. also: files read that are not in the usual places."""
        others = sorted(str(path) for path in also)
        record = {
            "inputs": inputs | also_read(others),
            "also": others,
            "outputs": outputs_of(self.out),
            "said": said,
        }
        self.file.parent.mkdir(parents=True, exist_ok=True)
        beside = self.file.with_suffix(".partial")
        beside.write_text(json.dumps(record), encoding="utf-8")
        beside.replace(self.file)


def inputs_of(scenes: Path, site_source: Path, work: Path) -> dict[str, str]:
    """Hashes of everything a build reads: scenes, models, the site's and the pipeline's code,
    what npm and pip installed, reports."""
    root = site_source.absolute().parent
    places = [*_files(scenes), *_files(site_source), *(work / "reports").glob("*.json")]
    places += [folder / "models" / "models.toml" for folder in scenes.absolute().parents]
    places += [
        root / "models" / "models.toml",
        root / "package-lock.json",
        root / "node_modules" / ".package-lock.json",
    ]
    named = {str(path): digest_of(path) for path in places}
    others = (f"{name} {version}" for name, (version, _) in sorted(installed().items()))
    versions = f"{sys.version} {zlib.ZLIB_RUNTIME_VERSION} {' '.join(others)}"
    return named | _code() | {"versions": versions, "format": str(FORMAT)}


def also_read(files: Iterable[str]) -> dict[str, str]:
    return {name: digest_or_missing(Path(name)) for name in files}


def outputs_of(out: Path) -> dict[str, str]:
    """Path -> hash of every file below a site."""
    return {path.relative_to(out).as_posix(): digest(path) for path in _files(out)}


def _files(folder: Path) -> Iterator[Path]:
    """All but what Python compiles and the type check makes for itself."""
    for place, folders, names in os.walk(folder):
        folders[:] = [name for name in folders if name != "__pycache__"]
        yield from (Path(place, name) for name in names if not name.endswith(".d.ts"))


@cache
def _code() -> dict[str, str]:
    """Hashed once a process: what runs is what was imported, however it is edited meanwhile."""
    return digests(_files(PACKAGE), PACKAGE)
