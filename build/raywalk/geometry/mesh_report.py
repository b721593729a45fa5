"""What `check` and a build say of a scene's meshes: the same sentences."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from raywalk.models.clean import Cleaned
from raywalk.models.faults import shown
from raywalk.models.kept import read_cleaned
from raywalk.models.model import Model
from raywalk.models.pieces import material_named
from raywalk.models.report import report
from raywalk.models.telling import in_short, listed, warnings
from raywalk.scene.mesh_parts import texture_fault
from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Mesh


def mesh_lines(scene: Scene) -> list[str]:
    """A line a mesh: what is in its file, what was done to it, what it is shown in."""
    lines = []
    for name, objects, cleaned in _meshes(scene):
        line = f'"{name}": {in_short(report(cleaned))}'
        shown_in = list(_shown_in(scene, objects, cleaned))
        lines.append(f"{line}; shown {', '.join(shown_in)}" if shown_in else line)
    return lines


def _shown_in(scene: Scene, objects: list[SceneObject], cleaned: Cleaned) -> Iterator[str]:
    """Materials by the names of parts, and that the file's colours are shown."""
    dressed = {
        _mesh(obj).piece.label or "the rest": scene.materials[obj.material].name  # type: ignore[union-attr]
        for obj in objects
        if _mesh(obj).piece
    }
    coloured = any(obj.base and obj.base.colours for obj in objects)
    if dressed and not (coloured and len(objects) == 1):
        own = all(part == material for part, material in dressed.items())
        parts = dressed if own else (f"{part} in {what}" for part, what in dressed.items())
        yield f"{'in its own materials ' if own else ''}{listed(parts)}"
    if coloured:
        yield f"in the colours of its {cleaned.model.colours_of}"


def mesh_warnings(scene: Scene) -> list[str]:
    """What of each mesh's file is not used, and what its author should know."""
    return [
        f'"{name}": {sentence}'
        for name, objects, cleaned in _meshes(scene)
        for sentence in (*warnings(report(cleaned)), *_not_used(objects, cleaned))
    ]


def _meshes(scene: Scene) -> Iterator[tuple[str, list[SceneObject], Cleaned]]:
    """Name, objects and triangles of each mesh of the file."""
    found: dict[str, list[SceneObject]] = {}
    for obj in scene.objects:
        if isinstance(obj.shape, Mesh):
            of = obj.shape.piece.of if obj.shape.piece else obj.name
            found.setdefault(of, []).append(obj)
    for name, objects in found.items():
        mesh = _mesh(objects[0])
        yield name, objects, read_cleaned(mesh.path, mesh.weld)


def _mesh(obj: SceneObject) -> Mesh:
    assert isinstance(obj.shape, Mesh)
    return obj.shape


def _not_used(objects: list[SceneObject], cleaned: Cleaned) -> Iterator[str]:
    model, piece = cleaned.model, _mesh(objects[0]).piece
    file, names = shown(model.path.name), [shown(each.name) for each in model.materials]
    if names and piece is None:
        yield (
            f"the materials of {file}, {listed(names)}, are not used, as the scene gives one: "
            "leave `material` out to see them, or dress them by name in `materials`"
        )
    if model.colours and not (piece and piece.by_material):
        yield (
            f"the colours of its {model.colours_of} are not used, as the scene gives a material: "
            "leave it out to see them"
        )
    if model.texture_places is None and any(obj.base and obj.base.texture for obj in objects):
        yield f"{file} tells no coordinates for a texture: it is shown without the scene's"
    if piece and piece.by_material:
        labels = [mesh.piece.label for obj in objects if (mesh := _mesh(obj)).piece]
        yield from _looks_not_used(model, report(cleaned), labels)


def _looks_not_used(model: Model, facts: dict[str, Any], labels: list[str]) -> Iterator[str]:
    for each in facts["materials"]:
        if each["name"] not in labels:
            continue
        material = material_named(model, each["name"])
        if material and (fault := texture_fault(model, material)):
            yield f"the texture {fault}: {shown(each['name'])} is shown without it"
        if each["opacity"] < 1.0:
            yield (
                f"{shown(each['name'])} is transparent in the file, and opaque here: give it a "
                "glass in `materials`"
            )
