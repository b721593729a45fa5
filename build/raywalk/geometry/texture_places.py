"""Where in a texture's picture a point of a shape lies: (u, v), u to the right and v up, in
pictures; a picture fills 0 to 1, and repeats.

A shape's own axes are those before its `transform`, which carries the picture along.
"""

from __future__ import annotations

import numpy as np

from raywalk.scene.exact import rounded
from raywalk.scene.shapes import Cone, Shape

Y, Z = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])


def places_on(shape: Shape, local: np.ndarray) -> np.ndarray:
    """(n, 2) of points (n, 3) in the shape's canonical coordinates (scene/shapes.py)."""
    match shape.canonical.name:
        case "sphere":
            return round_the_sphere(local)
        case "box":
            return on_the_box(local)
        case "plane" | "disc":
            return on_the_flat(shape, local)
        case "triangle":
            return np.asarray(local[:, :2])  # a (0, 0), b (1, 0), c (0, 1)
    return round_the_axis(shape, local)


def ends_of(shape: Shape) -> tuple[bool, bool]:
    """Whether there are no places below 0 and above 1 along u, and along v."""
    match shape.canonical.name:
        case "plane":
            return False, False
        case "box" | "disc" | "triangle":
            return True, True
    return False, True  # round it goes on, from pole to pole not


def round_the_sphere(local: np.ndarray) -> np.ndarray:
    """About the own y: u = 1/2 + atan2(x, z) / 2 pi (longitude), v = 1/2 + latitude / pi.

    So the picture's middle faces +z, its right half +x, its top edge is the pole at +y, and its
    left and right edges meet at -z. An ellipsoid's own axes are its half axes, and the latitude
    is that of the unit sphere it is the image of. The latitude is atan2(y, |x, z|), as asin(y)
    loses half of its digits at the poles.
    """
    x, y, z = local.T
    u = 0.5 + np.arctan2(x, z) / (2.0 * np.pi)
    return np.column_stack([u, 0.5 + np.arctan2(y, np.hypot(x, z)) / np.pi])


def on_the_box(local: np.ndarray) -> np.ndarray:
    """Each face shows the whole picture, as seen from outside, upright as `upright_on` has it.

    The face is the one whose plane is nearest: of |x|, |y|, |z|, each 1 on its two faces, the
    largest. Across it a canonical coordinate runs from -1 to 1.
    """
    axis = np.argmax(np.abs(local), axis=1)
    places = np.zeros((len(local), 2))
    for k in range(3):
        for sign in (-1.0, 1.0):
            rows = np.flatnonzero((axis == k) & (np.sign(local[:, k]) == sign))
            right, up = upright_on(sign * np.eye(3)[k])
            places[rows] = 0.5 + 0.5 * local[rows] @ np.column_stack([right, up])
    return places


def on_the_flat(shape: Shape, local: np.ndarray) -> np.ndarray:
    """A plane: own units from its `point`, one picture a unit. A disc: its bounding square."""
    linear = rounded(shape.placement()[0])
    is_disc = shape.canonical.name == "disc"
    normal = linear[:, 2] if is_disc else linear[:, 1]
    size = float(np.linalg.norm(normal))  # a disc's radius; 1 of a plane
    right, up = upright_on(normal / size)
    own = local @ (linear.T @ np.column_stack([right, up]))
    return np.asarray(0.5 + own / (2.0 * size) if is_disc else own)


def round_the_axis(shape: Shape, local: np.ndarray) -> np.ndarray:
    """Cylinders and cones: once round the side, v from 0 at `start` to 1 at `end`; a cap shows the
    picture as a disc does.

    u = 1/2 + angle / 2 pi, the angle growing to the right as seen from outside with `end` on top.
    The picture's middle faces +z of the own axes if the axis is upright (its y is the largest
    part), else +y: there the seam is below. A point is on a cap if it is nearer to that plane than
    to the side, in canonical lengths.
    """
    linear = rounded(shape.placement()[0])
    is_turned = isinstance(shape, Cone) and shape.radius > shape.end_radius  # canonical z runs back
    to_end = (-linear[:, 2] if is_turned else linear[:, 2]) / np.linalg.norm(linear[:, 2])
    middle = upright_on(to_end)[1] * (-1.0 if is_upright(to_end) else 1.0)
    own = local @ linear.T
    angle = np.arctan2(own @ np.cross(to_end, middle), own @ middle)
    z = local[:, 2]
    along = 0.5 + 0.5 * (-z if is_turned else z)
    places = np.column_stack([0.5 + angle / (2.0 * np.pi), along])
    if shape.canonical.name == "cylinder":
        low, high = shape.canonical.ends or (1.0, 1.0)
        wide = low + (high - low) * 0.5 * (1.0 + z)
        on_cap = np.abs(1.0 - np.abs(z)) < np.abs(np.hypot(local[:, 0], local[:, 1]) - wide)
        for sign, radius in ((-1.0, low), (1.0, high)):
            rows = np.flatnonzero(on_cap & (np.sign(z) == sign))
            outward = sign * linear[:, 2] / np.linalg.norm(linear[:, 2])
            across = np.column_stack(upright_on(outward))
            size = radius * float(np.linalg.norm(linear[:, 0]))
            flat = own[rows] - np.outer(own[rows] @ outward, outward)
            places[rows] = 0.5 + flat @ across / (2.0 * size)
    return places


def is_upright(normal: np.ndarray) -> bool:
    """Whether y is the largest part of a vector (3,)."""
    return bool(abs(normal[1]) >= max(abs(normal[0]), abs(normal[2])))


def upright_on(normal: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Unit vectors to the right and up, as seen by who looks at a flat surface's front: up is y
    across it, or -z where it lies (a floor's picture is read from +z, its top far away); right, up
    and the unit normal (3,) are right-handed."""
    up = -Z if is_upright(normal) else Y
    up = up - (up @ normal) * normal
    up = up / np.linalg.norm(up)
    return np.cross(up, normal), up
