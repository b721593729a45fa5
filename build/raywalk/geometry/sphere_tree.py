"""Scenes of many primitives: which of them a ray may meet, by a tree of spheres, eight a node.

Asking every primitive costs a ray in a block half a nanosecond each (`blocks.py`), so a tree pays
only from MANY on. A node's eight spheres are asked of a ray at once, by the rule that spares
it a primitive's own sphere.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.geometry.blocks import DD, DX, DY, DZ, OX, OY, OZ
from raywalk.geometry.primitives import ROOMY, Primitives
from raywalk.geometry.roots import is_past
from raywalk.optics.compiled import kernel

MANY = 600  # primitives; measured by `raywalk bench --only primitives`
WIDE = 8  # spheres a node
EMPTY = -1
DEPTH = 128  # of a ray's stack: WIDE for each of the fifteen levels that memory cannot hold


class SphereTree(NamedTuple):
    """Nodes of eight spheres; node 0 is the root. What is left over in a node is EMPTY."""

    # (nodes * 4 * WIDE,): of each node the eight x, y and z of its spheres' centres, world, and
    # their squared radii, -1 of what is empty.
    spheres: np.ndarray
    child: np.ndarray  # (nodes * WIDE,) int64: a node, or EMPTY - 1 - row of a primitive


def sphere_tree(primitives: Primitives) -> SphereTree:
    """The tree over the rows of a table that are not endless."""
    centre, reach = primitives.centre, np.sqrt(primitives.reach_sq)
    spheres: list[tuple[np.ndarray, float, int]] = []

    def node_of(rows: np.ndarray) -> tuple[np.ndarray, float, int]:
        """Lays out what holds these rows; its sphere and its index."""
        place = len(spheres)
        spheres.extend([(np.zeros(3), -1.0, EMPTY)] * WIDE)
        if len(rows) <= WIDE:
            parts = [(centre[k], float(reach[k]), EMPTY - 1 - int(k)) for k in rows]
        else:
            parts = [node_of(part) for part in octants(centre, rows) if len(part)]
        spheres[place : place + len(parts)] = parts
        points = np.array([part[0] for part in parts])
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        far = np.linalg.norm(points - middle, axis=1) + [part[1] for part in parts]
        return middle, ROOMY * float(far.max()), place // WIDE

    bounded = np.flatnonzero(np.isfinite(primitives.reach_sq))
    if len(bounded):
        node_of(bounded)
    points = np.array([sphere[0] for sphere in spheres]).reshape(-1, WIDE, 3)
    radius = np.array([sphere[1] for sphere in spheres]).reshape(-1, WIDE)
    squares = np.where(radius < 0.0, -1.0, radius**2)
    laid_out = np.concatenate([points.transpose(0, 2, 1), squares[:, None]], axis=1)
    child = np.array([sphere[2] for sphere in spheres], np.int64)
    return SphereTree(np.ascontiguousarray(laid_out).ravel(), child)


def octants(centre: np.ndarray, rows: np.ndarray) -> list[np.ndarray]:
    """Rows in eight equal parts, halved along each axis in turn."""
    parts = [rows]
    for axis in range(3):
        halves = []
        for part in parts:
            order = part[np.argsort(centre[part, axis], kind="stable")]
            halves += np.array_split(order, 2)
        parts = halves
    return parts


@kernel
def candidates_in_tree(tree, block, j, marks, stack, rows):
    """Writes the rows whose spheres column j's ray may meet to rows, ascending; returns how many.

    marks: (WIDE,) uint8, stack: (DEPTH,) and rows are room to work in.
    """
    ox, oy, oz = block[OX + j], block[OY + j], block[OZ + j]
    dx, dy, dz, dd = block[DX + j], block[DY + j], block[DZ + j], block[DD + j]
    found, waiting = 0, 0
    if tree.child.shape[0]:
        stack[0], waiting = 0, 1
    while waiting > 0:
        waiting -= 1
        node = stack[waiting]
        if node < 0:
            found = put_in_order(rows, found, EMPTY - 1 - node)
            continue
        spheres, child = tree.spheres[4 * WIDE * node :], tree.child[WIDE * node :]
        for c in range(WIDE):
            x, y, z = spheres[c] - ox, spheres[WIDE + c] - oy, spheres[2 * WIDE + c] - oz
            along, reach_sq = x * dx + y * dy + z * dz, spheres[3 * WIDE + c]
            misses = is_past(x * x + y * y + z * z, reach_sq, along, dd)
            marks[c] = (not misses) & (child[c] != EMPTY)
        for c in range(WIDE):  # without a branch, which none could predict
            stack[waiting] = child[c]
            waiting += marks[c]
    return found


@kernel
def put_in_order(rows, found, row):
    """Adds a row to a sorted list; returns how many it holds now."""
    place = found
    while place > 0 and rows[place - 1] > row:
        rows[place] = rows[place - 1]
        place -= 1
    rows[place] = row
    return found + 1
