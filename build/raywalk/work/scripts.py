"""What a script that node runs or bundles is made from: the files it names, and theirs."""

from __future__ import annotations

import re
from functools import lru_cache
from os.path import isfile, normpath
from pathlib import Path

from raywalk.work.snapshot import text_of

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
            own, others = _named_in(text_of(file))
            waiting += [found for path in own if (found := _file(file.parent, path))]
            packages |= others
    return files, packages


@lru_cache(maxsize=1024)  # `raywalk serve` asks again after each save
def _named_in(text: str) -> tuple[frozenset[str], frozenset[str]]:
    """Relative paths, and packages of others."""
    text = TYPES.sub("", text)
    return frozenset(OWN.findall(text)), frozenset(OTHERS.findall(text))


def _file(folder: Path, path: str) -> Path | None:
    """What a script means by a relative path; None if there is no such file."""
    place = normpath(folder / path)
    names = (place, *(place + ending for ending in SCRIPTS))
    return next((Path(name) for name in names if isfile(name)), None)


def npm_package(place: Path) -> str:
    """The name of the package that npm installed a file or folder with; "" for none."""
    below = place.as_posix().partition("/node_modules/")[2].split("/")
    return "/".join(below[: 2 if below[0].startswith("@") else 1])
