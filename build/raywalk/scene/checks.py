"""What a scene must make sense of, beyond each table by itself."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import dist, isinf

import numpy as np

from raywalk.scene.model import Camera, Material, SceneObject
from raywalk.scene.placement import UNMOVED, placement
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema import CameraTable, LightTable
from raywalk.scene.shapes import Mesh, Shape
from raywalk.scene.wording import plain, quoted

# Sine of the angle below which two directions are one to the eye: up that runs along the
# line of sight fixes no upright, an area light with such edges has no area.
PARALLEL = 1e-9
ROOMY = 1.0 + 1e-9  # of a sphere that holds a shape: more than what rounding takes from it


def check_names(names: Iterable[tuple[int, str]], section: str, problems: Problems) -> None:
    """Each name stands for one object or light."""
    first: dict[str, int] = {}
    for index, name in names:
        if name in first:
            message = f"{quoted(name)} is also the name of {section}[{first[name]}]"
            problems.add((section, index, "name"), message)
        else:
            first[name] = index


def check_camera(table: CameraTable, problems: Problems) -> None:
    """The camera looks somewhere, and knows what is up."""
    sight = np.subtract(table.target, table.eye)
    if not sight.any():
        problems.add(("camera", "target"), f"{plain(table.target)} is where the eye is")
        return
    if not any(table.up):
        problems.add(("camera", "up"), f"{plain(table.up)} has no direction")
        return
    up = np.array(table.up) / np.abs(table.up).max()
    sight = sight / np.abs(sight).max()
    sine = np.linalg.norm(np.cross(up, sight)) / (np.linalg.norm(up) * np.linalg.norm(sight))
    if sine < PARALLEL:
        message = f"{plain(table.up)} runs along the line of sight: nothing says what is upright"
        problems.add(("camera", "up"), message, hint="choose up across the line of sight")


def check_light(table: LightTable, at: Location, problems: Problems) -> None:
    """The edges of an area light span an area."""
    if table.edges is None:
        return
    lengths = [np.abs(edge).max() for edge in table.edges]
    if all(lengths):
        a, b = (np.array(edge) / size for edge, size in zip(table.edges, lengths, strict=True))
        if np.linalg.norm(np.cross(a, b)) > PARALLEL:
            return
    problems.add((*at, "edges"), f"{plain(table.edges)} span no area")


def check_closed(shape: Shape, material: Material, at: Location, problems: Problems) -> None:
    """Light that enters a body must be able to leave it: glass needs an inside."""
    # A mesh is asked where its triangles are known.
    is_open = shape.canonical.height is None and not isinstance(shape, Mesh)
    if material.transmit > 0 and is_open:
        problems.add(
            (*at, "material"),
            f"{quoted(material.name)} lets light through (transmit = {plain(material.transmit)}), "
            f"but a {shape.title} has no inside",
            hint="glass needs a closed shape: a sphere, ellipsoid, box or closed mesh, one with "
            "caps, or a plane as the border of a half-space",
        )


def check_eye_outside(
    camera: Camera, obj: SceneObject, material: Material, problems: Problems
) -> None:
    """A camera inside an opaque body would see its inner wall and nothing else.

    A transparent body is fine: the camera may be under water. So is a mirror: from within a ball
    it shows what its inside is like.
    """
    if material.transmit == 0 and material.reflect == 0 and is_strictly_inside(camera.eye, obj):
        message = f"{plain(camera.eye)} is inside {quoted(obj.name)}, which is opaque"
        hint = "move the eye out, or give the object transmit above 0"
        problems.add(("camera", "eye"), message, hint=hint)


def is_strictly_inside(point: Sequence[float], obj: SceneObject) -> bool:
    """Whether a point lies inside a closed shape.

    False for planes and open shapes, which have no inside that hides a camera; meshes are asked
    where their triangles are known.
    """
    canonical = obj.shape.canonical
    if canonical.height is None or isinf(canonical.reach):
        return False
    holder = obj.shape.holder()
    if holder and obj.transform is UNMOVED and dist(point, holder[0]) > ROOMY * holder[1]:
        return False  # as most objects are: no Decimals are needed to know it
    linear, centre = placement(obj)
    local = np.linalg.solve(linear, np.asarray(point, float) - centre)
    return bool(canonical.height(*local.tolist()) < 0)
