"""Where each canonical shape stands in the world: linear part and centre.

Canonical shapes: sphere of radius 1; plane y = 0 facing +y; cylinder
x^2 + y^2 <= 1, |z| <= 1; box |x|, |y|, |z| <= 1; disc z = 0 of radius 1 facing +z;
triangle (0,0,0) (1,0,0) (0,1,0); a mesh in its file's coordinates. The tracer and
the viewer place the same shapes by the same numbers.
"""

from __future__ import annotations

from decimal import Decimal, localcontext
from typing import Any

import numpy as np

from raywalk.scene.exact import DIGITS, cosine, rounded, sine
from raywalk.scene.model import (
    Box,
    Cylinder,
    Disc,
    Ellipsoid,
    Mesh,
    Plane,
    SceneObject,
    Shape,
    Sphere,
    Triangle,
)


def placement(obj: SceneObject) -> tuple[np.ndarray, np.ndarray]:
    """(3, 3) linear part and (3,) centre with world = linear @ canonical + centre.

    The two are kept apart so that a ray can be moved next to the shape by one
    subtraction before anything else is rounded, however far out the scene lies.
    """
    linear, centre = exact_placement(obj)
    return rounded(linear), rounded(centre)


def exact_placement(obj: SceneObject) -> tuple[np.ndarray, np.ndarray]:
    """The same as Decimals of 50 digits: the numbers of the scene are taken as exact, so that
    what is made of them (an inverse, an axis, a sum) is rounded once and not at every step."""
    with localcontext(prec=DIGITS):
        linear, centre = _shape_placement(obj.shape)
        outer = _exact(obj.transform)
        return outer[:3, :3] @ linear, outer[:3, :3] @ centre + outer[:3, 3]


def checker_axes(normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The two unit axes along which a plane's checker is measured; x and z on a floor."""
    with localcontext(prec=DIGITS):
        u, v = _axes(_unit(_exact(normal)))
    return rounded(u), rounded(v)


def rotation_matrix(axis: np.ndarray, degrees: float) -> np.ndarray:
    """(3, 3) right-handed rotation about an axis through the origin (Rodrigues)."""
    with localcontext(prec=DIGITS):
        return rounded(_rotation(_unit(_exact(axis)), degrees))


def _rotation(axis: np.ndarray, degrees: float) -> np.ndarray:
    x, y, z = axis
    none = Decimal(0)
    cross = np.array([[none, -z, y], [z, none, -x], [-y, x, none]])
    return _EYE + sine(degrees) * cross + (1 - cosine(degrees)) * (cross @ cross)


def _shape_placement(shape: Shape) -> tuple[np.ndarray, np.ndarray]:
    match shape:
        case Sphere():
            return Decimal(shape.radius) * _EYE, _exact(shape.center)
        case Ellipsoid():
            return _euler(shape.rotation) * _exact(shape.radii), _exact(shape.center)
        case Plane():
            n = _unit(_exact(shape.normal))
            u, _ = _axes(n)
            return np.column_stack([u, n, np.cross(u, n)]), _exact(shape.point)
        case Cylinder():
            return _cylinder_placement(shape)
        case Box():
            low, high = _exact(shape.minimum), _exact(shape.maximum)
            return _EYE * ((high - low) / 2), (low + high) / 2
        case Disc():
            n = _unit(_exact(shape.normal))
            u, _ = _axes(n)
            frame = np.column_stack([u, np.cross(n, u), n])
            return Decimal(shape.radius) * frame, _exact(shape.center)
        case Triangle():
            a, b, c = _exact(shape.a), _exact(shape.b), _exact(shape.c)
            return np.column_stack([b - a, c - a, np.cross(b - a, c - a)]), a
        case Mesh():
            return _EYE, _exact((0.0, 0.0, 0.0))
    raise TypeError(f"no placement for {type(shape).__name__}")


def _cylinder_placement(shape: Cylinder) -> tuple[np.ndarray, np.ndarray]:
    start, end = _exact(shape.start), _exact(shape.end)
    half = (end - start) / 2
    axis, radius = _unit(half), Decimal(shape.radius)
    u, _ = _axes(axis)
    linear = np.column_stack([radius * u, radius * np.cross(axis, u), half])
    return linear, start + half


def _euler(degrees: tuple[float, float, float]) -> np.ndarray:
    about_x, about_y, about_z = (_rotation(_EYE[k], degrees[k]) for k in range(3))
    return about_z @ about_y @ about_x


def _axes(n: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """checker_axes of a unit vector."""
    first, second = (axis for axis in range(3) if axis != int(np.argmax(np.abs(n))))
    u = _unit(_perpendicular(_EYE[first], n))
    v = _unit(_perpendicular(_perpendicular(_EYE[second], n), u))
    return u, v


def _exact(values: Any) -> np.ndarray:
    """An array of Decimals that are the given float64 numbers to the last digit."""
    given = np.asarray(values, float)
    exact = np.array([Decimal(x) for x in given.ravel().tolist()], object)
    return exact.reshape(given.shape)


_EYE = _exact(np.eye(3))


def _unit(vector: np.ndarray) -> np.ndarray:
    return np.asarray(vector / (vector @ vector).sqrt())


def _perpendicular(vector: np.ndarray, to: np.ndarray) -> np.ndarray:
    return np.asarray(vector - (vector @ to) * to)
