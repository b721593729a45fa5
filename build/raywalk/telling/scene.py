"""What the events need to know of a scene besides its trace."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from raywalk.scene.model import Scene
from raywalk.trace_file.container import unpack

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class ToldMaterial:
    """Of a material: what its own colour is made of, and whether it sends rays on."""

    ambient: Vector
    diffuse: Vector
    specular: Vector
    reflect: float
    transmit: float
    ior: float


@dataclass(frozen=True)
class ToldLight:
    """Of a light: its name, place (world units) and colour."""

    name: str
    position: Vector
    colour: Vector


@dataclass(frozen=True)
class ToldScene:
    """Names and numbers of a scene, objects and materials in the trace's order."""

    eye: Vector
    background: Vector
    depth: int
    radius: float  # of a sphere round everything finite, world units
    objects: tuple[tuple[str, int], ...]  # name, material
    materials: tuple[ToldMaterial, ...]
    lights: tuple[ToldLight, ...]


def scene_beside(trace: Path) -> ToldScene:
    """Of the scene.js that lies beside a trace file of the built site.

    Raises OSError, TraceFileError if it cannot be read.
    """
    return from_page_data(json.loads(unpack(trace.with_name("scene.js").read_bytes())))


def from_page_data(data: Mapping[str, Any]) -> ToldScene:
    """From SceneData as the viewer has it (viewer/trace/types.ts)."""
    return ToldScene(
        eye=_vector(data["camera"]["eye"]),
        background=_vector(data["background"]),
        depth=data["depth"],
        radius=data["bounds"]["radius"],
        objects=tuple((each["name"], each["material"]) for each in data["objects"]),
        materials=tuple(
            ToldMaterial(
                _vector(each["ambient"]), _vector(each["diffuse"]), _vector(each["specular"]),
                each["reflect"], each["transmit"], each["ior"],
            )
            for each in data["materials"]
        ),
        lights=tuple(
            ToldLight(each["name"], _vector(each["position"]), _vector(each["colour"]))
            for each in data["lights"]
        ),
    )  # fmt: skip


def told_scene(scene: Scene, radius: float) -> ToldScene:
    """From a scene as read, and the radius that the trace stage found (display.npz)."""
    return ToldScene(
        eye=_vector(scene.camera.eye),
        background=_vector(scene.background),
        depth=scene.render.depth,
        radius=radius,
        objects=tuple((each.name, each.material) for each in scene.objects),
        materials=tuple(
            ToldMaterial(
                _vector(each.ambient), _vector(each.diffuse), _vector(each.specular),
                each.reflect, each.transmit, each.ior,
            )
            for each in scene.materials
        ),
        lights=tuple(
            ToldLight(each.name, _vector(each.position), _vector(each.colour))
            for each in scene.lights
        ),
    )  # fmt: skip


def _vector(values: Any) -> Vector:
    x, y, z = (float(value) for value in values)
    return (x, y, z)
