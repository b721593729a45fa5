"""Ray trees as columns: one row a ray, for every pixel that some frustum resolution uses.

Order is path-major: first all camera rays in raster order, then all their
reflected (or totally reflected) children, then their refracted children, branch by
branch, and so on depth by depth; within each group the order of the parents is kept. A pixel's
tree is thus spread over the rows and held together by `parent`.

Invariant, tested: for every ray that hits,
    colour = local_weight * local + sum over children (weight * child colour),
    local  = B ambient + sum over lights V (diffuse * B Kd + specular * Ks), B: the base colour,
and for a ray that leaves the scene, colour = background.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from raywalk.trace.kinds import BRANCH_OF, RAYS


class Kind(IntEnum):
    """What sent a ray on its way: Python's names for the rows of ray_kinds.json."""

    CAMERA = RAYS["camera"]["code"]
    REFLECTED = RAYS["reflected"]["code"]
    REFRACTED = RAYS["refracted"]["code"]
    TOTAL = RAYS["total"]["code"]  # totally reflected inside glass

    @property
    def branch(self) -> int:
        """Rays of one branch stand in each other's place: a hit sends on at most one of them."""
        return int(BRANCH_OF[self])

    @property
    def bit(self) -> int:
        """In a trace file's `children`: that a hit sends such a ray on."""
        return 1 << (self - 1)


SENT_ON = tuple(kind for kind in Kind if kind != Kind.CAMERA)


class Visibility(IntEnum):
    """What a hit point knows of one light."""

    BLOCKED = 0  # a shadow ray was shot and stopped by `blocker`
    REACHED = 1  # a shadow ray was shot and arrived
    BEHIND = 2  # the surface faces away: dark, no shadow ray needed
    UNTESTED = 3  # the scene casts no shadows: lit, no shadow ray shot


LIT = (Visibility.REACHED, Visibility.UNTESTED)
SHOT = (Visibility.REACHED, Visibility.BLOCKED)  # by a shadow ray


def level_pixels(size: int, n: int) -> np.ndarray:
    """(n * n,) picture pixels that the tiles of n x n share their centres with, raster order: tile
    (i, j) is pixel (i k + (k - 1) / 2, j k + (k - 1) / 2), k = size / n. Raises ValueError."""
    k, rest = divmod(size, n)
    if rest or k % 2 == 0:
        raise ValueError(f"{n} does not divide {size} with an odd quotient")
    along = np.arange(n) * k + (k - 1) // 2
    return np.asarray((along[:, None] * size + along).reshape(-1))


def dense(key: np.ndarray) -> np.ndarray:
    """Small numbers, equal where the keys are and in their order."""
    return np.unique(key, return_inverse=True)[1].reshape(-1)


@dataclass(frozen=True, eq=False)
class RayTree:
    """Columns over m rays and L lights. World units; colours linear, unclamped.

    Lighting factors hold no material colour and no visibility:
    diffuse  = I a p max(0, n.l),  specular = I a p max(0, n.h)^s  with attenuation a and
    `passed` p, to be multiplied by kd * light colour and ks * light colour.
    """

    size: int  # width and height of the picture that these pixels belong to
    pixel: np.ndarray  # (m,) int32: row * size + column in the full picture
    parent: np.ndarray  # (m,) int32: row of the parent ray, -1 for camera rays
    kind: np.ndarray  # (m,) uint8: Kind
    depth: np.ndarray  # (m,) uint8: bounces before this ray, 0 for camera rays
    object: np.ndarray  # (m,) int32: index into Scene.objects, -1 if it leaves the scene
    material: np.ndarray  # (m,) int32: index into Scene.materials, -1 likewise
    inside: np.ndarray  # (m,) bool: met the surface from its inner side
    t: np.ndarray  # (m,) float64: distance from the origin; inf if it leaves the scene
    point: np.ndarray  # (m, 3): the hit; where it leaves: where its drawn line ends
    normal: np.ndarray  # (m, 3) unit shading normal, facing the incoming ray; 0 if none
    weight: np.ndarray  # (m,) share of this ray's colour in its parent's; 1 for camera rays
    local_weight: np.ndarray  # (m,) share of the local colour in this ray's colour
    local: np.ndarray  # (m, 3) Blinn-Phong colour at the hit, before local_weight
    colour: np.ndarray  # (m, 3) what the ray brings back
    visibility: np.ndarray  # (m, L) uint8: Visibility
    blocker: np.ndarray  # (m, L) int32: object that stopped the shadow ray, else -1
    blocked_at: np.ndarray  # (m, L) float64: share of the way to the light, 1 if it arrives
    passed: np.ndarray  # (m, L) float64: share of the light that glass on the way lets pass
    diffuse: np.ndarray  # (m, L) float64
    specular: np.ndarray  # (m, L) float64
    tests: np.ndarray  # (m,) int32: intersection tests made for this ray itself
    hits_start: np.ndarray  # (c + 1,) int32: camera ray k met hits_start[k]:hits_start[k+1]
    hits_t: np.ndarray  # (h,) float64: distances of all hits along it, ascending
    hits_object: np.ndarray  # (h,) int32: the objects met there
    base: np.ndarray | None = None  # (m, 3) base colour, 1 where none; None: nowhere any

    @property
    def cameras(self) -> int:
        """Number of camera rays, which stand first."""
        return len(self.hits_start) - 1
