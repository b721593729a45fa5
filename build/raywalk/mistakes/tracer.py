"""The tracer: START HERE.

All rays of one depth are traced together, a wave: what does each hit, what does each light give
there, where do mirrors and glass send it on? When none is left, colours are gathered back from the
deepest wave to the camera rays. It is the model of the site's page "The model", once more and
plainly: it shares no formula with the pipeline's tracer, only scenes and the names of ray kinds.

A mistake is a word (table.py). The line that makes it asks `if "far-root" in mistakes`, right
behind the line that does it rightly; any may be made together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from raywalk.mistakes.believed import believed
from raywalk.mistakes.bounces import Sent, bounced
from raywalk.mistakes.camera import camera_directions
from raywalk.mistakes.colour import to_bytes
from raywalk.mistakes.glass import stacks_holding
from raywalk.mistakes.habits import EXACT, Habits
from raywalk.mistakes.lighting import Lighting, light_hits
from raywalk.mistakes.nearest import OF_CAMERA_RAYS, hits_of
from raywalk.mistakes.rays import NOTHING, Hits, Rays, free_rays
from raywalk.mistakes.remembered import remembering
from raywalk.mistakes.table import Mistakes, checked
from raywalk.mistakes.vectors import column
from raywalk.mistakes.world import World, holding, refuse_left_out, world_of
from raywalk.scene.model import Scene
from raywalk.trace.tree import Kind

# A ray with a smaller share in its pixel is not followed in pictures: 0.06 of one step of a byte.
LEAST_SHARE = 1 / 4096
WHITE = 1.0
STRIP = 16_384  # pixels traced at once: what their rays need, and are remembered by, stays small


class Wave(NamedTuple):
    """All rays of one depth, and what became of them."""

    sent: Sent
    hits: Hits
    lighting: Lighting
    colour: np.ndarray  # (3, n) what each brings back: final once the waves behind are gathered


class Version(NamedTuple):
    """A way to write the program."""

    mistakes: Mistakes = frozenset()
    habits: Habits = EXACT


class Picture(NamedTuple):
    """What a program shows."""

    linear: np.ndarray  # (n, n, 3) before bytes are made of it, row 0 on top
    bytes: np.ndarray  # (n, n, 3) uint8


def picture(
    scene: Scene, n: int, mistakes: Mistakes = frozenset(), habits: Habits = EXACT,
    least_share: float = LEAST_SHARE,
) -> Picture:  # fmt: skip
    """An n x n picture of a scene. Raises SourceErrors that name what this tracer leaves out, and
    ValueError for a mistake that there is not."""
    traced = (trace(scene, n, one, mistakes, habits, least_share)[1][0] for one in strips_of(n))
    linear = np.concatenate([wave.colour.T for wave in traced]).reshape(n, n, 3)
    return Picture(linear, to_bytes(linear, mistakes, habits))


def strips_of(n: int) -> list[np.ndarray]:
    """The pixels of an n x n picture, in parts."""
    return np.array_split(np.arange(n * n), -(-n * n // STRIP))


def pictures(
    scene: Scene, n: int, versions: Sequence[Version], least_share: float = LEAST_SHARE
) -> list[np.ndarray]:
    """Of each version its n x n picture's bytes, as `picture` has them, which would trace for each
    what all have in common. Raises as `picture` does."""
    found: list[list[np.ndarray]] = [[] for _ in versions]
    for strip in strips_of(n):
        with remembering():
            for habits in {each.habits: None for each in versions}:
                trace(scene, n, strip, frozenset(), habits, least_share)
            for made, (mistakes, habits) in zip(found, versions, strict=True):
                waves = trace(scene, n, strip, mistakes, habits, least_share)[1]
                made.append(to_bytes(waves[0].colour.T, mistakes, habits))
    return [np.concatenate(made).reshape(n, n, 3) for made in found]


def trace(
    scene: Scene, n: int, pixels: np.ndarray, mistakes: Mistakes = frozenset(),
    habits: Habits = EXACT, least_share: float = 0.0,
) -> tuple[World, list[Wave]]:  # fmt: skip
    """Pixels (p,), row * n + column, of an n x n picture, traced to the end: wave 0 has their
    colours. The world is what the program took the scene for."""
    refuse_left_out(scene)
    world = world_of(believed(scene, checked(mistakes)), habits.precision)
    direction = camera_directions(world.scene.camera, n, pixels, mistakes, habits)
    eye = np.asarray(column(world.scene.camera.eye), habits.precision)
    return world, follow(world, free_rays(eye, direction), mistakes, habits, least_share)


def follow(
    world: World, rays: Rays, mistakes: Mistakes = frozenset(), habits: Habits = EXACT,
    least_share: float = 0.0,
) -> list[Wave]:  # fmt: skip
    """Rays that start where the eye is, to the end of all that they lead to."""
    # What has no answer (a ray beside a sphere) is worked out all the same, and not chosen.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
        waves = [wave_of(world, from_the_eye(world, rays), mistakes, habits)]
        for _ in range(world.scene.render.depth):
            sent = bounced(world.optics, waves[-1].sent, waves[-1].hits, least_share, mistakes)
            if not len(sent.parent):
                break
            waves.append(wave_of(world, sent, mistakes, habits))
        else:
            last = waves[-1]
            if "white-at-the-limit" in mistakes:
                beyond = bounced(world.optics, last.sent, last.hits, least_share, mistakes)
                for channel in last.colour:
                    np.add.at(channel, beyond.parent, beyond.weight * WHITE)
    gather(waves)
    return waves


def from_the_eye(world: World, rays: Rays) -> Sent:
    """Camera rays, in the glass that the eye may be in."""
    count = len(rays.leaving)
    clear = [body for body in world.bodies if body.is_clear]
    around = holding(clear, column(world.scene.camera.eye))
    ones = np.ones(count, rays.direction.dtype)
    return Sent(
        rays, np.full(count, -1), np.full(count, Kind.CAMERA), ones, ones,
        stacks_holding([body.number for body in around], len(clear), count),
    )  # fmt: skip


def wave_of(world: World, sent: Sent, mistakes: Mistakes, habits: Habits) -> Wave:
    """Rays that have been sent, traced to their hits."""
    own = replace(habits, offset=None) if "mirror-acne" in mistakes else habits
    is_camera = sent.parent[0] < 0
    hits = hits_of(
        world.bodies, sent.rays, mistakes if is_camera else mistakes - OF_CAMERA_RAYS, own
    )
    lighting = light_hits(world, sent.rays, hits, mistakes, habits)
    background = column(world.scene.background).astype(lighting.local.dtype)
    own = lighting.local_weight * lighting.local
    return Wave(sent, hits, lighting, np.where(hits.object == NOTHING, background, own))


def gather(waves: list[Wave]) -> None:
    """Adds weight * colour of each ray to the ray that sent it, from the deepest wave on."""
    for k in range(len(waves) - 1, 0, -1):
        sent, colour = waves[k].sent, waves[k].colour
        brought, before = sent.weight * colour, waves[k - 1].colour
        for is_of_branch in (sent.kind != Kind.REFRACTED, sent.kind == Kind.REFRACTED):
            # A hit sends on at most one ray of each branch: no parent stands here twice.
            branch = np.flatnonzero(is_of_branch)
            parent = sent.parent[branch]
            for to, part in zip(before, brought, strict=True):
                to[parent] += part[branch]
