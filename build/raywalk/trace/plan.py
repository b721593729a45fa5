"""What a scene needs, worked out from the scene alone; the tracer does nothing else.

Each switch may be turned off to measure what it brings (`raywalk bench --only skips`): the
picture stays the same, only the work grows.
"""

from __future__ import annotations

from dataclasses import dataclass

from raywalk.scene.model import Scene

# A ray with a smaller share in its pixel is not followed in pictures: it could change the
# 8-bit colour by 0.06 of a step. Clear glass splits every ray in two and would otherwise
# cost 2^depth rays a pixel for light that nobody can see.
LEAST_SHARE = 1.0 / 4096.0


@dataclass(frozen=True)
class Plan:
    """Of one scene. Materials and lights that stand in the scene unused do not count."""

    meshes: bool  # else trimesh and Embree are not even imported
    mirrors: bool
    glass: bool
    highlights: bool  # some surface has a highlight to work out
    depth: int  # bounces that can happen: 0 if nothing reflects or refracts
    shadows: bool  # the scene has shadows
    asked: tuple[bool, ...]  # per light: shadow rays are sent to it
    # Skips that depend on the ray, not on the scene alone:
    leave_turned: bool = True  # no shadow ray from a surface turned away from the light
    leave_colourless: bool = True  # no light asked where a surface has no colour of its own

    @property
    def stages_not_run(self) -> list[str]:
        """By the keys of their words, in the order of a ray's way."""
        runs = {
            "meshes": self.meshes,
            "shadows": any(self.asked),
            "highlights": self.highlights,
            "reflection": self.mirrors or self.glass,
            "refraction": self.glass,
        }
        return [stage for stage, is_run in runs.items() if not is_run]


def plan_of(scene: Scene, depth: int | None = None) -> Plan:
    """The plan of a scene; depth: bounces at most, the scene's own if not given."""
    used = {obj.material for obj in scene.objects}
    used |= {obj.checker.material for obj in scene.objects if obj.checker}
    materials = [scene.materials[k] for k in sorted(used)]
    glass = any(m.transmit > 0 for m in materials)
    mirrors = any(m.reflect > 0 for m in materials)
    has_own_colour = any(m.reflect + m.transmit < 1 for m in materials)
    bounces = scene.render.depth if depth is None else depth
    return Plan(
        meshes=scene.has_mesh,
        mirrors=mirrors,
        glass=glass,
        highlights=any(any(m.specular) for m in materials) and bool(scene.lights),
        depth=bounces if mirrors or glass else 0,
        shadows=scene.render.shadows,
        asked=tuple(
            scene.render.shadows and has_own_colour and light.intensity > 0 and any(light.colour)
            for light in scene.lights
        ),
    )
