"""What tracing a scene did not have to do: lines for its page, the viewer and `--stats`."""

from __future__ import annotations

from typing import Any

from raywalk.site.figures import Figures
from raywalk.words import Words

# Key of its words, what was spared, and of how many; 0 if that is not to be told.
Spared = tuple[str, int, int]


def spared_of(facts: dict[str, Any]) -> dict[str, Any]:
    """The same for the viewer, without words: the stages not run, and the counts there are.

    facts: what the trace stage counted (facts.json).
    """
    tally = facts["tally"]
    tests, pixels = tally["tests"] + tally["tests_spared"], tally["pixels"]
    counts = [(key, tally[key], 0) for key in ("shadow", "turned", "colourless", "dark")]
    counts += [(key, tally[key], 0) for key in ("unshadowed", "faint")]
    counts += [
        ("tests", tally["tests_spared"], tests),
        ("mesh", tally["mesh_rays_spared"], tally["mesh_rays"]),
        ("kept", pixels - tally["kept_pixels"], pixels),
    ]
    return {"notRun": facts["not_run"], "counts": [count for count in counts if count[1]]}


def spared_lines(facts: dict[str, Any], words: Words) -> Figures:
    """Label and value of each saving there was."""
    spared, say = spared_of(facts), words.say
    stages = ", ".join(say(f"spared.stages.{stage}") for stage in spared["notRun"])
    lines = [(say("spared.notRun"), stages)] if stages else []
    return lines + [
        (say(f"spared.{key}"), _value(part, whole, words)) for key, part, whole in spared["counts"]
    ]


def as_table(scene_id: str, facts: dict[str, Any], words: Words) -> str:
    """The same for the command line, with the rays that were traced."""
    tally = facts["tally"]
    rays = ", ".join(
        f"{words.numbers.grouped(tally[kind])} {kind}"
        for kind in ("camera", "reflected", "refracted")
        if tally[kind]
    )
    lines = [("Rays traced", rays), *spared_lines(facts, words)]
    width = max(len(label) for label, _ in lines)
    return "\n".join([scene_id, *(f"  {label:{width}}  {value}" for label, value in lines)])


def _value(part: int, whole: int, words: Words) -> str:
    numbers = words.numbers
    if not whole:
        return numbers.grouped(part)
    return words.say(
        "spared.of",
        part=numbers.grouped(part),
        whole=numbers.grouped(whole),
        share=numbers.percent(part / whole),
    )
