"""Blinn-Phong shading of many hits at once, fused per stage so that rows stay in cache."""

from __future__ import annotations

import math

import numpy as np

from raywalk.optics.blinn_phong import diffuse_cosine, highlight, strength
from raywalk.optics.compiled import kernel


@kernel
def towards_light(rows, point, geometric, light):
    """For r points and one light: unit direction (r, 3), distance (r,), facing (r,) bool.

    rows: (r,) of point and geometric, both (n, 3). facing: the light lies on the side of the
    surface that the ray came to. A light at the very point has no direction and faces nothing.
    """
    count = rows.shape[0]
    direction, distance = np.zeros((count, 3)), np.zeros(count)
    facing = np.zeros(count, np.bool_)
    for r in range(count):
        i = rows[r]
        x, y, z = light[0] - point[i, 0], light[1] - point[i, 1], light[2] - point[i, 2]
        away = math.sqrt(x * x + y * y + z * z)
        distance[r] = away
        if away == 0.0:
            continue
        direction[r, 0], direction[r, 1], direction[r, 2] = x / away, y / away, z / away
        facing[r] = x * geometric[i, 0] + y * geometric[i, 1] + z * geometric[i, 2] > 0.0
    return direction, distance, facing


@kernel
def light_factors(
    materials, rows, material, normal, incoming, to_light, distance, intensity, attenuation,
    k, diffuse, specular,
):  # fmt: skip
    """Fills column k of diffuse and specular (n, l) in these rows (r,): strength times cosine
    and times highlight.

    to_light: (r, 3) and distance: (r,) as from `towards_light`; the others are (n,) and (n, 3).
    incoming: direction of the ray that hit. A factor whose material colour is black is not
    worked out and stays 0: the power of a highlight is the dearest part of shading.
    """
    # Element by element: views of rows would cost more than the arithmetic.
    for r in range(rows.shape[0]):
        if distance[r] == 0.0:
            continue
        i = rows[r]
        m = material[i]
        nx, ny, nz = normal[i, 0], normal[i, 1], normal[i, 2]
        lx, ly, lz = to_light[r, 0], to_light[r, 1], to_light[r, 2]
        reach = strength(distance[r], intensity, attenuation[0], attenuation[1], attenuation[2])
        if materials.diffuse[m, 0] + materials.diffuse[m, 1] + materials.diffuse[m, 2] > 0.0:
            diffuse[i, k] = reach * diffuse_cosine(nx, ny, nz, lx, ly, lz)
        if materials.specular[m, 0] + materials.specular[m, 1] + materials.specular[m, 2] > 0.0:
            ex, ey, ez = -incoming[i, 0], -incoming[i, 1], -incoming[i, 2]
            shine = highlight(nx, ny, nz, lx, ly, lz, ex, ey, ez, materials.shininess[m])
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
