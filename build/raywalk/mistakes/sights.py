"""What right rays have that a mistake would change: of each ray of a wave, (n,) bool."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from raywalk.mistakes.habits import EXACT
from raywalk.mistakes.nearest import first_ahead, nearest
from raywalk.mistakes.rays import NOTHING, Hits, Rays, rays_off
from raywalk.mistakes.tracer import Wave
from raywalk.mistakes.vectors import column, dot, length, unit
from raywalk.mistakes.world import SOLIDS, World
from raywalk.trace.tree import LIT, Kind, Visibility

STEP = 0.3 / 255  # what is less in a colour seldom changes a byte

Test = Callable[[World, Wave], np.ndarray]


def is_mirror(world: World, wave: Wave) -> np.ndarray:
    """Hits on opaque mirrors."""
    return np.asarray(world.optics.reflect[wave.hits.material] > 0) & ~is_glass(world, wave)


def is_glass(world: World, wave: Wave) -> np.ndarray:
    """Hits on what light goes through."""
    return np.asarray(world.optics.transmit[wave.hits.material] > 0)


def is_fresnel(world: World, wave: Wave) -> np.ndarray:
    """Hits on glass that mirrors the more, the flatter a ray comes."""
    return np.asarray(world.optics.fresnel[wave.hits.material])


def is_total(world: World, wave: Wave) -> np.ndarray:
    """Rays that were totally reflected."""
    return np.asarray(wave.sent.kind == Kind.TOTAL)


def on_kind(*kinds: str) -> Test:
    """Hits on bodies of these kinds."""

    def test(world: World, wave: Wave) -> np.ndarray:
        is_it = np.array([*(body.kind in kinds for body in world.bodies), False])
        return np.asarray(is_it[wave.hits.object])

    return test


def is_long_normal(world: World, wave: Wave) -> np.ndarray:
    """Hits on balls whose normal p - c is not one long, and on ellipsoids."""
    is_it = [b.kind == "ellipsoid" or (b.kind == "sphere" and b.radius != 1) for b in world.bodies]
    return np.asarray(np.array([*is_it, False])[wave.hits.object])


def is_stretched(world: World, wave: Wave) -> np.ndarray:
    """Hits on ellipsoids with axes of several lengths."""
    is_it = []
    for body in world.bodies:
        square = body.to_world.T @ body.to_world
        is_ball = np.allclose(square, square[0, 0] * np.eye(3), rtol=0.01)
        is_it.append(body.kind == "ellipsoid" and not is_ball)
    return np.asarray(np.array([*is_it, False])[wave.hits.object])


def brought(world: World, wave: Wave) -> np.ndarray:
    """(L, n) what each light's diffuse part would bring the pixel, seen or not."""
    share = wave.sent.share * wave.lighting.local_weight
    return np.asarray(wave.lighting.diffuse * brightest(world, wave, "diffuse") * share)


def highlight(world: World, wave: Wave) -> np.ndarray:
    """(L, n) the same of its specular part."""
    share = wave.sent.share * wave.lighting.local_weight
    return np.asarray(wave.lighting.specular * brightest(world, wave, "specular") * share)


def brightest(world: World, wave: Wave, name: str) -> np.ndarray:
    """(n,) the largest part of a colour of each hit's material."""
    return np.asarray(getattr(world.surfaces, name)[wave.hits.material].max(axis=1))


def is_known(wave: Wave, *answers: Visibility) -> np.ndarray:
    """(L, n) what is known of the lights."""
    return np.isin(wave.lighting.visibility, answers)


def lit_by(world: World, wave: Wave) -> np.ndarray:
    """(L, n) lights that give something."""
    gives = np.maximum(brought(world, wave), highlight(world, wave)) > STEP
    return np.asarray(is_known(wave, *LIT) & gives)


def is_lit(world: World, wave: Wave) -> np.ndarray:
    """Hits that some light lights."""
    return np.asarray(lit_by(world, wave).any(axis=0))


def is_lit_solid(world: World, wave: Wave) -> np.ndarray:
    """Such hits on solids."""
    return on_kind(*SOLIDS)(world, wave) & is_lit(world, wave)


def has_ambient(world: World, wave: Wave) -> np.ndarray:
    """Hits with an ambient colour."""
    return np.asarray(brightest(world, wave, "ambient") > STEP)


def is_shiny(world: World, wave: Wave) -> np.ndarray:
    """Lit hits that could have a highlight."""
    return is_lit(world, wave) & (brightest(world, wave, "specular") > STEP)


def has_highlight(world: World, wave: Wave) -> np.ndarray:
    """Hits that have one."""
    return np.asarray((lit_by(world, wave) & (highlight(world, wave) > STEP)).any(axis=0))


def has_highlight_turned_away(world: World, wave: Wave) -> np.ndarray:
    """Hits that would have one, of a light that they face away from."""
    is_away = is_known(wave, Visibility.BEHIND) & (highlight(world, wave) > STEP)
    return np.asarray(is_away.any(axis=0))


def kept_from(world: World, wave: Wave) -> np.ndarray:
    """(L, n) lights that something keeps from giving."""
    return np.asarray(is_known(wave, Visibility.BLOCKED) & (brought(world, wave) > STEP))


def is_in_shadow(world: World, wave: Wave) -> np.ndarray:
    """Hits that something keeps a light from."""
    return np.asarray(kept_from(world, wave).any(axis=0))


def is_dark_to_a_second(world: World, wave: Wave) -> np.ndarray:
    """Hits that a light other than the first does not reach."""
    is_away = kept_from(world, wave) | is_known(wave, Visibility.BEHIND)
    return np.asarray(is_away[1:].any(axis=0))


def is_dark(world: World, wave: Wave) -> np.ndarray:
    """Hits that no light reaches, with an ambient colour."""
    share = wave.sent.share * wave.lighting.local_weight
    ambient = brightest(world, wave, "ambient") * share > STEP
    return np.asarray(~is_known(wave, *LIT).any(axis=0) & ambient)


def is_turned_away(world: World, wave: Wave) -> np.ndarray:
    """Hits that face away from a light which would be bright there."""
    found = np.zeros(len(wave.hits.t), bool)
    for light in world.scene.lights:
        to_light = column(light.position) - wave.hits.point
        cosine = dot(wave.hits.normal, to_light) / length(to_light)
        found |= cosine * light.intensity * brightest(world, wave, "diffuse") < -STEP
    return np.asarray(found & (wave.lighting.local_weight > 0))


def is_before_listed(world: World, wave: Wave) -> np.ndarray:
    """Rays that would also meet something that is listed before what they meet."""
    return would_meet(world, wave, lambda number: number < wave.hits.object)


def is_before_another(world: World, wave: Wave) -> np.ndarray:
    """Rays that would meet something else, too."""
    return would_meet(world, wave, lambda number: number != wave.hits.object)


def would_meet(world: World, wave: Wave, which: Callable[[int], Any]) -> np.ndarray:
    """Rays with one of these bodies, by their numbers, anywhere ahead."""
    found = np.zeros(len(wave.hits.t), bool)
    for body in world.bodies:
        ahead = first_ahead(body, wave.sent.rays, frozenset(), EXACT) < np.inf
        found |= ahead & which(body.number)
    return found


def is_before_something(world: World, wave: Wave) -> np.ndarray:
    """Camera rays that have something behind the eye."""
    rays = wave.sent.rays
    back = rays._replace(direction=-rays.direction)
    is_behind = nearest(world.bodies, back, frozenset(), EXACT)[1] != NOTHING
    return np.asarray(is_behind & (wave.sent.kind == Kind.CAMERA))


def asked_along(rays_to: Callable[[Hits, np.ndarray, np.ndarray], Rays]) -> Test:
    """Lit hits for which such rays, made of hits, light and way, meet something beyond the way."""

    def test(world: World, wave: Wave) -> np.ndarray:
        found, lit = np.zeros(len(wave.hits.t), bool), lit_by(world, wave)
        opaque = [body for body in world.bodies if not body.is_clear]
        for k, light in enumerate(world.scene.lights):
            rows = np.flatnonzero(lit[k])
            at, position = wave.hits.take(rows), column(light.position)
            rays = rays_to(at, position, unit(position - at.point))
            t, met = nearest(opaque, rays, frozenset(), EXACT)
            found[rows] |= (met != NOTHING) & (t > length(position - at.point))
        return found

    return test


def is_lit_through_glass(world: World, wave: Wave) -> np.ndarray:
    """Lit hits that have glass between them and the light."""
    found, lit = np.zeros(len(wave.hits.t), bool), lit_by(world, wave)
    clear = [body for body in world.bodies if body.is_clear]
    for k, light in enumerate(world.scene.lights):
        rows = np.flatnonzero(lit[k])
        to_light = column(light.position) - wave.hits.point[:, rows]
        rays = rays_off(wave.hits.take(rows), unit(to_light))
        found[rows] |= nearest(clear, rays, frozenset(), EXACT)[0] < length(to_light)
    return found


def is_coloured(world: World, wave: Wave) -> np.ndarray:
    """Rays that bring more red than blue, or less."""
    return np.asarray(np.abs(wave.colour[0] - wave.colour[2]) * wave.sent.share > STEP)


def from_hit(hits: Hits, position: np.ndarray, l: np.ndarray) -> Rays:
    return rays_off(hits, l)


def from_light(hits: Hits, position: np.ndarray, l: np.ndarray) -> Rays:
    start = np.broadcast_to(position, hits.point.shape)
    return Rays(start, -l, hits.object, np.zeros(len(hits.t), bool))
