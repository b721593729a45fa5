"""Mesh files: the named ones of models/models.toml, and a scene's own."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from pydantic import Field, TypeAdapter, ValidationError

from raywalk.home import HOME
from raywalk.models.faults import shown
from raywalk.models.read import READABLE
from raywalk.scene.fields import Allowed, Text
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema_objects import Crease, MeshTable
from raywalk.scene.shapes import CREASE
from raywalk.scene.table import Table
from raywalk.scene.toml import read_toml
from raywalk.scene.wording import did_you_mean, joined, quoted

CATALOGUE = "models/models.toml"
OURS = HOME / "models" / "models.toml"

Count = Annotated[int, Field(strict=True, ge=1), Allowed("a whole number of at least 1")]


class ModelTable(Table):
    """A mesh file that scenes may name, and where it comes from."""

    file: Text = Field(description="relative to models.toml")
    title: Text = Field(description="what it shows")
    source: Text = Field(description="package and version, or address, it was taken from")
    licence: Text = Field(description="under which it may be passed on")
    credit: Text = Field(description="who is to be named")
    unit: Text = Field(description="what one unit of its coordinates is")
    triangles: Count = Field(description="in the file")
    vertices: Count = Field(description="in the file")
    crease: Crease = Field(CREASE, description="what a mesh's `crease` is that has none")


_CATALOGUE = TypeAdapter(Annotated[dict[str, ModelTable], Allowed("a table of models")])


@dataclass(frozen=True)
class Models:
    """The catalogue: names in models.toml with their files."""

    catalogue: Path | None  # None: no models/models.toml beside or above the scene
    tables: dict[str, ModelTable]
    is_broken: bool = False  # then its names are unknown, and that is reported already

    def path(self, name: str) -> Path:
        assert self.catalogue is not None
        return self.catalogue.parent / self.tables[name].file

    def crease(self, name: str | None) -> float:
        """Of a model, or of a file of the scene's own (None)."""
        return CREASE if name is None else self.tables[name].crease


def find_catalogue(scene_file: Path) -> Path | None:
    """The nearest models/models.toml in the scene's folder or one above it, else Raywalk's own."""
    candidates = (folder / CATALOGUE for folder in scene_file.absolute().parents)
    return next((path for path in (*candidates, OURS) if path.is_file()), None)


def read_catalogue(catalogue: Path | None) -> tuple[Models, Problems]:
    """The catalogue, and what is wrong with it."""
    problems = Problems(catalogue or Path(CATALOGUE))
    if catalogue is None:
        return Models(None, {}), problems
    raw = read_toml(catalogue, problems)
    if raw is None:
        return Models(catalogue, {}, is_broken=True), problems
    try:
        return Models(catalogue, _CATALOGUE.validate_python(raw)), problems
    except ValidationError as error:
        problems.add_refusals(error)
    return Models(catalogue, {}, is_broken=True), problems


def mesh_file(
    table: MeshTable, models: Models, at: Location, problems: Problems
) -> tuple[str, Path] | None:
    """The mesh's name and its file; None, with the problem noted, if there is none."""
    if (table.model is None) == (table.file is None):
        both = "both are given" if table.model else "neither is given"
        problems.add(at, f"a mesh has a `model` or a `file`; here {both}")
        return None
    if table.model is not None:
        return _named(table.model, models, (*at, "model"), problems)
    assert table.file is not None
    return _own_file(table.file, (*at, "file"), problems)


def _named(name: str, models: Models, at: Location, problems: Problems) -> tuple[str, Path] | None:
    if models.is_broken:
        return None
    if name not in models.tables:
        known = f"known: {joined(models.tables)}" if models.tables else f"no {CATALOGUE} lists any"
        problems.add(
            at,
            f"no model is named {quoted(name)}",
            allowed=known,
            hint=did_you_mean(name, models.tables),
        )
        return None
    path = models.path(name)
    if not _is_file(path):
        problems.add(at, f"the model's file {quoted(models.tables[name].file)} is missing")
        return None
    return name, path


def _own_file(file: str, at: Location, problems: Problems) -> tuple[str, Path] | None:
    path = problems.file.parent / file
    if path.suffix.lower() not in READABLE:
        problems.add(
            at, f"{quoted(file)} is not a mesh file", allowed=f"allowed: {joined(READABLE)}"
        )
        return None
    if _is_file(path):
        return file, path
    problems.add(
        at,
        f"there is no file {quoted(shown(file))}",
        hint=did_you_mean(path.name, _beside(path)),
        allowed="seen from the scene file",
    )
    return None


def _is_file(path: Path) -> bool:
    """Also of a name that no file can have, of 5,000 characters or with a zero in it."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False


def _beside(path: Path) -> list[str]:
    try:
        return sorted(p.name for p in path.parent.glob("*") if p.suffix.lower() in READABLE)
    except (OSError, ValueError):
        return []
