"""What at a stop of a sweep the page's stage cannot move: it is drawn anew there."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from raywalk.scene.lights import lamp_of
from raywalk.scene.model import Scene
from raywalk.scene.shapes import Plane


def drawn_anew(scene: Scene) -> Any:
    """What the page's stage draws from the scene as it begins, and anew where it is other at a
    stop: all but where things and lamps are, and how bright these."""
    materials = [replace(each, ior=1.0) for each in scene.materials]
    lights = {lamp_of(each.name): (each.colour, each.attenuation) for each in scene.lights}
    objects = [
        (each.shape.drawn(), each.material, each.checker)
        + ((each.shape, each.transform.tolist()) if isinstance(each.shape, Plane) else ())
        for each in scene.objects
    ]
    return materials, lights, objects
