"""What lamps give at hits: Blinn-Phong. World units, linear colours."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from raywalk.mistakes.habits import Habits
from raywalk.mistakes.rays import NOTHING, Hits, Rays
from raywalk.mistakes.shadows import ask_light
from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.vectors import column, dot, length, unit
from raywalk.mistakes.world import Optics, Surfaces, World
from raywalk.scene.model import Light
from raywalk.trace.tree import LIT, Visibility

# A cosine is 1 at most, but for a mistake: powers of more are white long before they overflow.
DAZZLING = 1e3


class Lighting(NamedTuple):
    """At n hits, of L lights. Factors hold no material colour and no visibility."""

    visibility: np.ndarray  # (L, n) Visibility
    blocker: np.ndarray  # (L, n) object that stops the shadow ray, else NOTHING
    blocked_at: np.ndarray  # (L, n) share of the way to the light, 1 if it arrives
    passed: np.ndarray  # (L, n) share that glass on the way lets pass
    diffuse: np.ndarray  # (L, n)
    specular: np.ndarray  # (L, n)
    base: np.ndarray  # (n,) what ambient and diffuse are multiplied by: 1, but for a mistake
    local: np.ndarray  # (3, n) colour at the hit
    local_weight: np.ndarray  # (n,) its share in the ray's colour


def light_hits(
    world: World, rays: Rays, hits: Hits, mistakes: Mistakes, habits: Habits
) -> Lighting:
    """The lighting of the hits of rays.

    Points without a colour of their own (mirrors, clear glass) ask no light.
    """
    lights, surfaces, count = world.scene.lights, world.surfaces, len(hits.t)
    direction = rays.direction
    out = Lighting(
        visibility=np.full((len(lights), count), int(Visibility.UNTESTED), np.uint8),
        blocker=np.full((len(lights), count), NOTHING),
        blocked_at=np.ones((len(lights), count), direction.dtype),
        passed=np.ones((len(lights), count), direction.dtype),
        diffuse=np.zeros((len(lights), count), direction.dtype),
        specular=np.zeros((len(lights), count), direction.dtype),
        base=np.ones(count, direction.dtype),
        local=np.zeros_like(direction),
        local_weight=own_share(world.optics, hits, mistakes),
    )
    asked = np.flatnonzero(out.local_weight > 0)
    at, came = hits.take(asked), rays.take(asked)
    for k, light in enumerate(lights):
        to_light = column(light.position).astype(direction.dtype) - at.point
        distance = length(to_light)
        l = to_light / distance
        if "light-not-unit" in mistakes:
            l = to_light
        if "light-reversed" in mistakes:
            l = -l
        diffuse, specular = blinn_phong(surfaces, at, l, -came.direction, mistakes)
        strength = strength_at(light, distance)
        answer = ask_light(world, came, at, k, l, distance, mistakes, habits)
        out.visibility[k, asked] = answer.visibility
        out.blocker[k, asked], out.blocked_at[k, asked] = answer.blocker, answer.blocked_at
        out.passed[k, asked] = answer.passed
        out.diffuse[k, asked] = strength * answer.passed * diffuse
        out.specular[k, asked] = strength * answer.passed * specular
    is_lit = np.isin(out.visibility, LIT)
    if "shadow-darkens-ambient" in mistakes and lights:
        out.base[asked] = is_lit[:, asked].any(axis=0)
    out.local[:, asked] = local_colour(world, at.material, asked, is_lit, out)
    return out


def own_share(optics: Optics, hits: Hits, mistakes: Mistakes) -> np.ndarray:
    """(n,) 1 - kr - kt: what mirrors and glass leave of a surface's own colour."""
    reflect, transmit = optics.reflect[hits.material], optics.transmit[hits.material]
    share = 1 - reflect - transmit
    if "mirror-adds-own-colour" in mistakes:
        share = np.where((reflect > 0) & (transmit == 0), np.ones_like(share), share)
    return np.where(hits.object == NOTHING, np.zeros_like(share), share)


def strength_at(light: Light, distance: np.ndarray) -> np.ndarray:
    """(n,) I / (a0 + a1 D + a2 D^2); 0 where that would divide by 0."""
    a0, a1, a2 = light.attenuation
    falloff = a0 + a1 * distance + a2 * distance**2
    return np.where(falloff > 0, light.intensity / falloff, 0).astype(distance.dtype)


def blinn_phong(
    surfaces: Surfaces, hits: Hits, l: np.ndarray, e: np.ndarray, mistakes: Mistakes
) -> tuple[np.ndarray, np.ndarray]:
    """max(0, n.l) and max(0, n.h)^s with h = (l + e) / |l + e|, each (n,); 0 where the material has
    no such colour.

    l: to the light, e: to where the ray came from, (3, n) unit. Blinn, "Models of light reflection
    for computer synthesized pictures", SIGGRAPH 1977.
    """
    n, exponent = hits.normal, surfaces.shininess[hits.material]
    cosine = dot(n, l)
    diffuse = np.maximum(0, cosine)
    if "cosine-not-clamped" in mistakes:
        diffuse = cosine
    if "cosine-absolute" in mistakes:
        diffuse = np.abs(cosine)

    if "view-reversed" in mistakes:
        e = -e
    h = unit(l + e)
    if "half-not-unit" in mistakes:
        h = l + e
    shine = dot(n, h)
    if "phong-for-blinn" in mistakes:
        shine = dot(2 * cosine * n - l, e)
    specular = np.where(shine > 0, np.maximum(shine, 0) ** exponent, 0)
    specular = np.minimum(specular, DAZZLING)

    is_matt = np.any(surfaces.diffuse, axis=1).take(hits.material)
    is_shiny = np.any(surfaces.specular, axis=1).take(hits.material)
    return np.where(is_matt, diffuse, 0), np.where(is_shiny, specular, 0)


def local_colour(
    world: World, material: np.ndarray, asked: np.ndarray, is_lit: np.ndarray, lighting: Lighting
) -> np.ndarray:
    """(3, a) ka + sum over lights V (kd n.l + ks (n.h)^s) L at the hits `asked` (a,).

    material: (a,); is_lit: (L, n), the V.
    """
    surfaces, base = world.surfaces, lighting.base[asked]
    ambient, kd, ks = (
        colour.T.take(material, axis=1)
        for colour in (surfaces.ambient, surfaces.diffuse, surfaces.specular)
    )
    colour = ambient * base
    for k, light in enumerate(world.scene.lights):
        diffuse, specular = lighting.diffuse[k, asked], lighting.specular[k, asked]
        shine = (kd * base * diffuse + ks * specular) * column(light.colour).astype(colour.dtype)
        colour = colour + np.where(is_lit[k, asked], shine, 0)
    return colour
