"""Where a plane cuts an object: outlines for a flat drawing of the rays in that plane."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from raywalk.scene.model import SceneObject
from raywalk.scene.placement import placement
from raywalk.scene.shapes import Canonical

if TYPE_CHECKING:
    from raywalk.geometry.mesh_file import Triangles

ROUND = 96  # corners of a round outline
AXES = np.eye(3)
TOUCH = 1e-12  # radii: a plane this near to touching a sphere shows the point that its rays meet
BOX_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
BOX_EDGES = [(i, j) for i in range(8) for j in range(i) if bin(i ^ j).count("1") == 1]


@dataclass(frozen=True, eq=False)
class Cut:
    """A plane with coordinates on it: world = origin + x across + y up."""

    origin: np.ndarray  # (3,) world
    axes: np.ndarray  # (2, 3) rows x, y: unit, perpendicular
    reach: float  # world units from the origin: infinite planes end there

    @cached_property
    def normal(self) -> np.ndarray:
        """(3,) unit."""
        return _cross(self.axes[0], self.axes[1])

    def flat(self, points: np.ndarray) -> np.ndarray:
        """(..., 2) coordinates of world points, seen along the normal."""
        return np.asarray((points - self.origin) @ self.axes.T)


@dataclass(frozen=True, eq=False)
class Outline:
    """One curve in a cut's coordinates: a polygon, a chain, or an ellipse."""

    points: np.ndarray  # (k, 2); of an ellipse its centre and two conjugate half axes, (3, 2)
    kind: str  # "closed", "open" or "ellipse"


class Sliced:
    """One object to be cut by many planes: where it stands is worked out once."""

    def __init__(self, obj: SceneObject, triangles: Triangles | None = None):
        """triangles: of a mesh object."""
        self._canonical, self._triangles = obj.shape.canonical, triangles
        if triangles is None:
            self._linear, self._centre = placement(obj)
            self._smallest = float(np.linalg.svd(self._linear, compute_uv=False).min())

    def outlines(self, cut: Cut) -> list[Outline]:
        """The curves in which a plane meets the object's surface; [] if it passes by."""
        if self._triangles is not None:
            # Only here: a scene without a mesh runs none of it.
            from raywalk.geometry.mesh_section import mesh_chains

            return [
                Outline(points, "closed" if is_closed else "open")
                for points, is_closed in mesh_chains(self._triangles, cut)
            ]
        linear, centre = self._linear, self._centre
        # In canonical coordinates c the plane is normal . c = offset.
        normal, offset = linear.T @ cut.normal, cut.normal @ (cut.origin - centre)
        length = _length(normal)
        if not length > 0:
            return []
        normal, offset = normal / length, offset / length
        reach = 2 * cut.reach / self._smallest
        kind, corners = _canonical(self._canonical, normal, float(offset), reach)
        return [Outline(_placed(each, kind, linear, centre, cut), kind) for each in corners]


def _canonical(
    shape: Canonical, normal: np.ndarray, offset: float, reach: float
) -> tuple[str, list[np.ndarray]]:
    if shape.ends is not None:
        kind = "open" if shape.height is None else "closed"
        halves = _turned(*shape.ends, normal, offset)
        if halves is None:
            return kind, []
        half, other, on_cap = halves
        if kind == "open":
            return kind, list(_without_caps(half, other, on_cap))
        return kind, [np.concatenate([half, other[::-1]])]
    match shape.name:
        case "sphere":
            return "ellipse", _sphere(normal, offset)
        case "box":
            return "closed", _box(normal, offset)
        case "disc":
            return "open", _chord(normal, offset, np.array([0, 0, 1.0]), 1.0)
        case "plane":
            return "open", _chord(normal, offset, np.array([0, 1.0, 0]), reach)
        case "triangle":
            corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)
            return "open", _crossed(corners, [(0, 1), (1, 2), (2, 0)], normal, offset)
    raise TypeError(f"no outline for a {shape.name}")


def _placed(
    corners: np.ndarray, kind: str, linear: np.ndarray, centre: np.ndarray, cut: Cut
) -> np.ndarray:
    world = corners @ linear.T
    if kind != "ellipse":
        return cut.flat(world + centre)
    return np.vstack([cut.flat(world[:1] + centre), world[1:] @ cut.axes.T])


def _sphere(normal: np.ndarray, offset: float) -> list[np.ndarray]:
    if abs(offset) > 1 + TOUCH:
        return []
    u, v = _across(normal)
    radius = np.sqrt(max(0.0, 1 - offset * offset))
    return [np.array([offset * normal, radius * u, radius * v])]


def _box(normal: np.ndarray, offset: float) -> list[np.ndarray]:
    points = np.concatenate([np.empty((0, 3)), *_crossed(BOX_CORNERS, BOX_EDGES, normal, offset)])
    if len(points) < 3:
        return []
    u, v = _across(normal)
    from_middle = points - points.mean(axis=0)
    return [points[np.argsort(np.arctan2(from_middle @ v, from_middle @ u))]]


def _turned(
    low: float, high: float, normal: np.ndarray, offset: float
) -> tuple[np.ndarray, np.ndarray, list[bool]] | None:
    """The section of what a straight line from radius `low` at z = -1 to `high` at z = 1 makes when
    turned about z: both halves (k, 3), mirror images that begin and end together, and whether they
    do so on a cap. None if the plane passes by.

    The mirror plane holds the axis and the normal; in it the section is a line, cut to a trapezoid.
    """
    p, q = math.hypot(normal[0], normal[1]), float(normal[2])
    ax, ay = (normal[0] / p, normal[1] / p) if p > 0 else (1.0, 0.0)
    middle, slope = (low + high) / 2, (high - low) / 2
    # Along the line (x, z) = offset (p, q) + s (-q, p); each limit is start + s * way >= 0.
    x, z = offset * p, offset * q
    radius, widens = middle + slope * z, slope * p
    limits = [(1 - z, -p), (1 + z, p), (radius - x, widens + q), (radius + x, widens - q)]
    if any(start < 0 for start, way in limits if way == 0):
        return None
    begin, starts_on = max((-start / way, k) for k, (start, way) in enumerate(limits) if way > 0)
    end, ends_on = min((-start / way, k) for k, (start, way) in enumerate(limits) if way < 0)
    if begin >= end:
        return None
    (a, b), (c, d) = limits[2:]
    is_straight = abs(a * d - b * c) < 1e-9
    turn = np.linspace(0.0, math.pi, 2 if is_straight else ROUND // 2 + 1)
    s = (begin + end) / 2 - (end - begin) / 2 * np.cos(turn)
    out, up = x - q * s, z + p * s
    side = np.sqrt(np.maximum((a + b * s) * (c + d * s), 0.0))
    half, other = (
        np.column_stack([out * ax - y * ay, out * ay + y * ax, up]) for y in (side, -side)
    )
    return half, other, [starts_on < 2, ends_on < 2]


def _without_caps(half: np.ndarray, other: np.ndarray, on_cap: list[bool]) -> Iterator[np.ndarray]:
    """The parts of a section's border that lie on the side."""
    if all(on_cap):
        yield from (half, other)
    elif on_cap[1]:
        yield np.concatenate([half[::-1], other[1:]])
    else:
        yield np.concatenate([half, other[-2::-1], *([] if on_cap[0] else [half[:1]])])


def _chord(normal: np.ndarray, offset: float, axis: np.ndarray, radius: float) -> list[np.ndarray]:
    """The plane's line in the disc of this radius across an axis through the origin."""
    inward = normal - (normal @ axis) * axis
    length = _length(inward)
    if length < 1e-12 or abs(offset) >= radius * length:
        return []
    nearest = offset / length**2 * inward
    along = _cross(axis, inward / length) * np.sqrt(radius**2 - (offset / length) ** 2)
    return [np.array([nearest - along, nearest + along])]


def _crossed(
    corners: np.ndarray, edges: list[tuple[int, int]], normal: np.ndarray, offset: float
) -> list[np.ndarray]:
    height = corners @ normal - offset
    points = [
        corners[i] + height[i] / (height[i] - height[j]) * (corners[j] - corners[i])
        for i, j in edges
        if (height[i] < 0) != (height[j] < 0)
    ]
    return [np.array(points)] if points else []


def _across(normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two unit vectors perpendicular to a unit one and to each other."""
    u = _cross(normal, AXES[int(np.argmin(np.abs(normal)))])
    u /= _length(u)
    return u, _cross(normal, u)


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of two vectors (3,). numpy's own takes ten times as long to find that they are two."""
    (ax, ay, az), (bx, by, bz) = a.tolist(), b.tolist()
    return np.array([ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx])


def _length(vector: np.ndarray) -> float:
    return math.sqrt(vector @ vector)
