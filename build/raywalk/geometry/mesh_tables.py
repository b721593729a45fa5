"""What the kernels of one mesh know of it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.geometry.bvh import Bvh
from raywalk.geometry.embree import Query
from raywalk.geometry.mesh_star import Star


class MeshTables(NamedTuple):
    """One mesh; lengths are the scene's, places relative to its centre."""

    object: int  # its number in Scene.objects
    corners: np.ndarray  # (triangles, 3, 3)
    trusted: np.ndarray  # (triangles, 3) barycentric coordinates above which a hit is certain
    star: Star
    stands_for: np.ndarray  # (Embree's triangles,) int32: our triangle of each
    closed: bool
    glass: bool  # rays may be in it
    centre: tuple[float, float, float]  # world
    scale: float  # makes it 1 in size
    # Its box with room around it, in which all of Embree's triangles are.
    low: tuple[float, float, float]
    high: tuple[float, float, float]
    bundle: float  # rays that spread by less go down Embree's tree together, in the unit-sized copy
    bvh: Bvh
    query: Query
