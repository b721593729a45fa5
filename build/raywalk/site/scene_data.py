"""What the viewer knows of a scene: scene.js."""

from __future__ import annotations

import base64
import json
from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, cast

import numpy as np

from raywalk.scene.lesson_text import inline_html, lesson_html
from raywalk.scene.lights import lamp_of
from raywalk.scene.model import Choice, LessonStep, Light, Scene, SceneObject, Sweep
from raywalk.scene.placement import checker_axes, placement
from raywalk.scene.shapes import Mesh, Plane
from raywalk.site.drawn_anew import drawn_anew
from raywalk.site.mesh_data import DisplayMesh, mesh_data
from raywalk.site.savings import savings_of
from raywalk.site.scene_types import (
    AcrossData,
    ChoiceData,
    LessonData,
    LessonStepData,
    LessonStop,
    LightData,
    ObjectData,
    Savings,
    SceneData,
    SceneWords,
    StartData,
    SweepData,
)
from raywalk.site.terms import marked
from raywalk.terms.glossary import Glossary, read_glossary
from raywalk.trace_file.container import mark_of, write_script

NO_SWEEPS: Mapping[str, Path] = {}


@dataclass(frozen=True, eq=False)
class Display:
    """What only geometry knows of a scene, handed on for drawing it."""

    centre: np.ndarray  # (3,) of a sphere round everything finite
    radius: float
    meshes: dict[str, DisplayMesh]  # by object name
    # Of objects with a base colour, by name: its mean (3,); of planes (h, w, 3) uint8 and (2, 3).
    bases: dict[str, np.ndarray] = field(default_factory=dict)
    tiles: dict[str, tuple[np.ndarray, np.ndarray]] = field(default_factory=dict)


def scene_data(
    scene: Scene, display: Display, savings: Savings, files: dict[str, str], picture: str
) -> SceneData:
    """All of a scene for the viewer. picture: the name of its file."""
    data: SceneData = {
        "format": 1,
        "id": scene.id,
        "of": scene.id,
        "key": scene.key,
        "title": scene.title,
        "teaches": scene.teaches,
        "picture": picture,
        "size": scene.render.size,
        "camera": scene.camera,
        "background": list(scene.background),
        "shadows": scene.render.shadows,
        "depth": scene.render.depth,
        "levels": sorted(scene.render.resolutions),
        "start": start_of(scene),
        "bounds": {"center": display.centre.tolist(), "radius": display.radius},
        "materials": list(scene.materials),
        "objects": [object_data(obj, display) for obj in scene.objects],
        "meshes": {name: mesh_data(mesh) for name, mesh in display.meshes.items()},
        "lights": [light_data(light) for light in scene.lights],
        "lesson": [_step(step, scene.id, read_glossary()) for step in scene.lesson],
        "savings": savings,
        "files": files,
    }
    if scene.sweeps:
        data["sweeps"] = [_sweep(each, scene) for each in scene.sweeps]
        deepest = max(stop.render.depth for each in scene.sweeps for stop in each.stops)
        if deepest > scene.render.depth:
            data["deepest"] = deepest
    return data


def _sweep(sweep: Sweep, scene: Scene) -> SweepData:
    data: SweepData = {
        "id": sweep.id, "name": sweep.name, "values": _listed(sweep.values), "own": sweep.own + 1,
    }  # fmt: skip
    if sweep.is_turned:
        data["unit"] = "degrees"
    own = drawn_anew(scene)
    if any(drawn_anew(stop) != own for stop in sweep.stops):
        data["anew"] = True
    points = [
        [*Counter(lamp_of(light.name) for light in stop.lights).values()] for stop in sweep.stops
    ]
    if any(each != points[0] for each in points):
        data["points"] = [max(of) for of in zip(*points, strict=True)]
    if sweep.across:
        across: AcrossData = {"values": _listed(sweep.across.values)}
        if sweep.across.name:
            across["name"] = sweep.across.name
        if sweep.across.is_turned:
            across["unit"] = "degrees"
        data["across"] = across
    return data


def _listed(values: tuple[Any, ...]) -> list[Any]:
    return [list(each) if isinstance(each, tuple) else each for each in values]


def lesson_data(scene: Scene, base: Scene, own: dict[str, str]) -> LessonData:
    """Of a lesson on another scene what that scene's own data has not. own: marks of scripts."""
    return {
        "format": 1, "id": scene.id, "of": base.id, "key": scene.key, "title": scene.title,
        "teaches": scene.teaches, "start": start_of(scene),
        "lesson": [_step(step, scene.id, read_glossary()) for step in scene.lesson], "files": own,
    }  # fmt: skip


def scene_words(scene: Scene, glossary: Glossary | None = None) -> SceneWords:
    """What of SceneData is words: for a scene in a language other than its own, the terms of whose
    glossary are marked."""
    words: SceneWords = {
        "title": scene.title,
        "teaches": scene.teaches,
        "objects": [obj.name for obj in scene.objects],
        "lights": [light.name for light in scene.lights],
        "materials": [material.name for material in scene.materials],
        "lesson": [_step(step, scene.id, glossary) for step in scene.lesson],
    }
    if scene.sweeps:
        words["sweepNames"] = [each.name for each in scene.sweeps]
    if any(each.across for each in scene.sweeps):
        crossed = [each.across for each in scene.sweeps]
        words["acrossNames"] = [each.name if each else "" for each in crossed]
    return words


def _step(step: LessonStep, id: str, glossary: Glossary | None) -> LessonStepData:
    def html_of(text: str) -> str:
        html = lesson_html(text, id)
        return marked(html, glossary) if glossary else html

    said, *answers = [LessonStop(html=html_of(text), view=view) for text, view in step.stops()]
    data: LessonStepData = {"html": said["html"], "view": said["view"]}
    if answers:
        data["answer"] = answers[0]
    if step.choices:
        data["choices"] = [_choice(choice, id) for choice in step.choices]
    return data


def _choice(choice: Choice, id: str) -> ChoiceData:
    html, because = (inline_html(text, id) for text in (choice.text, choice.because))
    data = ChoiceData(html=html, because=because)
    if choice.right:
        data["right"] = True
    if choice.pixel is not None:
        data["pixel"] = list(choice.pixel)
    if choice.object is not None:
        data["object"] = choice.object
    if choice.colour is not None:
        data["colour"] = list(choice.colour)
    return data


def light_data(light: Light) -> LightData:
    return {key: getattr(light, key) for key in LightData.__annotations__}  # type: ignore[return-value]


def start_of(scene: Scene) -> StartData:
    """The first lesson step's ray, so that a visitor meets the scene where its story begins."""
    view = scene.lesson[0].view if scene.lesson else {}
    levels = sorted(scene.render.resolutions)
    n = view.get("resolution") or min(levels, key=lambda level: (abs(level - 15), level))
    pixel = view.get("pixel") if "resolution" in view else None
    return {"resolution": n, "pixel": list(pixel or (n // 2, n // 2))}


def object_data(obj: SceneObject, display: Display) -> ObjectData:
    linear, centre = placement(obj)
    if isinstance(obj.shape, Mesh):
        linear, centre = np.eye(3), display.meshes[obj.name].centre
    data = cast(ObjectData, {
        "name": obj.name,
        **obj.shape.drawn(),
        "label": obj.shape.word,
        "material": obj.material,
        "transform": column_major(linear, centre),
    })  # fmt: skip
    if obj.name in display.meshes:
        data["mesh"] = obj.name
    if obj.base:
        data["base"] = display.bases[obj.name].tolist()
    if obj.name in display.tiles:
        pixels, axes = display.tiles[obj.name]
        data["tile"] = {
            "width": pixels.shape[1],
            "pixels": base64.b64encode(pixels.tobytes()).decode("ascii"),
            "axes": axes.tolist(),
            "origin": centre.tolist(),
        }
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


def column_major(linear: np.ndarray, centre: np.ndarray) -> list[float]:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = linear, centre
    return [float(value) for value in matrix.T.reshape(-1)]


def write_page_data(
    scene: Scene, traced: Path, folder: Path, picture: str = "picture.png",
    worked: Path | None = None, sweeps: Mapping[str, Path] = NO_SWEEPS,
) -> None:  # fmt: skip
    """traced: the folder of the scene's trace, with facts.json and display.npz. picture: the name
    of the file that pages show. worked: the folder of what its lesson works out; sweeps: by their
    ids those of what is published of them."""
    own = {"worked": mark_of(worked / "worked.js")} if worked else {}
    if scene.base:
        _write(folder, scene, lesson_data(scene, scene.base, own))
        return
    facts = json.loads((traced / "facts.json").read_text(encoding="utf-8"))
    display = read_display(scene, traced / "display.npz")
    marks = own | {path.stem: mark_of(path) for path in sorted(traced.glob("*.js"))}
    for id, made in sweeps.items():
        marks |= {f"{id}/{path.stem}": mark_of(path) for path in sorted(made.glob("*.js"))}
    data = scene_data(scene, display, savings_of(facts), marks, picture)
    _write(folder, scene, data)


def _write(folder: Path, scene: Scene, data: SceneData | LessonData) -> None:
    text = json.dumps(data, separators=(",", ":"), allow_nan=False, default=asdict)
    write_script(folder / "scene.js", f"{scene.id}/scene", text.encode())


def read_display(scene: Scene, path: Path) -> Display:
    """The drawing data that the trace stage handed on."""
    arrays = np.load(path)
    meshes = {
        obj.name: DisplayMesh(
            centre=arrays[f"{k}.centre"],
            vertices=arrays[f"{k}.vertices"],
            faces=arrays[f"{k}.faces"],
            normals=arrays.get(f"{k}.normals"),
            colours=arrays.get(f"{k}.colours"),
        )
        for k, obj in enumerate(scene.objects)
        if f"{k}.faces" in arrays
    }
    bases = {
        obj.name: arrays[f"{k}.base"]
        for k, obj in enumerate(scene.objects)
        if f"{k}.base" in arrays
    }
    tiles = {
        obj.name: (arrays[f"{k}.tile"], arrays[f"{k}.tile_axes"])
        for k, obj in enumerate(scene.objects)
        if f"{k}.tile" in arrays
    }
    return Display(arrays["centre"], float(arrays["radius"]), meshes, bases, tiles)
