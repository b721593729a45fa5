"""Shadow rays: from the hits of a wave to one light, and on through glass where that is asked."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.geometry.compiled import CompiledScene, Hits, Rays, rows_of
from raywalk.geometry.roots import NOWHERE
from raywalk.optics.compiled import kernel
from raywalk.scene.model import Scene
from raywalk.trace.tables import Materials
from raywalk.trace.tree import Visibility
from raywalk.trace.wave import Lighting

# A shadow ray ends this share of its way before the light, so that a light on a surface
# is not blocked by it; 4,500 roundings, and 1e-12 of a scene is nothing to see.
SHORT_OF_LIGHT = 1.0 - 1e-12
BLOCKED, REACHED = int(Visibility.BLOCKED), int(Visibility.REACHED)
BEHIND = int(Visibility.BEHIND)


class Cast(NamedTuple):
    """Pairs of a point and a light that it asks."""

    rows: np.ndarray  # (p,) points, of the wave
    light: np.ndarray  # (p,)
    to_light: np.ndarray  # (p, 3) unit
    distance: np.ndarray  # (p,)
    facing: np.ndarray  # (p,) bool: on the light's side of their surface
    shot: np.ndarray  # (p,) bool: these shoot a shadow ray

    def take(self, chosen: np.ndarray) -> Cast:
        """The pairs at these indices."""
        return Cast(*rows_of(self, chosen))


def cast_shadows(
    scene: Scene, compiled: CompiledScene, materials: Materials, hits: Hits, cast: Cast,
    out: Lighting,
) -> None:  # fmt: skip
    """Fills the lights' visibility, and dims their factors where glass lets a share pass."""
    rays, reach = shadow_rays(hits, cast)
    found = compiled.nearest(rays, reach)
    t, met, passed = found[0], found[1], np.ones(len(reach))
    if scene.render.glass_shadows == "pass":
        t, met = through_glass(compiled, materials, rays, reach, found, passed)
    note_shadows(cast, t, met, passed, out)


Found = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]  # as CompiledScene.nearest gives it


def through_glass(
    compiled: CompiledScene, materials: Materials, rays: Rays, reach: np.ndarray, found: Found,
    passed: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:  # fmt: skip
    """Lets shadow rays pass glass unbent: t and object of the opaque thing each meets first.

    found: what they meet first at all, before reach (n,). passed: (n,) is multiplied by the
    `transmit` of the surfaces crossed. A stated simplification: real light bends, and gathers in
    caustics.
    """
    t, met = found[0].copy(), found[1].copy()
    base, going = np.zeros(len(t)), np.flatnonzero(met != NOWHERE)
    ahead = rows_of(found, going)
    while len(going):
        hits = compiled.surface(rays.take(going), *ahead)
        going = cross_glass(materials.transmit, hits, going, reach, base, passed, rays)
        further = compiled.nearest(rays.take(going), reach.take(going) - base.take(going))
        t[going], met[going] = base.take(going) + further[0], further[1]
        on = np.flatnonzero(further[1] != NOWHERE)
        going, ahead = going.take(on), rows_of(further, on)
    return t, met


def shadow_rays(hits: Hits, cast: Cast) -> tuple[Rays, np.ndarray]:
    """The shadow rays that are shot, and how far each goes."""
    *columns, reach = start_to_light(
        cast, hits.point, hits.object, hits.inside, hits.triangle, SHORT_OF_LIGHT
    )
    return Rays(*columns), reach


@kernel
def start_to_light(cast, point, leaving, inner, triangle, share):
    """Columns of Rays, and the share of each one's distance."""
    count = 0
    for shot in cast.shot:
        count += shot
    origin, direction = np.empty((count, 3)), np.empty((count, 3))
    own, inwards = np.empty(count, np.int32), np.empty(count, np.bool_)
    on, reach = np.empty(count, np.int32), np.empty(count)
    ray = 0
    for r in range(cast.rows.shape[0]):
        if not cast.shot[r]:
            continue
        i = cast.rows[r]
        for c in range(3):
            origin[ray, c], direction[ray, c] = point[i, c], cast.to_light[r, c]
        own[ray], inwards[ray], on[ray] = leaving[i], inner[i], triangle[i]
        reach[ray] = cast.distance[r] * share
        ray += 1
    return origin, direction, own, inwards, on, reach


@kernel
def cross_glass(transmit, hits, going, reach, base, passed, rays):
    """Moves the rays `going` (g,) through the clear surfaces that they met before their ends;
    returns which those are. The hits are (g,), the others (n,)."""
    on, filled = np.empty_like(going), 0
    for g in range(going.shape[0]):
        i, clear = going[g], transmit[hits.material[g]]
        if not (clear > 0.0 and hits.t[g] < reach[i] - base[i]):
            continue
        passed[i] *= clear
        base[i] += hits.t[g]
        for c in range(3):
            rays.origin[i, c] = hits.point[g, c]
        rays.leaving[i], rays.triangle[i] = hits.object[g], hits.triangle[g]
        rays.inner[i] = not hits.inside[g]
        on[filled] = i
        filled += 1
    return on[:filled]


@kernel
def note_shadows(cast, t, met, passed, out):
    """Writes columns (n, l): t, met and passed are of the rays that were shot."""
    ray = 0
    for r in range(cast.rows.shape[0]):
        i, k = cast.rows[r], cast.light[r]
        out.visibility[i, k] = BEHIND
        if not cast.shot[r]:
            continue
        if met[ray] != NOWHERE:
            out.blocked_at[i, k] = t[ray] / cast.distance[r]
        if cast.facing[r]:
            out.visibility[i, k] = BLOCKED if met[ray] != NOWHERE else REACHED
        out.blocker[i, k], out.passed[i, k] = met[ray], passed[ray]
        out.diffuse[i, k] *= passed[ray]
        out.specular[i, k] *= passed[ray]
        ray += 1
