"""scene.js: what the viewer is told of a scene, out of its file and its trace."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from raywalk.scene.model import Scene
from raywalk.scene.shapes import Mesh
from raywalk.site.mesh_data import DisplayMesh
from raywalk.site.savings import savings_of
from raywalk.site.scene_data import Display, scene_data
from raywalk.trace_file.script import write_script


def write_page_data(scene: Scene, traced: Path, folder: Path) -> None:
    """traced: the folder of the scene's trace, with facts.json and display.npz."""
    facts = json.loads((traced / "facts.json").read_text(encoding="utf-8"))
    data = scene_data(scene, read_display(scene, traced / "display.npz"), savings_of(facts))
    text = json.dumps(data, separators=(",", ":"), allow_nan=False)
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
        )
        for k, obj in enumerate(scene.objects)
        if isinstance(obj.shape, Mesh)
    }
    return Display(arrays["centre"], float(arrays["radius"]), meshes)
