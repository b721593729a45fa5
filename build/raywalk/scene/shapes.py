"""From the TOML of one object to its shape, refused where it has no extent."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import numpy as np

from raywalk.scene.model import (
    Box,
    Cylinder,
    Disc,
    Ellipsoid,
    Mesh,
    Plane,
    Shape,
    Sphere,
    Triangle,
    Triple,
)
from raywalk.scene.models import Models, mesh_file
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema_objects import (
    BoxTable,
    CylinderTable,
    DiscTable,
    EllipsoidTable,
    MeshTable,
    ObjectTable,
    PlaneTable,
    SphereTable,
    TriangleTable,
)
from raywalk.scene.wording import plain

# A triangle whose height is this share of its longest side is a line to float64.
THINNEST = 1e-14

Note = Callable[..., None]
Flat = TypeVar("Flat", Plane, Disc)


def shape_of(table: ObjectTable, models: Models, at: Location, problems: Problems) -> Shape | None:
    """The object's shape; None, with the problem noted, if it has no extent or no file."""

    def note(key: str, message: str, hint: str = "") -> None:
        problems.add((*at, key) if key else at, message, hint=hint)

    match table:
        case SphereTable():
            return Sphere(table.center, table.radius)
        case EllipsoidTable():
            return Ellipsoid(table.center, table.radii, table.rotation)
        case PlaneTable():
            return _facing(table.normal, Plane(table.point, table.normal), note)
        case DiscTable():
            disc = Disc(table.center, table.normal, table.radius)
            return _facing(table.normal, disc, note)
        case CylinderTable():
            return _cylinder(table, note)
        case BoxTable():
            return _box(table, note)
        case TriangleTable():
            return _triangle(table, note)
        case MeshTable():
            found = mesh_file(table, models, at, problems)
            return Mesh(*found, table.smooth, table.subdivide) if found else None
    raise TypeError(f"no shape for {type(table).__name__}")


def _facing(normal: Triple, shape: Flat, note: Note) -> Flat | None:
    if any(normal):
        return shape
    note("normal", f"{plain(normal)} has no direction", "a floor has [0, 1, 0]")
    return None


def _cylinder(table: CylinderTable, note: Note) -> Cylinder | None:
    if table.start == table.end:
        note("end", f"{plain(table.end)} is also the start: the cylinder has no length")
        return None
    return Cylinder(table.start, table.end, table.radius, table.capped)


def _box(table: BoxTable, note: Note) -> Box | None:
    flat = [k for k in range(3) if table.minimum[k] >= table.maximum[k]]
    for k in flat:
        note(
            "maximum",
            f"{'xyz'[k]} = {plain(table.maximum[k])} is not above the minimum's "
            f"{plain(table.minimum[k])}",
        )
    return None if flat else Box(table.minimum, table.maximum)


def _triangle(table: TriangleTable, note: Note) -> Triangle | None:
    a, b, c = (np.array(corner) for corner in (table.a, table.b, table.c))
    sides = np.array([b - a, c - a, c - b])
    longest = np.abs(sides).max()
    if longest > 0:
        sides = sides / longest  # first: squares of 1e-200 would vanish
        area = np.linalg.norm(np.cross(sides[0], sides[1]))
        if area > THINNEST * (sides**2).sum(axis=1).max():
            return Triangle(table.a, table.b, table.c)
    note("", "a, b and c lie on one line: the triangle has no area")
    return None
