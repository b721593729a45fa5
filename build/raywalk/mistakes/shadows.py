"""Whether a light can be seen from a point."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from raywalk.mistakes.habits import Habits
from raywalk.mistakes.nearest import OF_CAMERA_RAYS, nearest, roots_ahead
from raywalk.mistakes.rays import NOTHING, Hits, Rays, rays_off, rays_off_rounded
from raywalk.mistakes.remembered import remembered
from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.vectors import column, dot, length
from raywalk.mistakes.world import Body, World, asked_in_turn
from raywalk.trace.tree import Visibility

SHORT_OF_LIGHT = 1 - 1e-12  # share of its way that a shadow ray goes: a light may lie on a surface
FAR_TOO_LARGE = 0.2  # an offset in scenes that are a few units wide
# Of the first the offset is what is missing; a ray of the second starts on no surface.
WITHOUT_OFFSET = frozenset(["shadow-acne", "shadow-from-the-light"])


class Answer(NamedTuple):
    """What n points learn of one light; columns as in Lighting."""

    visibility: np.ndarray
    blocker: np.ndarray
    blocked_at: np.ndarray
    passed: np.ndarray


def ask_light(
    world: World, came: Rays, hits: Hits, light: int, l: np.ndarray, distance: np.ndarray,
    mistakes: Mistakes, habits: Habits,
) -> Answer:  # fmt: skip
    """From hits of the rays that came, along l (3, n), as the program has the direction to the
    light, which is `distance` (n,) away.

    A surface that faces away is in its own shadow, and a shadow ray is not needed to know it.
    """
    count = len(distance)
    answer = Answer(
        np.full(count, int(Visibility.UNTESTED)), np.full(count, NOTHING),
        np.ones_like(distance), np.ones_like(distance),
    )  # fmt: skip
    source = world.scene.lights[light]
    if not world.scene.render.shadows or source.intensity == 0 or not any(source.colour):
        return answer
    if "shadow-of-first-light-only" in mistakes and light > 0:
        return answer
    answer.visibility[:] = Visibility.BEHIND
    if "highlight-turned-away" in mistakes:
        answer.visibility[:] = Visibility.REACHED  # n.l, clamped, leaves no diffuse light there
    facing = np.flatnonzero(dot(hits.normal, l) > 0)
    at, away = hits.take(facing), distance[facing]
    came, l = came.take(facing), l.take(facing, axis=1)
    rays, reach = shadow_rays(world, came, at, light, l, away, mistakes)
    mistakes = mistakes - OF_CAMERA_RAYS
    if mistakes & WITHOUT_OFFSET:
        habits = replace(habits, offset=None)
    t, met, passed = stopped(world.bodies, passed_by(world), rays, reach, mistakes, habits)
    part = t / reach_of(rays, away)
    if "shadow-from-the-light" in mistakes:
        part = 1 - part
    if "shadow-of-own-surface" in mistakes:
        met, part = at.object, np.zeros_like(part)
    is_blocked = met != NOTHING
    answer.visibility[facing] = np.where(is_blocked, Visibility.BLOCKED, Visibility.REACHED)
    answer.blocker[facing], answer.passed[facing] = met, passed
    answer.blocked_at[facing] = np.where(is_blocked, np.clip(part, 0, 1), 1)
    return answer


def shadow_rays(
    world: World, came: Rays, hits: Hits, light: int, l: np.ndarray, distance: np.ndarray,
    mistakes: Mistakes,
) -> tuple[Rays, np.ndarray]:  # fmt: skip
    """The shadow rays, and the t (n,) that each goes to."""
    rays, reach = rays_off(hits, l), distance * SHORT_OF_LIGHT
    if "light-not-unit" in mistakes:
        reach = np.full_like(reach, SHORT_OF_LIGHT)  # l is as long as the way
    if "shadow-acne" in mistakes:
        rays = rays_off_rounded(came, hits, l)
    if "shadow-offset-too-large" in mistakes:
        rays = rays._replace(origin=hits.point + FAR_TOO_LARGE * hits.normal)
    if "shadow-beyond-the-light" in mistakes:
        reach = np.full_like(reach, np.inf)
    if "shadow-from-the-light" in mistakes:
        position = column(world.scene.lights[light].position).astype(l.dtype)
        start = np.broadcast_to(position, hits.point.shape)
        # Its own object it does not ask; what is behind the point it does.
        rays = Rays(start, -l, hits.object, np.zeros(len(distance), bool))
        reach = np.full_like(reach, np.inf)
    return rays, reach


def reach_of(rays: Rays, distance: np.ndarray) -> np.ndarray:
    """(n,) t of the light itself along its ray."""
    return distance / length(rays.direction)


def passed_by(world: World) -> np.ndarray | None:
    """(materials,) the share of light that a surface lets pass, where the scene says that light
    crosses glass, unbent; else None."""
    return world.optics.transmit if world.scene.render.glass_shadows == "pass" else None


@remembered
def stopped(
    bodies: tuple[Body, ...], passing: np.ndarray | None, rays: Rays, reach: np.ndarray,
    mistakes: Mistakes, habits: Habits,
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:  # fmt: skip
    """t and object of what stops each ray before `reach` (n,), inf and NOTHING if nothing; and the
    share that glass on the way lets pass, if any passes."""
    in_turn = asked_in_turn(bodies)
    opaque = [body for body in in_turn if passing is None or not body.is_clear]
    t, met = nearest(opaque, rays, mistakes, habits)
    stops = (t < reach) & (met != NOTHING)
    t, met = np.where(stops, t, np.inf), np.where(stops, met, NOTHING)
    passed, end = np.ones_like(reach), np.minimum(t, reach)
    if passing is None:
        return t, met, passed
    for body in in_turn:
        if body.is_clear:
            near, far = roots_ahead(body, rays, mistakes, habits)
            crossed = (near < end).astype(int) + (far < end)
            passed = passed * passing[body.material] ** crossed
    return t, met, passed
