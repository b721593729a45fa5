"""How far a pixel's answer hangs on the last digits: which pixels all right programs agree on.

A camera ray is turned by a hundredth of a milliradian to four sides. Where that changes what any
ray of the pixel's tree meets (at an edge, a tangent, a shadow's border, where two surfaces tie),
rounding may change it, too: the answer is not conditioned at all. Elsewhere no number of the tree
(distances, points, normals, shares, light factors, colours) moves more than `movement` times as
far, and so much does an error of rounding grow on its way.

Sheets that are solved by hand ask more of a pixel: see sheet_sights.py.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.geometry.roots import NOWHERE
from raywalk.trace.camera import camera_directions
from raywalk.trace.kinds import BRANCH_OF, BRANCHES
from raywalk.trace.wave import Wave
from raywalk.trace.wavefront import Tracer

TURN = 1e-5  # radians: a hundred roundings of float32, and a fraction of a pixel
# Where nothing moves more than this, the second tracer (mistakes/) differs by 4e-13 at most in
# scenes 1 to 5, 8 and 10, and in float32 by 2e-4: others get these bounds, with room for their
# order.
STEADY = 2000.0
WITHIN_FLOAT64, WITHIN_FLOAT32 = 1e-12, 1e-3


class Answers(NamedTuple):
    """All rays of some pixels: by key, so that those of a turned ray can be found."""

    key: np.ndarray  # (m,) uint64 of pixel and path
    pixel: np.ndarray  # (m,) place among the pixels
    names: np.ndarray  # (m, k) whole numbers: what was met
    numbers: np.ndarray  # (m, j) all others


def is_steady(tracer: Tracer, n: int, pixels: np.ndarray) -> np.ndarray:
    """(p,) bool: other right programs find the same at these pixels (row * n + column) of n x n."""
    return movement(tracer, n, pixels) <= STEADY


def movement(tracer: Tracer, n: int, pixels: np.ndarray) -> np.ndarray:
    """(p,) how far the numbers of each pixel move for a ray that is turned by 1; inf where what is
    met changes."""
    straight = camera_directions(tracer.scene.camera, n, n, pixels)
    here = answers(tracer, straight)
    most = np.zeros(len(pixels))
    for side in sides(straight):
        beside = straight + TURN * side
        beside /= np.linalg.norm(beside, axis=1, keepdims=True)
        most = np.maximum(most, moved(here, answers(tracer, beside), len(pixels)) / TURN)
    return most


def sides(d: np.ndarray) -> list[np.ndarray]:
    """Four unit directions (n, 3) across directions (n, 3)."""
    upright = np.eye(3)[np.abs(d).argmin(axis=1)]
    one = np.cross(d, upright)
    one /= np.linalg.norm(one, axis=1, keepdims=True)
    other = np.cross(d, one)
    return [one, -one, other, -other]


def answers(tracer: Tracer, direction: np.ndarray) -> Answers:
    """Of camera rays along these directions (p, 3)."""
    eye = np.array(tracer.scene.camera.eye, float)
    waves = tracer.follow(np.tile(eye, (len(direction), 1)), direction)
    pixel = np.arange(len(direction))
    key = (pixel.astype(np.uint64) + np.uint64(1)) << np.uint64(40)
    parts = []
    for depth, wave in enumerate(waves):
        if depth:
            pixel = pixel[wave.parent]
            # Wraps round, as a hash does: paths may be as long as a scene's bounce limit.
            key = key[wave.parent] * np.uint64(BRANCHES + 1)
            key = key + np.uint64(1) + BRANCH_OF[wave.kind].astype(np.uint64)
        parts.append((key, pixel, names_of(wave), numbers_of(wave)))
    return Answers(*(np.concatenate(part) for part in zip(*parts, strict=True)))


def names_of(wave: Wave) -> np.ndarray:
    """(m, k) kind, object, side, material, and of each light: is it seen, what is in its way."""
    every = [wave.kind, wave.hits.object, wave.hits.inside, wave.hits.material]
    of_lights = [*wave.lighting.visibility.T, *wave.lighting.blocker.T]
    return np.stack([*every, *of_lights]).T.astype(np.int64)


def numbers_of(wave: Wave) -> np.ndarray:
    """(m, j) all that is measured."""
    hits, lighting = wave.hits, wave.lighting
    t = np.where(hits.object == NOWHERE, 0.0, hits.t)
    columns = [
        t[:, None], wave.weight[:, None], wave.rays.direction, hits.point, hits.normal,
        lighting.local, wave.colour, lighting.diffuse, lighting.specular, lighting.blocked_at,
    ]  # fmt: skip
    return np.concatenate(columns, axis=1)


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
