"""The material libraries of an OBJ file: which are there, what they define, and what faces use
that they lack."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from raywalk.models.faults import quoted
from raywalk.models.model import FileMaterial
from raywalk.models.mtl import read_mtl

MOST_NAMES = 6  # in a sentence


@dataclass(frozen=True)
class Libraries:
    """What they tell of the materials that faces use, the files, and a sentence for each lack."""

    materials: list[FileMaterial]  # what no library tells is a name alone
    found: list[Path]
    lacks: list[str]


def names_of(folder: Path, whole: str, several: list[str]) -> list[str]:
    """Of a line: one file whose name may have spaces, or several."""
    is_one = _is_file(folder / whole) or not any(_is_file(folder / name) for name in several)
    return [whole] if is_one else several


def read_libraries(folder: Path, names: Iterable[str], used: Mapping[str, int]) -> Libraries:
    """used: the materials in use, each with the line that first names it, in order."""
    known: dict[str, FileMaterial] = {}
    found: list[Path] = []
    lacks: list[str] = []
    for name in dict.fromkeys(names):
        path = folder / name.replace("\\", "/")
        if not _is_file(path):
            lacks.append(_not_there(path, name))
            continue
        found.append(path)
        known |= read_mtl(path, folder)
    if found:
        lacks += _undefined(used, known, found)
    return Libraries([known.get(name, FileMaterial(name)) for name in used], found, lacks)


def _undefined(
    used: Mapping[str, int], known: dict[str, FileMaterial], found: list[Path]
) -> Iterator[str]:
    """Of materials that faces use and the libraries lack, as many as a person reads."""
    names = [name for name in used if name not in known]
    where = " and ".join(quoted(path.name) for path in found)
    holds = ", ".join(quoted(name) for name in list(known)[:MOST_NAMES]) or "none"
    holds += f" and {len(known) - MOST_NAMES} more" if len(known) > MOST_NAMES else ""
    for name in names[:MOST_NAMES]:
        yield (
            f"line {used[name]}: usemtl names {quoted(name)}, which {where} "
            f"does not define (it has {holds}): its faces have no colour of the file; correct "
            "the name, or export both files again"
        )
    if len(names) > MOST_NAMES:
        yield f"and {len(names) - MOST_NAMES} more materials that {where} does not define"


def _not_there(path: Path, library: str) -> str:
    """Also that only small and capital letters differ, which elsewhere are one."""
    said = f"the material file {quoted(library)} is not there"
    try:
        beside = [each.name for each in path.parent.iterdir()]
    except (OSError, ValueError):
        return said
    alike = [name for name in beside if name.casefold() == path.name.casefold()]
    return f"{said}, but {quoted(alike[0])} is: write it as the file is called" if alike else said


def _is_file(path: Path) -> bool:
    """Whether there is one; a name that no file can have has none."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False
