"""A mesh of several parts and materials as objects of a scene, each in what it is dressed in."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path, PureWindowsPath
from typing import NamedTuple

from raywalk.models.beside import beside
from raywalk.models.faults import ModelFault, shown
from raywalk.models.kept import read_cleaned
from raywalk.models.model import FileMaterial, Model
from raywalk.models.piece import Piece
from raywalk.models.pieces import labels, material_named, names_in
from raywalk.scene.materials import Dressed
from raywalk.scene.model import Base, Material, Texture
from raywalk.scene.pictures import PictureFault, read_texture
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema_objects import MeshTable
from raywalk.scene.shapes import Mesh, Triple
from raywalk.scene.wording import did_you_mean, joined, quoted

# A material that a file names without telling its colour is grey, as most programs show it.
UNKNOWN: Triple = (0.8, 0.8, 0.8)
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


def mesh_of(table: MeshTable, model: str, path: Path, crease: float) -> Mesh:
    """The whole file. crease: what holds where the table has none."""
    given = crease if table.crease is None else table.crease
    whole = Mesh(model, path, table.smooth, table.subdivide, given, table.weld)
    return replace(whole, beside=beside(path))


def dressed_parts(
    table: MeshTable, mesh: Mesh, name: str, given: Mapping[str, Dressed | None],
    rest: Dressed | None, at: Location, problems: Problems,
) -> Iterator[Part]:  # fmt: skip
    """The objects that a mesh becomes, in the order of its file.

    given: materials of parts by their names, None for one that is broken; rest: what the others
    are in, None for the file's own. Notes names that the file does not have.
    """
    key = "file" if table.file else "model"
    try:
        cleaned = read_cleaned(mesh.path, mesh.weld)
    except ModelFault as fault:
        problems.add((*at, key), fault.message, hint=fault.remedy)
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
        dressed = given[label] if label in given else rest or own_material(model, label)
        if dressed is None:
            continue  # reported where it was read
        is_own = label not in given and rest is None
        base = Base(is_own and model.colours is not None, dressed.texture)
        some = base if base.colours or base.texture else None
        yield Part(called, replace(mesh, piece=piece), dressed.material, some)


def own_material(model: Model, label: str) -> Dressed:
    """A file's material of that name as one of ours, and its texture if that can be read."""
    in_file = material_named(model, label) or FileMaterial(label or quoted(model.path.name))
    texture = own_texture(model, in_file)
    shown = texture if not texture_fault(model, in_file) else None
    r, g, b = diffuse = _diffuse(model, in_file, shown is not None)
    material = Material(
        in_file.name,
        ambient=(AMBIENT * r, AMBIENT * g, AMBIENT * b),
        diffuse=diffuse,
        specular=in_file.specular or (0.0, 0.0, 0.0),
        shininess=max(1.0, in_file.shininess or 1.0),
    )
    return Dressed(material, shown)


def _diffuse(model: Model, in_file: FileMaterial, is_textured: bool) -> Triple:
    """What the file's colours and texture multiply. In glTF they multiply the material's colour,
    and a texture does in MTL, but for a black that would hide it; colours of vertices stand in its
    place elsewhere."""
    if model.colours and not model.format.startswith(("glTF", "GLB")):
        return UNCHANGED
    if is_textured and not any(in_file.diffuse or ()):
        return UNCHANGED
    return in_file.diffuse or (UNCHANGED if model.colours else UNKNOWN)


def own_texture(model: Model, in_file: FileMaterial) -> Texture | None:
    """The texture of a file's material, whether or not it is there. A name of another machine's
    folder is looked for beside the model."""
    if in_file.texture is None:
        return None
    path, beside = in_file.texture, model.path.parent / PureWindowsPath(in_file.texture).name
    found = path if _is_file(path) or not _is_file(beside) else beside
    return Texture(found, in_file.texture_filter, inside=in_file.texture_inside)


def texture_fault(model: Model, in_file: FileMaterial) -> str:
    """Why the texture of a file's material is not shown, as in "wood.png is not there"; ""."""
    texture = own_texture(model, in_file)
    if texture is None:
        return ""
    name = shown(texture.path.name)
    if texture.inside >= 0:
        name = f"picture {texture.inside} in {name}"
    try:
        if not texture.path.resolve().is_relative_to(model.path.parent.resolve()):
            return f"{name} lies outside of the model's folder"
        read_texture(texture)
    except PictureFault as fault:
        return f"{name} {fault.cause}"
    except (OSError, ValueError):  # a name that no file can have
        return f"{name} is not there"
    if model.texture_places is None:
        return f"{name} has no places, as the file tells no coordinates for it"
    return ""


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False
