"""Right pictures at the sizes that students use."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from raywalk.scene.model import Scene
from raywalk.scene.resolutions import fits
from raywalk.trace.plan import LEAST_SHARE
from raywalk.trace.wavefront import Threads, Tracer, trace_colours

#: Sizes that programs are written for, none of which shares pixel centres with ours.
USUAL_SIZES = (100, 128, 200, 256, 400, 500, 512, 640, 800, 1000, 1024)
LEAST = 5  # pixels along
#: Each lamp is asked at each hit: scenes with more of them are about soft shadows, and have a right
#: picture of their own size only.
MOST_LAMPS = 8


def shared_sizes(scene: Scene) -> list[int]:
    """Sizes whose pixel centres are among those of the scene's picture, an odd number of its pixels
    to each of theirs; its own comes last."""
    size = scene.render.size
    return [n for n in range(LEAST, size + 1) if fits(n, size)]


def other_sizes(scene: Scene) -> list[int]:
    """Sizes that are traced anew."""
    return [n for n in USUAL_SIZES if n not in shared_sizes(scene)] if has_few_lamps(scene) else []


def has_few_lamps(scene: Scene) -> bool:
    """Few enough for more than its own picture."""
    return len(scene.lights) <= MOST_LAMPS


def right_picture(scene: Scene, n: int, threads: Threads = 1) -> np.ndarray:
    """(n, n, 3) uint8, as the site has it at the scene's own size."""
    sized = replace(scene, render=replace(scene.render, size=n, resolutions=()))
    return trace_colours(Tracer(sized, least_share=LEAST_SHARE), threads)[0]
