"""What `check` and a build say of a scene's meshes: the same sentences."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from raywalk.models.clean import Cleaned
from raywalk.models.faults import shown
from raywalk.models.kept import read_cleaned
from raywalk.models.palette import palette_of
from raywalk.models.pieces import chosen
from raywalk.models.report import report
from raywalk.models.telling import in_short, listed, warnings
from raywalk.scene.model import Scene
from raywalk.scene.shapes import Mesh


def mesh_lines(scene: Scene) -> list[str]:
    """A line a mesh: what is in its file, what was done to it, what it is shown in."""
    lines = []
    for name, objects, cleaned in _meshes(scene):
        line = f'"{name}": {in_short(report(cleaned))}'
        if any(mesh.painted for _, mesh in objects):
            count = sum(len(mesh.painted) for _, mesh in objects)
            line += f"; shown in {count} colours of its {cleaned.model.colours_of}"
            lines.append(line)
            continue
        dressed = {
            mesh.piece.label or "the rest": scene.materials[k].name
            for k, mesh in objects
            if mesh.piece
        }
        if dressed:
            own = all(part == material for part, material in dressed.items())
            parts = dressed if own else (f"{part} in {what}" for part, what in dressed.items())
            line += f"; shown {'in its own materials ' if own else ''}{listed(parts)}"
        lines.append(line)
    return lines


def mesh_warnings(scene: Scene) -> list[str]:
    """What of each mesh's file is not used, and what its author should know."""
    return [
        f'"{name}": {sentence}'
        for name, objects, cleaned in _meshes(scene)
        for sentence in (*warnings(report(cleaned)), *_not_used(objects, cleaned))
    ]


def _meshes(scene: Scene) -> Iterator[tuple[str, list[tuple[int, Mesh]], Cleaned]]:
    """Name, objects with the index of their material, and triangles of each mesh of the file."""
    found: dict[str, list[tuple[int, Mesh]]] = {}
    for obj in scene.objects:
        if isinstance(obj.shape, Mesh):
            of = obj.shape.piece.of if obj.shape.piece else obj.name
            found.setdefault(of, []).append((obj.material, obj.shape))
    for name, objects in found.items():
        mesh = objects[0][1]
        yield name, objects, read_cleaned(mesh.path, mesh.weld)


def _not_used(objects: list[tuple[int, Mesh]], cleaned: Cleaned) -> Iterator[str]:
    model, piece = cleaned.model, objects[0][1].piece
    file, names = shown(model.path.name), [shown(each.name) for each in model.materials]
    if names and piece is None:
        yield (
            f"the materials of {file}, {listed(names)}, are not used, as the scene gives one: "
            "leave `material` out to see them, or dress them by name in `materials`"
        )
    shown_colours = any(mesh.painted for _, mesh in objects) or (piece and piece.by_material)
    if model.colours and not shown_colours:
        yield (
            f"the colours of its {model.colours_of} are not used, as the scene gives a material: "
            "leave it out to see them"
        )
    counts = [len(mesh.painted) for _, mesh in objects if mesh.painted and mesh.piece]
    if any(palette_of(cleaned, chosen(cleaned, mesh.piece)).bits < 8
           for _, mesh in objects if mesh.painted and mesh.piece):  # fmt: skip
        yield f"its colours are rounded: {sum(counts)} are told apart"
    if piece and piece.by_material:
        yield from _looks_not_used(report(cleaned), [mesh.piece.label for _, mesh in objects
                                                    if mesh.piece])  # fmt: skip


def _looks_not_used(told: dict[str, Any], labels: list[str]) -> Iterator[str]:
    for each in told["materials"]:
        if each["name"] not in labels:
            continue
        if each["texture"]:
            yield f"the texture {shown(each['texture'])} of {shown(each['name'])} is not used"
        if each["opacity"] < 1.0:
            yield (
                f"{shown(each['name'])} is transparent in the file, and opaque here: give it a "
                "glass in `materials`"
            )
