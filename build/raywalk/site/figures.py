"""The numbers, models and simplifications that a scene's page names."""

from __future__ import annotations

from typing import Any

from raywalk.scene.model import Mesh, Scene
from raywalk.scene.models import find_catalogue, read_catalogue

Figures = list[tuple[str, str]]  # label, value

GLASS_SHADOWS = {
    "opaque": "are blocked by it, as by stone: a simplification",
    "pass": "go straight through, weakened but not bent: a simplification",
}


def scene_figures(scene: Scene, facts: dict[str, Any]) -> Figures:
    """Label and value for each line. facts: what the trace stage counted (facts.json)."""
    size, levels = scene.render.size, sorted(scene.render.resolutions)
    kept = sum(facts[kind] for kind in ("camera", "secondary", "shadow"))
    figures = [
        ("Picture", f"{size} × {size} pixels, one camera ray each"),
        ("Frustum grids", f"{len(levels)}, from {_square(levels[0])} to {_square(levels[-1])}"),
        ("Rays to walk", f"{kept:,}"),
        ("of these shadow rays", f"{facts['shadow']:,}"),
        ("Most bounces on one path", f"{facts['deepest']}"),
        ("Objects and lights", f"{len(scene.objects)} and {len(scene.lights)}"),
    ]
    if has_glass(scene):
        figures.append(("Shadow rays at glass", GLASS_SHADOWS[scene.render.glass_shadows]))
    figures += [(f"Triangles left out of {name}", why) for name, why in left_out(facts["dropped"])]
    figures += [("Note", warning) for warning in facts["warnings"]]
    return figures + [("Model", credit) for credit in model_credits(scene)]


def left_out(dropped: dict[str, dict[str, int]]) -> Figures:
    """Object and "2 without area, 1 not finite" for each mesh with unusable triangles."""
    return [
        (name, ", ".join(f"{count} {reason}" for reason, count in reasons.items()))
        for name, reasons in dropped.items()
    ]


def has_glass(scene: Scene) -> bool:
    """Whether light goes through any object."""
    return any(scene.materials[obj.material].transmit > 0 for obj in scene.objects)


def model_credits(scene: Scene) -> list[str]:
    """Title, credit and licence of each named model in the scene, once each."""
    named = {obj.shape.model for obj in scene.objects if isinstance(obj.shape, Mesh)}
    if not named:
        return []
    models, _ = read_catalogue(find_catalogue(scene.path))
    known = [models.tables[name] for name in sorted(named) if name in models.tables]
    return [f"{table.title}. {table.credit}. Licence: {table.licence}." for table in known]


def _square(side: int) -> str:
    return f"{side} × {side}"
