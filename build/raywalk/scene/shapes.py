"""Shapes: their numbers as authors give them, and what each is the affine image of.

A class a shape, found by its name in lower case, which is the TOML's `type`. Its fields are those
of its table in schema_objects.py. Everything else about a shape is said of its canonical one:
the tracer, outlines and the viewer know only these and where they stand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from decimal import Decimal
from functools import cache, partial
from math import dist, hypot, inf, pi, sqrt
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from raywalk.models.piece import Piece
from raywalk.scene.exact import EYE, across, axis_across, exact, rotation, unit
from raywalk.scene.wording import plain

Triple = tuple[float, float, float]
Placement = tuple[np.ndarray, np.ndarray]  # (3, 3) linear part, (3,) centre; Decimals
Flaw = tuple[str, str, str]  # the key, what is wrong with it, a hint
# A triangle whose height is this share of its longest side is a line to float64.
THINNEST = 1e-14
# Degrees: a prism of ten sides (36) still is a pipe, a chamfer and one of eight (45) have edges.
CREASE = 40.0


class Canonical(NamedTuple):
    """A shape in its own coordinates, which an affine map takes into the world."""

    name: str  # what kernels and outlines are chosen by
    reach: float = inf  # radius of a sphere round the origin that holds it
    volume: float = 0.0  # of what is closed
    height: Callable[..., Any] | None = None  # of what is closed: of (x, y, z), < 0 inside
    # Radii at z = -1 and 1 of what a straight line makes that is turned about z.
    ends: tuple[float, float] | None = None


# The geometry's kernels are compiled from these.
def sphere_height(x, y, z):  # type: ignore[no-untyped-def]
    return x * x + y * y + z * z - 1.0


def box_height(x, y, z):  # type: ignore[no-untyped-def]
    return max(abs(x), max(abs(y), abs(z))) - 1.0


def side_height(x, y, z, tip):  # type: ignore[no-untyped-def]
    """Of a cylinder's or cone's side."""
    if tip == 1.0:
        return x * x + y * y - 1.0
    return 2.0 * (sqrt(x * x + y * y) - (tip + 0.5 * (1.0 - tip) * (1.0 + z)))


def between_caps(side, z):  # type: ignore[no-untyped-def]
    """Of what is cut off at z = -1 and 1, from its side's height."""
    return max(side, abs(z) - 1.0)


def cylinder_height(x, y, z, tip=1.0):  # type: ignore[no-untyped-def]
    return between_caps(side_height(x, y, z, tip), z)


def plane_height(x, y, z):  # type: ignore[no-untyped-def]
    return y


SPHERE = Canonical("sphere", 1.0, 4.0 / 3.0 * pi, sphere_height)  # of radius 1
BOX = Canonical("box", sqrt(3.0), 8.0, box_height)  # |x|, |y|, |z| <= 1
# x^2 + y^2 <= w^2, |z| <= 1 with w = 1, or of a cone rising from ends[0] to 1
CYLINDER = Canonical("cylinder", sqrt(2.0), 2.0 * pi, cylinder_height, (1.0, 1.0))
TUBE = Canonical("tube", sqrt(2.0), ends=(1.0, 1.0))  # the same without its ends
PLANE = Canonical("plane", inf, inf, plane_height)  # y = 0 facing +y, the half-space behind it
DISC = Canonical("disc", 1.0)  # z = 0, of radius 1, facing +z
TRIANGLE = Canonical("triangle", 1.0)  # (0,0,0) (1,0,0) (0,1,0)
MESH = Canonical("mesh")  # in its file's coordinates; closed or not, as its triangles are
# Those that the viewer draws: a tube is a cylinder that is open.
DRAWN = tuple(each.name for each in (SPHERE, BOX, CYLINDER, PLANE, DISC, TRIANGLE, MESH))


class Shape:
    """What every shape answers."""

    @property
    def canonical(self) -> Canonical:
        raise NotImplementedError

    def placement(self) -> Placement:
        """Where the canonical shape stands, before the object's transform."""
        raise NotImplementedError

    def holder(self) -> tuple[Triple, float] | None:
        """Centre and radius of a sphere that holds what is closed, before the object's transform:
        roomy, but quick to find. None: not known."""
        return None

    def flaws(self) -> Iterator[Flaw]:
        """Why the numbers, each allowed by itself, make no shape."""
        yield from ()

    def drawn(self) -> dict[str, Any]:
        """What the viewer draws: a shape of viewer/state/shapes.ts."""
        name = self.canonical.name
        kind = {"type": "cylinder", "open": True} if name == "tube" else {"type": name}
        tip = (self.canonical.ends or (1.0, 1.0))[0]
        return kind if tip == 1.0 else kind | {"tip": tip}

    @property
    def word(self) -> str:
        """The TOML's `type`."""
        return type(self).__name__.lower()

    @property
    def title(self) -> str:
        """What an error calls it."""
        return self.word if getattr(self, "capped", True) else f"{self.word} without caps"


@dataclass(frozen=True)
class Sphere(Shape):
    center: Triple
    radius: float

    canonical = SPHERE

    def placement(self) -> Placement:
        return Decimal(self.radius) * EYE, exact(self.center)

    def holder(self) -> tuple[Triple, float]:
        return self.center, self.radius


@dataclass(frozen=True)
class Ellipsoid(Shape):
    center: Triple
    radii: Triple
    rotation: Triple = (0.0, 0.0, 0.0)  # degrees about x, then y, then z

    canonical = SPHERE

    def placement(self) -> Placement:
        if not any(self.rotation):
            return EYE * exact(self.radii), exact(self.center)
        about_x, about_y, about_z = (rotation(EYE[k], self.rotation[k]) for k in range(3))
        return about_z @ about_y @ about_x * exact(self.radii), exact(self.center)

    def holder(self) -> tuple[Triple, float]:
        return self.center, max(self.radii)


@dataclass(frozen=True)
class Plane(Shape):
    """Infinite; its inside is the half-space behind the normal."""

    point: Triple
    normal: Triple

    canonical = PLANE

    def placement(self) -> Placement:
        n = unit(exact(self.normal))
        u = axis_across(n)
        return np.column_stack([u, n, across(u, n)]), exact(self.point)

    def flaws(self) -> Iterator[Flaw]:
        yield from _without_direction(self.normal)


@dataclass(frozen=True)
class Cylinder(Shape):
    start: Triple  # centre of one end
    end: Triple  # centre of the other
    radius: float
    capped: bool = True

    @property
    def canonical(self) -> Canonical:
        return CYLINDER if self.capped else TUBE

    def placement(self) -> Placement:
        return _between(self.start, self.end, self.radius)

    def holder(self) -> tuple[Triple, float]:
        return self.start, dist(self.start, self.end) + self.radius

    def flaws(self) -> Iterator[Flaw]:
        yield from _without_length(self)


@dataclass(frozen=True)
class Cone(Shape):
    """A whole one, or what is left of one whose tip is cut off. With equal radii it is a cylinder,
    to the last digit. At the tip itself, where no plane is tangent, the normal is the axis."""

    start: Triple  # centre of one end
    end: Triple  # the tip, or centre of the other end
    radius: float  # at the start
    end_radius: float = 0.0
    capped: bool = True

    @property
    def canonical(self) -> Canonical:
        small, big = sorted((self.radius, self.end_radius))
        return _cut_cone(small / big, self.capped)

    def placement(self) -> Placement:
        """The canonical one is wider at z = 1."""
        if self.radius > self.end_radius:
            return _between(self.end, self.start, self.radius)
        return _between(self.start, self.end, self.end_radius)

    def holder(self) -> tuple[Triple, float]:
        return self.start, dist(self.start, self.end) + max(self.radius, self.end_radius)

    def flaws(self) -> Iterator[Flaw]:
        yield from _without_length(self)


@dataclass(frozen=True)
class Box(Shape):
    minimum: Triple
    maximum: Triple

    canonical = BOX

    def placement(self) -> Placement:
        low, high = exact(self.minimum), exact(self.maximum)
        return EYE * ((high - low) / 2), (low + high) / 2

    def holder(self) -> tuple[Triple, float]:
        return self.minimum, dist(self.minimum, self.maximum)

    def flaws(self) -> Iterator[Flaw]:
        for axis, low, high in zip("xyz", self.minimum, self.maximum, strict=True):
            if low >= high:
                said = f"{axis} = {plain(high)} is not above the minimum's {plain(low)}"
                yield "maximum", said, ""


@dataclass(frozen=True)
class Disc(Shape):
    center: Triple
    normal: Triple
    radius: float

    canonical = DISC

    def placement(self) -> Placement:
        n = unit(exact(self.normal))
        u = axis_across(n)
        frame = np.column_stack([u, across(n, u), n])
        return Decimal(self.radius) * frame, exact(self.center)

    def flaws(self) -> Iterator[Flaw]:
        yield from _without_direction(self.normal)


@dataclass(frozen=True)
class Triangle(Shape):
    a: Triple
    b: Triple
    c: Triple

    canonical = TRIANGLE

    def placement(self) -> Placement:
        a, b, c = exact([self.a, self.b, self.c])
        u, v = b - a, c - a
        return np.array([u, v, across(u, v)]).T, a

    def flaws(self) -> Iterator[Flaw]:
        ends = (self.a, self.b), (self.a, self.c), (self.b, self.c)
        sides = [[y - x for x, y in zip(*pair, strict=True)] for pair in ends]
        longest = max(abs(x) for side in sides for x in side)
        if longest > 0:
            # First: squares of 1e-200 would vanish.
            sides = [[x / longest for x in side] for side in sides]
            (ax, ay, az), (bx, by, bz) = sides[:2]
            area = hypot(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)
            if area > THINNEST * max(sum(x * x for x in side) for side in sides):
                return
        yield "", "a, b and c lie on one line: the triangle has no area", ""


@dataclass(frozen=True)
class Mesh(Shape):
    """A triangle mesh in a file; `model` is its name in models.toml or its file name."""

    model: str
    path: Path
    # Normals interpolated from the vertices, else one per triangle; None: as its format has it.
    smooth: bool | None = None
    subdivide: int = 0  # rounds of Loop subdivision before tracing, 0..3
    crease: float = CREASE  # degrees: sharper edges stay sharp where normals are averaged
    weld: float | None = None  # corners nearer than this share of the size are one; None: 1e-6
    piece: Piece | None = None  # only what has its label; None: the whole file
    beside: tuple[Path, ...] = ()  # files that it needs: materials, buffers

    canonical = MESH

    def placement(self) -> Placement:
        return EYE, exact((0.0, 0.0, 0.0))


SHAPES: dict[str, type[Any]] = {each.__name__.lower(): each for each in Shape.__subclasses__()}


def _without_direction(normal: Triple) -> Iterator[Flaw]:
    if not any(normal):
        yield "normal", f"{plain(normal)} has no direction", "a floor has [0, 1, 0]"


@cache
def _cut_cone(tip: float, capped: bool) -> Canonical:
    """Kept: it is asked for six times an object, of thousands that are alike."""
    if not capped:
        return TUBE._replace(ends=(tip, 1.0))
    volume = CYLINDER.volume * (1.0 + tip + tip * tip) / 3.0
    return CYLINDER._replace(
        ends=(tip, 1.0), volume=volume, height=partial(cylinder_height, tip=tip)
    )


def _between(start: Triple, end: Triple, radius: float) -> Placement:
    """z = -1 at the start and 1 at the end, where 1 across is the radius."""
    foot = exact(start)
    half = (exact(end) - foot) / 2
    axis = unit(half)
    u = axis_across(axis)
    wide = Decimal(radius)
    return np.column_stack([wide * u, wide * across(axis, u), half]), foot + half


def _without_length(shape: Cylinder | Cone) -> Iterator[Flaw]:
    if shape.start == shape.end:
        yield "end", f"{plain(shape.end)} is also the start: the {shape.word} has no length", ""
