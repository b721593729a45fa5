"""One pixel's rays as the right program and as a wrong one has them, in all digits."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any

import numpy as np

from raywalk.mistakes.camera import camera_directions
from raywalk.mistakes.colour import to_bytes
from raywalk.mistakes.habits import EXACT
from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.tracer import LEAST_SHARE, trace
from raywalk.mistakes.trees import tree_of
from raywalk.mistakes.vectors import unit
from raywalk.scene.model import Scene
from raywalk.trace.kinds import BRANCH_OF
from raywalk.trace.tree import RayTree

Path = tuple[int, ...]  # from the camera ray on: the branch that each hit sent on

# By the names of the viewer's Trace.
COLUMNS = {
    "kind": "kind", "parent": "parent", "depth": "depth", "object": "object",
    "material": "material", "inside": "inside", "t": "t", "weight": "weight",
    "local_weight": "localWeight", "tests": "tests", "point": "point", "normal": "normal",
    "colour": "colour", "visibility": "visibility", "blocker": "blocker",
    "blocked_at": "blockedAt", "passed": "passed", "diffuse": "diffuse", "specular": "specular",
    "hits_start": "hitsStart", "hits_t": "hitsT", "hits_object": "hitsObject",
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Walked:
    """A program's ray tree of one pixel."""

    scene: Scene  # as the program takes it
    n: int
    pixel: int  # row * n + column
    tree: RayTree  # of this pixel alone: its camera ray is row 0
    first: np.ndarray  # (3,) unit: where the camera ray goes
    bytes: tuple[int, int, int]

    @cached_property
    def rows(self) -> dict[Path, int]:
        """The rays by their paths, each followed by what it leads to, as a card lists them."""
        return dict(self._below(0, ()))

    def _below(self, row: int, path: Path) -> Iterator[tuple[Path, int]]:
        yield path, row
        for child in np.flatnonzero(self.tree.parent == row).tolist():
            yield from self._below(child, (*path, int(BRANCH_OF[self.tree.kind[child]])))

    def start(self, row: int) -> np.ndarray:
        """(3,) where a ray starts."""
        parent = self.tree.parent[row]
        return np.array(self.scene.camera.eye) if parent < 0 else self.tree.point[parent]

    def way(self, row: int) -> np.ndarray:
        """(3,) unit: where it goes."""
        if row == 0:
            return self.first
        return np.asarray(unit(self.tree.point[row] - self.start(row)))

    def as_json(self) -> dict[str, Any]:
        """For the viewer's modules: columns by their names there, and of the scene what a program
        may take otherwise. Infinity, which JSON has not, is null."""
        columns = {there: _plain(getattr(self.tree, here)) for here, there in COLUMNS.items()}
        base = np.ones_like(self.tree.point) if self.tree.base is None else self.tree.base
        return {
            "n": self.n, "pixel": self.pixel, "bytes": list(self.bytes),
            "columns": columns | {"base": _plain(base)},
            "materials": [asdict(material) for material in self.scene.materials],
            "depth": self.scene.render.depth,
            "based": [obj.base is not None for obj in self.scene.objects],
        }  # fmt: skip


def walked(scene: Scene, n: int, pixel: int, mistakes: Mistakes = frozenset()) -> Walked:
    """Followed as far as the rays of the scene's page are."""
    at = np.array([pixel])
    world, waves = trace(scene, n, at, mistakes, EXACT, LEAST_SHARE)
    tree = tree_of(world, waves, n, mistakes, EXACT)
    first = unit(camera_directions(world.scene.camera, n, at, mistakes))[:, 0]
    red, green, blue = to_bytes(waves[0].colour[:, 0], mistakes).tolist()
    return Walked(world.scene, n, pixel, tree, first, (red, green, blue))


def _plain(values: np.ndarray) -> list[Any]:
    flat = values.reshape(-1).tolist()
    return [None if value != value or value in (np.inf, -np.inf) else value for value in flat]
