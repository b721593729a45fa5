"""Shadows as the viewer's stage draws them: by shadow maps, which have pixels.

From a lamp's place a graphics card draws six square pictures, one a side of a cube, and notes how
far the light gets at each of their pixels; a point is lit as far as the pixels round its direction
say. The stage draws with three.js, whose rules these are (release 187,
`shaders/ShaderChunk/shadowmap_pars_fragment.glsl.js`, its PCF filter); sizes, depths and biases are
handed on by the viewer (`ShadowMaps` in viewer/stops/rasterised.ts), so that figures on paper have
the stairs of the page. The maps' depths are those of the surfaces, not of triangles in their place.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from raywalk.geometry.compiled import CompiledScene, Hits, Rays, rays_from
from raywalk.geometry.roots import NOWHERE
from raywalk.optics.shade import local_colours
from raywalk.trace.lighting import NO_BASE
from raywalk.trace.wave import Wave
from raywalk.trace.wavefront import Tracer

TAPS = 5  # places on a disc round a direction at which the map is asked
GOLDEN_ANGLE = 2.399963229728653  # between two of them (Vogel's spiral)
RADIUS = 1.0  # of that disc: of a side's two units, over its pixels
FRONT, BACK, BOTH = 0, 1, 2  # faces, as viewer/state/shadow-map.ts numbers them


@dataclass(frozen=True)
class ShadowMaps:
    """How lamps cast shadows; lengths in world units."""

    pixels: int  # across each of a lamp's six sides
    near: float
    far: float
    bias: float  # of a depth, from 0 at `near` to 1 at `far`
    normal_bias: float  # points are asked so far above their surface
    lamps: tuple[int, ...]  # the lights that have a map
    apart: int  # of so many lights one has, and stands for them
    casts: tuple[int | None, ...]  # by object: which faces are drawn into maps, None: none

    @property
    def depth_terms(self) -> tuple[float, float]:
        """A depth is a + b / z, z along a side's axis."""
        span = self.far - self.near
        return self.far / span, -self.near * self.far / span


def shadowed_colours(
    tracer: Tracer, maps: ShadowMaps, wave: Wave, places: np.ndarray
) -> np.ndarray:
    """(n, 3) linear colours of a wave that was lit without shadows and sends nothing on, now with
    those of the maps. places: (n, 2) x and y of its pixels, from the view's lower left."""
    hits, lighting = wave.hits, wave.lighting
    share = np.zeros_like(lighting.diffuse)
    for lamp in maps.lamps:
        asked = np.flatnonzero((lighting.diffuse[:, lamp] > 0) | (lighting.specular[:, lamp] > 0))
        lit = lit_share(tracer, maps, lamp, hits.take(asked), places[asked])
        share[asked, lamp] = maps.apart * lit
    rows = np.flatnonzero(hits.object != NOWHERE)
    colour = wave.colour.copy()
    base = NO_BASE if lighting.base is None else lighting.base
    local_colours(
        tracer.materials, tracer.lights, rows, hits.material, base, share > 0,
        lighting.diffuse * share, lighting.specular * share, colour,
    )  # fmt: skip
    return colour


def lit_share(
    tracer: Tracer, maps: ShadowMaps, lamp: int, hits: Hits, places: np.ndarray
) -> np.ndarray:
    """(n,) how much of a lamp's light the map lets arrive at each hit, 0..1."""
    light = tracer.lights.position[lamp]
    # A surface that is seen from both sides keeps its normal; others turn it to who sees them.
    turned = hits.inside & (np.array(maps.casts, float)[hits.object] == BOTH)
    outwards = np.where(turned[:, None], -hits.normal, hits.normal)
    to_point = hits.point + maps.normal_bias * outwards - light
    along_axis = np.abs(to_point).max(axis=1)
    distance = np.sqrt((to_point**2).sum(axis=1))
    towards = to_point / distance[:, None]
    a, b = maps.depth_terms
    asked = _spread(towards, places, RADIUS / maps.pixels).reshape(-1, 3)
    depth = a + maps.bias + b / (np.tile(distance, TAPS) * np.abs(asked).max(axis=1))
    share = _filtered(tracer.compiled, maps, light, asked, depth).reshape(TAPS, -1).mean(axis=0)
    is_mapped = (along_axis >= maps.near) & (along_axis <= maps.far)
    return np.where(is_mapped, share, 1.0)


def _spread(towards: np.ndarray, places: np.ndarray, reach: float) -> np.ndarray:
    """(TAPS, n, 3) directions round each of these unit ones, on a disc that every pixel turns by
    another angle."""
    x_wins = np.abs(towards[:, :1]) > np.abs(towards[:, 2:])
    tangent = np.cross(towards, np.where(x_wins, [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]))
    tangent = tangent / np.sqrt((tangent**2).sum(axis=1))[:, None]
    other = np.cross(towards, tangent)
    # Interleaved gradient noise (Jimenez, Next Generation Post Processing, 2014).
    turn = 2 * math.pi * ((52.9829189 * ((places @ [0.06711056, 0.00583715]) % 1)) % 1)
    k = np.arange(TAPS)[:, None]
    angle, radius = turn + k * GOLDEN_ANGLE, reach * np.sqrt((k + 0.5) / TAPS)
    across, up = (radius * np.cos(angle))[..., None], (radius * np.sin(angle))[..., None]
    return np.asarray(towards + across * tangent + up * other)


def _filtered(
    compiled: CompiledScene, maps: ShadowMaps, light: np.ndarray, direction: np.ndarray,
    depth: np.ndarray,
) -> np.ndarray:  # fmt: skip
    """(n,) how many of the map's four pixels round each direction the light reaches as far as
    `depth` in, weighted by how near they are. Of a map only the pixels that are asked for are
    drawn: few ever are."""
    side, at = _on_cube(direction, maps.pixels)
    corner = np.floor(at - 0.5)
    weight = at - 0.5 - corner
    steps = np.array([(0, 0), (1, 0), (0, 1), (1, 1)])
    numbers = [_number(side, corner + step, maps.pixels) for step in steps]
    wanted, which = np.unique(np.stack(numbers), return_inverse=True)
    found = _drawn(compiled, maps, light, wanted)[which.reshape(len(steps), -1)]
    parts = np.where(steps[:, None] == 1, weight, 1 - weight).prod(axis=2)
    return np.asarray((parts * (depth <= found)).sum(axis=0))


def _on_cube(direction: np.ndarray, pixels: int) -> tuple[np.ndarray, np.ndarray]:
    """Of directions (n, 3) the cube's side (n,), 2 axis + (whether it is the negative one), and the
    place on it (n, 2), in pixels: along the axes after that one."""
    axis = np.abs(direction).argmax(axis=1)
    rows = np.arange(len(axis))
    along = direction[rows, axis]
    others = np.stack([direction[rows, (axis + 1) % 3], direction[rows, (axis + 2) % 3]], axis=1)
    return 2 * axis + (along < 0), (others / np.abs(along)[:, None] + 1) / 2 * pixels


def _number(side: np.ndarray, pixel: np.ndarray, pixels: int) -> np.ndarray:
    """(n,) the numbers of pixels (n, 2) of sides (n,), side by side. What lies over a side's edge
    is on its neighbour."""
    over = np.flatnonzero(((pixel < 0) | (pixel >= pixels)).any(axis=1))
    if len(over):
        beyond, at = _on_cube(_way(side[over], pixel[over], pixels), pixels)
        side, pixel = side.copy(), pixel.copy()
        side[over], pixel[over] = beyond, np.floor(at)
    return ((side * pixels + pixel[:, 0]) * pixels + pixel[:, 1]).astype(np.int64)


def _way(side: np.ndarray, pixel: np.ndarray, pixels: int) -> np.ndarray:
    """(n, 3) from the lamp through pixels' centres: 1 along their sides' axes."""
    way, rows = np.empty((len(side), 3)), np.arange(len(side))
    axis, at = side // 2, (pixel + 0.5) * 2 / pixels - 1
    way[rows, axis] = np.where(side % 2, -1.0, 1.0)
    way[rows, (axis + 1) % 3], way[rows, (axis + 2) % 3] = at[:, 0], at[:, 1]
    return way


def _drawn(
    compiled: CompiledScene, maps: ShadowMaps, light: np.ndarray, number: np.ndarray
) -> np.ndarray:
    """(n,) the map's depths at these of its pixels: that of the nearest face which casts a shadow;
    1 where the light meets none."""
    side, pixel = np.divmod(number, maps.pixels**2)
    way = _way(side, np.stack(np.divmod(pixel, maps.pixels), axis=1), maps.pixels)
    rays = rays_from(np.tile(light, (len(way), 1)), way / np.sqrt((way**2).sum(axis=1))[:, None])
    depth, going = np.ones(len(way)), np.arange(len(way))
    casts = np.array([np.nan if faces is None else faces for faces in maps.casts])
    a, b = maps.depth_terms
    while len(going):
        hits = compiled.hits(rays)
        met = hits.object != NOWHERE
        going, rays, hits = going[met], rays.take(met), hits.take(met)
        along_axis = np.abs(hits.point - light).max(axis=1)
        faces = casts[hits.object]
        drawn = (faces == BOTH) | (faces == np.where(hits.inside, BACK, FRONT))
        drawn &= (along_axis >= maps.near) & (along_axis <= maps.far)
        depth[going[drawn]] = a + b / along_axis[drawn]
        going, rays, hits = going[~drawn], rays.take(~drawn), hits.take(~drawn)
        rays = Rays(hits.point, rays.direction, hits.object, ~hits.inside, hits.triangle)
    return depth
