"""What a scene must have for a mistake to show: asked of the right rays of a small picture of it.

A feature is seen in a share of the pixels; what is seen in less than SEEN of them tells nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np

from raywalk.mistakes import sights
from raywalk.mistakes.bounces import bounced
from raywalk.mistakes.sights import STEP, Test
from raywalk.mistakes.table import BY_NAME, TABLE
from raywalk.mistakes.tracer import trace
from raywalk.mistakes.world import SOLIDS
from raywalk.scene.model import Scene

GRID = 55
SEEN = 0.005  # of the pixels, as a mistake must change to be told


class Right:
    """The right rays of a scene."""

    def __init__(self, scene: Scene):
        self.scene = scene
        pixels = np.arange(GRID * GRID)
        self.world, self.waves = trace(scene, GRID, pixels, least_share=STEP)

    def pixels_of(self, depth: int) -> np.ndarray:
        """(n,) the pixels that the rays of a depth belong to."""
        pixel = np.arange(GRID * GRID)
        for wave in self.waves[1 : depth + 1]:
            pixel = pixel[wave.sent.parent]
        return pixel

    def seen(self, test: Test) -> float:
        """Share of the pixels with a ray in their tree that passes."""
        found = np.zeros(GRID * GRID, bool)
        with np.errstate(divide="ignore", invalid="ignore"):
            for depth, wave in enumerate(self.waves):
                found[self.pixels_of(depth)[test(self.world, wave)]] = True
        return float(found.mean())

    @cached_property
    def features(self) -> frozenset[str]:
        """Those that the scene has."""
        return frozenset(name for name, share in FEATURES.items() if share(self) > SEEN)


def shown_in(scene: Scene) -> list[str]:
    """Names of the mistakes that show in a scene. Raises SourceErrors that name what the tracer
    leaves out."""
    right = Right(scene)
    return [mistake.name for mistake in TABLE if shows(mistake.name, right)]


def shows(name: str, right: Right) -> bool:
    """Whether one mistake does."""
    return set(BY_NAME[name].needs) <= right.features


def limit_reached(right: Right) -> float:
    """Share of the pixels in which the bounce limit cuts something off that would be seen."""
    last = right.waves[-1]
    if len(right.waves) - 1 < right.scene.render.depth:
        return 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        cut = bounced(right.world.optics, last.sent, last.hits, STEP, frozenset())
    pixel = right.pixels_of(len(right.waves) - 1)
    return len(np.unique(pixel[cut.parent])) / (GRID * GRID)


def last_bounce(right: Right) -> float:
    """Share of the pixels that show what the last bounce allowed brings."""
    if len(right.waves) - 1 < right.scene.render.depth or len(right.waves) == 1:
        return 0.0
    sent, colour = right.waves[-1].sent, right.waves[-1].colour
    bright = np.flatnonzero((sent.share * colour).max(axis=0) > STEP)
    return len(np.unique(right.pixels_of(len(right.waves) - 1)[bright])) / (GRID * GRID)


def overexposed(right: Right) -> float:
    """Share of the pixels whose colour is above 1."""
    return float((255 * right.waves[0].colour + 0.5 >= 256).any(axis=0).mean())


def whether(test: Callable[[Scene], bool]) -> Callable[[Right], float]:
    """Of what a scene says."""
    return lambda right: float(test(right.scene))


def seen(test: Test) -> Callable[[Right], float]:
    """Of what is seen in the picture."""
    return lambda right: right.seen(test)


FEATURES: dict[str, Callable[[Right], float]] = {
    "one thing behind another": seen(sights.is_before_another),
    "nearer things listed later": seen(sights.is_before_listed),
    "something behind the eye": seen(sights.is_before_something),
    "a sphere": seen(sights.on_kind("sphere")),
    "a solid": seen(sights.on_kind(*SOLIDS)),
    "a solid with a colour": seen(sights.is_lit_solid),
    "a body of its own scale": seen(sights.on_kind("ellipsoid", "box", "cylinder")),
    "a ball that is not one wide": seen(sights.is_long_normal),
    "a stretched ellipsoid": seen(sights.is_stretched),
    "several lamps": whether(lambda scene: len(scene.lights) > 1),
    "lamps other than 1": whether(lambda scene: any(l.intensity != 1 for l in scene.lights)),
    "light": seen(sights.is_lit),
    "ambient colour": seen(sights.has_ambient),
    "highlights": seen(sights.has_highlight),
    "shiny surfaces": seen(sights.is_shiny),
    "highlights turned away": seen(sights.has_highlight_turned_away),
    "faces turned away": seen(sights.is_turned_away),
    "colours": seen(sights.is_coloured),
    "colours above 1": overexposed,
    "no shadows": whether(lambda scene: not scene.render.shadows),
    "shadows": whether(lambda scene: scene.render.shadows),
    "cast shadows": seen(sights.is_in_shadow),
    "shadow of a second lamp": seen(sights.is_dark_to_a_second),
    "darkness": seen(sights.is_dark),
    "something beyond a lamp": seen(sights.asked_along(sights.from_hit)),
    "something behind what is lit": seen(sights.asked_along(sights.from_light)),
    "mirrors": seen(sights.is_mirror),
    "mirrors or glass": seen(lambda w, s: sights.is_mirror(w, s) | sights.is_glass(w, s)),
    "the last bounce": last_bounce,
    "the bounce limit": limit_reached,
    "glass": seen(sights.is_glass),
    "rays inside glass": seen(lambda w, s: sights.is_glass(w, s) & s.hits.inside),
    "total reflection": seen(sights.is_total),
    "fresnel": seen(sights.is_fresnel),
    "light through glass": seen(sights.is_lit_through_glass),
}
