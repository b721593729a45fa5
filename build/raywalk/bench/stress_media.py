"""Which glass a ray is in: of every ray of every tree, against where the ray lies."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from itertools import product
from pathlib import Path

import numpy as np

from raywalk.bench.cases import Case, none_of
from raywalk.bench.glass_bodies import Body
from raywalk.bench.glass_pairs import PLACES, aimed, all_pairs, placed_somewhere, scene_with
from raywalk.geometry.roots import NOWHERE
from raywalk.trace.wave import Wave
from raywalk.trace.wavefront import Tracer

DEPTH = 6
# A place closer to a body's surface than this share of the scene's size, or of its distance from
# the origin, may be called in or out: a hundred times what a hit point's error bound allows.
MARGIN = 1e-12
SHARES = (0.1, 0.5, 0.9)  # of a ray's way, where it is asked what it is in
THOROUGH = 500_000  # from so many rays on every pair stands in every place, in both orders
RAYS_A_TREE = 8  # at least, on average: so many fewer camera rays are sent


def cases(count: int, seed: int) -> Iterator[Case]:
    """One case for each way in which bodies touch, all pairs of kinds together."""
    with tempfile.TemporaryDirectory() as folder:
        pairs = list(all_pairs(Path(folder)))
        variants = list(product(PLACES, (False, True)))
        rounds = len(variants) if count >= THOROUGH else 1
        rays = max(4, count // (RAYS_A_TREE * rounds * len(pairs)))
        for way in dict.fromkeys(way for _, way, _ in pairs):
            totals = np.zeros(3, int)
            for n, (_, _, bodies) in enumerate(pairs):
                if pairs[n][1] != way:
                    continue
                for k in range(rounds):
                    place, swapped = variants[(n + k) % len(variants)]
                    rng = np.random.default_rng([seed, n, k])
                    totals += wrong_media(placed_somewhere(bodies, place, rng), swapped, rays, rng)
            judged, kept, lacking = (int(number) for number in totals)
            yield none_of(
                judged, kept + lacking, seed, "touching glass", way,
                "rays that keep a medium they left or lack one",
                note=f"{kept} kept one, {lacking} lacked one",
            )  # fmt: skip


def wrong_media(
    bodies: list[Body], swapped: bool, rays: int, rng: np.random.Generator
) -> tuple[int, int, int]:
    """Rays judged, those that keep a medium they have left, those that lack one they are in."""
    origin, direction = aimed(bodies, rng, rays)
    waves = Tracer(scene_with(bodies, swapped, origin[0]), DEPTH).follow(origin, direction)
    judged = kept = lacking = 0
    for wave in waves:
        known, held, within = against_truth(wave, bodies[::-1] if swapped else bodies)
        judged += int(known.any(axis=1).sum())
        kept += int((known & held & ~within).any(axis=1).sum())
        lacking += int((known & ~held & within).any(axis=1).sum())
    return judged, kept, lacking


def against_truth(wave: Wave, bodies: list[Body]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(n, bodies) bool each: is it certain where the ray lies; does the ray hold the body as a
    medium; does it lie in the body."""
    marks = np.concatenate([one.marks() for one in bodies])
    size = float(np.abs(marks).max() + np.ptp(marks, axis=0).max())
    t = np.where(wave.hits.object == NOWHERE, size, wave.hits.t)
    held = np.stack([(wave.media == k).any(axis=1) for k in range(len(bodies))], axis=1)
    known, within = np.zeros_like(held), np.zeros_like(held)
    for share in SHARES:
        place = wave.rays.origin + (share * t)[:, None] * wave.rays.direction
        depth = np.stack([one.depth(place) for one in bodies], axis=1)
        certain = np.abs(depth) > MARGIN * size
        # Once a place has differed from what is held, no other makes up for it.
        speaks = certain & (~known | (within == held))
        within[speaks] = (depth < 0)[speaks]
        known |= certain
    return known, held, within
