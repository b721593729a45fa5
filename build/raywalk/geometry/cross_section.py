"""Where a plane cuts an object: outlines for a flat drawing of the rays in that plane."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from raywalk.scene.model import (
    Box,
    Cylinder,
    Disc,
    Ellipsoid,
    Plane,
    SceneObject,
    Sphere,
    Triangle,
)
from raywalk.scene.placement import placement

if TYPE_CHECKING:
    from raywalk.geometry.mesh_file import Triangles

ROUND = 96  # corners of a cylinder's outline
TOUCH = 1e-12  # radii: a plane this near to touching a sphere shows the point that its rays meet
BOX_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
BOX_EDGES = [(i, j) for i in range(8) for j in range(i) if bin(i ^ j).count("1") == 1]


@dataclass(frozen=True, eq=False)
class Cut:
    """A plane with coordinates on it: world = origin + x across + y up."""

    origin: np.ndarray  # (3,) world
    axes: np.ndarray  # (2, 3) rows x, y: unit, perpendicular
    reach: float  # world units from the origin: infinite planes end there

    @property
    def normal(self) -> np.ndarray:
        """(3,) unit."""
        return np.cross(self.axes[0], self.axes[1])

    def flat(self, points: np.ndarray) -> np.ndarray:
        """(..., 2) coordinates of world points, seen along the normal."""
        return np.asarray((points - self.origin) @ self.axes.T)


@dataclass(frozen=True, eq=False)
class Outline:
    """One curve in a cut's coordinates: a polygon, a chain, or an ellipse."""

    points: np.ndarray  # (k, 2); of an ellipse its centre and two conjugate half axes, (3, 2)
    kind: str  # "closed", "open" or "ellipse"


def outlines(obj: SceneObject, cut: Cut, triangles: Triangles | None = None) -> list[Outline]:
    """The curves in which a plane meets an object's surface; [] if it passes by.

    triangles: of a mesh object.
    """
    if triangles is not None:
        return list(_mesh_outlines(triangles, cut))
    linear, centre = placement(obj)
    # In canonical coordinates c the plane is normal . c = offset.
    normal, offset = linear.T @ cut.normal, cut.normal @ (cut.origin - centre)
    length = float(np.linalg.norm(normal))
    if not length > 0:
        return []
    normal, offset = normal / length, offset / length
    kind, corners = _canonical(obj, normal, float(offset), 2 * cut.reach / _smallest_scale(linear))
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
    kept = []
    for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
        above = [side * start[2] - 1, side * end[2] - 1]
        if above[0] <= 0:
            kept.append(start)
        if above[0] * above[1] < 0:
            crossing = start + above[0] / (above[0] - above[1]) * (end - start)
            crossing[2] = side  # exactly: that is how an edge on a cap is known
            kept.append(crossing)
    return np.array(kept).reshape(-1, 3)


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
    length = float(np.linalg.norm(inward))
    if length < 1e-12 or abs(offset) >= radius * length:
        return []
    nearest = offset / length**2 * inward
    along = np.cross(axis, inward / length) * np.sqrt(radius**2 - (offset / length) ** 2)
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


def _mesh_outlines(triangles: Triangles, cut: Cut) -> Iterator[Outline]:
    """Chains of the lines in which triangles meet the plane, each begun once."""
    corners, faces = triangles.vertices, triangles.faces
    height = corners @ cut.normal - cut.normal @ (cut.origin - triangles.centre)
    above = height >= 0
    cut_faces = faces[above[faces].any(axis=1) & ~above[faces].all(axis=1)]
    if not len(cut_faces):
        return
    edges = np.sort(cut_faces[:, [[0, 1], [1, 2], [2, 0]]], axis=2)
    crossed = above[edges[..., 0]] != above[edges[..., 1]]  # (f, 3), two a face
    ends, place = np.unique(edges[crossed], axis=0, return_inverse=True)
    low, high = ends[:, 0], ends[:, 1]
    share = height[low] / (height[low] - height[high])
    points = corners[low] + share[:, None] * (corners[high] - corners[low]) + triangles.centre
    flat = cut.flat(points)
    for chain in _chains(place.reshape(-1, 2), len(ends)):
        is_closed = chain[0] == chain[-1] and len(chain) > 3
        yield Outline(flat[chain[:-1] if is_closed else chain], "closed" if is_closed else "open")


def _chains(links: np.ndarray, count: int) -> Iterator[list[int]]:
    """Walks along links between `count` points; chains that have an end come first."""
    beside: list[list[int]] = [[] for _ in range(count)]
    for a, b in links.tolist():
        beside[a].append(b)
        beside[b].append(a)
    starts = [k for k in range(count) if len(beside[k]) == 1]
    for start in [*starts, *range(count)]:
        chain = [start]
        while beside[chain[-1]]:
            following = beside[chain[-1]].pop()
            beside[following].remove(chain[-1])
            chain.append(following)
        if len(chain) > 1:
            yield chain


def _across(normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Two unit vectors perpendicular to a unit one and to each other."""
    least = np.eye(3)[int(np.argmin(np.abs(normal)))]
    u = np.cross(normal, least)
    u /= np.linalg.norm(u)
    return u, np.cross(normal, u)


def _smallest_scale(linear: np.ndarray) -> float:
    return float(np.linalg.svd(linear, compute_uv=False).min())
