"""What each skip of the plan brings, scene by scene: the same rays with the skip on and off.

One thread's processor time, on strips spread over the picture, the two ways in turn; the
pictures must be the same. Where a skip has nothing to leave out in a scene, it is not measured.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from raywalk.bench.cases import Case
from raywalk.geometry.compiled import Hits
from raywalk.geometry.roots import NOWHERE
from raywalk.optics.shade import towards_lights
from raywalk.scene.model import Scene
from raywalk.trace.plan import LEAST_SHARE, Plan, plan_of
from raywalk.trace.record import kept_pixels, record
from raywalk.trace.shadows import Cast, shadow_rays
from raywalk.trace.wave import Met, Wave
from raywalk.trace.wavefront import STRIP, Tracer, eight_bit

STRIPS = 6  # of a picture's 82, spread evenly
# Rays below the least share together may move a colour that stands next to a rounding border.
FAINT_STEPS = 1
UNSEEN = 1e-300  # a highlight colour that is not black, and changes none


@dataclass(frozen=True)
class Skip:
    """One thing that is not done, and how to do it all the same."""

    key: str
    what: str
    needed: Callable[[Plan, Scene], bool]  # there may be something to leave out
    off: Callable[[Scene], Tracer]
    keeps_all: bool = False  # off: the trees of all pixels are kept


def _with_plan(**change: Any) -> Callable[[Scene], Tracer]:
    def off(scene: Scene) -> Tracer:
        return Tracer(scene, least_share=LEAST_SHARE, plan=replace(plan_of(scene), **change))

    return off


def _no_spheres(scene: Scene) -> Tracer:
    tracer = Tracer(scene, least_share=LEAST_SHARE)
    table = tracer.compiled.primitives
    tracer.compiled.primitives = table._replace(reach_sq=np.full_like(table.reach_sq, np.inf))
    return tracer


def _no_boxes(scene: Scene) -> Tracer:
    """Rays that pass by a mesh's box are put to Embree too."""
    tracer = Tracer(scene, least_share=LEAST_SHARE)
    meshes: list[Any] = tracer.compiled.meshes
    for mesh in meshes:
        mesh.meet = _asked_by_all(mesh)
    return tracer


def _asked_by_all(mesh: Any) -> Callable[..., Any]:
    from raywalk.geometry.mesh_nearest import meet_mesh
    from raywalk.geometry.mesh_savings import goes_past_box

    meet, endless = mesh.meet, (1e9 * mesh.size,) * 3
    asked = mesh.tables._replace(low=tuple(-x for x in endless), high=endless)

    def meet_all(
        origin: np.ndarray, direction: np.ndarray, leaving: np.ndarray, on: np.ndarray,
        limit: np.ndarray, rank: np.ndarray, t: np.ndarray, *rest: np.ndarray,
    ) -> None:  # fmt: skip
        reach = np.minimum(limit, t)
        past = np.flatnonzero(goes_past_box(mesh.bvh, origin - mesh.centre, direction, reach))
        if len(past):  # what they are given is not looked at
            nothing = np.full(len(past), NOWHERE, np.int32)
            meet_mesh(
                asked, origin[past], direction[past], nothing, nothing, reach[past], rank,
                np.full(len(past), np.inf), nothing.copy(), nothing.copy(),
                np.empty((len(past), 2)),
            )  # fmt: skip
        meet(origin, direction, leaving, on, limit, rank, t, *rest)

    return meet_all


def _all_highlights(scene: Scene) -> Tracer:
    tracer = Tracer(scene, least_share=LEAST_SHARE)
    materials = tracer.materials
    seen = np.where(materials.specular == 0.0, UNSEEN, materials.specular)
    tracer.materials = materials._replace(specular=seen)
    return tracer


class _Shooting(Tracer):
    """Shoots the shadow rays that a scene without shadows does not need."""

    def lit(self, met: Met) -> Wave:
        wave = super().lit(met)
        lit = np.flatnonzero(wave.lighting.local_weight > 0.0)
        if len(lit):
            self._shoot(wave.hits, lit)
        return wave

    def _shoot(self, hits: Hits, lit: np.ndarray) -> None:
        places = self.lights.position
        to_light, distance, facing = towards_lights(lit, hits.point, hits.geometric, places)
        rows, light = np.tile(lit, len(places)), np.arange(len(places)).repeat(len(lit))
        cast = Cast(rows, light, to_light, distance, facing, facing)
        self.compiled.nearest(*shadow_rays(hits, cast))


SKIPS = (
    Skip("shadows", "shadow rays where the scene has none",
         lambda plan, scene: not plan.shadows and bool(scene.lights),
         lambda scene: _Shooting(scene, least_share=LEAST_SHARE)),
    Skip("turned", "shadow rays from surfaces turned away",
         lambda plan, scene: any(plan.asked), _with_plan(leave_turned=False)),
    Skip("colourless", "lights where a surface has no colour of its own",
         lambda plan, scene: plan.mirrors or plan.glass, _with_plan(leave_colourless=False)),
    Skip("faint", "rays with less than 1/4096 of a pixel",
         lambda plan, scene: plan.glass, Tracer),
    Skip("spheres", "exact tests of primitives whose sphere a ray passes by",
         lambda plan, scene: True, _no_spheres),
    Skip("boxes", "mesh tests of rays that pass by the mesh's box",
         lambda plan, scene: plan.meshes, _no_boxes),
    Skip("highlights", "highlights of surfaces without any",
         lambda plan, scene: any(not any(m.specular) for m in scene.materials), _all_highlights),
    Skip("trees", "ray trees of pixels that no grid uses",
         lambda plan, scene: True, lambda scene: Tracer(scene, least_share=LEAST_SHARE),
         keeps_all=True),
)  # fmt: skip


def skips(scenes: list[Scene], rounds: int) -> Iterator[dict[str, Any]]:
    """A row a scene and skip: time off over time on, and whether the pictures are the same."""
    for scene in scenes:
        plan = plan_of(scene)
        for skip in SKIPS:
            if skip.needed(plan, scene):
                yield measured(scene, skip, rounds)


def measured(scene: Scene, skip: Skip, rounds: int) -> dict[str, Any]:
    """One skip in one scene."""
    on, off = Tracer(scene, least_share=LEAST_SHARE), skip.off(scene)
    ways = (partial_picture(on), partial_picture(off, skip.keeps_all))
    pictures = [way() for way in ways]  # compiled, and everything in its place
    ratios = []
    for turn in range(rounds):
        seconds = [0.0, 0.0]
        for k in (turn % 2, 1 - turn % 2):
            start = time.thread_time()
            ways[k]()
            seconds[k] = time.thread_time() - start
        ratios.append(seconds[1] / seconds[0])
    steps = np.abs(pictures[0].astype(int) - pictures[1].astype(int)).max(initial=0)
    return {
        "scene": scene.id, "skip": skip.key, "what": skip.what,
        "ratio": statistics.median(ratios), "surely": quarter(ratios), "steps": int(steps),
    }  # fmt: skip


def quarter(ratios: list[float]) -> float:
    """What three of four rounds reached: of many scenes, the best median alone may be chance."""
    return sorted(ratios)[len(ratios) // 4]


def partial_picture(tracer: Tracer, keeps_all: bool = False) -> Callable[[], np.ndarray]:
    """Traces some strips as a build does, and records what is kept; returns their colours."""
    render = tracer.scene.render
    size = render.size
    kept = kept_pixels(size, render.resolutions)
    if keeps_all:
        kept = np.ones_like(kept)
    starts = np.linspace(0, max(0, size * size - STRIP), STRIPS).astype(int)

    def trace() -> np.ndarray:
        colours = []
        for start in starts:
            pixels = np.arange(start, min(start + STRIP, size * size))
            waves = tracer.waves(pixels, size, size)
            record(tracer, waves, pixels, kept)
            colours.append(eight_bit(waves[0].colour))
        return np.concatenate(colours)

    return trace


def skip_cases(rows: list[dict[str, Any]], seed: int) -> Iterator[Case]:
    """Each skip leaves every picture as it is, and brings time somewhere."""
    for skip in SKIPS:
        own = [row for row in rows if row["skip"] == skip.key]
        if not own:
            continue
        best = max(row["surely"] for row in own)
        allowed = FAINT_STEPS if skip.key == "faint" else 0
        steps = max(row["steps"] for row in own)
        yield Case("skips", skip.what, "8-bit steps it changes", allowed, steps, 0, seed)
        share = "share of the time without it, in its best scene, three of four times"
        yield Case("skips", skip.what, share, 0.99, 1 / best, 0, seed)


def as_table(rows: list[dict[str, Any]]) -> Iterator[str]:
    """How many times as long each scene takes without the skip."""
    for skip in SKIPS:
        own = [row for row in rows if row["skip"] == skip.key]
        if own:
            scenes = ", ".join(f"{row['scene']} {row['ratio']:.2f}" for row in own)
            yield f"  {skip.what}: {scenes}"
