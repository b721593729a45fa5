"""Shadow rays and Blinn-Phong at the hits of a wave."""

from __future__ import annotations

import numpy as np

from raywalk.geometry.compiled import CompiledScene, Hits, Rays
from raywalk.geometry.roots import NOWHERE
from raywalk.optics.shade import light_factors, local_colours, towards_lights
from raywalk.scene.model import Scene
from raywalk.trace.plan import Plan, plan_of
from raywalk.trace.shadows import Cast, cast_shadows
from raywalk.trace.tables import Lights, Materials
from raywalk.trace.tree import Visibility
from raywalk.trace.wave import Lighting

# Of a hit and a light, asked at once: all hits of a strip and one light; of the last bounces, when
# few rays are left, all lights, which share what a call costs (up to a tenth of a scene's time).
PAIRS = 32_768
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
    at_once = max(1, PAIRS // len(asked))
    for first in range(0, many, at_once):
        lamps = np.arange(first, min(first + at_once, many))
        to_light, distance, facing = towards_lights(
            asked, hits.point, hits.geometric, lights.position[lamps]
        )
        light_factors(
            materials, lights, first, asked, hits.material, hits.normal, rays.direction, to_light,
            distance, out.diffuse, out.specular,
        )  # fmt: skip
        # Points that do not face the light are in their own shadow.
        shot = facing if plan.leave_turned else np.full(len(facing), True)
        pairs = np.tile(asked, len(lamps)), lamps.repeat(len(asked))
        cast = Cast(*pairs, to_light, distance, facing, shot)
        is_asked = np.array(plan.asked)[lamps]
        if not is_asked.all():
            cast = cast.take(np.flatnonzero(is_asked.repeat(len(asked))))
        if is_asked.any():
            cast_shadows(scene, compiled, materials, hits, cast, out)
    lit = (out.visibility == Visibility.REACHED) | (out.visibility == Visibility.UNTESTED)
    local_colours(
        materials, lights, asked, hits.material, NO_BASE if out.base is None else out.base,
        lit, out.diffuse, out.specular, out.local,
    )  # fmt: skip
    return out
