"""Why a pixel is dark or in shadow: viewer/state/why.ts in Python, operation by operation.

The ray whose end counts most in the pixel, and what the lights say there: from the stored shares
and the events alone.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from raywalk.trace_file.decode import DecodedTrace

if TYPE_CHECKING:
    from raywalk.telling.events import LightShare, RayEvent

DARK = 80  # of 255: the brightest channel of a dark pixel is below
LITTLE = 0.25  # of a light, by its stored diffuse factor
HOWS = ("blocked", "away", "little", "off", "reached", "paint")  # causes first


@dataclass(frozen=True)
class Reason:
    """What is to be said of some lights where the ray ends. how: one of HOWS, where paint is of no
    light: the surface itself is dark. by: what blocks."""

    how: str
    by: str
    lights: tuple[str, ...]


@dataclass(frozen=True)
class Why:
    """dark: else a light is blocked. end: local, background or stops. ray: its number in walking
    order, from 1. share: in the pixel's colour. name: of the object where it ends."""

    dark: bool
    end: str
    ray: int
    share: float
    name: str
    reasons: tuple[Reason, ...]


def why_of(trace: DecodedTrace, events: Sequence[RayEvent], tile: Sequence[int]) -> Why | None:
    """None: the pixel is neither dark nor is a light blocked. tile: its colour, 0 to 255 each."""
    dark, why, name = max(tile) < DARK, None, ""
    by: dict[str, str] = {}
    numbers: dict[int, int] = {}  # of each ray, in walking order
    for event in events:
        numbers.setdefault(event.ray, len(numbers) + 1)
        if event.what == "meets":
            name, by = event.facts["name"], {}
        elif event.what == "blocked":
            by[event.facts["name"]] = event.facts["by"]
        elif event.what in ("local", "stops", "background"):
            share = _share(trace, event.ray) * _part(trace, event)
            if why is None or share > why.share:
                is_local = event.what == "local"
                reasons = _reasons(event.facts["lights"], by, dark) if is_local else []
                number = numbers[event.ray]
                why = Why(dark, event.what, number, share, name, tuple(reasons))
    if why and (dark or any(each.how == "blocked" for each in why.reasons)):
        return why
    return None


def _share(trace: DecodedTrace, ray: int) -> float:
    """Of what a ray brings back in the pixel."""
    parent = int(trace.parent[ray])
    return 1.0 if parent < 0 else float(trace.weight[ray]) * _share(trace, parent)


def _part(trace: DecodedTrace, event: RayEvent) -> float:
    """Of the ray's colour that this end of it decides."""
    if event.what == "local":
        return float(event.facts["share"])
    return 1 - float(trace.localWeight[event.ray]) if event.what == "stops" else 1.0


def _reasons(lights: Sequence[LightShare], by: Mapping[str, str], dark: bool) -> list[Reason]:
    """Lights of which the same is to be said, together. by: what blocks each."""
    alike: dict[tuple[str, str], list[str]] = {}
    for light in lights:
        alike.setdefault((_how(light, dark), by.get(light.name, "")), []).append(light.name)
    found = [
        Reason(how, who, tuple(names))
        for each in HOWS
        for (how, who), names in alike.items()
        if how == each
    ]
    if dark and all(each.how == "reached" for each in found):
        return [*found, Reason("paint", "", ())]
    return found


def _how(light: LightShare, dark: bool) -> str:
    if light.seen == "unasked" and light.diffuse == 0:
        return "away"
    if light.seen in ("reached", "unasked"):
        return "little" if dark and light.diffuse < LITTLE else "reached"
    return light.seen
