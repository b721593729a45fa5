"""What glass does: Snell's law, total reflection, Fresnel's shares, and which glass a ray is in."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.mistakes.rays import NOTHING, Hits
from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.vectors import dot
from raywalk.mistakes.world import Optics


class Border(NamedTuple):
    """n rays at a border between media; unit directions."""

    d: np.ndarray  # (3, n) the ray's direction
    n: np.ndarray  # (3, n) the normal, facing the ray
    cosine: np.ndarray  # (n,) of the angle of incidence, -d.n
    n1: np.ndarray  # (n,) index of refraction that the ray comes from
    n2: np.ndarray  # (n,) that it would go into

    @property
    def sine_sq_beyond(self) -> np.ndarray:
        """(n,) sin^2 of the angle of refraction by Snell, n1 sin a1 = n2 sin a2; above 1 there is
        no such angle: the ray is totally reflected."""
        return np.asarray((self.n1 / self.n2) ** 2 * (1 - self.cosine**2))

    @property
    def cosine_beyond(self) -> np.ndarray:
        """(n,) of the angle of refraction, 0 where there is none."""
        return np.sqrt(np.maximum(0, 1 - self.sine_sq_beyond))

    @property
    def is_total(self) -> np.ndarray:
        """(n,) bool: total reflection."""
        return np.asarray(self.sine_sq_beyond > 1)


def border_at(
    optics: Optics, d: np.ndarray, hits: Hits, media: np.ndarray, mistakes: Mistakes
) -> Border:
    """At hits on glass; media: (w, n), what the rays are in."""
    n1 = indices_before(optics, hits, media)
    n2 = indices_in(optics, crossed(media, hits))
    if "inside-not-told" in mistakes:
        n1, n2 = np.ones_like(n1), optics.ior_of[hits.object]
    if "index-ratio-inverted" in mistakes:
        n1, n2 = n2, n1
    return Border(d, hits.normal, -dot(d, hits.normal), n1, n2)


def refracted_direction(border: Border, hits: Hits, mistakes: Mistakes) -> np.ndarray:
    """(3, n) t = r d + (r cos a1 - cos a2) n with r = n1 / n2 (Glassner, ed., An Introduction to
    Ray Tracing, 1989, ch. 2)."""
    r = border.n1 / border.n2
    bent = r * border.d + (r * border.cosine - border.cosine_beyond) * border.n
    if "total-passed-on" in mistakes:
        bent = np.where(border.is_total, border.d, bent)
    if "not-bent-at-exit" in mistakes:
        bent = np.where(hits.inside, border.d, bent)
    return bent


def shares(
    border: Border, hits: Hits, optics: Optics, mistakes: Mistakes
) -> tuple[np.ndarray, np.ndarray]:
    """(n,) each: shares of the reflected and of the refracted ray.

    Total reflection moves all that would go through to the reflected ray. A Fresnel material's two
    shares are split anew at each angle.
    """
    kr, kt = optics.reflect[hits.material], optics.transmit[hits.material]
    mirrored = fresnel(border, mistakes)
    is_fresnel, both = optics.fresnel[hits.material], kr + kt
    reflected = np.where(is_fresnel, both * mirrored, kr)
    refracted = np.where(is_fresnel, both * (1 - mirrored), kt)
    total = border.is_total
    if "not-bent-at-exit" in mistakes:
        total = total & ~hits.inside
    if "total-black" in mistakes:
        return np.where(total, 0, reflected), np.where(total, 0, refracted)
    if "total-passed-on" in mistakes:
        return np.where(total, 0, reflected), np.where(total, both, refracted)
    return np.where(total, both, reflected), np.where(total, 0, refracted)


def fresnel(border: Border, mistakes: Mistakes) -> np.ndarray:
    """(n,) share of unpolarised light that a border mirrors (Born and Wolf, Principles of Optics,
    7th ed., sec. 1.5.2)."""
    if "fresnel-from-the-other-side" in mistakes:
        border = border._replace(cosine=border.cosine_beyond)
    cos1, cos2, n1, n2 = border.cosine, border.cosine_beyond, border.n1, border.n2
    across = (n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2)
    along = (n2 * cos1 - n1 * cos2) / (n2 * cos1 + n1 * cos2)
    # Never above 1 but for a wrong normal, whose cosine is negative.
    return np.minimum((across**2 + along**2) / 2, 1)


# Which glass rays are in: a stack each, (w, n) objects, the one entered last on top, then NOTHING.


def stacks_holding(entered: list[int], width: int, count: int) -> np.ndarray:
    """(width, count): all in these objects, the outermost first."""
    held = np.array([*entered, *[NOTHING] * width][:width], int)
    return np.tile(held[:, None], (1, count))


def crossed(media: np.ndarray, hits: Hits) -> np.ndarray:
    """(w, n) the stacks beyond the surfaces that were hit: entered, or left wherever it lies."""
    count = (media != NOTHING).sum(axis=0)
    entered = np.where(np.arange(len(media))[:, None] == count, hits.object, media)
    from_it_on = np.cumsum(media == hits.object, axis=0) > 0
    lowered = np.concatenate([media[1:], np.full_like(media[:1], NOTHING)])
    left = np.where(from_it_on, lowered, media)
    return np.where(hits.inside, left, entered)


def indices_in(optics: Optics, media: np.ndarray) -> np.ndarray:
    """(n,) index of refraction on top of each stack; 1 outside everything."""
    count = (media != NOTHING).sum(axis=0)
    top = np.take_along_axis(media, np.maximum(count - 1, 0)[None], axis=0)[0]
    return np.where(count > 0, optics.ior_of[top], 1).astype(optics.ior_of.dtype)


def indices_before(optics: Optics, hits: Hits, media: np.ndarray) -> np.ndarray:
    """(n,) index that rays come from. What a ray leaves without having entered it, it was in."""
    is_lone = hits.inside & (media[0] == NOTHING)
    return np.where(is_lone, optics.ior_of[hits.object], indices_in(optics, media))
