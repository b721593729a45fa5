"""Where each canonical shape stands in the world: linear part and centre.

Canonical shapes: sphere of radius 1; plane y = 0 facing +y; cylinder
x^2 + y^2 <= 1, |z| <= 1; box |x|, |y|, |z| <= 1; disc z = 0 of radius 1 facing +z;
triangle (0,0,0) (1,0,0) (0,1,0); a mesh in its file's coordinates. The tracer and
the viewer place the same shapes by the same numbers.
"""

from __future__ import annotations

import numpy as np

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
    linear, centre = _shape_placement(obj.shape)
    outer = obj.transform[:3, :3]
    return outer @ linear, outer @ centre + obj.transform[:3, 3]


def checker_axes(normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The two unit axes along which a plane's checker is measured; x and z on a floor."""
    n = _unit(np.asarray(normal, float))
    first, second = (axis for axis in range(3) if axis != int(np.argmax(np.abs(n))))
    u = _unit(_perpendicular(np.eye(3)[first], n))
    v = _unit(_perpendicular(_perpendicular(np.eye(3)[second], n), u))
    return u, v


def rotation_matrix(axis: np.ndarray, degrees: float) -> np.ndarray:
    """(3, 3) right-handed rotation about an axis through the origin (Rodrigues)."""
    x, y, z = _unit(np.asarray(axis, float))
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = np.radians(degrees)
    return np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * (cross @ cross)


def _shape_placement(shape: Shape) -> tuple[np.ndarray, np.ndarray]:
    match shape:
        case Sphere():
            return shape.radius * np.eye(3), _vector(shape.center)
        case Ellipsoid():
            return _euler(shape.rotation) @ np.diag(shape.radii), _vector(shape.center)
        case Plane():
            n = _unit(_vector(shape.normal))
            u, _ = checker_axes(n)
            return np.column_stack([u, n, np.cross(u, n)]), _vector(shape.point)
        case Cylinder():
            return _cylinder_placement(shape)
        case Box():
            low, high = _vector(shape.minimum), _vector(shape.maximum)
            return np.diag((high - low) / 2), (low + high) / 2
        case Disc():
            n = _unit(_vector(shape.normal))
            u, _ = checker_axes(n)
            frame = np.column_stack([u, np.cross(n, u), n])
            return shape.radius * frame, _vector(shape.center)
        case Triangle():
            a, b, c = _vector(shape.a), _vector(shape.b), _vector(shape.c)
            return np.column_stack([b - a, c - a, np.cross(b - a, c - a)]), a
        case Mesh():
            return np.eye(3), np.zeros(3)
    raise TypeError(f"no placement for {type(shape).__name__}")


def _cylinder_placement(shape: Cylinder) -> tuple[np.ndarray, np.ndarray]:
    start, end = _vector(shape.start), _vector(shape.end)
    half = (end - start) / 2
    axis = _unit(half)
    u, _ = checker_axes(axis)
    linear = np.column_stack([shape.radius * u, shape.radius * np.cross(axis, u), half])
    return linear, start + half


def _euler(degrees: tuple[float, float, float]) -> np.ndarray:
    about_x, about_y, about_z = (rotation_matrix(np.eye(3)[k], degrees[k]) for k in range(3))
    return about_z @ about_y @ about_x


def _vector(values: tuple[float, float, float]) -> np.ndarray:
    return np.array(values, dtype=np.float64)


def _unit(vector: np.ndarray) -> np.ndarray:
    # Divided by the largest component first: squares of 1e-200 would vanish.
    scaled = vector / np.abs(vector).max()
    return scaled / np.sqrt(scaled @ scaled)


def _perpendicular(vector: np.ndarray, to: np.ndarray) -> np.ndarray:
    return vector - (vector @ to) * to
