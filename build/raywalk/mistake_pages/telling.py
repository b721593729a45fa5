"""The pixel that tells a mistake most plainly: few rays, a great difference, and an answer that
does not hang on a rounding."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.mistakes.camera import camera_directions
from raywalk.mistakes.colour import to_bytes
from raywalk.mistakes.habits import EXACT
from raywalk.mistakes.rays import free_rays
from raywalk.mistakes.table import BY_NAME, Mistakes
from raywalk.mistakes.tracer import LEAST_SHARE, Wave, follow, trace
from raywalk.mistakes.vectors import column, unit
from raywalk.mistakes.world import World
from raywalk.scene.model import Scene
from raywalk.trace.kinds import BRANCH_OF, BRANCHES

ABOUT = 33  # tiles across: enough to choose from, few enough to be pressed
PLAIN = 96.0  # of 255: more of a difference tells no more
TURN = 1e-5  # radians, as trace/conditioning.py turns camera rays
ASKED = 12  # pixels whose rays are turned, the best first


class Program(NamedTuple):
    """What a program makes of all pixels of n x n."""

    world: World
    waves: list[Wave]
    bytes: np.ndarray  # (n * n, 3) uint8
    rays: np.ndarray  # (n * n,) rays of each pixel's tree


def traced(scene: Scene, n: int, mistakes: Mistakes) -> Program:
    """Followed as far as the pipeline's own rays are."""
    world, waves = trace(scene, n, np.arange(n * n), mistakes, EXACT, LEAST_SHARE)
    return Program(
        world, waves, to_bytes(waves[0].colour.T, mistakes), np.bincount(pixels_of(waves))
    )


def pixels_of(waves: list[Wave]) -> np.ndarray:
    """The pixel of each ray, wave after wave."""
    pixel, every = np.arange(len(waves[0].sent.parent)), []
    for depth, wave in enumerate(waves):
        pixel = pixel[wave.sent.parent] if depth else pixel
        every.append(pixel)
    return np.concatenate(every)


def grids_of(scene: Scene) -> list[int]:
    """The grids of the scene's page, that which pixels are chosen from first: others are asked
    where a mistake shows between its pixels only."""
    return sorted(scene.render.resolutions, key=lambda n: (abs(n - ABOUT), n))


def telling_pixel(scene: Scene, n: int, right: Program, name: str) -> int | None:
    """row * n + column, None if no pixel differs. right: the right program's answers. Where none is
    well conditioned, as where speckles are, the plainest."""
    mistakes = frozenset([name])
    wrong = traced(scene, n, mistakes)
    off = np.abs(right.bytes.astype(int) - wrong.bytes).max(axis=1)
    hits = (right.waves[0].hits.object >= 0) + 0.5 * (wrong.waves[0].hits.object >= 0)
    around = mean_around(np.minimum(off, PLAIN).reshape(n, n)).reshape(-1)
    plainness = np.minimum(off, PLAIN) * around * (1 + hits) / (2 + right.rays + wrong.rays)
    order = np.argsort(-plainness, kind="stable")[:ASKED]
    order = order[off[order] > 0]
    if not len(order):
        return None
    steady = is_steady(right.world, n, order, frozenset())
    if not BY_NAME[name].speckles:
        steady &= is_steady(wrong.world, n, order, mistakes)
    return int(order[steady][0] if steady.any() else order[0])


def mean_around(values: np.ndarray) -> np.ndarray:
    """(n, n) means of 5 x 5: a pixel amid others that are wrong tells more than one at a rim."""
    padded = np.pad(values, 2)
    windows = np.lib.stride_tricks.sliding_window_view(padded, (5, 5))
    return np.asarray(windows.mean(axis=(2, 3)))


def is_steady(world: World, n: int, pixels: np.ndarray, mistakes: Mistakes) -> np.ndarray:
    """(p,) bool: a camera ray that is turned a little to any of four sides meets the same, and so
    do all rays that it leads to."""
    d = unit(camera_directions(world.scene.camera, n, pixels, mistakes))
    across = unit(np.cross(d.T, np.eye(3)[np.abs(d.T).argmin(axis=1)]).T)
    up = np.cross(d.T, across.T).T
    ways = [d, d + TURN * across, d - TURN * across, d + TURN * up, d - TURN * up]
    eye = np.asarray(column(world.scene.camera.eye), float)
    rays = free_rays(eye, unit(np.concatenate(ways, axis=1)))
    met = names_met(follow(world, rays, mistakes, EXACT, LEAST_SHARE))
    count = len(pixels)
    return np.array([all(met[k + j * count] == met[k] for j in range(1, 5)) for k in range(count)])


def names_met(waves: list[Wave]) -> list[frozenset[tuple[int, ...]]]:
    """Of each camera ray all that its tree meets: path, object, and what of the lights is seen."""
    found: list[set[tuple[int, ...]]] = [set() for _ in waves[0].sent.parent]
    pixel, path = np.arange(len(found)), [1] * len(found)
    for depth, wave in enumerate(waves):
        if depth:
            pixel = pixel[wave.sent.parent]
            branches = BRANCH_OF[wave.sent.kind].tolist()
            parents = wave.sent.parent.tolist()
            path = [
                (BRANCHES + 1) * path[p] + b + 1 for p, b in zip(parents, branches, strict=True)
            ]
        seen, stopped = wave.lighting.visibility.T.tolist(), wave.lighting.blocker.T.tolist()
        objects = wave.hits.object.tolist()
        for k, at in enumerate(pixel.tolist()):
            found[at].add((path[k], objects[k], *seen[k], *stopped[k]))
    return [frozenset(each) for each in found]
