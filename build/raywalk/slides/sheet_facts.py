"""What stands on a worksheet before its questions: the scene in all its digits, and the formulas
that the questions need."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from raywalk.scene.camera import camera_frame, half_width
from raywalk.scene.lights import lamp_of
from raywalk.scene.model import Light, Scene, SceneObject
from raywalk.scene.on_paper import INSIDE, equation
from raywalk.slides.words import numbers, say

MOST_DECIMALS = 6  # of what is given: as many as it has, of roots and turned axes these

NO_STEP = 1e-9  # between two steps along a row of lamps: roundings

Facts = dict[str, Any]  # those of trace/sheet_pixels.py: "n", "boxes", "asked"


def exactly(value: float) -> str:
    """A number with the decimals that it has, so that nothing is lost in print."""
    digits = next(
        (k for k in range(MOST_DECIMALS) if round(value, k) == round(value, 9)), MOST_DECIMALS
    )
    return numbers().fixed(value, digits)


def exact_vector(values: Iterable[float]) -> str:
    return f"({numbers().listed(map(exactly, values))})"


def given(scene: Scene, facts: Facts) -> list[str]:
    """A line each: the camera, its frame, objects, lights."""
    camera, (right, up, forward) = scene.camera, camera_frame(scene.camera)
    lines = [
        say("slides.givenCamera", eye=exact_vector(camera.eye), target=exact_vector(camera.target),
            fov=exactly(camera.fov)),
        say("sheet.frame", right=exact_vector(right), up=exact_vector(up),
            forward=exact_vector(forward), half=exactly(camera.fov / 2),
            spread=exactly(half_width(camera))),
    ]  # fmt: skip
    for k, obj in enumerate(scene.objects):
        told = shape_words(obj, facts["boxes"].get(str(k)))
        if told is None:  # nothing is asked of this scene
            continue
        lines.append(f"{obj.name}: {told}")
        glass = scene.materials[obj.material]
        if glass.transmit > 0:
            lines[-1] += say("sheet.glass", ior=exactly(glass.ior))
    if scene.has_glass and scene.render.shadows and scene.render.glass_shadows == "pass":
        lines.append(say("sheet.glassPasses"))
    return lines + [_placed(name, lights) for name, lights in lamps(scene).items()]


def lamps(scene: Scene) -> dict[str, list[Light]]:
    """By name: a light that has an area is a grid of points, row by row."""
    by_name: dict[str, list[Light]] = {}
    for light in scene.lights:
        by_name.setdefault(lamp_of(light.name), []).append(light)
    return by_name


def _placed(name: str, lights: list[Light]) -> str:
    at = np.array([light.position for light in lights])
    if len(at) == 1:
        return say("slides.givenLight", light=name, at=exact_vector(at[0]))
    steps = np.abs(np.diff(at, axis=0) - (at[1] - at[0])).max(axis=1) > NO_STEP
    across = int(np.argmax(steps)) + 1 if steps.any() else len(at)
    down = at[across] - at[0] if across < len(at) else np.zeros(3)
    return say(
        "sheet.lampGrid", light=name, across=across, down=len(at) // across, at=exact_vector(at[0]),
        step=exact_vector(at[1] - at[0]), row=exact_vector(down),
    )  # fmt: skip


def shape_words(obj: SceneObject, box: list[list[float]] | None) -> str | None:
    """A shape in the world's coordinates; None where nothing is known. box: corners, of what no
    formula here is for."""
    told = equation(obj)
    if told is None:
        if box is None:
            return None
        low, high = box
        return say(f"sheet.shape.{INSIDE}", low=exact_vector(low), high=exact_vector(high))
    word, slots = told
    return say(f"sheet.shape.{word}", **{
        key: exactly(value) if isinstance(value, float | int) else exact_vector(value)
        for key, value in slots.items()
    })  # fmt: skip


def formulas(scene: Scene, facts: Facts) -> list[str]:
    """Those that the questions need, a line each."""
    return [say(f"sheet.formula.{key}") for key in _needed(scene, facts)]


def _needed(scene: Scene, facts: Facts) -> Iterator[str]:
    kinds = {fact["of"] for fact in facts["asked"]}
    if not kinds:
        return
    if kinds != {"bytes"}:
        yield "ray"
        words = dict.fromkeys(told[0] for obj in scene.objects if (told := equation(obj)))
        moved = [word for word in words if word.startswith("moved")]
        plain = dict.fromkeys(word.removeprefix("moved").lower() for word in words)
        yield from (word for word in FORMULAS if word in plain)
        yield from ["moved"] * bool(moved)
        yield "first"
    if kinds & {"lambert", "reflected", "refracted"}:
        yield "normal"
    yield from (key for key in ("lambert", "shadow", "reflected", "refracted") if key in kinds)
    if "bytes" in kinds:
        yield "bytes"


FORMULAS = ("sphere", "ellipsoid", "plane", "disc", "cylinder", "box", "triangle")
