"""What a program needs to be told of a scene."""

from __future__ import annotations

from dataclasses import asdict, fields
from typing import Any

from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.placement import is_unmoved
from raywalk.scene.shapes import Mesh


def given(scene: Scene) -> dict[str, Any]:
    """Camera, render settings, background, lights, materials and objects, as plain values; in the
    names of scene files, with nothing left to inherit."""
    return {
        "camera": asdict(scene.camera),
        "background": list(scene.background),
        "shadows": scene.render.shadows,
        "depth": scene.render.depth,
        "glass_shadows": scene.render.glass_shadows,
        "lights": [asdict(light) for light in scene.lights],
        "materials": [asdict(material) for material in scene.materials],
        "objects": [object_given(scene, obj) for obj in scene.objects],
    }


def object_given(scene: Scene, obj: SceneObject) -> dict[str, Any]:
    """Its shape's own numbers; a matrix (3 rows of 4) only if it is moved, a checker if it has one.
    Of a mesh the file's name."""
    shape = obj.shape
    if isinstance(shape, Mesh):
        own: dict[str, Any] = {"model": shape.path.name}
    else:
        own = {field.name: getattr(shape, field.name) for field in fields(shape)}  # type: ignore[arg-type]
    found = {
        "name": obj.name,
        "type": shape.word,
        **own,
        "material": scene.materials[obj.material].name,
    }
    if not is_unmoved(obj):
        found["matrix"] = obj.transform[:3].tolist()
    if obj.checker:
        odd = scene.materials[obj.checker.material].name
        found["checker"] = {"size": obj.checker.size, "odd": odd}
    return found
