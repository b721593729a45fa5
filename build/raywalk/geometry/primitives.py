"""Analytic primitives of a scene as one table of arrays, which the kernels read."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.geometry.solids import BOX, CYLINDER, DISC, PLANE, SPHERE, TRIANGLE, TUBE
from raywalk.scene.model import (
    Box,
    Cylinder,
    Disc,
    Ellipsoid,
    Mesh,
    Plane,
    Scene,
    Shape,
    Sphere,
    Triangle,
)
from raywalk.scene.placement import placement


class Primitives(NamedTuple):
    """One row a primitive; float64 throughout.

    Of surfaces that tie the first row is met: opaque ones stand before transparent ones, both in
    the order of the scene's objects.
    """

    shape: np.ndarray  # (p,) int8: SPHERE .. TRIANGLE
    object: np.ndarray  # (p,) int32: index into Scene.objects
    centre: np.ndarray  # (p, 3) world
    to_world: np.ndarray  # (p, 3, 3) canonical -> world, without the centre
    to_local: np.ndarray  # (p, 3, 3) its inverse
    stretch: np.ndarray  # (p,) largest row sum of |to_local|: local units per world unit
    reach_sq: np.ndarray  # (p,) squared radius of a sphere round it and `centre`; inf if endless
    row_of: np.ndarray  # (objects,) int32: this table's row of an object, -1 for a mesh


def compile_primitives(scene: Scene) -> Primitives:
    """The table of all objects that are not meshes; transforms are known to be regular."""
    kept = [k for k, obj in enumerate(scene.objects) if not isinstance(obj.shape, Mesh)]
    kept.sort(key=lambda k: scene.materials[scene.objects[k].material].transmit > 0)
    placed = [placement(scene.objects[k]) for k in kept]
    to_world = np.array([linear for linear, _ in placed]).reshape(-1, 3, 3)
    to_local = np.array([_inverse(linear) for linear, _ in placed]).reshape(-1, 3, 3)
    row_of = np.full(len(scene.objects), -1, np.int32)
    row_of[kept] = np.arange(len(kept))
    return Primitives(
        shape=np.array([_code(scene.objects[k].shape) for k in kept], np.int8),
        object=np.array(kept, np.int32),
        centre=np.array([centre for _, centre in placed]).reshape(-1, 3),
        to_world=to_world,
        to_local=to_local,
        stretch=np.abs(to_local).sum(axis=2).max(axis=1, initial=0.0),
        reach_sq=np.array(
            [_reach(scene.objects[k].shape, m) for k, (m, _) in zip(kept, placed, strict=True)]
        )
        ** 2,
        row_of=row_of,
    )


# The sphere round a shape is this much larger than it need be, so that no hit that rounding
# moves is ever outside of it.
ROOMY = 1.0 + 1e-6


def _reach(shape: Shape, to_world: np.ndarray) -> float:
    """Radius of a sphere round the centre that holds the shape, world units."""
    stretch = float(np.linalg.norm(to_world, 2))  # the longest axis of the unit sphere's image
    match shape:
        case Plane():
            return np.inf
        case Box():
            return ROOMY * np.sqrt(3.0) * stretch
        case Cylinder():
            return ROOMY * np.sqrt(2.0) * stretch
        case Triangle():  # its centre is a corner
            return ROOMY * float(np.linalg.norm(to_world[:, :2], axis=0).max())
    return ROOMY * stretch


def _inverse(linear: np.ndarray) -> np.ndarray:
    """Inverse by cofactors: exact for axis-aligned shapes, where LU would round."""
    a, b, c = linear.T  # columns
    rows = np.array([np.cross(b, c), np.cross(c, a), np.cross(a, b)])
    return np.asarray(rows / (a @ rows[0]))


def _code(shape: Shape) -> int:
    match shape:
        case Sphere() | Ellipsoid():
            return SPHERE
        case Box():
            return BOX
        case Cylinder():
            return CYLINDER if shape.capped else TUBE
        case Plane():
            return PLANE
        case Disc():
            return DISC
        case Triangle():
            return TRIANGLE
    raise TypeError(f"{type(shape).__name__} is not an analytic primitive")
