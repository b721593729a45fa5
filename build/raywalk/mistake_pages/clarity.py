"""How clearly each mistake shows in a scene, asked of small pictures: which scene tells it best is
decided before anything larger is traced."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.mistake_pages.best import Clarity
from raywalk.mistakes.features import SEEN
from raywalk.mistakes.sights import STEP
from raywalk.mistakes.table import TABLE
from raywalk.mistakes.tracer import picture
from raywalk.mistakes.world import left_out
from raywalk.scene.model import Scene

FILE = "clarity.json"
GRID = 33
# Each of a soft light's lamps costs as much again, a coarser grid tells the same.
MANY_LAMPS, COARSE = 8, 15
PLAIN = 64.0  # of 255: what differs by more is not seen any better


def clarity_in(scene: Scene) -> dict[str, Clarity]:
    """By mistake, of all that change anything."""
    n = COARSE if len(scene.lights) > MANY_LAMPS else GRID
    right = picture(scene, n, least_share=STEP).bytes.astype(int)
    found = {}
    for mistake in TABLE:
        wrong = picture(scene, n, frozenset([mistake.name]), least_share=STEP).bytes
        off = np.abs(wrong - right).max(axis=2)
        if off.any():
            clear = float(np.minimum(off, PLAIN).mean() / PLAIN)
            changed = float((off > 0).mean())
            found[mistake.name] = Clarity(changed, clear, changed > SEEN)
    return found


def write_clarity(scene: Scene, folder: Path) -> None:
    """clarity.json: by mistake its Clarity; or which objects the tracer leaves out."""
    named = [obj.name for obj in scene.objects if left_out(obj)]
    found = {} if named else clarity_in(scene)
    told: dict[str, Any] = {"left_out": named, "mistakes": found}
    (folder / FILE).write_text(json.dumps(told), encoding="utf-8")
