"""Shadow rays and Blinn-Phong at the hits of a wave."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.compiled import CompiledScene, Hits, Rays
from raywalk.geometry.roots import NOWHERE
from raywalk.optics.shade import light_factors, local_colours, towards_light
from raywalk.scene.model import Scene
from raywalk.trace.plan import Plan, plan_of
from raywalk.trace.shadows import Cast, cast_shadows
from raywalk.trace.tables import Lights, Materials
from raywalk.trace.tree import Visibility
from raywalk.trace.wave import Lighting

NO_BASE = np.empty((0, 3))


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
        blocker=np.full((count, many), NOWHERE, np.int32),
        blocked_at=np.ones((count, many)),
        passed=np.ones((count, many)),
        diffuse=np.zeros((count, many)),
        specular=np.zeros((count, many)),
        local=np.zeros((count, 3)),
        local_weight=local_weight,
        base=compiled.base_colours(hits),
    )
    wanted = local_weight > 0.0 if plan.leave_colourless else hits.object != NOWHERE
    asked = np.flatnonzero(wanted)
    if not len(asked):
        return out
    for k in range(many):
        to_light, distance, facing = towards_light(
            asked, hits.point, hits.geometric, lights.position[k]
        )
        light_factors(
            materials, asked, hits.material, hits.normal, rays.direction, to_light, distance,
            lights.intensity[k], lights.attenuation[k], k, out.diffuse, out.specular,
        )  # fmt: skip
        if plan.asked[k]:
            # Points that do not face the light are in their own shadow.
            shot = facing if plan.leave_turned else np.full(len(asked), True)
            cast = Cast(asked, to_light, distance, facing, shot)
            cast_shadows(scene, compiled, materials, hits, cast, k, out)
    lit = (out.visibility == Visibility.REACHED) | (out.visibility == Visibility.UNTESTED)
    local_colours(
        materials, lights, asked, hits.material, NO_BASE if out.base is None else out.base,
        lit, out.diffuse, out.specular, out.local,
    )  # fmt: skip
    return out
