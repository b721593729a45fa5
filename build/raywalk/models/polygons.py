"""Polygons cut into triangles: convex ones as a fan, others by ears, so that nothing is covered
that the polygon leaves open.

Mapbox's earcut does the work. It leaves corners out that lie on a straight line, which would part
a face from its neighbour; where it did, ears are cut here, the roundest first, and keep them.
"""

from __future__ import annotations

import numpy as np

# Corners of a polygon that is cut again so that it keeps them all; the time grows by the square.
MOST_CORNERS = 1500
TRIES = 8  # ears that are looked at for each corner: of one that crosses itself none may do
CORNERS = 1 << 17  # looked at together
# Below this share of its longest side squared a triangle counts as without area.
FLAT = 1e-12


def triangulated(
    vertices: np.ndarray, counts: np.ndarray, corners: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Triangles (t, 3) int, as places in `corners`, and the polygon (t,) int64 of each.

    vertices: (v, 3); counts: (p,) corners of each polygon, at least 3; corners: (sum,) rows of
    vertices. In the order of the polygons; triangles stay as they are.
    """
    if (counts == 3).all():
        return np.arange(len(corners), dtype=np.int32).reshape(-1, 3), np.arange(len(counts))
    start = np.cumsum(counts) - counts
    made, of = [], []
    for size in np.unique(counts):
        of_size = np.flatnonzero(counts == size)
        # A few at once: what is worked out for each weighs ten times as much as it does.
        for which in np.array_split(of_size, -(-len(of_size) * size // CORNERS)):
            places = start[which][:, None] + np.arange(size)
            fans, odd = _fans(vertices, corners, places)
            whose = np.repeat(which, size - 2)
            fan = fans.reshape(-1, 3)
            fan, whose = _with_cut(vertices, corners, places, odd, fan, whose, which)
            made.append(fan)
            of.append(whose)
    triangles, polygon = np.concatenate(made), np.concatenate(of)
    order = np.argsort(polygon, kind="stable")
    return triangles[order], polygon[order]


def _fans(
    vertices: np.ndarray, corners: np.ndarray, places: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Fans (p, n - 2, 3) from the first corners, and which polygons (p,) bool they do not suit."""
    size = places.shape[1]
    fan = np.stack(
        [np.broadcast_to(places[:, :1], (len(places), size - 2)), places[:, 1:-1], places[:, 2:]],
        axis=2,
    )
    if size == 3:
        return fan, np.zeros(len(places), bool)
    at = vertices[corners[places]]
    with np.errstate(all="ignore"):
        # Newell's normal, relative to the first corner so that places far out keep their digits.
        beside = at - at[:, :1]
        normal = np.cross(beside, np.roll(beside, -1, axis=1)).sum(axis=1)
        forward = np.roll(at, -1, axis=1) - at
        turns = (np.cross(np.roll(forward, 1, axis=1), forward) * normal[:, None]).sum(axis=2)
        blades = np.cross(beside[:, 1:-1], beside[:, 2:])
        share = (blades * normal[:, None]).sum(axis=2)
        least = FLAT * (normal**2).sum(axis=1)[:, None]
        is_convex = (turns >= 0).all(axis=1) & (share > least).all(axis=1)
    return fan, ~is_convex


def _with_cut(
    vertices: np.ndarray, corners: np.ndarray, places: np.ndarray, odd: np.ndarray,
    fans: np.ndarray, of: np.ndarray, which: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:  # fmt: skip
    """The fans, but for odd polygons, which are cut by their ears."""
    if not odd.any():
        return fans, of
    cut = [ears(vertices[corners[places[k]]]) for k in np.flatnonzero(odd)]
    made = [places[k][ear] for k, ear in zip(np.flatnonzero(odd), cut, strict=True)]
    keep = ~np.repeat(odd, places.shape[1] - 2)
    whose = np.repeat(which[odd], [len(each) for each in made])
    return np.concatenate([fans[keep], *made]), np.concatenate([of[keep], whose])


def ears(points: np.ndarray) -> np.ndarray:
    """Triangles (t, 3) of one polygon's corners (n, 3), which lie about in a plane."""
    flat = _flattened(points)
    if flat is None:  # on a line, or no places: whatever it is cut into is dropped later
        return _fan(len(points))
    import mapbox_earcut  # only here: most files hold triangles

    found = mapbox_earcut.triangulate_float64(flat, np.array([len(flat)], np.uint32))
    cut = np.array(found, np.int64).reshape(-1, 3)
    cut = np.where((_twice_area(flat, cut) < 0)[:, None], cut[:, ::-1], cut)
    if _keeps_all(flat, cut) or len(flat) > MOST_CORNERS:
        return cut
    own = roundest_ears(flat)
    return own if len(own) else cut


def roundest_ears(flat: np.ndarray) -> np.ndarray:
    """Triangles (n - 2, 3) of a simple polygon (n, 2), anticlockwise: the ear with the largest
    smallest height is cut first, so that corners on a straight line go into proper triangles.

    Empty where it crosses itself, and no ear is left.
    """
    left, made, tries = list(range(len(flat))), [], TRIES * len(flat)
    while len(left) > 3:
        ring = np.array(left)
        before, after = np.roll(ring, 1), np.roll(ring, -1)
        trio = np.column_stack([before, ring, after])
        quality = _quality(flat, trio)
        for place in np.argsort(-quality):
            tries -= 1
            if not quality[place] > 0 or tries < 0:
                return np.empty((0, 3), np.int64)
            if not _holds_any(flat, trio[place], ring):
                made.append(trio[place])
                del left[place]
                break
        else:
            return np.empty((0, 3), np.int64)
    cut = np.array([*made, left], np.int64)
    return cut if (_quality(flat, cut[-1:]) > 0).all() else cut[:0]


def _quality(flat: np.ndarray, trio: np.ndarray) -> np.ndarray:
    """(t,) twice the area over the longest side squared; negative if it turns the other way."""
    at = flat[trio]
    longest = ((np.roll(at, 1, axis=1) - at) ** 2).sum(axis=2).max(axis=1)
    area = _twice_area(flat, trio)
    share = np.divide(area, longest, out=np.zeros_like(area), where=longest > 0)
    return np.where(share > FLAT, share, np.minimum(share, 0.0))


def _holds_any(flat: np.ndarray, trio: np.ndarray, ring: np.ndarray) -> bool:
    """Whether a corner of the ring lies in the triangle, or on the side that would be cut."""
    others = flat[ring[~np.isin(ring, trio)]]
    a, b, c = flat[trio]
    same = (others[:, None] == np.array([a, b, c])).all(axis=2).any(axis=1)
    sides = [_side(a, b, others), _side(b, c, others), _side(c, a, others)]
    # On the new side counts as in: what was meant to be there is off it by rounding.
    on_it = -FLAT * ((c - a) ** 2).sum()
    return bool(((sides[0] > 0) & (sides[1] > 0) & (sides[2] >= on_it) & ~same).any())


def _side(a: np.ndarray, b: np.ndarray, points: np.ndarray) -> np.ndarray:
    return (b[0] - a[0]) * (points[:, 1] - a[1]) - (b[1] - a[1]) * (points[:, 0] - a[0])


def _keeps_all(flat: np.ndarray, cut: np.ndarray) -> bool:
    """Whether each side of the polygon is a side of one triangle, and none is without area."""
    if len(cut) != len(flat) - 2 or not (_quality(flat, cut) > 0).all():
        return False
    sides = np.concatenate([cut[:, [0, 1]], cut[:, [1, 2]], cut[:, [2, 0]]])
    held = set(map(tuple, sides.tolist()))
    return all((k, (k + 1) % len(flat)) in held for k in range(len(flat)))


def _flattened(points: np.ndarray) -> np.ndarray | None:
    """(n, 2) in the polygon's plane, anticlockwise; None if it has none."""
    if not np.isfinite(points).all():
        return None
    beside = points - points[0]
    size = np.abs(beside).max()
    if size == 0 or not np.isfinite(size):
        return None
    beside = beside / size
    normal = np.cross(beside, np.roll(beside, -1, axis=0)).sum(axis=0)
    if not np.abs(normal).max() > FLAT:
        return None
    axis = int(np.abs(normal).argmax())
    kept = [(axis + 1) % 3, (axis + 2) % 3]
    flat = beside[:, kept] if normal[axis] > 0 else beside[:, kept] * [1.0, -1.0]
    return np.ascontiguousarray(flat)


def _twice_area(flat: np.ndarray, trio: np.ndarray) -> np.ndarray:
    a, b, c = flat[trio[:, 0]], flat[trio[:, 1]], flat[trio[:, 2]]
    u, v = b - a, c - a
    return u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]


def _fan(count: int) -> np.ndarray:
    last = np.arange(2, count)
    return np.column_stack([np.zeros_like(last), last - 1, last])
