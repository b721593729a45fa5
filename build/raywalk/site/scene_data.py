"""What the viewer knows of a scene: scene.js, as SceneData in viewer/trace/types.ts."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from raywalk.lesson_text import lesson_html
from raywalk.scene.model import Camera, LessonStep, Light, Material, Scene, SceneObject
from raywalk.scene.placement import checker_axes, placement
from raywalk.scene.shapes import Mesh, Plane
from raywalk.site.mesh_data import DisplayMesh, mesh_data

Json = dict[str, Any]


@dataclass(frozen=True, eq=False)
class Display:
    """What only geometry knows of a scene, handed on for drawing it."""

    centre: np.ndarray  # (3,) of a sphere round everything finite
    radius: float
    meshes: dict[str, DisplayMesh]  # by object name


def scene_data(scene: Scene, display: Display) -> Json:
    """SceneData as plain JSON values."""
    return {
        "format": 1,
        "id": scene.id,
        "key": scene.key,
        "title": scene.title,
        "teaches": scene.teaches,
        "picture": "picture.png",
        "size": scene.render.size,
        "camera": _camera(scene.camera),
        "background": list(scene.background),
        "shadows": scene.render.shadows,
        "depth": scene.render.depth,
        "levels": sorted(scene.render.resolutions),
        "start": _start(scene),
        "bounds": {"center": display.centre.tolist(), "radius": display.radius},
        "materials": [_material(m) for m in scene.materials],
        "objects": [_object(obj, display) for obj in scene.objects],
        "meshes": {name: mesh_data(mesh) for name, mesh in display.meshes.items()},
        "lights": [_light(light) for light in scene.lights],
        "lesson": [_step(step) for step in scene.lesson],
    }


def scene_words(scene: Scene) -> Json:
    """What of SceneData is words, SceneWords in viewer/trace/types.ts: for a scene in a language
    other than its own."""
    return {
        "title": scene.title,
        "teaches": scene.teaches,
        "objects": [obj.name for obj in scene.objects],
        "lights": [light.name for light in scene.lights],
        "materials": [material.name for material in scene.materials],
        "lesson": [[lesson_html(text) for text, _ in step.stops()] for step in scene.lesson],
    }


def _step(step: LessonStep) -> Json:
    said, *revealed = [{"html": lesson_html(text), "view": view} for text, view in step.stops()]
    return said | {"answer": revealed[0]} if revealed else said


def _start(scene: Scene) -> Json:
    """The first lesson step's ray, so that a visitor meets the scene where its story begins."""
    view = scene.lesson[0].view if scene.lesson else {}
    levels = sorted(scene.render.resolutions)
    n = view.get("resolution") or min(levels, key=lambda level: (abs(level - 15), level))
    pixel = view.get("pixel") if "resolution" in view else None
    return {"resolution": n, "pixel": list(pixel or (n // 2, n // 2))}


def _camera(camera: Camera) -> Json:
    return {
        "eye": list(camera.eye),
        "target": list(camera.target),
        "up": list(camera.up),
        "fov": camera.fov,
    }


def _material(material: Material) -> Json:
    return asdict(material)


def _light(light: Light) -> Json:
    return {
        "name": light.name,
        "position": list(light.position),
        "colour": list(light.colour),
        "intensity": light.intensity,
    }


def _object(obj: SceneObject, display: Display) -> Json:
    linear, centre = placement(obj)
    if isinstance(obj.shape, Mesh):
        linear, centre = np.eye(3), display.meshes[obj.name].centre
    data: Json = {
        "name": obj.name,
        **obj.shape.drawn(),
        "label": obj.shape.word,
        "material": obj.material,
        "transform": _column_major(linear, centre),
    }
    if isinstance(obj.shape, Mesh):
        data["mesh"] = obj.name
    if obj.checker and isinstance(obj.shape, Plane):
        u, v = checker_axes(np.array(obj.shape.normal, float))
        outer = obj.transform[:3, :3]
        data["checker"] = {
            "size": obj.checker.size,
            "material": obj.checker.material,
            "axes": [(outer @ u).tolist(), (outer @ v).tolist()],
            "origin": centre.tolist(),
        }
    return data


def _column_major(linear: np.ndarray, centre: np.ndarray) -> list[float]:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = linear, centre
    return [float(value) for value in matrix.T.reshape(-1)]
