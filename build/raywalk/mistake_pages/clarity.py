"""How clearly each mistake shows in a scene, asked of small pictures: which scene tells it best is
decided before anything larger is traced. And which others look like it there without being taken
for it: what one weighs who is asked which mistake a picture shows."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.mistake_pages.best import Clarity
from raywalk.mistakes.features import SEEN
from raywalk.mistakes.sights import STEP
from raywalk.mistakes.table import TABLE
from raywalk.mistakes.tracer import Version, pictures
from raywalk.mistakes.world import left_out
from raywalk.scene.model import Scene

FILE = "clarity.json"
GRID = 33
# Each of a soft light's lamps costs as much again, a coarser grid tells the same.
MANY_LAMPS, COARSE = 8, 15
PLAIN = 64.0  # of 255: what differs by more is not seen any better
EYE = 24  # of 255: what two pictures beside one another differ by at least for an eye to see it
NEAR = 24  # others that are told of a mistake, the most alike first

Bytes = dict[str, np.ndarray]  # by mistake, (n, n, 3) int


def clarity_in(scene: Scene) -> dict[str, Clarity]:
    """By mistake, of all that change anything."""
    return _clarity(*_pictures(scene))


def write_clarity(scene: Scene, folder: Path) -> None:
    """clarity.json: by mistake its Clarity; what an eye sees of each, and of each beside those that
    look most like it; or which objects the tracer leaves out."""
    named = [obj.name for obj in scene.objects if left_out(obj)]
    told: dict[str, Any] = {"left_out": named, "mistakes": {}, "eye": {}, "near": {}}
    if not named:
        right, wrong = _pictures(scene)
        told["mistakes"] = _clarity(right, wrong)
        told["eye"] = {name: seen_apart(own, right) for name, own in wrong.items()}
        told["near"] = nearest(wrong)
    (folder / FILE).write_text(json.dumps(told), encoding="utf-8")


def _pictures(scene: Scene) -> tuple[np.ndarray, Bytes]:
    """The right one, and those that differ from it."""
    n = COARSE if len(scene.lights) > MANY_LAMPS else GRID
    versions = [Version(), *(Version(frozenset([mistake.name])) for mistake in TABLE)]
    right, *made = (each.astype(int) for each in pictures(scene, n, versions, STEP))
    both = zip(TABLE, made, strict=True)
    return right, {mistake.name: each for mistake, each in both if (each != right).any()}


def _clarity(right: np.ndarray, wrong: Bytes) -> dict[str, Clarity]:
    found = {}
    for name, made in wrong.items():
        off = np.abs(made - right).max(axis=2)
        clear = float(np.minimum(off, PLAIN).mean() / PLAIN)
        changed = float((off > 0).mean())
        found[name] = Clarity(changed, clear, changed > SEEN)
    return found


def seen_apart(one: np.ndarray, other: np.ndarray) -> float:
    """Share of the pixels in which an eye sees two pictures differ."""
    return float((np.abs(one - other).max(axis=2) >= EYE).mean())


def nearest(wrong: Bytes) -> dict[str, list[tuple[str, float]]]:
    """Of each mistake others, the most alike first, with what is seen apart of both; those that
    cannot be told from it too."""
    near = {}
    for name, own in wrong.items():
        apart = [
            (other, seen_apart(own, made), float(np.abs(own - made).mean()))
            for other, made in wrong.items()
            if other != name
        ]
        apart.sort(key=lambda each: each[2])
        near[name] = [(other, seen) for other, seen, _ in apart[:NEAR]]
    return near
