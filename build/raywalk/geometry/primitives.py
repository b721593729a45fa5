"""Analytic primitives of a scene as one table of arrays, which the kernels read."""

from __future__ import annotations

from decimal import Decimal, localcontext
from typing import NamedTuple

import numpy as np

from raywalk.geometry.faces import BOX, SHAPE, TRIANGLE, shape_record
from raywalk.geometry.shared_rims import shared_rims
from raywalk.scene.exact import DIGITS, exact, rounded, with_rest
from raywalk.scene.model import Scene
from raywalk.scene.placement import exact_placement, is_unmoved
from raywalk.scene.shapes import Box, Canonical, Mesh, Shape, Triangle, Triple


class Primitives(NamedTuple):
    """One row a primitive; float64 throughout.

    Of surfaces that tie the first row is met: opaque ones stand before transparent ones, both in
    the order of the scene's objects.
    """

    shape: np.ndarray  # (p,) SHAPE: what kernels branch on
    object: np.ndarray  # (p,) int32: index into Scene.objects
    centre: np.ndarray  # (p, 3) world
    centre_rest: np.ndarray  # (p, 3) what float64 leaves over of it
    to_world: np.ndarray  # (p, 3, 3) canonical -> world, without the centre
    to_local: np.ndarray  # (p, 3, 3) its inverse
    to_local_rest: np.ndarray  # (p, 3, 3) what float64 leaves over of that
    is_skewed: np.ndarray  # (p,) bool: the inverse cancels, so that its rounding shows
    is_thin: np.ndarray  # (p,) bool: scaled onto its surface, a point would move along it
    stretch: np.ndarray  # (p,) largest row sum of |to_local|: local units per world unit
    reach_sq: np.ndarray  # (p,) squared radius of a sphere round it and `centre`; inf if endless
    row_of: np.ndarray  # (objects,) int32: this table's row of an object, -1 for a mesh
    is_edged: np.ndarray  # (p,) bool: its edges are decided exactly; see `exact_at_edges`
    # Of triangles 3 and of boxes 8 corners, world; of shared rims what `rims.py` reads; and what
    # float64 leaves over of them; else 0.
    corner: np.ndarray  # (p, 8, 3)
    corner_rest: np.ndarray  # (p, 8, 3)


EDGED = (Box, Triangle)


def compile_primitives(scene: Scene) -> Primitives:
    """The table of all objects that are not meshes; transforms are known to be regular."""
    kept = [k for k, obj in enumerate(scene.objects) if not isinstance(obj.shape, Mesh)]
    kept.sort(key=lambda k: scene.materials[scene.objects[k].material].transmit > 0)
    placed = [exact_placement(scene.objects[k]) for k in kept]
    inverse = _stack([_inverse(linear) for linear, _ in placed], (3, 3))
    middle = _stack([centre for _, centre in placed], (3,))
    to_world = rounded(_stack([linear for linear, _ in placed], (3, 3)))
    (to_local, to_local_rest), (centre, centre_rest) = with_rest(inverse), with_rest(middle)
    sizes = np.linalg.svd(to_world, compute_uv=False)  # half axes of the unit sphere's image
    shapes = [scene.objects[k].shape for k in kept]
    is_edged = np.array([isinstance(shape, EDGED) for shape in shapes], bool)
    corner, corner_rest = np.zeros((2, len(kept), 8, 3))
    moved = []
    for row in np.flatnonzero(is_edged).tolist():
        if is_unmoved(scene.objects[kept[row]]):
            given = _given_corners(shapes[row])
            corner[row, : len(given)] = given
        else:
            moved.append(row)
    corners = _stack([_corners(shapes[row], *placed[row]) for row in moved], (8, 3))
    corner[moved], corner_rest[moved] = with_rest(corners)
    rimmed, rims = shared_rims(shapes, placed, inverse, to_world, centre)
    is_edged[rimmed] = True
    corner[rimmed], corner_rest[rimmed] = with_rest(rims)
    row_of = np.full(len(scene.objects), -1, np.int32)
    row_of[kept] = np.arange(len(kept))
    return Primitives(
        shape=np.array([shape_record(shape.canonical) for shape in shapes], SHAPE),
        object=np.array(kept, np.int32),
        centre=centre,
        centre_rest=centre_rest,
        to_world=to_world,
        to_local=to_local,
        to_local_rest=to_local_rest,
        is_skewed=_growth(to_world, to_local) > SKEWED,
        is_thin=_are_thin([shape.canonical for shape in shapes], to_world, sizes),
        stretch=np.abs(to_local).sum(axis=2).max(axis=1, initial=0.0),
        reach_sq=np.array(
            [
                _reach(shape, m, own[0])
                for shape, m, own in zip(shapes, to_world, sizes, strict=True)
            ]
        )
        ** 2,
        row_of=row_of,
        is_edged=is_edged,
        corner=corner,
        corner_rest=corner_rest,
    )


def exact_at_edges(table: Primitives, vertices: list[np.ndarray]) -> Primitives:
    """The table with `is_edged` for only those that need it, which costs all rays: triangles, open
    and met flatly, boxes that share a corner with another object, and who shares a rim. A box for
    itself is tight.

    vertices: (v, 3) of each mesh, world.
    """
    has_corners = np.isin(table.shape["code"], (BOX, TRIANGLE))
    is_edged = table.is_edged & ~has_corners
    rows = np.flatnonzero(table.is_edged & has_corners)
    if len(rows):
        is_triangle = table.shape[rows]["code"] == TRIANGLE
        has = np.where(is_triangle[:, None], np.arange(8) < 3, True)
        given = [table.corner[rows][has], *vertices]
        owner = [np.nonzero(has)[0], *(np.full(len(v), -1 - k) for k, v in enumerate(vertices))]
        shared = _is_shared(np.concatenate(given), np.concatenate(owner))[: has.sum()]
        is_edged[rows[is_triangle]] = True
        is_edged[rows[owner[0][shared]]] = True
    return table._replace(is_edged=is_edged)


def _is_shared(points: np.ndarray, owner: np.ndarray) -> np.ndarray:
    """(n,) bool: whether another owner has the very same point (n, 3)."""
    order = np.lexsort([owner, *points.T])
    point, who = points[order], owner[order]
    first = np.append(True, (point[1:] != point[:-1]).any(axis=1))
    start = np.flatnonzero(first)
    last = np.append(start[1:], len(who)) - 1
    shared = np.empty(len(who), bool)
    shared[order] = np.repeat(who[start] != who[last], last - start + 1)
    return shared


# The sphere round a shape is this much larger than it need be, so that no hit that rounding
# moves is ever outside of it.
ROOMY = 1.0 + 1e-6


def _reach(shape: Shape, to_world: np.ndarray, longest: float) -> float:
    """Radius of a sphere round the centre that holds the shape, world units."""
    if isinstance(shape, Triangle):  # its centre is a corner
        return ROOMY * float(np.linalg.norm(to_world[:, :2], axis=0).max())
    return ROOMY * shape.canonical.reach * float(longest)


# Canonical corners in the order of BOX_TRIANGLES, and of a triangle's a, b, c.
BOX_CORNERS = exact([(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)])
TRIANGLE_CORNERS = exact([(0, 0, 0), (1, 0, 0), (0, 1, 0)])


def _given_corners(shape: Shape) -> list[Triple]:
    """The same, as they stand in the scene file: float64 to the last digit."""
    if isinstance(shape, Triangle):
        return [shape.a, shape.b, shape.c]
    assert isinstance(shape, Box)
    (x, y, z), (u, v, w) = shape.minimum, shape.maximum
    return [(a, b, c) for c in (z, w) for b in (y, v) for a in (x, u)]


def _corners(shape: Shape, linear: np.ndarray, centre: np.ndarray) -> np.ndarray:
    """(8, 3) Decimals: where the corners of a box or triangle stand, then zeros."""
    given = BOX_CORNERS if isinstance(shape, Box) else TRIANGLE_CORNERS
    out = np.full((8, 3), Decimal(0), object)
    with localcontext(prec=DIGITS):
        out[: len(given)] = centre + given @ linear.T
    return out


def _inverse(linear: np.ndarray) -> np.ndarray:
    """Inverse by cofactors, of Decimals."""
    (a, b, c), (d, e, f), (g, h, i) = linear.tolist()
    with localcontext(prec=DIGITS):
        rows = [
            [e * i - h * f, h * c - b * i, b * f - e * c],
            [f * g - i * d, i * a - c * g, c * d - f * a],
            [d * h - g * e, g * b - a * h, a * e - d * b],
        ]
        size = a * rows[0][0] + d * rows[0][1] + g * rows[0][2]
        return np.array([[each / size for each in row] for row in rows], object)


def _stack(arrays: list[np.ndarray], shape: tuple[int, ...]) -> np.ndarray:
    """(p, *shape) Decimals, also of none."""
    return np.array(arrays, object).reshape(-1, *shape)


# Of a turned ellipsoid it is at most 3, of a sheared one about its condition number.
SKEWED = 4.0


# Largest axis over smallest from which on. Below it a point moves by as many of its own roundings
# at most, halved.
THIN = 4.0
SQUARE = 1e-9  # cosine below which two axes are square to each other, but for rounding


def _are_thin(canonical: list[Canonical], to_world: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """(p,) bool: whether the way from a point next to the surface to its canonical foot is far from
    the shortest in the world.

    sizes: (p, 3) half axes of the unit sphere's image, the longest first.
    """
    lengths = np.linalg.norm(to_world, axis=1)
    axes = to_world / lengths[:, None]
    turned = np.abs(axes.transpose(0, 2, 1) @ axes - np.eye(3))  # cosines
    names = np.array([each.name for each in canonical], "U8")
    is_open = np.isin(names, ("plane", "disc", "triangle"))
    across = np.where(names == "plane", 1, 2)
    is_leaning = turned[np.arange(len(names)), across].max(axis=1, initial=0.0) > SQUARE
    is_skew = turned.max(axis=(1, 2), initial=0.0) > SQUARE
    is_even = np.array([each.ends == (1.0, 1.0) for each in canonical], bool)
    is_round = is_even & (np.abs(lengths[:, 0] - lengths[:, 1]) <= SQUARE * lengths[:, 0])
    is_thin = (names == "sphere") | is_skew | ~((names == "box") | is_round)
    return np.where(is_open, is_leaning, (sizes[:, 0] > THIN * sizes[:, -1]) & is_thin)


def _growth(to_world: np.ndarray, to_local: np.ndarray) -> np.ndarray:
    """(p,) by how much rounding the inverse moves a surface point, in roundings of the point."""
    return np.asarray((np.abs(to_world) @ np.abs(to_local)).sum(axis=2).max(axis=1, initial=0.0))
