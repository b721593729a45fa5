"""Refuses a camera that can see nothing: one buried in something opaque."""

from __future__ import annotations

from raywalk.errors import SourceError, SourceErrors
from raywalk.scene.model import Scene
from raywalk.scene.shapes import Plane


def refuse_buried_camera(scene: Scene, around: list[int]) -> None:
    """Raises SourceErrors if an opaque closed object contains the camera's eye.

    A plane is a surface to an author, not a solid: being behind one is fine.
    """
    problems = [
        SourceError(
            scene.path,
            "camera.eye",
            f'{list(scene.camera.eye)} lies inside the opaque "{scene.objects[k].name}"',
            allowed="a camera may stand outside, or inside glass (transmit > 0)",
        )
        for k in around
        if not scene.materials[scene.objects[k].material].transmit
        and not isinstance(scene.objects[k].shape, Plane)
    ]
    if problems:
        raise SourceErrors(problems)
