"""Patches: pieces of objects on which points and normals follow a simple fitted rule.

A codec device, fitted to the rays at hand and verified on each: a flat patch has one
normal and a frame; on a curved one the normal is parallel to gradient = M point + b,
which holds on every quadric; if M is positive definite, its points are an affine image
of the unit sphere. What fits neither is `free` and stores all its numbers.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raywalk.trace_file.groups import rows_of_each
from raywalk.trace_file.null_vector import gradient_rule, triangular

MOST_FACES = 8  # flat patches looked for on one object; a box needs 6
MOST_SEEDS = 40  # rays whose plane is tried
GOLDEN = 0.6180339887498949  # spreads them over the object
FACE_SHARE = 0.02  # of an object's rays: smaller flat pieces are left to the rest
SAME_NORMAL = 1e-11  # 1 - cosine below which two normals are one
SAME_PLANE = 1e-9  # of the scene's extent
FITS = 1e-8  # difference of unit normals, or of radii of a unit sphere
VANISHING = 1e-9  # a gradient that is rounding gives no normal: such a rule is a chance find
SAMPLE = 3000  # rays a fit looks at
NO_OBJECT = -1


@dataclass(frozen=True)
class Patch:
    """points: "flat", "ball" or "free"; normals: "one", "gradient", "stored" or "none"."""

    object: int
    points: str
    normals: str
    origin: tuple[float, ...] = (0.0, 0.0, 0.0)  # of the frame, or the ball's centre
    axes: tuple[float, ...] = ()  # 2 or 3 vectors: world = origin + sum of (axis * coordinate)
    gradient: tuple[float, ...] = ()  # M by rows, then b; or the one normal
    step: float = 0.0  # of stored coordinates
    curvature: float = 1.0  # how far a normal turns where a point moves by 1; not in the file


def split_into_patches(
    thing: np.ndarray, point: np.ndarray, normal: np.ndarray, extent: float
) -> tuple[list[Patch], np.ndarray]:
    """Patches, and (m,) which one each ray ends on. thing: object, -1 where a ray leaves."""
    patches: list[Patch] = []
    patch_of = np.zeros(len(thing), np.int64)
    things, which = np.unique(thing, return_inverse=True)
    for index, rows in zip(things.tolist(), rows_of_each(which, len(things)), strict=True):
        split = _leaving if index == NO_OBJECT else _of_object
        for patch, members in split(index, rows, point, normal, extent):
            patch_of[members] = len(patches)
            patches.append(patch)
    return patches, patch_of


Found = list[tuple[Patch, np.ndarray]]


def _of_object(
    index: int, rows: np.ndarray, point: np.ndarray, normal: np.ndarray, extent: float
) -> Found:
    if not len(_on_plane(rows, rows[0], point, normal, extent)[1]):
        return [(_flat(index, rows, point, normal), rows)]
    whole = _curved(index, rows, point, normal)
    if whole:
        return [(whole, rows)]
    found, rest = _faces(index, rows, point, normal, extent)
    if len(rest):
        curved = _curved(index, rest, point, normal)
        found.append((curved or Patch(index, "free", "stored"), rest))
    return found


def _faces(
    index: int, rows: np.ndarray, point: np.ndarray, normal: np.ndarray, extent: float
) -> tuple[Found, np.ndarray]:
    """Large flat pieces, sought from evenly spread rays; and what is left."""
    found: Found = []
    rest = rows
    for k in range(MOST_SEEDS):
        if not len(rest) or len(found) == MOST_FACES:
            break
        seed = rest[int(len(rest) * (k * GOLDEN % 1))]
        face, others = _on_plane(rest, seed, point, normal, extent)
        if len(face) >= max(3, FACE_SHARE * len(rows)):
            found.append((_flat(index, face, point, normal), face))
            rest = others
    return found, rest


def _on_plane(
    rows: np.ndarray, seed: int, point: np.ndarray, normal: np.ndarray, extent: float
) -> tuple[np.ndarray, np.ndarray]:
    """Rows whose point and normal are those of the seed's plane, and the others."""
    away = point[rows] - point[seed]
    reach = SAME_PLANE * (extent + np.abs(away).max(axis=1))
    turned = 1 - np.abs(normal[rows] @ normal[seed])
    on = (np.abs(away @ normal[seed]) <= reach) & (turned <= SAME_NORMAL)
    return rows[on], rows[~on]


def _flat(index: int, rows: np.ndarray, point: np.ndarray, normal: np.ndarray) -> Patch:
    up = normal[rows[0]]
    across = np.eye(3)[int(np.argmin(np.abs(up)))]
    u = np.cross(up, across) / np.linalg.norm(np.cross(up, across))
    v = np.cross(up, u)
    # The origin is the plane's point nearest to the world's: digits stay short.
    origin = up * float(np.median(point[rows] @ up))
    return Patch(
        index, "flat", "one", tuple(origin.tolist()), (*u.tolist(), *v.tolist()),
        tuple(up.tolist()), curvature=0.0,
    )  # fmt: skip


def _curved(index: int, rows: np.ndarray, point: np.ndarray, normal: np.ndarray) -> Patch | None:
    """A quadric whose gradient is parallel to every normal, found as a null vector."""
    picked = rows[:: max(1, len(rows) // SAMPLE)]
    middle = point[picked].mean(axis=0)
    scale = float(np.abs(point[picked] - middle).max()) or 1.0
    p, n = (point[picked] - middle) / scale, normal[picked]
    found = np.linalg.svd(triangular(gradient_rule(p, n)))[2][-1]
    m = np.tensordot(found[:6], SYMMETRIC, axes=1) / scale
    b = found[6:] - m @ middle
    gradient = point[rows] @ m + b
    length = np.linalg.norm(gradient, axis=1)
    if length.min() <= VANISHING:  # of 1, as `found` is one long and the points are within 1 each
        return None
    along = gradient / length[:, None]
    sign = np.sign((along * normal[rows]).sum(axis=1))
    if np.abs(along * sign[:, None] - normal[rows]).max() > FITS:
        return None
    curvature = float(np.abs(np.linalg.eigvalsh(m)).max() / length.min())
    return _ball(index, m, b, point[rows], curvature) or Patch(
        index,
        "free",
        "gradient",
        gradient=(*m.reshape(-1).tolist(), *b.tolist()),
        curvature=curvature,
    )


SYMMETRIC = np.array([
    np.diag([1, 0, 0]), np.diag([0, 1, 0]), np.diag([0, 0, 1]),
    [[0, 1, 0], [1, 0, 0], [0, 0, 0]],
    [[0, 0, 1], [0, 0, 0], [1, 0, 0]],
    [[0, 0, 0], [0, 0, 1], [0, 1, 0]],
], float)  # fmt: skip


def _ball(
    index: int, m: np.ndarray, b: np.ndarray, point: np.ndarray, curvature: float
) -> Patch | None:
    """The patch as an affine image of the unit sphere, if it is one."""
    m, b = (m, b) if np.trace(m) > 0 else (-m, -b)
    if np.linalg.eigvalsh(m).min() <= 1e-6 * np.abs(m).max():  # m may be all 0: a plane
        return None
    centre = -np.linalg.solve(m, b)
    level = float((((point - centre) @ m) * (point - centre)).sum(axis=1).mean())
    m, b = m / level, b / level
    axes = np.linalg.inv(np.linalg.cholesky(m)).T
    radius = np.linalg.norm((point - centre) @ np.linalg.inv(axes).T, axis=1)
    if np.abs(radius - 1).max() > FITS:
        return None
    axes = axes @ _pole_towards(np.linalg.solve(axes, (point - centre).mean(axis=0)))
    return Patch(
        index, "ball", "gradient", tuple(centre.tolist()), tuple(axes.T.reshape(-1).tolist()),
        (*m.reshape(-1).tolist(), *b.tolist()), curvature=curvature,
    )  # fmt: skip


def _pole_towards(mean: np.ndarray) -> np.ndarray:
    """A rotation that takes +z to where most points are: the fold lies on the other side."""
    length = float(np.linalg.norm(mean))
    if length < 1e-3:
        return np.eye(3)
    z = mean / length
    x = np.cross(np.eye(3)[int(np.argmin(np.abs(z)))], z)
    x = x / np.linalg.norm(x)
    return np.stack([x, np.cross(z, x), z], axis=1)


def _leaving(
    index: int, rows: np.ndarray, point: np.ndarray, normal: np.ndarray, extent: float
) -> Found:
    """Lines of rays that leave end on a sphere round the scene, if most do; else anywhere."""
    picked = point[rows[:: max(1, len(rows) // SAMPLE)]]
    on = picked
    for _ in range(4):
        if not len(on):  # they end all over the place, as those do that start at a horizon
            return [(Patch(index, "free", "none"), rows)]
        centre, radius = _sphere_through(on)
        off = np.abs(np.linalg.norm(picked - centre, axis=1) - radius)
        if off.max() <= FITS * radius:
            break
        on = picked[off <= max(FITS * radius, float(np.quantile(off, 0.9)) * 0.5)]
    is_on = np.abs(np.linalg.norm(point[rows] - centre, axis=1) - radius) <= FITS * radius
    on = rows[is_on]
    if len(on) < 10:
        return [(Patch(index, "free", "none"), rows)]
    to_pole = _pole_towards((point[on] - centre).mean(axis=0)) * radius
    ball = Patch(index, "ball", "none", tuple(centre.tolist()), tuple(to_pole.T.reshape(-1)))
    rest = rows[~is_on]
    return [(ball, on)] + ([(Patch(index, "free", "none"), rest)] if len(rest) else [])


def _sphere_through(point: np.ndarray) -> tuple[np.ndarray, float]:
    middle = point.mean(axis=0)
    p = point - middle
    table = np.concatenate([2 * p, np.ones((len(p), 1)), (p**2).sum(axis=1)[:, None]], axis=1)
    small = triangular(table)
    found = np.linalg.lstsq(small[:, :4], small[:, 4], rcond=None)[0]
    square = float(found[3] + found[:3] @ found[:3])
    return middle + found[:3], float(np.sqrt(max(square, 0.0)))
