"""What each piece of work is made from; the hash of that is its key in the store.

Code, the files it reads and the packages it uses are found in the sources (`closure.py`), never
listed. The parts are kept beside the work, so that `raywalk site --explain` can name the part
that changed. Keys are taken before anything runs: a file edited meanwhile is then made next time.
"""

from __future__ import annotations

import platform
import zlib
from collections.abc import Iterable
from dataclasses import asdict, dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.scene.shapes import Mesh
from raywalk.work.closure import Closure, Sources
from raywalk.work.digests import digest
from raywalk.work.packages import npm_versions, versions
from raywalk.work.scripts import script_closure
from raywalk.work.snapshot import digest_of

# Of modules that begin so a scene without a mesh runs none (tested), and needs no key.
MESH = "mesh_"
OURS = Sources()

Parts = dict[str, Any]  # plain values, as JSON


@dataclass(frozen=True)
class Maker:
    """A function by its names: what is hashed is then what is run. Its module is imported when
    it runs, so a build with nothing to make never pays for numba, ReportLab and their like."""

    module: str
    function: str

    def __call__(self, *given: Any, **named: Any) -> Any:
        return getattr(import_module(self.module), self.function)(*given, **named)

    def parts(
        self, shut: str = "", languages: Iterable[str] | None = None, sources: Sources = OURS
    ) -> Parts:
        """Its code with what it reads and uses. shut: as in Sources.closure; languages: whose
        sentences it says, all if None."""
        return parts_of(sources.closure(self.module, shut), languages, sources)


TRACE = Maker("raywalk.products", "write_products")
PAGE_DATA = Maker("raywalk.site.page_data", "write_page_data")
PREVIEW = Maker("raywalk.site.preview", "write_preview")


def trace_parts(scene: Scene) -> Parts:
    """The scene without its words, its meshes' bytes, and what traces it."""
    silent = replace(scene, title="", teaches="", key="", lesson=(), path=Path())
    return {
        "what": "trace",
        "of": scene.id,
        "scene": plain(silent),
        "models": models_of(scene),
        **TRACE.parts(shut_for(scene)),
    }


def models_of(scene: Scene) -> dict[str, str]:
    """Hash of each object's mesh file. Raises OSError."""
    meshes = {obj.name: obj.shape.path for obj in scene.objects if isinstance(obj.shape, Mesh)}
    hashes = {path: digest(path) for path in set(meshes.values())}
    return {f"{path.name} of {name}": hashes[path] for name, path in meshes.items()}


def shut_for(scene: Scene) -> str:
    """The modules that a scene has no use for."""
    return "" if any(isinstance(obj.shape, Mesh) for obj in scene.objects) else MESH


def page_data_parts(scene: Scene, trace_key: str) -> Parts:
    """The whole scene with its words, its trace, and what makes its data."""
    whole = plain(replace(scene, path=Path()))
    return {
        "what": "page data", "of": scene.id, "scene": whole, "trace": trace_key,
        **PAGE_DATA.parts(),
    }  # fmt: skip


def preview_parts(id: str, trace_key: str) -> Parts:
    """A scene's preview picture: its trace, our typeface, what draws it."""
    return {"what": "preview", "of": id, "trace": trace_key, **PREVIEW.parts()}


def viewer_parts(site_source: Path) -> Parts:
    """The bundler, all that it bundles, and the npm packages they import."""
    root = site_source.absolute().parent
    files, packages = script_closure(site_source.absolute() / "bundle.mjs")
    code = {path.relative_to(root).as_posix(): digest_of(path) for path in sorted(files)}
    return {
        "what": "viewer", "of": "viewer", "code": code, "packages": npm_versions(root, packages)
    }  # fmt: skip


def parts_of(found: Closure, languages: Iterable[str] | None, sources: Sources = OURS) -> Parts:
    """A closure as plain values. Versions of Python and zlib are among them: they decide on how
    numbers are written and files are packed."""
    said = None if languages is None else {f"{code}.json" for code in languages}
    scripts = {path: digest_of(path) for path in found.scripts}
    read = {
        path: digest_of(path)
        for path in found.read
        if said is None or path.parent.name != "words" or path.name in said
    }
    own = {"python": platform.python_version(), "zlib": zlib.ZLIB_RUNTIME_VERSION}
    return {
        "code": named(found.modules | scripts, sources),
        "read": named(read, sources),
        "packages": own | versions(found.packages) | npm_versions(sources.root, found.npm),
    }


def named(hashes: dict[Path, str], sources: Sources) -> dict[str, str]:
    """By the path below our package, or below the repository."""
    return {sources.name(path): hashes[path] for path in sorted(hashes)}


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
