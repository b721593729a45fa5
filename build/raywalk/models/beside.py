"""The files that a model file needs beside it: materials of OBJ, buffers of glTF."""

from __future__ import annotations

import json
import re
from pathlib import Path

from raywalk.models.gltf_buffers import beside_gltf
from raywalk.models.text import name_of

LIBRARY = re.compile(rb"^[ \t]*mtllib[ \t]+([^\r\n]+)", re.MULTILINE)


def beside(path: Path) -> tuple[Path, ...]:
    """Those that are there. A file that cannot be read has none; reading it says why."""
    try:
        match path.suffix.lower():
            case ".obj":
                lines = LIBRARY.findall(path.read_bytes())
                names = {name_of(line).replace("\\", "/") for line in lines}
                names |= {name_of(word) for line in lines for word in line.split()}
                found = {path.parent / name for name in names}
            case ".gltf":
                found = set(beside_gltf(path, json.loads(path.read_bytes())))
            case _:
                return ()
        return tuple(sorted(each for each in found if each.is_file()))
    except (OSError, ValueError, TypeError, AttributeError, RecursionError):
        return ()
