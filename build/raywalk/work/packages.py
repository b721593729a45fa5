"""Which versions of other people's packages are installed, read off their folders: asking each
package itself takes as long as all the rest of a build with nothing to do."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterable
from functools import cache
from pathlib import Path

REQUIRED = re.compile(r"^Requires-Dist: ([\w.-]+)(?!.*\bextra ==)", re.MULTILINE)


@cache
def installed() -> dict[str, tuple[str, Path]]:
    """Distribution, named as pip compares names -> its version and the folder that tells of it."""
    found: dict[str, tuple[str, Path]] = {}
    for place in map(Path, sys.path):
        if place.name.endswith("-packages") and place.is_dir():
            for info in place.glob("*.dist-info"):
                name, _, version = info.stem.rpartition("-")
                found.setdefault(_plain(name), (version, info))
    return found


def versions(modules: Iterable[str]) -> dict[str, str]:
    """Distribution -> version of all that modules of these names come from, with what those
    require."""
    found: dict[str, str] = {}
    waiting = [_distribution(module) for module in modules]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found[name] = installed()[name][0] if name in installed() else "none"
            waiting += [other for other in _required(name) if other in installed()]
    return found


@cache
def _distribution(module: str) -> str:
    """Mostly of the same name; Pillow's module is PIL."""
    if (name := _plain(module)) in installed():
        return name
    brings = (f"{module}/", f"{module}.")
    for name, (_, info) in installed().items():
        if any(line.startswith(brings) for line in _lines(info / "RECORD")):
            return name
    return name


@cache
def _required(name: str) -> list[str]:
    """What a distribution cannot do without."""
    if name not in installed():
        return []
    head = "\n".join(_lines(installed()[name][1] / "METADATA"))
    return [_plain(required) for required in REQUIRED.findall(head)]


def npm_versions(root: Path, names: Iterable[str]) -> dict[str, str]:
    """npm package -> version, "none" where it is not installed below the folder."""
    found = {}
    for name in names:
        try:
            about = (root / "node_modules" / name / "package.json").read_text(encoding="utf-8")
            found[f"npm {name}"] = str(json.loads(about)["version"])
        except (OSError, ValueError, KeyError):
            found[f"npm {name}"] = "none"
    return found


def _plain(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def _lines(file: Path) -> list[str]:
    try:
        return file.read_text(encoding="utf-8").splitlines()
    except OSError:
        return []
