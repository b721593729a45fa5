"""A trace as it would be with switches set, as the viewer's state/what-if.ts has it.

A pixel is a weighted sum over its ray tree: every switch leaves out or scales terms that the
trace holds, and nothing is traced anew.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.telling.events import OFF
from raywalk.trace_file import DecodedTrace, Kind, Visibility
from raywalk.trace_file.rebuild import eight_bit, recombine

PAINTS = ("ambient", "diffuse", "specular")
SHARES = {"reflect": "reflected", "transmit": "refracted"}  # of a material, and what they send on
LEFT_OUT = -1  # pixel of a ray that is not there
OF_AREA = re.compile(r" \d+/\d+$", re.ASCII)  # what a point of an area light adds to its name


@dataclass(frozen=True)
class Switches:
    """What is switched; as a lesson's view names it."""

    bounces: int | None = None  # rays with more bounces are left out
    lamps: tuple[tuple[str, float], ...] = ()  # factor of each named light's brightness
    shadows: bool = True  # false: every light counts as seen
    without: tuple[str, ...] = ()  # parts of a colour that are left out

    @property
    def is_set(self) -> bool:
        return self != Switches()

    def brightness(self, light: str) -> float:
        """Factor of a light, or of the area light that it is a point of."""
        lamps = dict(self.lamps)
        return lamps.get(light, lamps.get(OF_AREA.sub("", light), 1.0))


AS_TRACED = Switches()


def switches_of(given: dict[str, Any] | None, scene: Scene) -> Switches:
    """From a view's table; what is as traced anyway is not switched."""
    asked = given or {}
    bounces = asked.get("bounces")
    lamps = tuple((name, float(f)) for name, f in (asked.get("lights") or {}).items() if f != 1)
    return Switches(
        bounces if bounces is not None and bounces < scene.render.depth else None,
        lamps,
        asked.get("shadows") in (None, True) or not scene.render.shadows,
        tuple(asked.get("without") or ()),
    )


def switched_scene(scene: Scene, switches: Switches) -> Scene:
    """The scene's colours, shares and limits with the switches set: what words are made from."""
    altered: dict[str, Any] = {
        part: (0.0, 0.0, 0.0) for part in PAINTS if part in switches.without
    } | {key: 0.0 for key, part in SHARES.items() if part in switches.without}
    depth = scene.render.depth if switches.bounces is None else switches.bounces
    shadows = scene.render.shadows and switches.shadows
    return replace(
        scene,
        render=replace(scene.render, depth=depth, shadows=shadows),
        lights=tuple(
            replace(light, intensity=light.intensity * switches.brightness(light.name))
            for light in scene.lights
        ),
        materials=tuple(replace(each, **altered) for each in scene.materials),
    )


def switched_trace(trace: DecodedTrace, scene: Scene, switches: Switches) -> DecodedTrace:
    """The trace's columns as they would be; rays that are left out have pixel LEFT_OUT."""
    if not switches.is_set:
        return trace
    shadows = switches.shadows or not scene.render.shadows
    bright = np.array([switches.brightness(light.name) for light in scene.lights])
    pixel, weight = _followed(trace, scene, switches)
    visibility = trace.visibility.copy()
    if not shadows:
        visibility[:] = Visibility.UNTESTED
    visibility[:, bright == 0] = OFF
    # What glass on the way to a light let pass counts only while there are shadows.
    factor = bright / np.where(trace.passed > 0, trace.passed, 1.0) if not shadows else bright
    altered = replace(
        trace, pixel=pixel, weight=weight, visibility=visibility,
        diffuse=trace.diffuse * factor, specular=trace.specular * factor,
    )  # fmt: skip
    header = _dimmed(trace.header, switches)
    columns = {name: getattr(altered, name) for name in COLUMNS} | {"level": _levels(trace.parent)}
    colour = recombine(header, columns)
    tiles = eight_bit(colour[: trace.n**2]).reshape(-1).astype(trace.tiles.dtype)
    return replace(altered, colour=colour, tiles=tiles)


COLUMNS = (
    "parent", "kind", "material", "visibility", "diffuse", "specular", "weight", "localWeight",
)  # fmt: skip


def _dimmed(header: dict[str, Any], switches: Switches) -> dict[str, Any]:
    """The header with the colours black that are left out."""
    black = {part: [0.0, 0.0, 0.0] for part in switches.without}
    return header | {
        "materials": [
            material | {part: black.get(part, material[part]) for part in PAINTS}
            for material in header["materials"]
        ]
    }


def _followed(
    trace: DecodedTrace, scene: Scene, switches: Switches
) -> tuple[np.ndarray, np.ndarray]:
    """Which rays are still there, by their pixels, and their shares."""
    pixel, weight = trace.pixel.copy(), trace.weight.copy()
    mirrors, refracts = (part not in switches.without for part in ("reflected", "refracted"))
    sent = trace.parent >= 0
    total = sent & (trace.kind == Kind.TOTAL)
    if not (mirrors and refracts):
        own = np.array([mirrors * m.reflect + refracts * m.transmit for m in scene.materials])
        weight[total] = own[trace.material[trace.parent[total]]]
    if not mirrors:
        weight[sent & (trace.kind == Kind.REFLECTED)] = 0
    if not refracts:
        weight[sent & (trace.kind == Kind.REFRACTED)] = 0
    limit = np.inf if switches.bounces is None else switches.bounces
    gone = sent & ((weight == 0) | (trace.depth > limit))
    levels = _levels(trace.parent)
    for level in range(1, int(levels.max(initial=0)) + 1):
        rows = np.flatnonzero(levels == level)
        gone[rows] |= gone[trace.parent[rows]]
    pixel[gone], weight[gone] = LEFT_OUT, 0
    return pixel, weight


def _levels(parent: np.ndarray) -> np.ndarray:
    """Bounces before each ray; a trace's own column ends at 255."""
    levels = np.zeros(len(parent), np.int32)
    above = parent
    while (above >= 0).any():
        levels += above >= 0
        above = np.where(above >= 0, parent[above], -1)
    return levels
