"""How exact each column has to be, and the quantisation steps that follow.

Every step comes from what a person reads or sees; the encoder measures the errors that
really occur and states them in the header.
"""

from __future__ import annotations

import numpy as np

from raywalk.scene.model import Scene
from raywalk.scene.shapes import Plane
from raywalk.trace.tree import RayTree

# A person reads three decimals in a scene some 5 to 25 units wide.
POINT_SHARE = 2e-5  # of the finite extent: points, lengths
MOST_POINT = 5e-4  # world units, in any scene
LEAVING = 10.0  # times less exact: ends of the drawn lines of rays that leave
NORMAL = 2e-4  # difference of unit vectors
SPLIT = 7e-5  # step of a fresnel share; three decimals of both shares seldom tie
COLOUR = 0.5 / 255 * 0.2  # switched lights and bounces stay within 1 of 255
LIGHT_SHARE = 0.9  # of COLOUR for the lighting terms, the rest for fresnel shares
MOST_LIGHT_STEP = 5e-4  # a person reads three decimals
OCTAHEDRON = 2.13  # length on the unit sphere of half a step in both coordinates, at most
WHOLE = 2.0**46  # numbers stay below: exact in float64, also as differences


def finite_extent(tree: RayTree, scene: Scene) -> float:
    """Largest side of a box round eye, lights, and all hits except on infinite planes."""
    finite = [k for k, item in enumerate(scene.objects) if not isinstance(item.shape, Plane)]
    corners = [
        np.array([scene.camera.eye, *(light.position for light in scene.lights)], float),
        tree.point[np.isin(tree.object, finite)],
    ]
    if not finite:
        corners.append(np.median(tree.point[tree.object >= 0][:1000], axis=0, keepdims=True))
    box = np.concatenate([part for part in corners if np.isfinite(part).all()])
    return float((box.max(axis=0) - box.min(axis=0)).max()) or 1.0


def point_error(extent: float, curvature: float) -> float:
    """Allowed error of points on a patch whose normals turn by `curvature` a unit of length."""
    allowed = min(POINT_SHARE * extent, MOST_POINT)
    return min(allowed, NORMAL / curvature) if curvature > 0 else allowed


def depth_step(z: np.ndarray, slant: np.ndarray, error: float) -> float:
    """Step of 1 / z so that points z * slant along a ray stay within the error."""
    fine = float((2 * error / (z * z * slant)).min())
    return _short(max(fine, 1 / (WHOLE * float(z.min()))))


def coordinate_step(points: str, error: float, axes: tuple[float, ...]) -> float:
    """Step of a patch's coordinates: half of it in each keeps the error."""
    if points == "ball":
        longest = max(np.linalg.norm(np.array(axes).reshape(3, 3), axis=1))
        return _short(error / (OCTAHEDRON * float(longest)))
    return _short(2 * error / np.sqrt(2 if points == "flat" else 3))


def light_step(weight: float, terms: float) -> float:
    """Step of lighting factors, from the share and the sum of colours they multiply."""
    full = weight * terms
    return _short(min(MOST_LIGHT_STEP, 2 * COLOUR * LIGHT_SHARE / full if full else 1.0))


def normal_step() -> float:
    return _short(NORMAL / OCTAHEDRON)


def _short(step: float) -> float:
    """Rounded down to three digits: the header is read by people too."""
    power = 10.0 ** (np.floor(np.log10(step)) - 2)
    return float(format(np.floor(step / power) * power, ".3g"))
