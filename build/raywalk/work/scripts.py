"""What a script that node runs or bundles is made from: the files it names, and theirs."""

from __future__ import annotations

import re
from os.path import normpath
from pathlib import Path

SCRIPTS = (".ts", ".mjs", ".js")
# Types leave nothing behind in a script.
TYPES = re.compile(r"^\s*(?:import|export)\s+type\b[^;]*?;", re.MULTILINE)
# Not only behind `from`: a bundler's entries are texts like any other.
OWN = re.compile(r"""["'`](\.{1,2}/[\w./-]+)["'`]""")
OTHERS = re.compile(r"""\b(?:from|import)\s*\(?\s*["']((?:@[\w-]+/)?[\w-]+)(?:/[^"'\n]*)?["']""")


def script_closure(entry: Path) -> tuple[set[Path], set[str]]:
    """The script, all of ours that it names by relative paths, what those name, and the npm
    packages they import. JSON that is named belongs to it too. Raises OSError."""
    files: set[Path] = set()
    packages: set[str] = set()
    waiting = [entry]
    while waiting:
        file = waiting.pop()
        if file in files:
            continue
        files.add(file)
        if file.suffix in SCRIPTS:
            text = TYPES.sub("", file.read_text(encoding="utf-8"))
            waiting += [found for path in OWN.findall(text) if (found := _file(file.parent, path))]
            packages |= set(OTHERS.findall(text))
    return files, packages


def _file(folder: Path, path: str) -> Path | None:
    """What a script means by a relative path; None if there is no such file."""
    place = Path(normpath(folder / path))
    places = (place, *(place.with_name(place.name + ending) for ending in SCRIPTS))
    return next((file for file in places if file.is_file()), None)


def npm_package(place: Path) -> str:
    """The name of the package that npm installed a file or folder with; "" for none."""
    below = place.as_posix().partition("/node_modules/")[2].split("/")
    return "/".join(below[: 2 if below[0].startswith("@") else 1])
