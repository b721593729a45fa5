"""Which closed objects a point lies in: for a camera under water, or inside a wall."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.compiled import CompiledScene
from raywalk.geometry.faces import holds
from raywalk.geometry.roots import to_local
from raywalk.optics.compiled import kernel


def objects_around(compiled: CompiledScene, point: np.ndarray) -> list[int]:
    """Closed objects that strictly contain a point (a plane: the half-space behind it),
    the largest first: what lies inside what, where one lies inside the other."""
    around = _primitives_around(compiled, point)
    for mesh in compiled.meshes:
        if mesh.triangles.closed and winding_number(mesh.corners, point - mesh.centre) > 0.5:
            around.append(mesh.index)
    return sorted(around, key=lambda k: int(compiled.outermost_first[k]))


def _primitives_around(compiled: CompiledScene, point: np.ndarray) -> list[int]:
    table = compiled.primitives
    return [int(k) for k in table.object[_rows_around(table, *map(float, point))]]


@kernel
def _rows_around(primitives, px, py, pz):
    out = np.zeros(len(primitives.shape), np.bool_)
    for row in range(len(out)):
        c = primitives.centre[row]
        x, y, z = to_local(primitives.to_local[row], px - c[0], py - c[1], pz - c[2])
        out[row] = holds(primitives.shape[row], x, y, z)
    return out


def winding_number(corners: np.ndarray, point: np.ndarray) -> float:
    """How often a closed mesh goes round a point: 1 inside, 0 outside.

    Unlike counting crossings, no ray can run into an edge. corners: (n, 3, 3).
    """
    # Only here: a scene without a mesh runs none of it.
    from raywalk.geometry.mesh_sides import turns_round

    x, y, z = point.tolist()
    # A read-only array, as trimesh gives, would have it compiled once more.
    return float(turns_round(np.require(corners, float, ["C", "W"]), (x, y, z)))
