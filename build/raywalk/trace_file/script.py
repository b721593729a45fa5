"""Writes files so that a reader never meets half of one: beside, then renamed."""

from __future__ import annotations

import os
from pathlib import Path

from raywalk.trace_file.container import pack, script


def write_beside(path: Path, data: bytes) -> None:
    """The file appears whole or not at all."""
    beside = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        beside.write_bytes(data)
        beside.replace(path)
    finally:
        beside.unlink(missing_ok=True)


def write_script(path: Path, name: str, json_bytes: bytes) -> None:
    """raywalkReceive("<name>","<base64 of the gzip of the JSON>") as a classic script."""
    write_packed(path, name, pack(json_bytes))


def write_packed(path: Path, name: str, packed: bytes) -> None:
    """The same of JSON that is packed already."""
    write_beside(path, script(name, packed))
