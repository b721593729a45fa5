"""Mistakes about what a scene says: the scene that the program takes it for.

All others stand where the wrong line of code would stand.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from raywalk.mistakes.table import Mistakes
from raywalk.scene.model import Base, Material, Scene

WRONG_EXPONENT = 4.0  # times too small
PLASTIC = {"ambient": (0.1, 0.1, 0.1), "diffuse": (1.0, 1.0, 1.0), "specular": (1.0, 1.0, 0.5),
           "shininess": 100.0}  # fmt: skip


def believed(scene: Scene, mistakes: Mistakes) -> Scene:
    """The scene as a program with these mistakes has it."""
    for name, change in CHANGES.items():
        if name in mistakes:
            scene = change(scene)
    return scene


def _materials(scene: Scene, change: Callable[[Material], dict[str, Any]]) -> Scene:
    return replace(scene, materials=tuple(replace(m, **change(m)) for m in scene.materials))


def _render(scene: Scene, **keys: Any) -> Scene:
    return replace(scene, render=replace(scene.render, **keys))


def _intensities(scene: Scene, of: Callable[[float], float]) -> Scene:
    lights = (replace(light, intensity=of(light.intensity)) for light in scene.lights)
    return replace(scene, lights=tuple(lights))


def _scaled(colour: tuple[float, ...], by: tuple[float, ...]) -> tuple[float, ...]:
    return tuple(a * b for a, b in zip(colour, by, strict=True))


def _ambient_times(scene: Scene, times: float) -> Scene:
    return _materials(scene, lambda m: {"ambient": _scaled(m.ambient, (times,) * 3)})


def _mirror_as_plastic(scene: Scene) -> Scene:
    """Mirrors without any colour get the one that all materials begin with."""

    def dressed(m: Material) -> dict[str, Any]:
        is_bare = not any((*m.ambient, *m.diffuse, *m.specular))
        return PLASTIC if m.reflect > 0 and m.transmit == 0 and is_bare else {}

    return _materials(scene, dressed)


def _with_base(scene: Scene) -> Scene:
    """A trace file notes a factor of ambient and diffuse at the objects that say they have one."""
    objects = tuple(replace(obj, base=Base()) for obj in scene.objects)
    return replace(scene, objects=objects)


CHANGES: dict[str, Callable[[Scene], Scene]] = {
    "ambient-forgotten": lambda scene: _ambient_times(scene, 0.0),
    "ambient-once-a-light": lambda scene: _ambient_times(scene, len(scene.lights)),
    "highlight-forgotten": lambda scene: _materials(scene, lambda m: {"specular": (0.0,) * 3}),
    "specular-times-diffuse": lambda scene: _materials(
        scene, lambda m: {"specular": _scaled(m.specular, m.diffuse)}
    ),
    "exponent-wrong": lambda scene: _materials(
        scene, lambda m: {"shininess": m.shininess / WRONG_EXPONENT}
    ),
    "exponent-forgotten": lambda scene: _materials(scene, lambda m: {"shininess": 1.0}),
    "intensity-forgotten": lambda scene: _intensities(scene, lambda one: 1.0),
    "lights-averaged": lambda scene: _intensities(scene, lambda one: one / len(scene.lights)),
    "shadows-forgotten": lambda scene: _render(scene, shadows=False),
    "shadow-darkens-ambient": _with_base,
    "depth-one-too-many": lambda scene: _render(scene, depth=scene.render.depth + 1),
    "depth-one-too-few": lambda scene: _render(scene, depth=max(0, scene.render.depth - 1)),
    "mirror-adds-own-colour": _mirror_as_plastic,
    "no-fresnel": lambda scene: _materials(scene, lambda m: {"fresnel": False}),
    "glass-shadow-opaque": lambda scene: _render(scene, glass_shadows="opaque"),
}
