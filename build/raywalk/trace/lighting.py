"""Shadow rays and Blinn-Phong at the hits of a wave."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.compiled import CompiledScene, Hits, Rays
from raywalk.geometry.nearest import NOWHERE
from raywalk.optics.shade import light_factors, local_colours, towards_light
from raywalk.scene.model import Scene
from raywalk.trace.plan import Plan, plan_of
from raywalk.trace.tables import Lights, Materials
from raywalk.trace.tree import Visibility
from raywalk.trace.wave import Lighting

# A shadow ray ends this share of its way before the light, so that a light on a surface
# is not blocked by it; 4,500 roundings, and 1e-12 of a scene is nothing to see.
SHORT_OF_LIGHT = 1.0 - 1e-12


def light_hits(
    scene: Scene, compiled: CompiledScene, materials: Materials, lights: Lights,
    rays: Rays, hits: Hits, plan: Plan | None = None,
) -> Lighting:  # fmt: skip
    """What each light gives to each hit. Points without a colour of their own are not asked."""
    plan = plan or plan_of(scene)
    count, many = len(hits.t), len(lights.intensity)
    share = 1.0 - materials.reflect[hits.material] - materials.transmit[hits.material]
    local_weight = np.where(hits.object != NOWHERE, share, 0.0)
    out = Lighting(
        visibility=np.full((count, many), Visibility.UNTESTED, np.uint8),
        blocker=np.full((count, many), NOWHERE, np.int16),
        blocked_at=np.ones((count, many)),
        passed=np.ones((count, many)),
        diffuse=np.zeros((count, many)),
        specular=np.zeros((count, many)),
        local=np.zeros((count, 3)),
        local_weight=local_weight,
    )
    wanted = local_weight > 0.0 if plan.leave_colourless else hits.object != NOWHERE
    asked = np.flatnonzero(wanted)
    if not len(asked):
        return out
    seen = hits.take(asked)
    incoming = rays.direction[asked]
    for k in range(many):
        to_light, distance, facing = towards_light(seen.point, seen.geometric, lights.position[k])
        diffuse, specular = np.zeros(len(asked)), np.zeros(len(asked))
        light_factors(
            materials, seen.material, seen.normal, incoming, to_light, distance,
            lights.intensity[k], lights.attenuation[k], diffuse, specular,
        )  # fmt: skip
        if plan.asked[k]:
            passed = _shadow(scene, compiled, materials, seen, to_light, distance, facing,
                             asked, k, out, plan)  # fmt: skip
            out.passed[asked, k] = passed
            diffuse, specular = diffuse * passed, specular * passed
        out.diffuse[asked, k], out.specular[asked, k] = diffuse, specular
    lit = out.visibility[asked] != Visibility.BLOCKED
    lit &= out.visibility[asked] != Visibility.BEHIND
    out.local[asked] = local_colours(
        materials, lights, seen.material, lit, out.diffuse[asked], out.specular[asked]
    )
    return out


def _shadow(
    scene: Scene, compiled: CompiledScene, materials: Materials, seen: Hits,
    to_light: np.ndarray, distance: np.ndarray, facing: np.ndarray,
    asked: np.ndarray, k: int, out: Lighting, plan: Plan,
) -> np.ndarray:  # fmt: skip
    """Fills one light's visibility; returns the share (n,) that glass on the way lets pass.

    Only points that face the light shoot a shadow ray: the others are in their own shadow.
    """
    visibility = np.full(len(asked), Visibility.BEHIND, np.uint8)
    shot = np.flatnonzero(facing) if plan.leave_turned else np.arange(len(asked))
    rays = Rays(
        seen.point[shot], to_light[shot], seen.object[shot], seen.inside[shot], seen.triangle[shot]
    )
    reach = distance[shot] * SHORT_OF_LIGHT
    t, met, _, _ = compiled.nearest(rays, reach)
    passed = np.ones(len(asked))
    if scene.render.glass_shadows == "pass":
        t, met, passed[shot] = through_glass(compiled, materials, rays, reach, t, met)
    blocked = met != NOWHERE
    visibility[shot] = np.where(blocked, Visibility.BLOCKED, Visibility.REACHED)
    visibility[~facing] = Visibility.BEHIND
    out.visibility[asked, k] = visibility
    out.blocker[asked[shot], k] = met
    out.blocked_at[asked[shot], k] = np.where(blocked, t / distance[shot], 1.0)
    return passed


def through_glass(
    compiled: CompiledScene, materials: Materials, rays: Rays,
    reach: np.ndarray, t: np.ndarray, met: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:  # fmt: skip
    """Lets shadow rays pass glass unbent: t and object of the first opaque hit, and the share.

    The share (n,) is the product of `transmit` over the surfaces crossed. A stated
    simplification: real light bends, and gathers in caustics.
    """
    t, met, passed = t.copy(), met.copy(), np.ones(len(t))
    base, going = np.zeros(len(t)), np.flatnonzero(met != NOWHERE)
    while len(going):
        hits = compiled.hits(rays.take(going))
        clear = materials.transmit[hits.material]
        on = (clear > 0.0) & (hits.t < reach[going] - base[going])
        going, clear = going[on], clear[on]
        hits = hits.take(on)
        passed[going] *= clear
        base[going] += hits.t
        rays.origin[going], rays.leaving[going] = hits.point, hits.object
        rays.inner[going], rays.triangle[going] = ~hits.inside, hits.triangle
        further, next_met, _, _ = compiled.nearest(rays.take(going), reach[going] - base[going])
        t[going], met[going] = base[going] + further, next_met
        going = going[next_met != NOWHERE]
    return t, met, passed
