"""Hashes of files and of plain values: what keys and manifests are made of."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any


def digest(path: Path) -> str:
    """SHA-256 of a file's bytes."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def digest_or_missing(path: Path) -> str:
    """Of a file that may not be there, or not be readable: that too is a state of the inputs."""
    try:
        return digest(path)
    except OSError:
        return "missing"


def digests(files: Iterable[Path], root: Path) -> dict[str, str]:
    """Path below `root` -> hash, in order."""
    return {path.relative_to(root).as_posix(): digest(path) for path in sorted(files)}


def key_of(made_from: Any) -> str:
    """Name of an entry: 24 hex digits of the hash of plain values."""
    text = json.dumps(made_from, sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()[:24]
