"""A scene's atlas: its right picture and the wrong ones that mistakes make of it, on one grid.

Wrong pictures are made by the numpy tracer, exactly, and once more as most programs calculate: in
float32 with an offset. The second is kept where it is another picture. What shows hardly at all is
found on a coarse grid, at a ninth of the work.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raywalk.mistakes.habits import EXACT, Habits
from raywalk.mistakes.table import TABLE, Mistake
from raywalk.mistakes.tracer import Version, pictures
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
    hinted = _hinted(scene)
    versions = [Version(), *(each for of_one in hinted.values() for each in of_one)]
    right, *others = pictures(scene, GRID, versions)
    made, wrong = iter(others), []
    for mistake, of_one in hinted.items():
        own = [next(made) for _ in of_one]
        if max(changed(each, right) for each in own) > CHANGED:
            is_other = changed(own[0], own[-1], OTHER) > CHANGED
            wrong.append(Wrong(mistake, own if is_other else own[:1]))
    return Atlas(right, wrong)


def _hinted(scene: Scene) -> dict[Mistake, list[Version]]:
    """The versions worth a fine picture, of mistakes that show on the coarse grid: the exact one,
    and the usual one where its picture seems to be another."""
    both = [
        [Version(frozenset([each.name]), habits) for habits in (EXACT, USUAL)] for each in TABLE
    ]
    right, *made = pictures(scene, COARSE, [Version(), *(each for two in both for each in two)])
    hinted = {}
    for mistake, two, exact, usual in zip(TABLE, both, made[::2], made[1::2], strict=True):
        if max(changed(exact, right), changed(usual, right)) > HINT:
            hinted[mistake] = two if changed(exact, usual, OTHER) > HINT else two[:1]
    return hinted


def changed(a: np.ndarray, b: np.ndarray, steps: int = 1) -> float:
    """Share of the pixels that differ by more than so many steps of 255."""
    return float((np.abs(a.astype(int) - b).max(axis=-1) > steps).mean())
