"""Rays on their way and what they meet: columns, a ray each. World units."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.mistakes.vectors import dot

NOTHING = -1  # meets no object, leaves no surface


class Rays(NamedTuple):
    """n rays. A ray that starts on a surface knows which: it cannot meet that surface where it
    starts, so no small number has to keep it off (Waechter and Binder, Ray Tracing Gems, 2019,
    ch. 6)."""

    origin: np.ndarray  # (3, n)
    direction: np.ndarray  # (3, n)
    leaving: np.ndarray  # (n,) the object whose surface it starts on, or NOTHING
    inwards: np.ndarray  # (n,) bool: it starts to the inner side of that surface

    def take(self, chosen: np.ndarray) -> Rays:
        """Those at these indices."""
        # numpy's own indexing, part[..., chosen], takes four times as long.
        return Rays(*(part.take(chosen, axis=-1) for part in self))


class Hits(NamedTuple):
    """What n rays met first."""

    t: np.ndarray  # (n,) in units of the direction, inf if nothing
    object: np.ndarray  # (n,) NOTHING if nothing
    point: np.ndarray  # (3, n)
    normal: np.ndarray  # (3, n) as the program has it: right if unit and facing the ray
    outward: np.ndarray  # (3, n) unit, truly the surface's, to its outer side
    inside: np.ndarray  # (n,) bool: the ray came from the inner side
    material: np.ndarray  # (n,) -1 if nothing

    def take(self, chosen: np.ndarray) -> Hits:
        """Those at these indices."""
        return Hits(*(part.take(chosen, axis=-1) for part in self))


def free_rays(origin: np.ndarray, direction: np.ndarray) -> Rays:
    """Rays that start on no surface, such as camera rays."""
    count = direction.shape[1]
    start = np.broadcast_to(origin, direction.shape)
    return Rays(start, direction, np.full(count, NOTHING), np.zeros(count, bool))


def rays_off(hits: Hits, direction: np.ndarray) -> Rays:
    """Rays that set out from hits."""
    return Rays(hits.point, direction, hits.object, dot(direction, hits.outward) < 0)


def rays_off_rounded(came: Rays, hits: Hits, direction: np.ndarray) -> Rays:
    """Rays that forget which surface they leave, and have no offset: from o + t d of the rays that
    came, worked out in float32. So about half of them start below their surface and meet it."""
    single = (part.astype(np.float32) for part in (came.origin, hits.t, came.direction))
    o, t, d = single
    start = (o + t * d).astype(direction.dtype)
    count = direction.shape[1]
    return Rays(start, direction, np.full(count, NOTHING), np.zeros(count, bool))
