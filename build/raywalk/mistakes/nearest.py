"""The nearest hit: of all surfaces that a ray meets, the one with the smallest t > 0."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from raywalk.mistakes.habits import Habits
from raywalk.mistakes.intersection import roots
from raywalk.mistakes.normals import outward_normal, programs_normal
from raywalk.mistakes.rays import NOTHING, Hits, Rays
from raywalk.mistakes.remembered import remembered
from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.vectors import dot, length
from raywalk.mistakes.world import FLAT, Body, World, asked_in_turn

# Of others it would be the surface that they leave: all of it would be in its own shadow.
OF_CAMERA_RAYS = frozenset(["behind-the-eye"])
MET_IN_ITS_OWN = ("ellipsoid", "box", "cylinder", "tube")  # where a ray has another length


def nearest(
    bodies: Iterable[Body], rays: Rays, mistakes: Mistakes, habits: Habits
) -> tuple[np.ndarray, np.ndarray]:
    """t (n,), inf if nothing, and object (n,) of what each ray meets first. bodies: as they are
    asked in turn."""
    count = rays.direction.shape[1]
    best = np.full(count, np.inf, rays.direction.dtype)  # of what is compared: t
    t, met = best.copy(), np.full(count, NOTHING)
    if "farthest-hit" in mistakes:
        best = -best
    if "first-in-list" in mistakes:
        bodies = sorted(bodies, key=lambda body: body.number)
    for body in bodies:
        ahead = first_ahead(body, rays, mistakes, habits)
        compared = ahead
        if "t-of-own-scale" in mistakes and body.kind in MET_IN_ITS_OWN:
            compared = ahead * length(body.own_direction(rays.direction))
        is_nearer = compared <= best if habits.last_wins else compared < best
        if "farthest-hit" in mistakes:
            is_nearer = compared > best
        if "first-in-list" in mistakes:
            is_nearer = met == NOTHING
        is_nearer &= ahead < np.inf
        best, t = np.where(is_nearer, compared, best), np.where(is_nearer, ahead, t)
        met = np.where(is_nearer, body.number, met)
    return t, met


def first_ahead(body: Body, rays: Rays, mistakes: Mistakes, habits: Habits) -> np.ndarray:
    """(n,) the smallest t > 0 at which rays meet one body, inf where they do not."""
    near, far = roots_ahead(body, rays, mistakes, habits)
    if "far-root" in mistakes and body.kind not in FLAT:
        return np.where(far < np.inf, far, near)
    if "inside-hits-lost" in mistakes and body.kind not in FLAT:
        return near
    return np.minimum(near, far)


def roots_ahead(
    body: Body, rays: Rays, mistakes: Mistakes, habits: Habits
) -> tuple[np.ndarray, np.ndarray]:
    """Both t (n,), where they lie ahead of the start, else inf."""
    near, far = roots(body, rays.origin, rays.direction, mistakes)
    least: float = 0.0
    if habits.offset is not None:
        least = habits.offset
    else:
        # A ray never meets again the surface that it leaves outwards; inwards, it comes out at
        # the far side. A flat one it leaves for good.
        leaves = rays.leaving == body.number
        if leaves.any():
            near = np.where(leaves, np.inf, near)
            far = np.where(leaves & ~rays.inwards, np.inf, far)
    if "behind-the-eye" in mistakes:
        return near, far
    return np.where(near > least, near, np.inf), np.where(far > least, far, np.inf)


@remembered
def hits_of(bodies: tuple[Body, ...], rays: Rays, mistakes: Mistakes, habits: Habits) -> Hits:
    """What each ray meets first, and the surface there."""
    t, met = nearest(asked_in_turn(bodies), rays, mistakes, habits)
    return surface_at(bodies, rays, t, met, mistakes)


def surface_at(
    bodies: Iterable[Body], rays: Rays, t: np.ndarray, met: np.ndarray, mistakes: Mistakes
) -> Hits:
    """The surfaces that rays meet at t (n,), of the objects `met` (n,)."""
    point = rays.origin + np.where(met == NOTHING, 0, t) * rays.direction
    normal, outward = np.zeros_like(rays.direction), np.zeros_like(rays.direction)
    inside, material = np.zeros(len(t), bool), np.full(len(t), -1)
    for body in bodies:
        here = np.flatnonzero(met == body.number)
        if not len(here):
            continue
        at, direction = point.take(here, axis=1), rays.direction.take(here, axis=1)
        out = outward_normal(body, at)
        outward[:, here] = out
        own = programs_normal(body, at, out, mistakes)
        inside[here] = dot(direction, own) > 0
        # The normal is turned to face the ray: both sides of a surface are lit.
        turns = inside[here]
        if "normal-not-turned" in mistakes:
            turns = np.zeros_like(turns)
        if "normal-inwards" in mistakes and body.is_solid:
            turns = ~turns
        normal[:, here] = np.where(turns, -own, own)
        material[here] = material_at(body, at)
    return Hits(t, met, point, normal, outward, inside, material)


def material_at(body: Body, point: np.ndarray) -> np.ndarray:
    """(n,) a body's material at its points (3, n): a checker has two."""
    if body.squares is None:
        return np.full(point.shape[1], body.material)
    x, _, z = body.own_point(point) / body.squares.size
    cell = np.floor(x) + np.floor(body.squares.sense * z)
    return np.where(cell % 2 == 1, body.squares.material, body.material)


def all_hits(
    world: World, rays: Rays, mistakes: Mistakes, habits: Habits
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Every hit of n rays, nearest first: ray (h,), t (h,), object (h,)."""
    every: list[np.ndarray] = []
    who: list[int] = []
    for body in asked_in_turn(world.bodies):
        every += roots_ahead(body, rays, mistakes, habits)
        who += [body.number, body.number]
    t = np.stack(every) if every else np.empty((0, rays.direction.shape[1]))
    place, ray = np.nonzero(t < np.inf)
    order = np.lexsort([place, t[place, ray], ray])
    place, ray = place[order], ray[order]
    return ray, t[place, ray], np.array(who, int)[place]
