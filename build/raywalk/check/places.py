"""What is seen where in a scene's picture, so that a page can say where a student's is wrong."""

from __future__ import annotations

import numpy as np

from raywalk.check.atlas import GRID
from raywalk.geometry.roots import NOWHERE
from raywalk.scene.model import Scene
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.tree import LIT as SEEN_BY
from raywalk.trace.tree import Kind, Visibility
from raywalk.trace.wave import Wave
from raywalk.trace.wavefront import STRIP, Tracer

#: Bits of a pixel's second number: what is met first is dark to a lamp that it faces, or lit by
#: one; shows in a mirror or glass something that counts; has a neighbour that meets something else.
IN_SHADOW, LIT, MIRROR, GLASS, EDGE = 1, 2, 4, 8, 16
#: Of a pixel's colour: where mirrors or glass bring less, they do not decide whether it is right.
SHARE = 0.1
MOST_OBJECTS = 254


def places(scene: Scene) -> np.ndarray:
    """(GRID, GRID, 3) uint8: the number of the object met first, from 1 on, MOST_OBJECTS for that
    and all later ones, 0 for none; its bits; 0."""
    tracer = Tracer(scene, least_share=LEAST_SHARE)
    count = GRID * GRID
    strips = [np.arange(first, min(first + STRIP, count)) for first in range(0, count, STRIP)]
    parts = [_of_strip(tracer, strip) for strip in strips]
    met, bits = (np.concatenate(each).reshape(GRID, GRID) for each in zip(*parts, strict=True))
    bits[_edges(met)] |= EDGE
    shown = np.minimum(met + 1, MOST_OBJECTS).astype(np.uint8)
    return np.stack([shown, bits, np.zeros_like(shown)], axis=-1)


def _of_strip(tracer: Tracer, pixels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(p,) objects, and bits without edges."""
    waves = tracer.each_wave(tracer.camera_rays(pixels, GRID, GRID), tracer.eye_media)
    first = next(waves)
    met, bits = np.array(first.hits.object), _light(first)
    if second := next(waves, None):
        for bit, kinds in ((MIRROR, [Kind.REFLECTED]), (GLASS, [Kind.REFRACTED, Kind.TOTAL])):
            seen = np.isin(second.kind, kinds) & (second.weight >= SHARE)
            bits[second.parent[seen]] |= bit
    return met, bits


def _light(wave: Wave) -> np.ndarray:
    """Whether each hit has a lamp that it faces and does not see, and one that it sees."""
    visibility = wave.lighting.visibility
    is_hit = wave.hits.object != NOWHERE
    dark = is_hit & (visibility == Visibility.BLOCKED).any(axis=1)
    lit = is_hit & np.isin(visibility, SEEN_BY).any(axis=1)
    return (IN_SHADOW * dark + LIT * lit).astype(np.uint8)


def _edges(met: np.ndarray) -> np.ndarray:
    """(GRID, GRID) bool: where any of the eight neighbours meets another object."""
    wide = np.pad(met, 1, mode="edge")
    n = len(met)
    around = [wide[v : v + n, u : u + n] for v in range(3) for u in range(3)]
    return np.any([each != met for each in around], axis=0)
