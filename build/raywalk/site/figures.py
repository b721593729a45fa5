"""The numbers, models and simplifications that a scene's page names."""

from __future__ import annotations

from typing import Any

from raywalk.scene.credits import named_models
from raywalk.scene.model import Scene
from raywalk.words import Words

Figures = list[tuple[str, str]]  # label, value


def scene_figures(scene: Scene, facts: dict[str, Any], words: Words) -> Figures:
    """Label and value for each line. facts: what the trace stage counted (facts.json)."""
    say, grouped = words.say, words.numbers.grouped
    size, levels = scene.render.size, sorted(scene.render.resolutions)
    kept = sum(facts[kind] for kind in ("camera", "secondary", "shadow"))
    things = {"objects": len(scene.objects), "lights": len(scene.lights)}
    grids = {"amount": len(levels), "least": levels[0], "most": levels[-1]}
    figures = [
        (say("pages.figures.picture"), say("pages.figures.pictureIs", size=size)),
        (say("pages.figures.grids"), say("pages.figures.gridsAre", **grids)),
        (say("pages.figures.rays"), grouped(kept)),
        (say("pages.figures.shadowRays"), grouped(facts["shadow"])),
        (say("pages.figures.deepest"), str(facts["deepest"])),
        (say("pages.figures.things"), say("pages.figures.thingsAre", **things)),
    ]
    if scene.has_glass:
        figures.append((say("pages.figures.glassShadows"), say(_at_glass(scene))))
    figures += [
        (say("pages.figures.leftOut", name=name), why) for name, why in left_out(facts["dropped"])
    ]
    figures += [(say("pages.figures.note"), warning) for warning in facts["warnings"]]
    return figures + [
        (say("pages.figures.model"), credit) for credit in model_credits(scene, words)
    ]


def left_out(dropped: dict[str, dict[str, int]]) -> Figures:
    """Object and "2 without area, 1 not finite" for each mesh with unusable triangles."""
    return [
        (name, ", ".join(f"{count} {reason}" for reason, count in reasons.items()))
        for name, reasons in dropped.items()
    ]


def model_credits(scene: Scene, words: Words) -> list[str]:
    """Title, credit and licence of each named model in the scene, once each."""
    return [
        words.say(
            "pages.figures.modelIs", title=table.title, credit=table.credit, licence=table.licence
        )
        for table in named_models(scene)
    ]


def _at_glass(scene: Scene) -> str:
    """The key of what happens to shadow rays at the scene's glass."""
    if scene.render.glass_shadows == "opaque":
        return "pages.figures.glassOpaque"
    used = (scene.materials[obj.material] for obj in scene.objects)
    is_clear = all(material.transmit == 1 for material in used if material.transmit > 0)
    return "pages.figures.glassClear" if is_clear else "pages.figures.glassPass"
