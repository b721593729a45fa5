"""The parts of a scene file that can be read, though others may be broken.

What follows the reading (names, geometry, light) is checked on these, so that one
wrong number does not hide the next mistake until the next run.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeVar

from pydantic import TypeAdapter, ValidationError

from raywalk.scene.problems import Problems
from raywalk.scene.schema import (
    CameraTable,
    LessonFile,
    LightTable,
    RenderTable,
    SceneFile,
    StepTable,
)
from raywalk.scene.schema_objects import AnyObject, MaterialTable, ObjectTable
from raywalk.scene.schema_sweeps import SweepTable

_OBJECT: TypeAdapter[Any] = TypeAdapter(AnyObject)
T = TypeVar("T")


@dataclass
class Draft:
    """Tables by their place in the file; what is broken is absent, or None by its name."""

    camera: CameraTable | None
    render: RenderTable | None
    materials: dict[str, MaterialTable | None]
    objects: dict[int, ObjectTable]
    lights: dict[int, LightTable]
    lesson: dict[int, StepTable]
    sweeps: dict[int, SweepTable]


def read_tables(raw: dict[str, Any], problems: Problems) -> tuple[SceneFile | None, Draft]:
    """The whole file if every table is sound, and the sound tables in any case."""
    try:
        whole = SceneFile.model_validate(raw)
    except ValidationError as error:
        problems.add_refusals(error)
        return None, _sound_tables(raw)
    return whole, _tables_of(whole)


def _tables_of(whole: SceneFile) -> Draft:
    return Draft(
        camera=whole.camera,
        render=whole.render,
        materials=dict(whole.materials),
        objects=dict(enumerate(whole.objects)),
        lights=dict(enumerate(whole.lights)),
        lesson=dict(enumerate(whole.lesson)),
        sweeps=dict(enumerate(whole.sweeps)),
    )


def _sound_tables(raw: dict[str, Any]) -> Draft:
    materials, material = raw.get("materials", {}), TypeAdapter(MaterialTable)
    return Draft(
        camera=_sound(TypeAdapter(CameraTable), raw.get("camera")),
        render=_sound(TypeAdapter(RenderTable), raw.get("render", {})),
        materials={
            name: _sound(material, table)
            for name, table in (materials.items() if isinstance(materials, dict) else ())
        },
        objects=_sound_items(_OBJECT, raw.get("objects")),
        lights=_sound_items(TypeAdapter(LightTable), raw.get("lights")),
        lesson=_sound_items(TypeAdapter(StepTable), raw.get("lesson")),
        sweeps=_sound_items(TypeAdapter(SweepTable), raw.get("sweeps")),
    )


def read_lesson(
    raw: dict[str, Any], problems: Problems
) -> tuple[LessonFile | None, dict[int, StepTable]]:
    """A lesson's whole file if it is sound, and its sound steps in any case."""
    try:
        whole = LessonFile.model_validate(raw)
    except ValidationError as error:
        problems.add_refusals(error)
        return None, _sound_items(TypeAdapter(StepTable), raw.get("lesson"))
    return whole, dict(enumerate(whole.lesson))


def _sound_items(kind: TypeAdapter[T], items: Any) -> dict[int, T]:
    found = {i: _sound(kind, item) for i, item in enumerate(items if type(items) is list else [])}
    return {i: item for i, item in found.items() if item is not None}


def _sound(kind: TypeAdapter[T], value: Any) -> T | None:
    try:
        return kind.validate_python(value)
    except ValidationError:
        return None  # reported when the whole file was read
