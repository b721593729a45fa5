"""What of a scene's data is other at a stop of a sweep: what moves on the stage."""

from __future__ import annotations

import json
from dataclasses import asdict
from typing import Any

import numpy as np

from raywalk.scene.model import Scene, SceneObject
from raywalk.scene.shapes import Mesh
from raywalk.site.scene_data import Display, column_major, light_data, object_data
from raywalk.site.scene_types import StopData


def stop_data(stop: Scene, scene: Scene, display: Display, picture: str) -> StopData:
    """display: of the scene itself. Meshes are drawn as they are there, moved. picture: the name of
    the file."""
    data: dict[str, Any] = {"picture": picture}
    for key, there, here in (
        ("camera", stop.camera, scene.camera),
        ("background", list(stop.background), list(scene.background)),
        ("shadows", stop.render.shadows, scene.render.shadows),
        ("depth", stop.render.depth, scene.render.depth),
    ):
        if _json(there) != _json(here):
            data[key] = there
    moved = zip(stop.objects, scene.objects, strict=True)
    lists: dict[str, tuple[list[Any], list[Any]]] = {
        "objects": (
            [_moved(there, here, display) for there, here in moved],
            [object_data(each, display) for each in scene.objects],
        ),
        "lights": _lights(stop, scene),
        "materials": ([*map(asdict, stop.materials)], [*map(asdict, scene.materials)]),
    }
    for key, (those, these) in lists.items():
        others = [_other(there, here) for there, here in zip(those, these, strict=True)]
        if any(others):
            data[key] = others
    return StopData(**data)  # type: ignore[typeddict-item]


def _lights(stop: Scene, scene: Scene) -> tuple[list[Any], list[Any]]:
    """Those of the stop, and what they are told beside: nothing where a lamp has another number of
    points, which stand in place of the scene's then."""
    there, here = [*map(light_data, stop.lights)], [*map(light_data, scene.lights)]
    return there, here if len(here) == len(there) else [{} for _ in there]


def _moved(obj: SceneObject, own: SceneObject, display: Display) -> Any:
    """An object's data at a stop; own: it in the scene itself."""
    data = object_data(obj, display)
    if isinstance(own.shape, Mesh) and not np.array_equal(obj.transform, own.transform):
        moved = obj.transform @ np.linalg.inv(own.transform)
        centre = display.meshes[own.name].centre
        data["transform"] = column_major(moved[:3, :3], moved[:3, :3] @ centre + moved[:3, 3])
    return data


def _other(those: Any, these: Any) -> dict[str, Any]:
    """What is other; names are not: they are the scene's, in each language."""
    return {
        key: value
        for key, value in those.items()
        if not (key == "name" and these) and _json(value) != _json(these.get(key))
    }


def _json(value: Any) -> str:
    return json.dumps(value, default=asdict)
