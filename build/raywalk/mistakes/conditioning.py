"""How far a pixel's answer hangs on the last digits.

A camera ray is turned by a millionth of a milliradian to four sides. Where that changes what any
ray of the pixel's tree meets (at an edge, a tangent, a shadow's border, where two surfaces tie),
rounding may change it, too: the answer is not conditioned at all. Elsewhere no number of the tree
(distances, points, normals, shares, light factors, colours) moves more than `movement` times as
far, and so much does an error of rounding grow on its way.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.mistakes.camera import camera_directions
from raywalk.mistakes.rays import free_rays
from raywalk.mistakes.tracer import Wave, follow
from raywalk.mistakes.vectors import column, cross, unit
from raywalk.mistakes.world import World, world_of
from raywalk.scene.model import Scene
from raywalk.trace.kinds import BRANCH_OF, BRANCHES

TURN = 1e-9  # radians: ten million roundings, and far less than a pixel
# A program that works in another order was off by 5e-16 of this at most, two roundings of
# coordinates of some units (scenes 1 to 5, 8 and 10 at 33 x 33): so up to here two programs agree
# to 1e-12.
STEADY = 2000.0


class Answers(NamedTuple):
    """All rays of some pixels: by key, so that those of a turned ray can be found."""

    key: np.ndarray  # (m,) uint64 of pixel and path
    pixel: np.ndarray  # (m,)
    names: np.ndarray  # (m, k) whole numbers: what was met
    numbers: np.ndarray  # (m, j) all others


def is_steady(scene: Scene, n: int, pixels: np.ndarray) -> np.ndarray:
    """(p,) bool: another right program finds the same at these pixels of n x n, to 1e-12."""
    return movement(scene, n, pixels) <= STEADY


def movement(scene: Scene, n: int, pixels: np.ndarray) -> np.ndarray:
    """(p,) how far the numbers of each pixel (row * n + column) move for a ray turned by 1; inf
    where what is met changes."""
    world = world_of(scene)
    straight = camera_directions(scene.camera, n, pixels)
    here = answers(world, straight)
    most = np.zeros(len(pixels))
    for side in sides(straight):
        turned = answers(world, unit(straight + TURN * side))
        most = np.maximum(most, moved(here, turned, len(pixels)) / TURN)
    return most


def sides(d: np.ndarray) -> list[np.ndarray]:
    """Four directions (3, n) across directions (3, n)."""
    upright = np.zeros_like(d)
    upright[np.abs(d).argmin(axis=0), np.arange(d.shape[1])] = 1
    one = unit(cross(d, upright))
    other = cross(d, one)
    return [one, -one, other, -other]


def answers(world: World, direction: np.ndarray) -> Answers:
    """Of camera rays along these directions (3, p)."""
    rays = free_rays(column(world.scene.camera.eye).astype(float), direction)
    waves = follow(world, rays)
    pixel = np.arange(direction.shape[1])
    key = (pixel.astype(np.uint64) + np.uint64(1)) << np.uint64(40)
    parts = []
    for depth, wave in enumerate(waves):
        if depth:
            parent = wave.sent.parent
            pixel = pixel[parent]
            # Wraps round, as a hash does: paths may be as long as a scene's bounce limit.
            key = key[parent] * np.uint64(BRANCHES + 1)
            key = key + np.uint64(1) + BRANCH_OF[wave.sent.kind].astype(np.uint64)
        parts.append((key, pixel, names_of(wave), numbers_of(wave)))
    joined = (np.concatenate(part) for part in zip(*parts, strict=True))
    return Answers(*joined)


def names_of(wave: Wave) -> np.ndarray:
    """(m, k) kind, object, side, material, and of each light: is it seen, what is in its way."""
    sent, hits, lighting = wave.sent, wave.hits, wave.lighting
    every = [sent.kind, hits.object, hits.inside, hits.material]
    return np.stack([*every, *lighting.visibility, *lighting.blocker]).T.astype(np.int64)


def numbers_of(wave: Wave) -> np.ndarray:
    """(m, j) all that is measured."""
    hits, lighting = wave.hits, wave.lighting
    t = np.where(np.isfinite(hits.t), hits.t, 0)
    every = [t, wave.sent.weight, *hits.point, *hits.normal, *lighting.local, *wave.colour]
    of_lights = [*lighting.diffuse, *lighting.specular, *lighting.blocked_at]
    return np.stack([*every, *wave.sent.rays.direction, *of_lights]).T


def moved(here: Answers, turned: Answers, count: int) -> np.ndarray:
    """(count,) the farthest that a number of each pixel moved, inf where a name changed."""
    most = np.zeros(count)
    mine, theirs = np.argsort(here.key), np.argsort(turned.key)
    is_shared = np.isin(here.key[mine], turned.key), np.isin(turned.key[theirs], here.key)
    most[here.pixel[mine[~is_shared[0]]]] = np.inf
    most[turned.pixel[theirs[~is_shared[1]]]] = np.inf
    a, b = mine[is_shared[0]], theirs[is_shared[1]]
    by = np.abs(here.numbers[a] - turned.numbers[b]).max(axis=1)
    by[(here.names[a] != turned.names[b]).any(axis=1)] = np.inf
    np.maximum.at(most, here.pixel[a], by)
    return most
