"""The key of a scene's trace: a hash of everything that decides what it looks like."""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, replace
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.model import Mesh, Scene

SOURCE = Path(__file__).resolve().parent.parent
# The stages a trace goes through. The site's code is not among them: a page edit traces nothing.
STAGES = ("scene/placement.py", "optics", "geometry", "trace", "trace_file", "products.py")
PACKAGES = ("numpy", "numba", "embreex", "trimesh", "pillow")


def trace_key(scene: Scene) -> str:
    """Hash of the scene without its words, its meshes' bytes, the stages' code and versions."""
    digest = hashlib.sha256()
    silent = replace(scene, title="", teaches="", key="", lesson=(), path=Path())
    digest.update(json.dumps(asdict(silent), default=_plain, sort_keys=True).encode())
    for obj in scene.objects:
        if isinstance(obj.shape, Mesh):
            digest.update(obj.shape.path.read_bytes())
    for file in _code():
        digest.update(file.relative_to(SOURCE).as_posix().encode() + b"\0" + file.read_bytes())
    digest.update(" ".join(f"{name} {version(name)}" for name in PACKAGES).encode())
    return digest.hexdigest()[:24]


def _code() -> list[Path]:
    places = [SOURCE / stage for stage in STAGES]
    files = [place for place in places if place.is_file()]
    for folder in (place for place in places if place.is_dir()):
        files += [path for path in folder.rglob("*") if path.suffix in (".py", ".json")]
    return sorted(files)


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.tolist()
    return value.name if isinstance(value, Path) else repr(value)
