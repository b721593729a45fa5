"""What a module's work is made from, found in the sources: the modules it imports, at their tops
and inside functions, with what those import; files and scripts they name; packages of others.

A file counts as named where its place is worked out from the module's own, `Path(__file__)`, or
from HOME (`home.py`), with constant parts behind it. A script brings what it imports itself
(`scripts.py`).
"""

from __future__ import annotations

import ast
import hashlib
import json
import os
import sys
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from os.path import normpath
from pathlib import Path
from typing import Any

from raywalk.home import home_of
from raywalk.work.digests import digest
from raywalk.work.scripts import SCRIPTS, npm_package, script_closure

PACKAGE = Path(__file__).resolve().parent.parent
HOME = "HOME"  # as modules write it
Found = dict[str, list[str]]  # "imports", "places" of one module
# Modules with their hashes, places that they name, packages that they import.
Reached = tuple[dict[Path, str], set[Path], set[str]]


@dataclass(frozen=True)
class Closure:
    """All that decides on the bytes a module's functions write, besides what they are given."""

    modules: dict[Path, str]  # ours, with what the package holds for them, by their hashes
    scripts: frozenset[Path]  # ours, run by node
    read: frozenset[Path]  # files that modules read elsewhere
    packages: frozenset[str]  # names of modules that others wrote
    npm: frozenset[str]  # packages that scripts import, or whose files are read


class Sources:
    """The package's modules as they stand when they are first asked for: what runs is what was
    imported, however it is edited meanwhile."""

    def __init__(self, package: Path = PACKAGE):
        self.package = package
        self.root = home_of(package)
        self._modules: dict[Path, tuple[str, Found]] = {}
        self._reached: dict[tuple[str, str], Reached] = {}
        self._names: dict[Path, str] = {}
        # Parsing all takes half a second, so what was found is kept with the text's hash.
        self._cache = package / "__pycache__" / "imports.json"
        self._kept: dict[str, tuple[str, Found]] = _read_cache(self._cache)
        self._is_kept = True

    def closure(self, module: str, shut: str = "") -> Closure:
        """module: dotted. shut: our modules whose names begin so are doors that stay shut; what
        is only behind them is not reached. Raises KeyError if there is no such module."""
        if (module, shut) not in self._reached:
            self._reached[module, shut] = self._reach(module, shut)
        modules, places, packages = self._reached[module, shut]
        whole = _with_files(places, packages)  # scripts may be edited between two builds
        # Tables beside a module are read when it is imported: they are as much code as it is.
        tables = {file: self._table(file) for file in whole.read if self._is_beside_code(file)}
        return replace(whole, modules=modules | tables, read=whole.read - tables.keys())

    def _reach(self, module: str, shut: str) -> Reached:
        if module not in self._there:
            raise KeyError(f"there is no module {module}")
        modules: dict[Path, str] = {}
        places: set[Path] = set()
        packages: set[str] = set()
        waiting, seen = [module], {module}
        while waiting:
            name = waiting.pop()
            if name.split(".")[0] != self.package.name:
                packages.add(name.split(".")[0])
            for file in self._files(name):
                if file not in modules and not (shut and file.stem.startswith(shut)):
                    modules[file], found = self._module(file)
                    waiting += [each for each in found["imports"] if each not in seen]
                    seen.update(found["imports"])
                    places |= {self._at(file, place) for place in found["places"]}
        if not self._is_kept:
            _write_cache(self._cache, self._kept)
            self._is_kept = True
        return modules, places, packages

    def name(self, path: Path) -> str:
        """A file by its path below the package, or else below its home: the same in a wheel."""
        if path not in self._names:
            below = path.relative_to(self.package if self._is_beside_code(path) else self.root)
            self._names[path] = below.as_posix()
        return self._names[path]

    def _is_beside_code(self, path: Path) -> bool:
        """Whether it lies in the package, but not in a home that a wheel's package carries."""
        around = (folder for folder in path.parents if folder in (self.package, self.root))
        return next(around, None) == self.package

    def _at(self, file: Path, place: str) -> Path:
        """A place that a module names."""
        home, _, below = place.partition("/")
        return self.root / below if home == HOME else Path(normpath(file.parent / place))

    def place(self, name: str) -> Path:
        """The file of such a name; what is in a package is in no home, and the other way round."""
        inside = self.package / name
        return inside if inside.exists() else self.root / name

    def _files(self, name: str) -> set[Path]:
        """The module of a dotted name, which may go on with a name in it, and packages around."""
        parts = name.split(".")
        around = (".".join(parts[: k + 1]) for k in range(len(parts)))
        return {self._there[each] for each in around if each in self._there}

    @cached_property
    def _there(self) -> dict[str, Path]:
        """Every module by its dotted name."""
        found = {}
        for file in self.package.rglob("*.py"):
            *folders, last = file.relative_to(self.package.parent).with_suffix("").parts
            found[".".join(folders if last == "__init__" else [*folders, last])] = file
        return found

    def _table(self, file: Path) -> str:
        if file not in self._modules:
            self._modules[file] = digest(file), {}
        return self._modules[file][0]

    def _module(self, file: Path) -> tuple[str, Found]:
        if file not in self._modules:
            text = file.read_bytes()
            name, hash = self.name(file), hashlib.sha256(text).hexdigest()
            if name not in self._kept or self._kept[name][0] != hash:
                self._kept[name], self._is_kept = (hash, found_in(text)), False
            self._modules[file] = self._kept[name]
        return self._modules[file]


def _with_files(places: set[Path], packages: set[str]) -> Closure:
    npm = {npm_package(place) for place in places}
    own = {place for place in places if not npm_package(place)}
    scripts: set[Path] = set()
    for place in (place for place in own if place.suffix in SCRIPTS):
        files, names = script_closure(place)
        scripts, npm = scripts | files, npm | names
    read = {file for place in own - scripts for file in _files_at(place)}
    others = packages - sys.stdlib_module_names
    return Closure(
        {}, frozenset(scripts), frozenset(read), frozenset(others), frozenset(npm - {""})
    )


def _files_at(place: Path) -> Iterator[Path]:
    return filter(Path.is_file, place.rglob("*")) if place.is_dir() else iter([place])


def found_in(text: bytes) -> Found:
    """A module's imports as dotted names, of modules or of names in them, and the places that it
    names, relative to its folder."""
    imports, places = set(), set()
    for node in _run(ast.parse(text)):
        if isinstance(node, ast.Import):
            imports |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            if node.level or not node.module:
                raise ValueError("imports are absolute here")
            imports |= {f"{node.module}.{alias.name}" for alias in node.names}
        elif (place := _place(node)) and not place.endswith(("_", "..", HOME)):
            places.add(normpath(place))
    if f"raywalk.home.{HOME}" not in imports:  # another thing of that name
        places = {place for place in places if not place.startswith(f"{HOME}/")}
    return {"imports": sorted(imports), "places": sorted(places)}


def _run(tree: ast.AST) -> Iterator[ast.AST]:
    """Every node but what only a type checker looks at, and parts of a place."""
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        yield node
        is_types = isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
        if not is_types and _place(node) is None:
            waiting += ast.iter_child_nodes(node)


def _place(node: Any) -> str | None:
    """What an expression that begins with Path(__file__) comes to, relative to the file's folder,
    in which the file is `_`; one that begins with HOME as it is written; None for others."""
    match node:
        case ast.Name(id="HOME"):
            return HOME
        case ast.Call(func=ast.Name(id="Path"), args=[ast.Name(id="__file__")]):
            return "_"
        case ast.Call(func=ast.Attribute(value=of, attr="resolve" | "absolute"), args=[]):
            inner, then = _place(of), ""
        case ast.Attribute(value=of, attr="parent"):
            inner, then = _place(of), "/.."
        case ast.Subscript(
            value=ast.Attribute(value=of, attr="parents"), slice=ast.Constant(value=int(count))
        ):
            inner, then = _place(of), "/.." * (count + 1)
        case ast.BinOp(left=of, op=ast.Div(), right=ast.Constant(value=str(part))):
            inner, then = _place(of), f"/{part}"
        case ast.Call(
            func=ast.Attribute(value=of, attr="with_name"), args=[ast.Constant(value=str(part))]
        ):
            inner, then = _place(of), f"/../{part}"
        case _:
            return None
    return None if inner is None else inner + then


def _read_cache(file: Path) -> dict[str, tuple[str, Found]]:
    """By the module's name, if it was found by these very rules."""
    try:
        cache = json.loads(file.read_text(encoding="utf-8"))
        return dict(cache["found"]) if cache["by"] == _rules() else {}
    except (OSError, ValueError, KeyError, TypeError):
        return {}


def _write_cache(file: Path, found: dict[str, tuple[str, Found]]) -> None:
    beside = file.with_suffix(f".{os.getpid()}")
    try:
        file.parent.mkdir(exist_ok=True)
        beside.write_text(json.dumps({"by": _rules(), "found": found}), encoding="utf-8")
        beside.replace(file)
    except OSError:
        return  # where the package cannot be written to, it is parsed each time


def _rules() -> str:
    return hashlib.sha256(Path(__file__).read_bytes()).hexdigest()
