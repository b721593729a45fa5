"""Re-lighting: where only light changes, rays and what they hit stay, and are lit anew.

A light that moves, a colour or a background that changes leaves camera, reflected and refracted
rays as they are. Only shadow rays and colours are worked out again.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

import numpy as np

from raywalk.scene.model import Scene
from raywalk.trace.wave import Met

# Rays that are kept at most, about 170 bytes each: of a stop of any scene of the course. Of more,
# some strips are followed anew.
MOST = 1_000_000
BLACK = (0.0, 0.0, 0.0)


class KnownPaths:
    """What the rays of a picture's strips hit, for the next scene whose `unlit` is the same."""

    def __init__(self, most: int = MOST):
        self.relit = 0  # rays that were not followed again
        self._room = most
        self._strips: dict[tuple[int, int], list[Met]] = {}

    def through(self, pixels: np.ndarray, follow: Callable[[], Iterator[Met]]) -> Iterable[Met]:
        """Wave by wave, of pixels (n,) in their order; follow: finds it where it is not known."""
        strip = (int(pixels[0]), int(pixels[-1]))
        known = self._strips.get(strip)
        if known is None:
            return self._kept(strip, follow())
        self.relit += sum(len(each.shot.parent) for each in known)
        return known

    def _kept(self, strip: tuple[int, int], found: Iterator[Met]) -> Iterator[Met]:
        """What is found, as it comes; kept if there is room for the whole strip."""
        waves: list[Met] = []
        rays = 0
        for met in found:
            rays += len(met.shot.parent)
            if rays > self._room:
                waves.clear()
            else:
                waves.append(met)
            yield met
        if rays <= self._room:
            self._room -= rays
            self._strips[strip] = waves


def unlit(scene: Scene) -> Scene:
    """The scene without what no ray's way depends on: lights, colours and highlights."""
    bare = [
        replace(each, ambient=BLACK, diffuse=BLACK, specular=BLACK, shininess=1.0)
        for each in scene.materials
    ]
    return replace(scene, lights=(), background=BLACK, materials=tuple(bare))
