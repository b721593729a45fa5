"""Bodies of glass that say themselves where they are: the truth that media are judged by.

Each body's depth comes from its equation in its own frame, in plain numpy, and shares nothing
with the tracer: no canonical table, no tree, no stack.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.bench.made_scenes import icosphere, placed, write_ply
from raywalk.scene.shapes import Box, Cone, Cylinder, Ellipsoid, Mesh, Shape, Sphere

Depth = Callable[[np.ndarray], np.ndarray]  # (n, 3) own frame -> (n,) < 0 inside, own units
CUBE = ((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0))


@dataclass(frozen=True, eq=False)
class Body:
    """A shape with its place in the world, and points of interest on it."""

    kind: str
    shape: Shape
    depth_of: Depth
    points: np.ndarray  # (p, 3) own frame: corners, places on edges, tips
    linear: np.ndarray  # (3, 3) own frame -> world
    offset: np.ndarray  # (3,)

    def depth(self, world: np.ndarray) -> np.ndarray:
        """(n,) how deep points lie outside (> 0) or inside (< 0), about in world units."""
        size = np.cbrt(abs(np.linalg.det(self.linear)))
        own = np.linalg.solve(self.linear, (world - self.offset).T).T
        return np.asarray(size * self.depth_of(own))

    def marks(self) -> np.ndarray:
        """Its points of interest in the world."""
        return self.points @ self.linear.T + self.offset

    def moved(self, linear: Any = 1.0, offset: Any = (0.0, 0.0, 0.0)) -> Body:
        """The same body after another affine map of the world."""
        matrix = np.asarray(linear) * (np.eye(3) if np.ndim(linear) == 0 else 1.0)
        return replace(self, linear=matrix @ self.linear, offset=matrix @ self.offset + offset)

    def transform(self) -> np.ndarray:
        return placed(self.linear, self.offset)


def body(kind: str, folder: Path) -> Body:
    """A body of this kind, about the unit cube's size; meshes are written to the folder."""
    if kind in MESHES:
        corners, depth = MESHES[kind]()
        path = folder / f"{kind.replace(' ', '-')}.ply"
        if not path.exists():
            write_ply(path, corners)
        shape: Shape = Mesh(kind, path, smooth=False)
        edges = np.concatenate([corners, (corners + np.roll(corners, 1, axis=1)) / 2], axis=1)
        points = np.unique(edges.reshape(-1, 3), axis=0)
    else:
        shape, depth, points = SOLIDS[kind]()
    return Body(kind, shape, depth, points, np.eye(3), np.zeros(3))


def ball() -> tuple[Shape, Depth, np.ndarray]:
    return Sphere((0.0, 0.0, 0.0), 1.0), lambda p: np.linalg.norm(p, axis=1) - 1.0, _tips()


def egg() -> tuple[Shape, Depth, np.ndarray]:
    radii = (0.8, 1.0, 0.6)
    scale = np.array(radii)
    return (
        Ellipsoid((0.0, 0.0, 0.0), radii),
        lambda p: 0.6 * (np.linalg.norm(p / scale, axis=1) - 1.0),
        _tips() * scale,
    )


def drum() -> tuple[Shape, Depth, np.ndarray]:
    turn = np.linspace(0.0, 2 * np.pi, 8, endpoint=False)
    rim = np.stack([np.cos(turn), np.ones(8), np.sin(turn)], axis=1)
    return (
        Cylinder((0.0, -1.0, 0.0), (0.0, 1.0, 0.0), 1.0),
        lambda p: np.maximum(np.hypot(p[:, 0], p[:, 2]) - 1.0, np.abs(p[:, 1]) - 1.0),
        np.concatenate([rim, rim * [1, -1, 1], _tips()]),
    )


def spike() -> tuple[Shape, Depth, np.ndarray]:
    rim = drum()[2][8:16]
    return (
        Cone((0.0, -1.0, 0.0), (0.0, 1.0, 0.0), 1.0),
        lambda p: np.maximum(
            0.9 * np.hypot(p[:, 0], p[:, 2]) - 0.45 * (1.0 - p[:, 1]), -1.0 - p[:, 1]
        ),
        np.concatenate([rim, rim * [0.5, 0.0, 0.5], [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]]]),
    )


def block() -> tuple[Shape, Depth, np.ndarray]:
    points = np.unique(_boxed(*CUBE).reshape(-1, 3), axis=0)
    middles = np.array([(a + b) / 2 for a in points for b in points if np.sum(a != b) <= 2])
    return Box(*CUBE), _depth_in_box(*CUBE), np.concatenate([points, middles])


def block_mesh() -> tuple[np.ndarray, Depth]:
    return _boxed(*CUBE), _depth_in_box(*CUBE)


def ball_mesh() -> tuple[np.ndarray, Depth]:
    """A polyhedron: inside is behind all its planes."""
    corners = icosphere(1)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    height = (normal * corners[:, 0]).sum(axis=1)
    return corners, lambda p: (p @ normal.T - height).max(axis=1)


def corner_mesh() -> tuple[np.ndarray, Depth]:
    """An L, not convex: the cube without the quarter x > 0, y > 0."""
    outline = np.array([[-1, -1], [1, -1], [1, 0], [0, 0], [0, 1], [-1, 1]], float)
    front, back = (np.column_stack([outline, np.full(6, z)]) for z in (1.0, -1.0))
    caps = [(0, 1, 2), (0, 2, 3), (0, 3, 5), (3, 4, 5)]
    corners = [front[list(cap)] for cap in caps] + [back[list(cap[::-1])] for cap in caps]
    for a, b in pairwise([*range(6), 0]):
        corners += [np.stack([front[a], back[a], back[b]]), np.stack([front[a], back[b], front[b]])]
    low = (-1.0, -1.0, -1.0)
    upright, lying = _depth_in_box(low, (0.0, 1.0, 1.0)), _depth_in_box(low, (1.0, 0.0, 1.0))
    return np.array(corners), lambda p: np.minimum(upright(p), lying(p))


SOLIDS = {"sphere": ball, "ellipsoid": egg, "cylinder": drum, "cone": spike, "box": block}
MESHES = {"mesh": block_mesh, "round mesh": ball_mesh, "L mesh": corner_mesh}
FLAT = ("cylinder", "box", "mesh", "L mesh")  # y = -1 and y = 1 hold faces of these


def _tips() -> np.ndarray:
    return np.concatenate([np.eye(3), -np.eye(3)])


def _depth_in_box(low: Sequence[float], high: Sequence[float]) -> Depth:
    a, b = np.array(low), np.array(high)
    return lambda p: np.maximum(a - p, p - b).max(axis=1)


def _boxed(low: Sequence[float], high: Sequence[float]) -> np.ndarray:
    """(12, 3, 3) triangles of a box, outwards."""
    import trimesh

    return np.asarray(trimesh.creation.box(bounds=[low, high]).triangles, float)
