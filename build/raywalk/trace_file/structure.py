"""Who is whose child: everything about a ray tree that needs no number but symbols.

The tree is grown as a reader will grow it, depth by depth: a coder is asked for each ray's surface
and children, which it knows, and notes how well they were guessed.

Guesses come from rays that lie beside a ray in the picture and have the same history. The
neighbours of a camera ray are those of its pixel; those of a reflected ray are the reflected rays
of its parent's neighbours, and so on. All come earlier in the file, so whoever reads it knows them
when he reaches the ray.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from raywalk.trace.kinds import BRANCH_OF, BRANCHES
from raywalk.trace.tree import SENT_ON, Kind, dense

NONE = -1


def follow(step: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """step[rows], with -1 leading to -1."""
    if not len(step):
        return np.full(rows.shape, NONE)
    return np.where(rows >= 0, step[rows], NONE)


def in_raster(n: int) -> np.ndarray:
    """(4, n * n): left, up, up-left, up-right of n x n camera rays, -1 where there is none."""
    row, column = np.divmod(np.arange(n * n), n)
    here = np.arange(n * n)
    return np.stack([
        np.where(column > 0, here - 1, NONE),
        np.where(row > 0, here - n, NONE),
        np.where((row > 0) & (column > 0), here - n - 1, NONE),
        np.where((row > 0) & (column < n - 1), here - n + 1, NONE),
    ])  # fmt: skip


# (column, first row, group, kind, sides within these rows) -> symbols of these rows
Coder = Callable[[str, int, np.ndarray, np.ndarray, np.ndarray], np.ndarray]


@dataclass
class Structure:
    """Columns over rays, of the whole file or (counted from its first row) of one depth."""

    pixel: np.ndarray  # row * n + column
    parent: np.ndarray  # always counted in the whole file
    kind: np.ndarray
    level: np.ndarray  # bounces before this ray
    before: np.ndarray  # equal where two rays have the same history so far
    sides: np.ndarray  # (4, m) as in_raster has them
    paths: list[int]  # where each path (RR, RT ...) of one depth starts, and the end
    surface: np.ndarray
    children: np.ndarray
    history: np.ndarray  # `before` and the patch met: equal where two rays met the same patches

    @property
    def count(self) -> int:
        return len(self.pixel)


def grow(n: int, first_object: np.ndarray, patch_of: np.ndarray, coder: Coder) -> Structure:
    """The tree of n x n camera rays that meet `first_object` first; patch_of[surface]."""
    waves: list[Structure] = []
    wave, first = _cameras(n, first_object), 0
    base = len(patch_of) + 1
    while wave.count:
        wave.surface = coder("surface", first, wave.before, wave.before, wave.sides)
        wave.history = dense(wave.before * base + patch_of[wave.surface])
        group = wave.history * base + wave.surface
        wave.children = coder("children", first, group, wave.surface, wave.sides)
        waves.append(wave)
        wave, first = _next(wave, first), first + wave.count
    return _joined(waves)


def _cameras(n: int, first_object: np.ndarray) -> Structure:
    count, empty = n * n, np.empty(0, np.int64)
    return Structure(
        np.arange(count), np.full(count, NONE), np.full(count, int(Kind.CAMERA)),
        np.zeros(count, np.int64), first_object + 1, in_raster(n), [0, count],
        empty, empty, empty,
    )  # fmt: skip


def _next(wave: Structure, first: int) -> Structure:
    """The children of a wave whose first row is `first`: path by path, each in its order."""
    picked, sent, paths = [], [], [0]
    for start, end in zip(wave.paths, wave.paths[1:], strict=False):
        children = wave.children[start:end]
        for branch in range(BRANCHES):
            rows = start + np.flatnonzero(children & bits_of(branch))
            if len(rows):
                picked.append(rows)
                sent.append(kinds_in(branch, wave.children[rows]))
                paths.append(paths[-1] + len(rows))
    empty = np.empty(0, np.int64)
    parent = np.concatenate([empty, *picked])
    kind = np.concatenate([empty, *sent])
    branch_of = BRANCH_OF[kind]
    return Structure(
        wave.pixel[parent], first + parent, kind, wave.level[parent] + 1,
        BRANCHES * wave.history[parent] + branch_of, _sides(wave, parent, branch_of), paths,
        empty, empty, empty,
    )  # fmt: skip


def bits_of(branch: int) -> int:
    """The bits in `children` of all kinds of a branch."""
    return sum(kind.bit for kind in SENT_ON if kind.branch == branch)


def kinds_in(branch: int, children: np.ndarray) -> np.ndarray:
    """(n,) which kind of a branch hits send on that send one; of two named, the later stands."""
    kind = np.zeros(len(children), np.int64)
    for each in SENT_ON:
        if each.branch == branch:
            kind[(children & each.bit) > 0] = each
    return kind


def _sides(wave: Structure, parent: np.ndarray, branch_of: np.ndarray) -> np.ndarray:
    """A child's neighbours are the like children of its parent's neighbours."""
    sides = np.empty((4, len(parent)), np.int64)
    for branch in range(BRANCHES):
        mine = np.flatnonzero(branch_of == branch)
        child = np.full(wave.count, NONE)
        child[parent[mine]] = mine
        sides[:, mine] = follow(child, wave.sides[:, parent[mine]])
    return sides


def _joined(waves: list[Structure]) -> Structure:
    """All depths as one, histories and neighbours made distinct and counted in the file."""
    first = np.cumsum([0, *(wave.count for wave in waves)])
    columns: dict[str, np.ndarray] = {
        name: np.concatenate([getattr(wave, name) for wave in waves])
        for name in ("pixel", "parent", "kind", "level", "before", "surface", "children")
    }
    histories = [wave.history + start for wave, start in zip(waves, first, strict=False)]
    sides = [
        np.where(wave.sides >= 0, wave.sides + start, NONE)
        for wave, start in zip(waves, first, strict=False)
    ]
    return Structure(
        **columns, history=np.concatenate(histories), sides=np.concatenate(sides, axis=1), paths=[]
    )
