"""Blinn-Phong shading of many hits at once, fused per stage so that rows stay in cache."""

from __future__ import annotations

import math

import numpy as np

from raywalk.optics.blinn_phong import diffuse_cosine, highlight, strength
from raywalk.optics.compiled import kernel


@kernel
def towards_lights(rows, point, geometric, light):
    """For r points and l lights, light by light: unit direction (l r, 3), distance (l r,), facing
    (l r,) bool.

    rows: (r,) of point and geometric, both (n, 3); light: (l, 3). facing: the light lies on the
    side of the surface that the ray came to. A light at the very point has no direction and faces
    nothing.
    """
    count = light.shape[0] * rows.shape[0]
    direction, distance = np.zeros((count, 3)), np.zeros(count)
    facing, pair = np.zeros(count, np.bool_), -1
    for k in range(light.shape[0]):
        for i in rows:
            pair += 1
            x = light[k, 0] - point[i, 0]
            y = light[k, 1] - point[i, 1]
            z = light[k, 2] - point[i, 2]
            away = math.sqrt(x * x + y * y + z * z)
            distance[pair] = away
            if away == 0.0:
                continue
            direction[pair, 0], direction[pair, 1] = x / away, y / away
            direction[pair, 2] = z / away
            side = x * geometric[i, 0] + y * geometric[i, 1] + z * geometric[i, 2]
            facing[pair] = side > 0.0
    return direction, distance, facing


@kernel
def light_factors(
    materials, lights, first, rows, material, normal, incoming, to_light, distance, diffuse,
    specular,
):  # fmt: skip
    """Fills diffuse and specular (n, l) in these rows (r,) and the columns of g lights from `first`
    on: strength times cosine and times highlight.

    to_light: (g r, 3) and distance: (g r,) as from `towards_lights`; the others are (n,) and
    (n, 3). incoming: direction of the ray that hit. A factor whose material colour is black is not
    worked out and stays 0: the power of a highlight is the dearest part of shading.
    """
    # Element by element: views of rows would cost more than the arithmetic.
    has_diffuse = np.array([kd[0] + kd[1] + kd[2] > 0.0 for kd in materials.diffuse])
    has_specular = np.array([ks[0] + ks[1] + ks[2] > 0.0 for ks in materials.specular])
    shininess, intensity, attenuation = materials.shininess, lights.intensity, lights.attenuation
    count, pair = rows.shape[0], -1
    for k in range(first, first + distance.shape[0] // max(1, count)):
        a0, a1, a2 = attenuation[k, 0], attenuation[k, 1], attenuation[k, 2]
        for i in rows:
            pair += 1
            m, away = material[i], distance[pair]
            if away == 0.0:
                continue
            nx, ny, nz = normal[i, 0], normal[i, 1], normal[i, 2]
            lx, ly, lz = to_light[pair, 0], to_light[pair, 1], to_light[pair, 2]
            reach = strength(away, intensity[k], a0, a1, a2)
            if has_diffuse[m]:
                diffuse[i, k] = reach * diffuse_cosine(nx, ny, nz, lx, ly, lz)
            if has_specular[m]:
                ex, ey, ez = -incoming[i, 0], -incoming[i, 1], -incoming[i, 2]
                shine = highlight(nx, ny, nz, lx, ly, lz, ex, ey, ez, shininess[m])
                specular[i, k] = reach * shine


@kernel
def local_colours(materials, lights, rows, material, base, lit, diffuse, specular, colour):
    """Fills colour (n, 3) in these rows (r,): B ambient + sum over lights V (diffuse B kd +
    specular ks) light colour, with the base colour B.

    material: (n,); base: (n, 3), or (0, 3) where it is 1 everywhere; lit (V), diffuse and specular:
    (n, l).
    """
    for i in rows:
        m = material[i]
        for c in range(3):
            b = base[i, c] if base.shape[0] > 0 else 1.0
            total = materials.ambient[m, c] * b
            for k in range(lights.colour.shape[0]):
                if lit[i, k]:
                    shine = diffuse[i, k] * (materials.diffuse[m, c] * b)
                    shine += specular[i, k] * materials.specular[m, c]
                    total += shine * lights.colour[k, c]
            colour[i, c] = total
