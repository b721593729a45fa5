"""The tracer: START HERE.

A picture is traced strip by strip, a strip depth by depth. One depth, a wave, is:
meet (what does each ray hit?), light (what does each light give there?), bounce (where
do mirrors and glass send it on?). When no ray is left, colours are gathered back from
the deepest wave to the camera rays. Rays that some frustum resolution needs are recorded.
"""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from raywalk.errors import SourceError, SourceErrors
from raywalk.geometry.compiled import CompiledScene, Hits, Rays, rays_from
from raywalk.geometry.containment import objects_around
from raywalk.geometry.extent import finite_sphere
from raywalk.geometry.roots import NOWHERE
from raywalk.scene.model import Scene
from raywalk.scene.shapes import Plane
from raywalk.trace.bounce import Bounced, bounce
from raywalk.trace.camera import camera_directions
from raywalk.trace.lighting import light_hits
from raywalk.trace.media import stack_width, stacks_holding
from raywalk.trace.plan import LEAST_SHARE, Plan, plan_of
from raywalk.trace.record import Recorded, Recording, assemble, kept_pixels
from raywalk.trace.relighting import KnownPaths
from raywalk.trace.tables import compile_lights, compile_materials
from raywalk.trace.tally import Tally
from raywalk.trace.tree import Kind, RayTree, level_pixels
from raywalk.trace.wave import Met, Wave, gather

Result = TypeVar("Result")
# How many; if asked each time, threads join in when other scenes are done with their cores.
Threads = int | Callable[[], int]

# Rays in a strip. Of the last bounces few are left, and they share what a call costs: 16,384 took 4
# to 10 % longer where there is glass. Twice as many save little more, and take memory.
STRIP = 32_768
# Of very many lights less, as what each gives at each hit is 35 bytes.
FACTORS = 4_200_000


@dataclass(frozen=True, eq=False)
class Traced:
    """What one trace of a scene yields."""

    picture: np.ndarray  # (size, size, 3) uint8, row 0 on top
    tree: RayTree  # of the pixels that frustum resolutions use
    tally: Tally  # what was done, and what was not needed


class Tracer:
    """A scene ready to be traced, at any pixel of any picture size."""

    def __init__(
        self,
        scene: Scene,
        depth: int | None = None,
        least_share: float = 0.0,
        plan: Plan | None = None,
        known: KnownPaths | None = None,
    ):
        """known: of scenes that differ from it in nothing but light (`trace/relighting.py`)."""
        self.scene = scene
        self.plan = plan or plan_of(scene, depth)
        self.least_share = least_share
        self.known = known
        self.compiled = CompiledScene(scene)
        self.materials = compile_materials(scene)
        self.lights = compile_lights(scene)
        self.ior_of = self.materials.ior[[obj.material for obj in scene.objects]]
        self.scene_sphere = finite_sphere(scene, self.compiled)
        eye = np.array(scene.camera.eye, float)
        refuse_buried_camera(scene, objects_around(self.compiled, eye))
        self.eye_media = self.media_at(eye)

    def media_at(self, eye: np.ndarray) -> list[int]:
        """The glass that an eye (3,) is in, the largest body first."""
        around = objects_around(self.compiled, eye)
        return [k for k in around if self.materials.transmit[self.scene.objects[k].material]]

    def waves(self, pixels: np.ndarray, width: int, height: int) -> list[Wave]:
        """Traces pixels (n,) (row * width + column) to the end; wave 0 holds their colours."""
        return self.to_the_end(self.camera_rays(pixels, width, height), self.eye_media)

    def camera_rays(self, pixels: np.ndarray, width: int, height: int) -> Rays:
        """Through the centres of pixels (n,), as `waves` numbers them."""
        direction = camera_directions(self.scene.camera, width, height, pixels)
        return rays_from(
            np.tile(np.array(self.scene.camera.eye, float), (len(pixels), 1)), direction
        )

    def follow(self, origin: np.ndarray, direction: np.ndarray) -> list[Wave]:
        """Traces rays (n, 3) that start where the eye is, or in the same media, to the end."""
        return self.to_the_end(rays_from(origin, direction), self.eye_media)

    def to_the_end(self, first: Rays, media: list[int], met: Hits | None = None) -> list[Wave]:
        """Traces these first rays, whatever they leave, which start in this glass. met: their
        hits, where these are known."""
        waves = list(self.each_wave(first, media, met))
        gather(waves)
        return waves

    def each_wave(self, first: Rays, media: list[int], met: Hits | None = None) -> Iterator[Wave]:
        """Their waves, one after the other, of which only the last is held: their colours are yet
        to be gathered."""
        return map(self.lit, self.each_met(first, media, met))

    def each_met(self, first: Rays, media: list[int], met: Hits | None = None) -> Iterator[Met]:
        """The rays of each wave and what they hit, of which no light changes anything."""
        shot, hits = self._shot(first, media), met or self.compiled.hits(first)
        for _ in range(self.plan.depth):
            onward = bounce(
                self.compiled, self.materials, self.ior_of, shot.rays, hits, shot.media,
                shot.share, self.least_share,
            )  # fmt: skip
            yield Met(shot._replace(faint=onward.faint), hits)
            if not len(onward.parent):
                return
            shot, hits = onward, self.compiled.hits(onward.rays)
        yield Met(shot._replace(faint=0), hits)  # nothing is sent on, however bright

    def met_through(self, pixels: np.ndarray) -> Iterable[Met]:
        """Of the rays through these pixels (n,) of the scene's picture; met before, if known."""
        size = self.scene.render.size

        def followed() -> Iterator[Met]:
            return self.each_met(self.camera_rays(pixels, size, size), self.eye_media)

        return self.known.through(pixels, followed) if self.known else followed()

    def _shot(self, rays: Rays, media: list[int]) -> Bounced:
        count = len(rays.origin)
        return Bounced(
            rays=rays,
            parent=np.full(count, -1, np.int32),
            kind=np.full(count, Kind.CAMERA, np.uint8),
            weight=np.ones(count),
            share=np.ones(count),
            media=stacks_holding(media, stack_width(self.scene), count),
            faint=0,
        )

    def lit(self, met: Met) -> Wave:
        """A wave's rays with the light of this scene."""
        shot, hits = met
        lighting = light_hits(
            self.scene, self.compiled, self.materials, self.lights, shot.rays, hits, self.plan
        )
        colour = lighting.local_weight[:, None] * lighting.local
        colour[hits.object == NOWHERE] = self.scene.background
        return Wave(*shot, hits=hits, lighting=lighting, colour=colour)


def trace_scene(scene: Scene, threads: Threads = 2) -> Traced:
    """The whole picture and the ray trees of all frustum resolutions."""
    return trace_picture(Tracer(scene, least_share=LEAST_SHARE), threads)


def trace_picture(
    tracer: Tracer, threads: Threads = 2, report: Callable[[float], None] | None = None
) -> Traced:
    """The whole picture and the ray trees of all frustum resolutions.

    The result does not depend on the number of threads. report: called with the share traced.
    Only the strips at work are in memory: what grows with the picture is the picture alone.
    """
    size = tracer.scene.render.size
    picture = np.empty((size, size, 3), np.uint8)
    kept = kept_pixels(size, tracer.scene.render.resolutions)
    records, tally = _trace_into(picture, tracer, np.arange(size * size), kept, threads, report)
    return Traced(picture, assemble(tracer, records, size), tally)


def trace_colours(
    tracer: Tracer, threads: Threads = 2, report: Callable[[float], None] | None = None
) -> tuple[np.ndarray, Tally]:
    """The picture and the tally that `trace_picture` gives, where the trees are known already."""
    size = tracer.scene.render.size
    picture = np.empty((size, size, 3), np.uint8)
    return picture, _trace_into(picture, tracer, np.arange(size * size), None, threads, report)[1]


def trace_grids(
    tracer: Tracer, threads: Threads = 2, report: Callable[[float], None] | None = None
) -> Traced:
    """The ray trees of all frustum resolutions, as `trace_picture` gives them; of the picture only
    their pixels, each of the rest as the finest tile that it is in. About a sixtieth of its rays.
    """
    render = tracer.scene.render
    size, finest = render.size, max(render.resolutions)
    kept = kept_pixels(size, render.resolutions)
    pixels = np.flatnonzero(kept)
    picture = np.zeros((size, size, 3), np.uint8)
    records, tally = _trace_into(picture, tracer, pixels, kept, threads, report)
    tiles = picture.reshape(-1, 3)[level_pixels(size, finest)].reshape(finest, finest, 3)
    exact = picture.reshape(-1, 3)[pixels]
    picture[:] = tiles.repeat(size // finest, axis=0).repeat(size // finest, axis=1)
    picture.reshape(-1, 3)[pixels] = exact
    return Traced(picture, assemble(tracer, records, size), tally)


def trace_coarse(
    tracer: Tracer, resolutions: tuple[int, ...], side: int, threads: Threads = 2
) -> Traced:
    """Some frustum resolutions' trees, and side x side pixels of the picture, as `trace_picture`
    gives them; the picture's other pixels are black. side: size divided by an odd number."""
    size = tracer.scene.render.size
    kept = kept_pixels(size, resolutions)
    pixels = np.flatnonzero(kept | kept_pixels(size, (side,)))
    picture = np.zeros((size, size, 3), np.uint8)
    records, tally = _trace_into(picture, tracer, pixels, kept, threads, None)
    return Traced(picture, assemble(tracer, records, size), tally)


def _trace_into(
    picture: np.ndarray, tracer: Tracer, chosen: np.ndarray, kept: np.ndarray | None,
    threads: Threads, report: Callable[[float], None] | None,
) -> tuple[list[Recorded], Tally]:  # fmt: skip
    """Traces the chosen pixels (n,), in the order of their numbers, into a picture; records those
    that are kept (size * size,)."""
    count = max(1, -(-len(chosen) // strip_pixels(tracer.scene)))
    ends = np.linspace(0, len(chosen), count + 1).astype(int)

    def traced(strip: int) -> tuple[np.ndarray, Recorded | None, Tally]:
        return trace_strip(tracer, chosen[ends[strip] : ends[strip + 1]], kept)

    records, total, flat = [], Tally(), picture.reshape(-1, 3)
    for strip, (colours, recorded, tally) in enumerate(in_order(traced, count, threads)):
        flat[chosen[ends[strip] : ends[strip + 1]]] = colours
        records += [recorded] if recorded else []
        total.add(tally)
        if report:
            report((strip + 1) / count)
    return records, total


def strip_pixels(scene: Scene) -> int:
    """How many at most are traced at once."""
    return max(1, min(STRIP, FACTORS // max(1, len(scene.lights))))


def trace_strip(
    tracer: Tracer, pixels: np.ndarray, kept: np.ndarray | None
) -> tuple[np.ndarray, Recorded | None, Tally]:
    """8-bit colours (n, 3) of these pixels of the scene's picture, the rays of those that are kept
    (size * size,), and what was done."""
    recording, brought = Recording(tracer, pixels, kept), []
    for wave in map(tracer.lit, tracer.met_through(pixels)):
        recording.add(wave)
        brought.append(wave.brings())
    gather(brought)
    colours = [each.colour for each in brought]
    recorded = None if kept is None else recording.finished(colours)
    return eight_bit(colours[0]), recorded, recording.tally


def in_order(work: Callable[[int], Result], count: int, threads: Threads) -> Iterator[Result]:
    """work(0), work(1) ... in that order, by some threads, which run a little ahead at most."""
    most = threads if isinstance(threads, int) else os.cpu_count() or 1
    ahead: deque[Future[Result]] = deque()
    with ThreadPoolExecutor(most) as pool:
        try:
            for k in range(count):
                _submit(pool, work, range(k + len(ahead), count), ahead, most, threads)
                result = ahead.popleft().result()
                _submit(pool, work, range(k + 1 + len(ahead), count), ahead, most, threads)
                yield result
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


def _submit(
    pool: Executor, work: Callable[[int], Result], still: range, ahead: deque[Future[Result]],
    most: int, threads: Threads,
) -> None:  # fmt: skip
    """As many as may run now; twice as many if the pool itself lets no more run."""
    allowed = threads if isinstance(threads, int) else threads()
    wanted = allowed if allowed < most else 2 * most
    ahead.extend(pool.submit(work, k) for k in still[: max(0, wanted - len(ahead))])


def eight_bit(colour: np.ndarray) -> np.ndarray:
    """Linear colours clamped to 0..1 and rounded to 0..255 (halves up), no gamma."""
    return np.floor(255.0 * np.clip(colour, 0.0, 1.0) + 0.5).astype(np.uint8)


def refuse_buried_camera(scene: Scene, around: list[int]) -> None:
    """Raises SourceErrors if an opaque closed object contains the camera's eye.

    A plane is a surface to an author, not a solid: being behind one is fine. So is being in a
    mirror, which shows what its inside is like.
    """
    problems = [
        SourceError(
            scene.path,
            "camera.eye",
            f'{list(scene.camera.eye)} lies inside the opaque "{scene.objects[k].name}"',
            allowed="a camera may stand outside, or inside glass (transmit > 0)",
        )
        for k in around
        if not scene.materials[scene.objects[k].material].transmit
        and not scene.materials[scene.objects[k].material].reflect
        and not isinstance(scene.objects[k].shape, Plane)
    ]
    if problems:
        raise SourceErrors(problems)
