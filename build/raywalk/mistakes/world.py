"""A scene as plain arrays, in the precision that a program calculates in."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import DTypeLike

from raywalk.errors import SourceError, SourceErrors
from raywalk.mistakes.vectors import column, cross, turned, unit
from raywalk.scene.model import Checker, Material, Scene, SceneObject
from raywalk.scene.placement import checker_axes, is_unmoved, placement
from raywalk.scene.shapes import Mesh, Plane, Sphere

SOLIDS = ("sphere", "ellipsoid", "box", "cylinder")  # a line is inside of each in one interval
FLAT = ("plane", "disc", "triangle")  # a line crosses each once


@dataclass(frozen=True, eq=False)
class Body:
    """One object: world = to_world @ own + centre, where `own` is a unit shape (scene/shapes.py).

    kind: "sphere" is one that is met in the world, by its centre and radius; a stretched or turned
    one is an "ellipsoid", met in its own coordinates, where it is the unit sphere.
    """

    number: int  # in the scene
    kind: str
    centre: np.ndarray  # (3, 1)
    to_world: np.ndarray  # (3, 3)
    to_own: np.ndarray  # (3, 3), its inverse
    radius: float  # of a sphere
    tip: float  # radius of a cylinder's or cone's other end: 1 for a cylinder
    material: int
    squares: Squares | None
    is_clear: bool  # light goes through

    @property
    def is_solid(self) -> bool:
        return self.kind in SOLIDS

    def own_point(self, point: np.ndarray) -> np.ndarray:
        """(3, n) world points in the body's own coordinates."""
        return turned(self.to_own, point - self.centre)

    def own_direction(self, direction: np.ndarray) -> np.ndarray:
        """(3, n) world directions likewise; not unit there, so t stays the world's."""
        return turned(self.to_own, direction)


@dataclass(frozen=True, eq=False)
class Squares:
    """A plane's checker, in its own coordinates: cells along x and along z, or against it."""

    size: float
    sense: float  # 1, or -1 where the second axis is -z
    material: int  # of the odd ones


@dataclass(frozen=True, eq=False)
class Surfaces:
    """Materials, a row each. The last one is nothing: what a ray that meets nothing (-1) shows."""

    ambient: np.ndarray  # (m, 3)
    diffuse: np.ndarray  # (m, 3)
    specular: np.ndarray  # (m, 3)
    shininess: np.ndarray  # (m,)


class Optics(NamedTuple):
    """What sends rays on: of materials, likewise, and of objects."""

    reflect: np.ndarray  # (m,)
    transmit: np.ndarray  # (m,)
    fresnel: np.ndarray  # (m,) bool
    ior_of: np.ndarray  # (objects,)


@dataclass(frozen=True, eq=False)
class World:
    """What is traced."""

    scene: Scene
    bodies: tuple[Body, ...]  # by number
    surfaces: Surfaces
    optics: Optics


def asked_in_turn(bodies: Iterable[Body]) -> list[Body]:
    """Opaque bodies first, then in the scene's order: of hits at one distance the first counts (a
    glass that stands on a floor does not let light through it)."""
    return sorted(bodies, key=lambda body: body.is_clear)


def world_of(scene: Scene, precision: DTypeLike = np.float64) -> World:
    """Raises SourceErrors that name what this tracer leaves out."""
    refuse_left_out(scene)
    bodies = tuple(body_of(scene, k, obj, precision) for k, obj in enumerate(scene.objects))
    return World(scene, bodies, surfaces_of(scene, precision), optics_of(scene, precision))


def refuse_left_out(scene: Scene) -> None:
    """Raises SourceErrors that name every object that this tracer has no rule for."""
    problems = [
        SourceError(scene.path, f"objects[{k}]", f'"{obj.name}" {why}: not part of this tracer')
        for k, obj in enumerate(scene.objects)
        for why in left_out(obj)
    ]
    if problems:
        raise SourceErrors(problems)


def left_out(obj: SceneObject) -> list[str]:
    """What an object has that this tracer leaves out."""
    found = ["is a mesh"] if isinstance(obj.shape, Mesh) else []
    is_painted = obj.base is not None and (obj.base.colours or obj.base.texture is not None)
    return [*found, "has a texture or colours of its own"] if is_painted else found


def body_of(scene: Scene, number: int, obj: SceneObject, precision: DTypeLike) -> Body:
    """One object of the scene."""
    to_world, centre = placement(obj)
    name = obj.shape.canonical.name
    is_sphere = isinstance(obj.shape, Sphere) and is_unmoved(obj)
    return Body(
        number=number,
        kind="ellipsoid" if name == "sphere" and not is_sphere else name,
        centre=column(centre).astype(precision),
        to_world=to_world.astype(precision),
        to_own=np.linalg.inv(to_world).astype(precision),
        radius=obj.shape.radius if isinstance(obj.shape, Sphere) else 0.0,
        tip=(obj.shape.canonical.ends or (1.0, 1.0))[0],
        material=obj.material,
        squares=squares_of(obj.checker, obj.shape) if isinstance(obj.shape, Plane) else None,
        is_clear=scene.materials[obj.material].transmit > 0,
    )


def squares_of(checker: Checker | None, plane: Plane) -> Squares | None:
    """A plane's checker, if it has one."""
    if checker is None:
        return None
    normal = np.array(plane.normal, float)
    u, v = checker_axes(normal)
    return Squares(checker.size, float(np.sign(v @ cross(u, normal))), checker.material)


def surfaces_of(scene: Scene, precision: DTypeLike) -> Surfaces:
    """The scene's materials as columns."""
    rows = _column_of(scene, precision)
    return Surfaces(rows("ambient"), rows("diffuse"), rows("specular"), rows("shininess"))


def optics_of(scene: Scene, precision: DTypeLike) -> Optics:
    """The same of what sends rays on."""
    rows, material = _column_of(scene, precision), [obj.material for obj in scene.objects]
    ior_of = rows("ior")[np.array(material, int)]
    return Optics(rows("reflect"), rows("transmit"), rows("fresnel") > 0, ior_of)


def _column_of(scene: Scene, precision: DTypeLike) -> Callable[[str], np.ndarray]:
    nothing = Material("nothing")
    return lambda name: np.array([getattr(m, name) for m in (*scene.materials, nothing)], precision)


def plane_normal(body: Body) -> np.ndarray:
    """(3, 1) unit normal of a plane in the world: of what is y = 0 in its own coordinates."""
    return column(unit(body.to_own[1]))


def holding(bodies: list[Body], point: np.ndarray) -> list[Body]:
    """Those that a point (3, 1) is inside of, the largest first."""
    around = [body for body in bodies if body.is_solid and is_inside(body, point)]
    return sorted(around, key=lambda body: -abs(float(np.linalg.det(body.to_world))))


def is_inside(body: Body, point: np.ndarray) -> bool:
    """Whether a solid holds a point (3, 1)."""
    x, y, z = np.abs(body.own_point(point))[:, 0]
    if body.kind in ("sphere", "ellipsoid"):
        return bool(x * x + y * y + z * z < 1)
    if body.kind == "box":
        return bool(max(x, y, z) < 1)
    up = body.own_point(point)[2, 0]
    width = body.tip + 0.5 * (1 - body.tip) * (1 + up)
    return bool(z < 1 and x * x + y * y < width * width)
