"""A function that makes a piece of work, and all that it is made from besides what it is given.

Code, the files it reads and the packages it uses are found in the sources (`closure.py`), never
listed. Keys are taken before anything runs: a file edited meanwhile is then made next time.
"""

from __future__ import annotations

import platform
import zlib
from collections.abc import Iterable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from raywalk.node import node_program
from raywalk.work.closure import Closure, Sources
from raywalk.work.packages import npm_versions, versions
from raywalk.work.snapshot import digest_of

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


def parts_of(found: Closure, languages: Iterable[str] | None, sources: Sources = OURS) -> Parts:
    """A closure as plain values. Versions of Python and zlib are among them: they decide on how
    numbers are written and files are packed."""
    said = None if languages is None else {f"{code}.json" for code in languages}
    scripts = {path: digest_of(path) for path in found.scripts}
    read = {
        path: digest_of(path)
        for path in found.read
        if said is None or not _is_a_language(path) or path.name in said
    }
    own = {"python": platform.python_version(), "zlib": zlib.ZLIB_RUNTIME_VERSION}
    if scripts:
        own["node"] = which_build(node_program())
    return {
        "code": named(found.modules | scripts, sources),
        "read": named(read, sources),
        "packages": own | versions(found.packages) | npm_versions(sources.root, found.npm),
    }


def _is_a_language(path: Path) -> bool:
    """A file of sentences; what else stands beside them belongs to all languages."""
    return path.parent.name == "words" and path.suffix == ".json"


def which_build(program: str | None) -> str:
    """What tells one build of a program from another without running it, which would take as long
    as all the rest of a build with nothing to do; "none" if there is none."""
    if not program:
        return "none"
    about = Path(program).stat()
    return f"of {about.st_size} bytes, {about.st_mtime_ns}"


def named(hashes: dict[Path, str], sources: Sources) -> dict[str, str]:
    """By the path below our package, or below the repository."""
    # By their texts: paths compare themselves part by part, in Python.
    return {sources.name(path): hashes[path] for path in sorted(hashes, key=str)}
