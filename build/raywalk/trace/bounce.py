"""The rays that mirrors and glass send on."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.geometry.compiled import CompiledScene, Hits, Rays, rows_of
from raywalk.optics.scatter import glass_shares, mirror_directions, refracted_directions
from raywalk.trace.media import indices_before, indices_in, resolve_media
from raywalk.trace.tables import Materials
from raywalk.trace.tree import Kind


class Bounced(NamedTuple):
    """Rays of the next wave with their ties to this one."""

    rays: Rays
    parent: np.ndarray  # (n,) int32
    kind: np.ndarray  # (n,) uint8
    weight: np.ndarray  # (n,)
    share: np.ndarray  # (n,) product of weights from the camera on: share in the pixel
    media: np.ndarray  # (n, w) int32
    faint: int  # rays not sent, because of `least`


def bounce(
    compiled: CompiledScene, materials: Materials, ior_of: np.ndarray,
    rays: Rays, hits: Hits, media: np.ndarray, share: np.ndarray, least: float,
) -> Bounced:  # fmt: skip
    """Reflected rays first, then refracted ones, each in the order of their parents.

    A ray whose share in the pixel would be at most `least` is not sent.
    """
    mirror = materials.reflect[hits.material]
    through, total = np.zeros(len(mirror)), np.zeros(len(mirror), bool)
    n_from = n_to = np.ones(len(mirror))
    after = media
    glass = np.flatnonzero(materials.transmit[hits.material] > 0.0)
    if len(glass):
        n_from, n_to, after = n_from.copy(), n_to.copy(), media.copy()
        met, direction = hits.take(glass), rays.direction.take(glass, axis=0)
        crossed = media.take(glass, axis=0)
        before = indices_before(crossed, met.object, met.inside, ior_of)
        # Straight on: where glass touches glass, all borders are crossed at once.
        straight = Rays(met.point, direction, met.object, ~met.inside, met.triangle)
        resolve_media(crossed, *compiled.beyond(straight, met.t, straight=True))
        beyond = indices_in(crossed, ior_of)
        n_from[glass], n_to[glass], after[glass] = before, beyond, crossed
        mirror[glass], through[glass], total[glass] = glass_shares(
            direction, met.normal, before, beyond, materials.reflect[met.material],
            materials.transmit[met.material], materials.fresnel[met.material],
        )  # fmt: skip
    back, on = np.flatnonzero(mirror * share > least), np.flatnonzero(through * share > least)
    faint = int(np.count_nonzero(mirror) + np.count_nonzero(through)) - len(back) - len(on)
    reflected = mirror_directions(*rows_of((rays.direction, hits.normal, hits.geometric), back))
    refracted = np.empty((0, 3))
    if len(on):
        refracted = refracted_directions(
            *rows_of((rays.direction, hits.normal, hits.geometric, n_from, n_to), on)
        )
    parent = np.concatenate([back, on])
    weight = np.concatenate([mirror[back], through[on]])
    # A reflected ray stays on the side it came from, a refracted one changes it.
    point, leaving, triangle = rows_of((hits.point, hits.object, hits.triangle), parent)
    onward = Rays(
        point, np.concatenate([reflected, refracted]), leaving,
        np.concatenate([hits.inside[back], ~hits.inside[on]]), triangle,
    )  # fmt: skip
    stacks = np.concatenate([media.take(back, axis=0), after.take(on, axis=0)])
    if stacks.shape[1]:
        resolve_media(stacks, *compiled.beyond(onward, hits.t[parent]))
    return Bounced(
        rays=onward,
        parent=parent.astype(np.int32),
        kind=np.concatenate(
            [
                np.where(total[back], Kind.TOTAL, Kind.REFLECTED),
                np.full(len(on), Kind.REFRACTED),
            ]
        ).astype(np.uint8),
        weight=weight,
        share=share[parent] * weight,
        media=stacks,
        faint=faint,
    )
