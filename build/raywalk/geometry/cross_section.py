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
from raywalk.scene.shapes import Box, Cylinder, Disc, Ellipsoid, Plane, Sphere, Triangle

if TYPE_CHECKING:
    from raywalk.geometry.mesh_file import Triangles

ROUND = 96  # corners of a cylinder's outline
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
        self._object, self._triangles = obj, triangles
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
        kind, corners = _canonical(self._object, normal, float(offset), reach)
        return [Outline(_placed(each, kind, linear, centre, cut), kind) for each in corners]


def _canonical(
    obj: SceneObject, normal: np.ndarray, offset: float, reach: float
) -> tuple[str, list[np.ndarray]]:
    match obj.shape:
        case Sphere() | Ellipsoid():
            return "ellipse", _sphere(normal, offset)
        case Box():
            return "closed", _box(normal, offset)
        case Cylinder(capped=True):
            return "closed", [section for section in [_cylinder(normal, offset)] if len(section)]
        case Cylinder():
            return "open", list(_without_caps(_cylinder(normal, offset)))
        case Disc():
            return "open", _chord(normal, offset, np.array([0, 0, 1.0]), 1.0)
        case Plane():
            return "open", _chord(normal, offset, np.array([0, 1.0, 0]), reach)
        case Triangle():
            corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)
            return "open", _crossed(corners, [(0, 1), (1, 2), (2, 0)], normal, offset)
    raise TypeError(f"no outline for {type(obj.shape).__name__}")


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


def _cylinder(normal: np.ndarray, offset: float) -> np.ndarray:
    """Corners of the section of x^2 + y^2 <= 1, |z| <= 1; (0, 3) if there is none."""
    if abs(normal[2]) < 1e-9:  # along the axis: a rectangle
        chord = _chord(normal, offset, np.array([0, 0, 1.0]), 1.0)
        if not chord:
            return np.empty((0, 3))
        up = np.array([0, 0, 1.0])
        return np.array([chord[0][0] - up, chord[0][1] - up, chord[0][1] + up, chord[0][0] + up])
    angle = 2 * np.pi * np.arange(ROUND) / ROUND
    x, y = np.cos(angle), np.sin(angle)
    ring = np.column_stack([x, y, (offset - normal[0] * x - normal[1] * y) / normal[2]])
    return _kept_below(_kept_below(ring, 1.0), -1.0)


def _kept_below(corners: np.ndarray, side: float) -> np.ndarray:
    """A polygon cut at side * z <= 1 (Sutherland, Hodgman 1974)."""
    above = side * corners[:, 2] - 1
    if (above <= 0).all():
        return corners
    end, above_end = np.roll(corners, -1, axis=0), np.roll(above, -1)
    crosses = above * above_end < 0
    share = above[crosses] / (above[crosses] - above_end[crosses])
    crossing = corners[crosses] + share[:, None] * (end[crosses] - corners[crosses])
    crossing[:, 2] = side  # exactly: that is how an edge on a cap is known
    # Each corner's crossing comes behind it.
    both = np.concatenate([corners[above <= 0], crossing])
    place = np.concatenate([np.flatnonzero(above <= 0), np.flatnonzero(crosses) + 0.5])
    return np.asarray(both[np.argsort(place)])


def _without_caps(section: np.ndarray) -> Iterator[np.ndarray]:
    """The parts of a section's border that lie on the tube."""
    if not len(section):
        return
    on_cap = np.abs(section[:, 2]) >= 1
    is_cap_edge = on_cap & np.roll(on_cap, -1)
    if not is_cap_edge.any():
        yield np.vstack([section, section[:1]])
        return
    begin = int(np.flatnonzero(is_cap_edge)[0]) + 1
    section, is_cap_edge = np.roll(section, -begin, axis=0), np.roll(is_cap_edge, -begin)
    for part in np.split(section, np.flatnonzero(is_cap_edge) + 1):
        if len(part) > 1:
            yield part


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
