"""Which closed objects a point lies in: for a camera under water, or inside a wall."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.nearest import to_local
from raywalk.geometry.solids import BOX, CYLINDER, PLANE, SPHERE, height

# Any direction will do for counting how often a closed mesh is crossed; this one lies on
# no axis or diagonal, along which models like to put their edges.
PROBE = np.array([0.5773, 0.2113, 0.7887])


def objects_around(compiled: CompiledScene, point: np.ndarray) -> list[int]:
    """Closed objects that strictly contain a point (a plane: the half-space behind it),
    the largest first: what lies inside what, where one lies inside the other."""
    sizes = _primitives_around(compiled, point)
    for mesh in compiled.meshes:
        if not mesh.triangles.closed:
            continue
        ray, _ = mesh.all_hits(point[None, :], PROBE[None, :])
        if len(ray) % 2 == 1:
            sizes[mesh.index] = mesh.size**3
    return sorted(sizes, key=lambda k: (-sizes[k], k))


def _primitives_around(compiled: CompiledScene, point: np.ndarray) -> dict[int, float]:
    table, sizes = compiled.primitives, {}
    for k, shape in enumerate(table.shape):
        x, y, z = to_local(table.to_local[k], *(point - table.centre[k]))
        if shape == PLANE and y < 0.0:
            sizes[int(table.object[k])] = np.inf
        if shape in (SPHERE, BOX, CYLINDER) and height(shape, x, y, z) < 0.0:
            sizes[int(table.object[k])] = abs(float(np.linalg.det(table.to_world[k])))
    return sizes
