"""What each piece of work of a site is made from; the hash of that is its key in the store.

The parts are kept beside the work, so that `raywalk site --explain` can name the part that
changed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.site.assets import MADE
from raywalk.work.digests import digest
from raywalk.work.maker import Maker, Parts
from raywalk.work.packages import npm_versions
from raywalk.work.scripts import script_closure
from raywalk.work.snapshot import digest_of
from raywalk.work.store import Entry

# Of modules that begin so a scene without a mesh runs none (tested), and needs no key.
MESH = "mesh_"
NO_SWEEPS: Mapping[str, Entry] = {}

TRACE = Maker("raywalk.pipeline.trace_products", "write_products")
PAGE_DATA = Maker("raywalk.site.scene_data", "write_page_data")
PAGE_PICTURES = Maker("raywalk.site.page_pictures", "write_page_pictures")


def trace_parts(scene: Scene) -> Parts:
    """The scene without its words, its meshes' bytes, and what traces it."""
    return {
        "what": "trace",
        "of": scene.id,
        "scene": silent(scene),
        "models": models_of(scene),
        **TRACE.parts(shut_for(scene)),
    }


def silent(scene: Scene) -> Any:
    """All of a scene that is traced: it without its words."""
    words: dict[str, Any] = {
        "title": "", "teaches": "", "key": "", "chapter": "", "before": "", "mistakes": (),
        "lesson": (), "goals": (), "base": None, "sweeps": (),
    }  # fmt: skip
    return plain(replace(scene, path=Path(), **words))


def grids_parts(of_trace: Parts) -> Parts:
    """What a scene's grids are made from that were traced before its picture: what its trace is."""
    return {**of_trace, "what": "grids"}


def models_of(scene: Scene) -> dict[str, str]:
    """Hash of each object's mesh file, of those it needs, and of its texture. Raises OSError."""
    named = [(obj.name, path) for obj in scene.objects for path in obj.files]
    hashes = {path: digest(path) for path in {path for _, path in named}}
    return {f"{path.name} of {name}": hashes[path] for name, path in named}


def shut_for(scene: Scene) -> str:
    """The modules that a scene has no use for."""
    return "" if scene.has_mesh else MESH


def page_data_parts(
    scene: Scene, trace_key: str, picture: str = "picture.png", worked: Entry | None = None,
    sweeps: Mapping[str, Entry] = NO_SWEEPS,
) -> Parts:  # fmt: skip
    """The whole scene with its words, its trace, the picture it names, what its lesson works out,
    what is published of its sweeps, and what makes its data."""
    whole = plain(replace(scene, path=Path()))
    return {
        "what": "page data", "of": scene.id, "scene": whole, "trace": trace_key,
        "picture": picture, "worked": worked.folder.name if worked else "",
        "sweeps": {id: each.folder.name for id, each in sweeps.items()}, **PAGE_DATA.parts(),
    }  # fmt: skip


def page_pictures_parts(id: str, trace_key: str) -> Parts:
    """A scene's pictures as pages show them: its trace, our typeface, what makes them."""
    return {"what": "page pictures", "of": id, "trace": trace_key, **PAGE_PICTURES.parts()}


def viewer_parts(site_source: Path) -> Parts:
    """The bundler, all it bundles, and the npm packages they import; in a wheel the bundles."""
    root, made = site_source.absolute().parent, site_source.absolute() / MADE
    if made.is_dir():
        files, packages = set(made.iterdir()), set[str]()
    else:
        files, packages = script_closure(site_source.absolute() / "bundle.mjs")
    code = {path.relative_to(root).as_posix(): digest_of(path) for path in sorted(files)}
    return {
        "what": "viewer", "of": "viewer", "code": code, "packages": npm_versions(root, packages)
    }  # fmt: skip


def plain(scene: Scene) -> Any:
    """A scene as JSON values; files by their name, as their content is hashed."""
    return _plain(scene)


def _plain(value: Any) -> Any:
    if is_dataclass(value):  # asdict would copy each number deeply, in three times the time
        return {each.name: _plain(getattr(value, each.name)) for each in fields(value)}
    match value:
        case str() | float() | int() | None:  # nearly all
            return value
        case dict():
            return {key: _plain(inner) for key, inner in value.items()}
        case list() | tuple():
            return [_plain(inner) for inner in value]
        case np.ndarray():
            return value.tolist()
        case Path():
            return value.name
    return value
