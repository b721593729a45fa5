"""What each piece of work is made from; the hash of that is its key in the store.

The parts are kept beside the work, so that `raywalk site --explain` can name the part that
changed. Keys are taken before anything runs: a file edited meanwhile is then made next time.
"""

from __future__ import annotations

import zlib
from dataclasses import asdict, replace
from functools import cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.scene.shapes import Mesh
from raywalk.work.digests import digest, digests

SOURCE = Path(__file__).resolve().parent.parent
# The stages a trace goes through. The site's code is not among them: a page edit traces nothing.
STAGES = ("scene/placement.py", "optics", "geometry", "trace", "trace_file", "products.py")
PACKAGES = ("numpy", "numba", "pillow")
# A scene without a mesh runs none of this (tested), so it is not traced again when it changes.
MESH_STAGES = frozenset(
    f"{name}.py"
    for name in (
        "geometry/bvh", "geometry/display", "geometry/float32_copy", "geometry/mesh_file",
        "geometry/mesh_section", "geometry/mesh_savings", "geometry/mesh_target",
        "geometry/shallow_boxes", "trace/boxes",
    )
)  # fmt: skip
MESH_PACKAGES = ("embreex", "trimesh")
# What a scene's data for the viewer is made by, from its trace and its words.
PAGE_STAGES = ("scene", "site", "trace_file", "lesson_text.py")
PAGE_PACKAGES = ("numpy", "markdown")

Parts = dict[str, Any]  # plain values, as JSON


def trace_parts(scene: Scene) -> Parts:
    """The scene without its words, its meshes' bytes, the code and packages that trace it."""
    has_mesh = any(isinstance(obj.shape, Mesh) for obj in scene.objects)
    meshes = {obj.shape.path for obj in scene.objects if isinstance(obj.shape, Mesh)}
    silent = replace(scene, title="", teaches="", key="", lesson=(), path=Path())
    skipped = frozenset() if has_mesh else MESH_STAGES
    return {
        "what": "trace",
        "of": scene.id,
        "scene": plain(silent),
        "models": {path.name: digest(path) for path in sorted(meshes)},
        **makers(STAGES, PACKAGES + (MESH_PACKAGES if has_mesh else ()), skipped),
    }


def page_data_parts(scene: Scene, trace_key: str) -> Parts:
    """The whole scene with its words, its trace, and the code that makes its data."""
    whole = plain(replace(scene, path=Path()))
    return {
        "what": "page data", "of": scene.id, "scene": whole, "trace": trace_key,
        **makers(PAGE_STAGES, PAGE_PACKAGES),
    }  # fmt: skip


def preview_parts(id: str, trace_key: str) -> Parts:
    """A scene's preview picture: its trace, our typeface, what draws it."""
    own = makers(("site/preview.py",), ("pillow",))
    return {"what": "preview", "of": id, "trace": trace_key, **own}


def viewer_parts(site_source: Path) -> Parts:
    """The viewer's sources, its bundler and the packages that npm has installed."""
    sources = [*site_source.rglob("*.mjs"), *(site_source / "viewer").rglob("*")]
    root = site_source.absolute().parent
    locks = [root / "package-lock.json", root / "node_modules" / ".package-lock.json"]
    return {
        "what": "viewer",
        "of": "viewer",
        "code": digests((path for path in sources if is_source(path)), site_source),
        "ray kinds": digest(SOURCE / "trace" / "ray_kinds.json"),
        "packages": {
            lock.relative_to(root).as_posix(): digest(lock) for lock in locks if lock.is_file()
        },
    }


def is_source(path: Path) -> bool:
    """Not what the type check makes for itself: types are no part of what is built."""
    return path.is_file() and not path.name.endswith(".d.ts")


def makers(
    stages: tuple[str, ...], packages: tuple[str, ...], skipped: frozenset[str] = frozenset()
) -> Parts:
    """The code of some stages and the versions of packages, also of zlib: it decides on bytes."""
    code = {name: made for name, made in _code(stages).items() if name not in skipped}
    versions = {name: _version(name) for name in packages}
    return {"code": code, "packages": versions | {"zlib": zlib.ZLIB_RUNTIME_VERSION}}


_version = cache(version)


@cache
def _code(stages: tuple[str, ...]) -> dict[str, str]:
    """Hashed once a process: what runs is what was imported."""
    places = [SOURCE / stage for stage in stages]
    files = [place for place in places if place.is_file()]
    for folder in (place for place in places if place.is_dir()):
        files += [path for path in folder.rglob("*") if path.suffix in (".py", ".json")]
    return digests(files, SOURCE)


def plain(scene: Scene) -> Any:
    """A scene as JSON values; files by their name, as their content is hashed."""
    return _plain(asdict(scene))


def _plain(value: Any) -> Any:
    match value:
        case dict():
            return {key: _plain(inner) for key, inner in value.items()}
        case list() | tuple():
            return [_plain(inner) for inner in value]
        case np.ndarray():
            return value.tolist()
        case Path():
            return value.name
    return value
