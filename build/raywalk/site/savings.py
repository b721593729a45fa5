"""What tracing a scene did not have to do: lines for its page, the viewer and `--stats`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from raywalk.site.scene_types import Saving, Savings

if TYPE_CHECKING:
    from raywalk.site.figures import Figures
    from raywalk.words import Words

COUNTED: tuple[Saving, ...] = (
    "shadow", "turned", "colourless", "dark", "unshadowed", "faint",
)  # fmt: skip


def savings_of(facts: dict[str, Any]) -> Savings:
    """The same for the viewer, without words: the stages not run, and the counts there are.

    facts: what the trace stage counted (facts.json).
    """
    tally = facts["tally"]
    tests, pixels = tally["tests"] + tally["tests_saved"], tally["pixels"]
    counts: list[tuple[Saving, int, int]] = [
        *((key, tally[key], 0) for key in COUNTED),
        ("tests", tally["tests_saved"], tests),
        ("mesh", tally["mesh_rays_saved"], tally["mesh_rays"]),
        ("kept", pixels - tally["kept_pixels"], pixels),
    ]
    return {"notRun": facts["not_run"], "counts": [count for count in counts if count[1]]}


def savings_lines(facts: dict[str, Any], words: Words) -> Figures:
    """Label and value of each saving there was."""
    savings, say = savings_of(facts), words.say
    stages = ", ".join(say(f"savings.stages.{stage}") for stage in savings["notRun"])
    lines = [(say("savings.notRun"), stages)] if stages else []
    return lines + [
        (say(f"savings.{key}"), _value(part, whole, words))
        for key, part, whole in savings["counts"]
    ]


def as_table(scene_id: str, facts: dict[str, Any], words: Words) -> str:
    """The same for the command line, with the rays that were traced."""
    rays = ", ".join(
        f"{words.numbers.grouped(count)} {words.say(f'line.{kind}')}"
        for kind, count in facts["tally"]["rays"].items()
        if count
    )
    lines = [("Rays traced", rays), *savings_lines(facts, words)]
    width = max(len(label) for label, _ in lines)
    return "\n".join([scene_id, *(f"  {label:{width}}  {value}" for label, value in lines)])


def _value(part: int, whole: int, words: Words) -> str:
    numbers = words.numbers
    if not whole:
        return numbers.grouped(part)
    return words.say(
        "savings.of",
        part=numbers.grouped(part),
        whole=numbers.grouped(whole),
        share=numbers.percent(part / whole),
    )
