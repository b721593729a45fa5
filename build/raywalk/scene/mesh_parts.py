"""A mesh of several parts and materials as objects of a scene, each in what it is dressed in."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from raywalk.models.beside import beside
from raywalk.models.faults import ModelFault, shown
from raywalk.models.kept import read_cleaned
from raywalk.models.model import FileMaterial, Model
from raywalk.models.piece import Piece
from raywalk.models.pieces import labels, material_named, names_in
from raywalk.scene.model import Base, Material
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema_objects import MeshTable
from raywalk.scene.shapes import Mesh, Triple
from raywalk.scene.wording import did_you_mean, joined, quoted

# A material that a file names without telling its colour is grey, as most programs show it.
UNTOLD: Triple = (0.8, 0.8, 0.8)
# What leaves the colours of a file's vertices as they are.
UNCHANGED: Triple = (1.0, 1.0, 1.0)
# Of a file's colour the share that is there without any lamp, as the built-in materials have it.
AMBIENT = 0.1


class Part(NamedTuple):
    """One object."""

    name: str
    mesh: Mesh
    material: Material
    base: Base | None


def mesh_of(table: MeshTable, model: str, path: Path) -> Mesh:
    """The whole file."""
    return Mesh(model, path, table.smooth, table.subdivide, table.weld, beside=beside(path))


def dressed_parts(
    table: MeshTable, mesh: Mesh, name: str, given: Mapping[str, Material | None],
    rest: Material | None, at: Location, problems: Problems,
) -> Iterator[Part]:  # fmt: skip
    """The objects that a mesh becomes, in the order of its file.

    given: materials of parts by their names, None for one that is broken; rest: what the others
    are in, None for the file's own. Notes names that the file does not have.
    """
    key = "file" if table.file else "model"
    try:
        cleaned = read_cleaned(mesh.path, mesh.weld)
    except ModelFault as fault:
        problems.add((*at, key), fault.told, hint=fault.remedy)
        return
    model = cleaned.model
    known = names_in(model)
    for unknown in (part for part in given if part not in known):
        problems.add(
            (*at, "materials", unknown),
            f"{shown(mesh.path.name)} has no part or material of that name",
            allowed=f"known: {joined(map(shown, known))}" if known else "it names none",
            hint=did_you_mean(unknown, known),
        )
    if table.material is None and not model.materials and not model.colours and not given:
        problems.add(
            (*at, "material"), f"missing: {shown(mesh.path.name)} tells no material of its own",
            hint="material: a material's name, or a table with the keys of one",
        )  # fmt: skip
        return
    by_material = table.material is None
    found, _ = labels(cleaned, given, by_material)
    for label in found:
        whole = len(found) == 1
        called = name if whole else f"{name}, {label or 'rest'}"
        piece = Piece(name, label, tuple(given), by_material, label == found[0])
        material = given[label] if label in given else rest or own_material(model, label)
        if material is None:
            continue  # told where it was read
        base = None
        if label not in given and rest is None and model.colours:
            base = Base(colours=True)
            if not model.format.startswith(("glTF", "GLB")):  # glTF multiplies, others replace
                material = replace(material, ambient=(AMBIENT,) * 3, diffuse=UNCHANGED)
        yield Part(called, replace(mesh, piece=piece), material, base)


def own_material(model: Model, label: str) -> Material:
    """A file's material of that name as one of ours."""
    told = material_named(model, label) or FileMaterial(label or quoted(model.path.name))
    diffuse = told.diffuse or (UNCHANGED if model.colours else UNTOLD)
    r, g, b = diffuse
    return Material(
        told.name,
        ambient=(AMBIENT * r, AMBIENT * g, AMBIENT * b),
        diffuse=diffuse,
        specular=told.specular or (0.0, 0.0, 0.0),
        shininess=max(1.0, told.shininess or 1.0),
    )
