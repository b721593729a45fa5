"""What a lesson's steps work out beside the stage, as worked.js for its page."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from raywalk.scene.model import Scene
from raywalk.trace.equations import equations_of
from raywalk.trace.wavefront import Tracer
from raywalk.trace_file.container import write_script
from raywalk.trace_file.nested import nested_samples


def write_worked(scene: Scene, traced: Path, asked: dict[str, Any], folder: Path) -> None:
    """asked: what `asked_of` (worked.py) found in the lesson; traced: the folder of its trace."""
    found: dict[str, Any] = {"format": 1, "scene": scene.id}
    if "equation" in asked or "tree" in asked:
        tracer = Tracer(scene)
    if "equation" in asked:
        found["equations"] = equations_of(tracer, asked["equation"])
    if "tree" in asked:
        from raywalk.trace.mesh_visits import tree_of  # a scene without a mesh runs none of it

        found["tree"] = tree_of(tracer, asked["tree"])
    if "average" in asked:
        picture = np.asarray(Image.open(traced / "picture.png").convert("RGB"))
        found["average"] = nested_samples(picture, asked["average"], scene.render.resolutions)
    text = json.dumps(found, separators=(",", ":"), allow_nan=False)
    write_script(folder / "worked.js", f"{scene.id}/worked", text.encode())
