"""What mirrors and glass have round them, for the approximate look: FORMAT of surroundings.js.

A rasteriser draws a mirror by looking up, for each pixel, which way a ray would go on and what is
seen that way from the mirror's place. Both are traced here, once an object: a picture of all
directions with how far things are, and a table of how far a ray turns at each angle. So the viewer
looks up, and works nothing out. What a flat mirror shows a rasteriser draws as the eye's mirror
image sees it, wherever that is: of such a mirror only the share is told.
"""

from __future__ import annotations

import base64
import math
from io import BytesIO
from typing import Any

import numpy as np
from PIL import Image

from raywalk.geometry.compiled import Rays, rays_from
from raywalk.geometry.roots import NOWHERE
from raywalk.optics.scatter import glass_shares, mirror_directions, refracted_directions
from raywalk.scene.model import Material, SceneObject
from raywalk.scene.shapes import Box, Disc, Plane, Triangle
from raywalk.trace.wavefront import STRIP, Tracer, eight_bit

SIDE = 240  # pixels of a picture of all directions: less than a degree each
MOST = 24  # bodies, the largest: in a scene of many little is seen of the others
ANGLES = 64  # rows of a table of turns, by the cosine of the angle of incidence from 0 to 1
QUALITY = 90  # of WebP: a mean error of about 2 of 255
METHOD = 4  # 6 makes 10 % fewer bytes of them in fifty times the time
# Of a surface: less is not seen as a mirror or as something to look through (state/look.ts).
MIRRORS_FROM, CLEAR_FROM = 0.5, 0.3
FLOOR_MIRRORS_FROM = 0.05  # polished, it shows what stands on it
SHEETS = (Disc, Triangle)
PARALLEL = (Box, *SHEETS)  # through these a ray goes on as it came

Json = dict[str, Any]


def surroundings_of(tracer: Tracer) -> Json | None:
    """Of each mirror and glass body, at most MOST, its surroundings, and of each flat mirror its
    share: SurroundingsData in site/scene_types.py. None where there are none.

    A body's are {"object": index, "centre", "radius" of a sphere round it, "picture": a data URI,
    "turns"}.
    Pixel (u, v) of the picture is the direction that `directions` gives for it: its colour, and as
    opacity radius / (radius + distance from the centre). Turns: for cosines 0 to 1 of the angle of
    incidence [turn of what is mirrored, share mirrored, turn of what goes through, angle on a ball
    between where it goes in and where it comes out], radians; turns go from the ray's way towards
    the normal.
    """
    scene = tracer.scene
    bodies = [
        (k, *_sphere(tracer, k))
        for k, obj in enumerate(scene.objects)
        if _is_shown(obj, scene.materials[obj.material])
    ]
    bodies.sort(key=lambda body: -body[2])
    shown = [
        _surroundings(tracer, *body) for body in sorted(bodies[:MOST], key=lambda body: body[0])
    ]
    flat = [
        {"object": k, "share": scene.materials[obj.material].reflect}
        for k, obj in enumerate(scene.objects)
        if _is_flat_mirror(obj, scene.materials[obj.material])
    ]
    if not shown and not flat:
        return None
    return {
        "format": 2, "scene": scene.id, "objects": shown, "flat": flat,
        "background": list(scene.background),
    }  # fmt: skip


def _is_shown(obj: SceneObject, material: Material) -> bool:
    shows = material.reflect > MIRRORS_FROM or material.transmit > CLEAR_FROM
    return shows and not isinstance(obj.shape, Plane) and not _is_flat_mirror(obj, material)


def _is_flat_mirror(obj: SceneObject, material: Material) -> bool:
    if material.transmit > CLEAR_FROM:
        return False
    if isinstance(obj.shape, Plane):
        return material.reflect > FLOOR_MIRRORS_FROM
    return isinstance(obj.shape, SHEETS) and material.reflect > MIRRORS_FROM


def _surroundings(tracer: Tracer, k: int, centre: np.ndarray, radius: float) -> Json:
    obj = tracer.scene.objects[k]
    picture = _around(tracer, k, centre, radius)
    return {
        "object": k,
        "centre": centre.tolist(),
        "radius": radius,
        "picture": _data_uri(picture),
        "turns": turns(tracer.scene.materials[obj.material], isinstance(obj.shape, PARALLEL)),
    }


def _sphere(tracer: Tracer, k: int) -> tuple[np.ndarray, float]:
    for mesh in tracer.compiled.meshes:
        if mesh.index == k:
            reach = np.sqrt((mesh.corners.reshape(-1, 3) ** 2).sum(axis=1).max())
            return mesh.centre, float(reach)
    table = tracer.compiled.primitives
    row = table.row_of[k]
    return table.centre[row], math.sqrt(table.reach_sq[row])


def directions(side: int) -> np.ndarray:
    """(side * side, 3) unit directions of a square picture's pixels, raster order.

    The octahedron |x| + |y| + |z| = 1 seen from above, its lower half folded out into the corners
    (Engelhardt and Dachsbacher, Octahedron Environment Maps, 2008).
    """
    at = (np.arange(side) + 0.5) * 2 / side - 1
    x, z = np.tile(at, side), np.repeat(at, side)
    y = 1 - np.abs(x) - np.abs(z)
    below = y < 0
    folded = (1 - np.abs(z)) * np.where(x < 0, -1, 1), (1 - np.abs(x)) * np.where(z < 0, -1, 1)
    way = np.stack([np.where(below, folded[0], x), y, np.where(below, folded[1], z)], axis=1)
    return np.asarray(way / np.sqrt((way**2).sum(axis=1))[:, None])


def _around(tracer: Tracer, k: int, centre: np.ndarray, radius: float) -> np.ndarray:
    """(SIDE, SIDE, 4) uint8: what is seen from the centre as if object k were not there."""
    media = [each for each in tracer.media_at(centre) if each != k]
    strips = []
    for way in np.array_split(directions(SIDE), max(1, SIDE * SIDE // STRIP)):
        rays = _through(tracer, rays_from(np.tile(centre, (len(way), 1)), way), k)
        first = tracer.to_the_end(rays, media)[0]
        away = np.sqrt(((first.hits.point - centre) ** 2).sum(axis=1))
        away[first.hits.object == NOWHERE] = np.inf
        near = np.rint(255 * radius / (radius + away)).astype(np.uint8)
        strips.append(np.column_stack([eight_bit(first.colour), near]))
    return np.concatenate(strips).reshape(SIDE, SIDE, 4)


def _through(tracer: Tracer, rays: Rays, k: int) -> Rays:
    """The rays, started anew behind every surface of object k that is in their way."""
    going = np.arange(len(rays.origin))
    rays = Rays(*(column.copy() for column in rays))
    while len(going):
        hits = tracer.compiled.hits(rays.take(going))
        own = np.flatnonzero(hits.object == k)
        going, hits = going[own], hits.take(own)
        rays.origin[going], rays.leaving[going] = hits.point, k
        rays.inner[going], rays.triangle[going] = ~hits.inside, hits.triangle
    return rays


def turns(material: Material, flat: bool = False) -> list[list[float]]:
    """The table of `surroundings_of` for a material, of a ball of it or of a flat body."""
    cosine = np.linspace(0, 1, ANGLES)
    cosine[0] = 1e-6  # along the surface nothing goes on
    sine = np.sqrt(1 - cosine**2)
    way = np.stack([sine, -cosine, np.zeros(ANGLES)], axis=1)
    normal = np.tile([0.0, 1.0, 0.0], (ANGLES, 1))
    ones = np.ones(ANGLES)
    mirrored = _turn(way, mirror_directions(way, normal, normal))
    if material.transmit <= CLEAR_FROM:
        return np.stack([mirrored, ones, 0 * ones, 0 * ones], axis=1).round(5).tolist()
    inside = ones * material.ior
    share, _, _ = glass_shares(
        way, normal, ones, inside, ones * material.reflect, ones * material.transmit,
        np.full(ANGLES, material.fresnel),
    )  # fmt: skip
    refracted = refracted_directions(way, normal, normal, ones, inside)
    bent = _turn(way, refracted)
    # On a ball a ray comes out at the angle at which it went in: it turns by the same once more.
    between = np.pi - 2 * np.arctan2(refracted[:, 0], -refracted[:, 1])
    if flat:  # both faces mirror, again and again: s + (1 - s)^2 s + ... = 2 s / (1 + s)
        bent, between, share = 0 * ones, 0 * ones, 2 * share / (1 + share)
    return np.stack([mirrored, share, 2 * bent, between], axis=1).round(5).tolist()


def _turn(before: np.ndarray, after: np.ndarray) -> np.ndarray:
    """(n,) angles in the plane of x and y from one direction to the other, towards +y."""
    across = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    return np.arctan2(across, (before * after).sum(axis=1))


def _data_uri(picture: np.ndarray) -> str:
    file = BytesIO()
    Image.fromarray(picture).save(file, "WEBP", quality=QUALITY, method=METHOD, exact=True)
    return "data:image/webp;base64," + base64.b64encode(file.getvalue()).decode("ascii")
