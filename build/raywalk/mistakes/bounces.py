"""The rays that mirrors and glass send on."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.mistakes.glass import border_at, crossed, refracted_direction, shares
from raywalk.mistakes.mirrors import mirror_direction
from raywalk.mistakes.rays import Hits, Rays, rays_off, rays_off_rounded
from raywalk.mistakes.remembered import remembered
from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.world import Optics
from raywalk.trace.tree import Kind


class Sent(NamedTuple):
    """Rays of the next depth, with their ties to this one."""

    rays: Rays
    parent: np.ndarray  # (n,) place in the depth before, -1 of camera rays
    kind: np.ndarray  # (n,) Kind
    weight: np.ndarray  # (n,) share of its colour in its parent's
    share: np.ndarray  # (n,) product of weights from the camera on
    media: np.ndarray  # (w, n) the glass that each is in


@remembered
def bounced(optics: Optics, sent: Sent, hits: Hits, least_share: float, mistakes: Mistakes) -> Sent:
    """The rays that the hits of `sent` send on: reflected ones first, then refracted ones, each in
    the order of their parents. A ray whose share in its pixel would not be above least_share is not
    sent."""
    mirrored = optics.reflect[hits.material]
    through, total = np.zeros_like(mirrored), np.zeros(len(mirrored), bool)
    bent, beyond = sent.rays.direction.copy(), sent.media.copy()
    glass = np.flatnonzero(optics.transmit[hits.material] > 0)
    if len(glass):
        at, media = hits.take(glass), sent.media.take(glass, axis=1)
        border = border_at(optics, sent.rays.direction.take(glass, axis=1), at, media, mistakes)
        mirrored[glass], through[glass] = shares(border, at, optics, mistakes)
        total[glass] = border.is_total & (through[glass] == 0)
        bent[:, glass] = refracted_direction(border, at, mistakes)
        beyond[:, glass] = crossed(media, at)
    back = np.flatnonzero(mirrored * sent.share > least_share)
    on = np.flatnonzero(through * sent.share > least_share)
    parent = np.concatenate([back, on])
    off = mirror_direction(sent.rays.direction.take(back, axis=1), hits.take(back), mistakes)
    direction = np.concatenate([off, bent.take(on, axis=1)], axis=1)
    rays = rays_off(hits.take(parent), direction)
    if "mirror-acne" in mistakes:
        rays = rays_off_rounded(sent.rays.take(parent), hits.take(parent), direction)
    weight = np.concatenate([mirrored[back], through[on]])
    kind = [np.where(total[back], Kind.TOTAL, Kind.REFLECTED), np.full(len(on), Kind.REFRACTED)]
    return Sent(
        rays, parent, np.concatenate(kind), weight, sent.share[parent] * weight,
        np.concatenate([sent.media.take(back, axis=1), beyond.take(on, axis=1)], axis=1),
    )  # fmt: skip
