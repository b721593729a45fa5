"""Shapes by equations that fit a line of a worksheet, in world coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.scene.model import SceneObject
from raywalk.scene.placement import is_unmoved, placement
from raywalk.scene.shapes import Box, Cylinder, Disc, Ellipsoid, Plane, Sphere, Triangle

# Of the catalogue's group sheet.shape, by class; what a worksheet says is what its slots hold.
OWN = {
    Sphere: "sphere", Ellipsoid: "ellipsoid", Plane: "plane", Cylinder: "cylinder", Box: "box",
    Disc: "disc", Triangle: "triangle",
}  # fmt: skip
# Those that a transform has moved, by their canonical shape: all points c + x a + y b + z d.
MOVED = {"sphere": "movedSphere", "box": "movedBox", "cylinder": "movedCylinder"}
INSIDE = "mesh"  # only a box that holds it can be told


def equation(obj: SceneObject) -> tuple[str, dict[str, Any]] | None:
    """The word of its kind in the catalogue, and what fills its slots: numbers or three of them.
    None: meshes, cones, tubes and what was moved otherwise."""
    shape = obj.shape
    word = OWN.get(type(shape))
    if word is None or not getattr(shape, "capped", True):
        return None
    is_turned = isinstance(shape, Ellipsoid) and any(shape.rotation)
    if is_unmoved(obj) and not is_turned:
        fields = vars(shape)
        return word, {key: fields[key] for key in fields if key not in ("rotation", "capped")}
    linear, centre = placement(obj)
    if isinstance(shape, Plane):
        normal = np.linalg.inv(linear)[1]  # of the canonical one: +y
        return word, {"point": centre, "normal": normal / np.linalg.norm(normal)}
    moved = MOVED.get(shape.canonical.name)
    if moved is None:
        return None
    a, b, d = linear.T
    return moved, {"center": centre, "a": a, "b": b, "d": d}
