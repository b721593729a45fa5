"""A scene's atlas: its right picture and the wrong ones that mistakes make of it, on one grid.

Wrong pictures are made by the numpy tracer, exactly, and once more as most programs calculate: in
float32 with an offset. The second is kept where it is another picture. What shows hardly at all is
found on a coarse grid, at a ninth of the work.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raywalk.mistakes.habits import Habits
from raywalk.mistakes.table import TABLE, Mistake
from raywalk.mistakes.tracer import picture
from raywalk.scene.model import Scene

GRID, COARSE = 231, 77
USUAL = Habits(precision=np.float32, offset=1e-3)
CHANGED = 0.005  # of the pixels, by more than a step: a mistake that changes fewer is not told
OTHER = 3  # steps of 255 from which on the usual program's picture is another than the exact one's
#: What the coarse grid must see of either: it misses thin things that the fine one has.
HINT = CHANGED / 2


@dataclass(frozen=True)
class Wrong:
    """What one mistake makes of a scene."""

    mistake: Mistake
    pictures: list[np.ndarray]  # one or two, (n, n, 3) uint8


@dataclass(frozen=True)
class Atlas:
    """Pictures are (GRID, GRID, 3) uint8."""

    right: np.ndarray
    wrong: list[Wrong]  # in the order of the table, of mistakes that show


def atlas_of(scene: Scene) -> Atlas:
    """Raises SourceErrors that name what the numpy tracer leaves out."""
    right, coarse = (picture(scene, n).bytes for n in (GRID, COARSE))
    found = ((mistake, _pictures(scene, mistake.name, right, coarse)) for mistake in TABLE)
    return Atlas(right, [Wrong(mistake, made) for mistake, made in found if made])


def _pictures(
    scene: Scene, name: str, right: np.ndarray, coarse: np.ndarray
) -> list[np.ndarray]:  # fmt: skip
    """None of a mistake that does not show."""
    mistakes = frozenset([name])
    quick = [picture(scene, COARSE, mistakes, habits).bytes for habits in (Habits(), USUAL)]
    if max(changed(each, coarse) for each in quick) <= HINT:
        return []
    wrong = picture(scene, GRID, mistakes).bytes
    if changed(quick[0], quick[1], OTHER) <= HINT:
        return [wrong] if changed(wrong, right) > CHANGED else []
    usual = picture(scene, GRID, mistakes, USUAL).bytes
    if max(changed(wrong, right), changed(usual, right)) <= CHANGED:
        return []
    return [wrong, usual] if changed(usual, wrong, OTHER) > CHANGED else [wrong]


def changed(a: np.ndarray, b: np.ndarray, steps: int = 1) -> float:
    """Share of the pixels that differ by more than so many steps of 255."""
    return float((np.abs(a.astype(int) - b).max(axis=-1) > steps).mean())
