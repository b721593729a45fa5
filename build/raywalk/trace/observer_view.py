"""What an observer sees of a scene: a shaded view from any place, and which stretches of a
line are hidden from there.

Walls are cut outwards as on the viewer's stage: a plane seen from the side on which the ray-tracing
camera is not, and what of a plane lies beyond another one, outside of the room.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raywalk.geometry.compiled import Hits, Rays, rays_from
from raywalk.geometry.roots import NOWHERE
from raywalk.scene.placement import placement
from raywalk.scene.shapes import Plane
from raywalk.trace.camera import unit_directions
from raywalk.trace.shadow_maps import ShadowMaps, shadowed_colours
from raywalk.trace.wavefront import STRIP, Tracer, eight_bit

# An endless floor fades outwards between these distances from the scene's middle, in its radii.
FADE_FROM, FADE_TO = 1.0, 2.1
# A plane ends this share of the scene's radius beyond where another one crosses it: no gap.
EDGE = 1e-6
SAMPLES = 48  # places along a line at which its visibility is asked
HALVINGS = 14  # where it changes between two of them: to 1e-6 of the line
# A point this share nearer than the surface in front of it counts as on it, so as visible.
ON_SURFACE = 1e-6


@dataclass(frozen=True, eq=False)
class Observer:
    """Where it stands and how wide it sees; pixels of its view. Vectors (3,), frame unit."""

    eye: np.ndarray
    right: np.ndarray
    up: np.ndarray
    forward: np.ndarray
    focal: float  # pixels that one world unit takes at depth 1
    width: int
    height: int


def shaded_view(tracer: Tracer, observer: Observer, maps: ShadowMaps | None = None) -> np.ndarray:
    """(height, width, 4) uint8: traced colours, and how much there is to see at each pixel:
    0 where rays leave the scene, fading far out on a plane. maps: the tracer asks for no shadows,
    which come from these instead."""
    walls, media = Walls(tracer, observer.eye), tracer.media_at(observer.eye)
    pixels = np.arange(observer.width * observer.height)
    view = np.zeros((len(pixels), 4), np.uint8)
    for strip in np.array_split(pixels, max(1, -(-len(pixels) // STRIP))):
        first, met = _through_cut(tracer, _rays_through(observer, strip), walls)
        wave = tracer.to_the_end(first, media, met)[0]
        colour = wave.colour
        if maps:
            colour = shadowed_colours(tracer, maps, wave, _places(observer, strip))
        view[strip, :3] = eight_bit(colour)
        view[strip, 3] = np.rint(255 * _presence(tracer, wave.hits.object, wave.hits.point))
    return view.reshape(observer.height, observer.width, 4)


def hidden_stretches(
    tracer: Tracer, eye: np.ndarray, lines: np.ndarray
) -> list[list[tuple[float, float]]]:
    """For each of the lines (n, 2, 3) the stretches, as shares of its length, that an opaque object
    hides from the eye. Stretches shorter than 1 / SAMPLES may be missed; ends are exact to 1e-6."""
    if not len(lines):
        return []
    walls = Walls(tracer, eye)
    share = (np.arange(SAMPLES) + 0.5) / SAMPLES
    start, span = lines[:, :1], lines[:, 1:] - lines[:, :1]
    hidden = _hidden(tracer, eye, (start + share[:, None] * span).reshape(-1, 3), walls)
    hidden = hidden.reshape(len(lines), SAMPLES)
    line, before = np.nonzero(hidden[:, 1:] != hidden[:, :-1])
    low, high = share[before], share[before + 1]
    first = hidden[line, before]
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        same = first == _hidden(
            tracer, eye, lines[line, 0] + middle[:, None] * (lines[line, 1] - lines[line, 0]), walls
        )
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    changes = (low + high) / 2
    return [_stretches(bool(hidden[k, 0]), changes[line == k].tolist()) for k in range(len(lines))]


def hidden_points(tracer: Tracer, eye: np.ndarray, points: np.ndarray) -> np.ndarray:
    """(n,) bool: which of the points (n, 3) an opaque object hides from the eye."""
    return _hidden(tracer, eye, points, Walls(tracer, eye))


class Walls:
    """A scene's planes, and what of them is cut outwards for an observer."""

    def __init__(self, tracer: Tracer, eye: np.ndarray):
        scene = tracer.scene
        camera = np.array(scene.camera.eye, float)
        self.margin = EDGE * tracer.scene_sphere[1]
        self.is_wall = np.array([isinstance(obj.shape, Plane) for obj in scene.objects], bool)
        self.cut = np.zeros(len(scene.objects), bool)
        self.sides: list[tuple[int, np.ndarray, float]] = []  # object, normal to the camera, offset
        for k in np.flatnonzero(self.is_wall).tolist():
            linear, point = placement(scene.objects[k])
            normal = np.cross(linear[:, 2], linear[:, 0])
            normal = normal / np.sqrt(normal @ normal) * np.sign((camera - point) @ normal or 1.0)
            self.cut[k] = (eye - point) @ normal < 0
            self.sides.append((k, normal, float(point @ normal)))

    def let_through(self, hits: Hits) -> np.ndarray:
        """(n,) bool: hits on walls that are not there for the observer."""
        hit = hits.object != NOWHERE
        gone = hit & self.cut[hits.object] if len(self.cut) else np.zeros(len(hit), bool)
        for k, normal, offset in self.sides:
            beyond = hits.point @ normal < offset - self.margin
            gone |= hit & self.is_wall[hits.object] & (hits.object != k) & beyond
        return gone


def _stretches(starts_hidden: bool, changes: list[float]) -> list[tuple[float, float]]:
    borders = [0.0, *changes] if starts_hidden else changes
    if len(borders) % 2:
        borders = [*borders, 1.0]
    return list(zip(borders[::2], borders[1::2], strict=True))


def _rays_through(observer: Observer, pixels: np.ndarray) -> Rays:
    """From the observer's eye through the centres of pixels (n,), raster order."""
    frame = np.array([observer.right, observer.up, observer.forward])
    spread = observer.height / (2 * observer.focal)
    direction = unit_directions(frame, spread, observer.width, observer.height, pixels)
    return rays_from(np.tile(observer.eye, (len(pixels), 1)), direction)


def _places(observer: Observer, pixels: np.ndarray) -> np.ndarray:
    """(n, 2) centres of pixels (n,), x and y from the lower left."""
    row, column = np.divmod(pixels, observer.width)
    return np.stack([column + 0.5, observer.height - row - 0.5], axis=1)


def _through_cut(tracer: Tracer, rays: Rays, walls: Walls) -> tuple[Rays, Hits]:
    """The rays, started anew behind every plane that is cut outwards, and what they meet."""
    met = tracer.compiled.hits(rays)
    if not walls.sides:
        return rays, met
    rays, hits, going = Rays(*(column.copy() for column in rays)), met, np.arange(len(met.t))
    while len(through := np.flatnonzero(walls.let_through(hits))):
        going = going[through]
        _pass(rays, going, hits.take(through))
        hits = tracer.compiled.hits(rays.take(going))
        for column, found in zip(met, hits, strict=True):
            column[going] = found
    return rays, met


def _pass(rays: Rays, going: np.ndarray, hits: Hits) -> None:
    """These rays go on from what they met."""
    rays.origin[going], rays.leaving[going] = hits.point, hits.object
    rays.inner[going], rays.triangle[going] = ~hits.inside, hits.triangle


def _presence(tracer: Tracer, met: np.ndarray, point: np.ndarray) -> np.ndarray:
    """(n,) 0..1: 1 on bodies, less far out on a plane, 0 where nothing was met."""
    centre, radius = tracer.scene_sphere
    flat = np.array([isinstance(obj.shape, Plane) for obj in tracer.scene.objects], bool)
    far = np.sqrt(((point - centre) ** 2).sum(axis=1)) / radius
    fade = np.clip((FADE_TO - far) / (FADE_TO - FADE_FROM), 0, 1)
    there = (
        np.where(flat[met], fade * fade * (3 - 2 * fade), 1.0) if len(flat) else np.ones(len(met))
    )
    return np.where(met == NOWHERE, 0.0, there)


def _hidden(tracer: Tracer, eye: np.ndarray, points: np.ndarray, walls: Walls) -> np.ndarray:
    """(n,) bool: whether something opaque and not cut outwards stands before each point."""
    scene = tracer.scene
    clear = np.array([scene.materials[obj.material].transmit > 0 for obj in scene.objects], bool)
    outwards = points - eye
    reach = np.sqrt((outwards**2).sum(axis=1))
    rays = rays_from(np.tile(eye, (len(points), 1)), outwards / reach[:, None])
    left = reach * (1.0 - ON_SURFACE)
    hidden, going = np.zeros(len(points), bool), np.arange(len(points))
    while len(going):
        hits = tracer.compiled.hits(rays.take(going))
        before = (hits.object != NOWHERE) & (hits.t < left[going])
        passed = before & (clear[hits.object] | walls.let_through(hits))
        hidden[going[before & ~passed]] = True
        going, hits = going[passed], hits.take(passed)
        left[going] -= hits.t
        _pass(rays, going, hits)
    return hidden
