"""Glass meshes of several shells: of every ray of every tree, what it is in, against where it
lies among the cubes that the mesh is made of."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from raywalk.bench.cases import Case, none_of
from raywalk.bench.families import directions, unit_rows
from raywalk.bench.made_scenes import mesh_object, scene_of
from raywalk.bench.model_files import CORNERS, TRIANGLES
from raywalk.scene.model import Material
from raywalk.trace.wavefront import Tracer

GLASS = Material("glass", transmit=1.0, ior=1.5168, fresnel=True)
DEPTH = 8
MESHES = 12  # of each kind
RAYS_A_TREE = 12
# A place closer to a face than this share of a cube's size may be called in or out.
MARGIN = 1e-9

# Cubes as (size, place, +1 or -1 for a hollow).
Cube = tuple[float, np.ndarray, int]


def cases(count: int, seed: int) -> Iterator[Case]:
    """Cubes in one another, with hollows, across one another; rays at corners, edges, anywhere."""
    for name in ("nested", "hollow", "overlapping"):
        judged = wrong = 0
        rays = max(8, count // (3 * MESHES * RAYS_A_TREE))
        for k in range(MESHES):
            rng = np.random.default_rng([seed, k, len(name)])
            known, bad = wrong_media(arranged(name, rng), rays, rng)
            judged, wrong = judged + known, wrong + bad
        yield none_of(judged, wrong, seed, "shells of a mesh", name, "rays in the wrong medium")


def arranged(name: str, rng: np.random.Generator) -> list[Cube]:
    """Two to four cubes, none with a face in the plane of another's."""
    if name == "overlapping":
        count = int(rng.integers(2, 5))
        return [(rng.uniform(0.6, 1.2), rng.uniform(-0.4, 0.4, 3), 1) for _ in range(count)]
    cubes, size, place = [], 1.0, np.zeros(3)
    for k in range(int(rng.integers(2, 5))):
        hollow = name == "hollow" and k % 2 == 1
        cubes.append((size, place, -1 if hollow else 1))
        inner = size * rng.uniform(0.5, 0.85)
        place = place + rng.uniform(-0.4, 0.4, 3) * (size - inner)
        size = inner
    return cubes


def wrong_media(cubes: list[Cube], rays: int, rng: np.random.Generator) -> tuple[int, int]:
    """Rays judged, and those of them that are held to be in glass and are not, or the reverse."""
    faces = np.array(TRIANGLES)
    corners = np.concatenate(
        [
            size * np.array(CORNERS)[faces if sense > 0 else faces[:, ::-1]] + place
            for size, place, sense in cubes
        ]
    )
    with tempfile.TemporaryDirectory() as folder:
        mesh = mesh_object(Path(folder) / "shells.ply", corners)
        tracer = Tracer(scene_of([mesh], materials=(GLASS,), depth=DEPTH))
    origin = 3.0 * directions(rng, rays)
    marks = corners[rng.integers(len(corners), size=rays), rng.integers(3, size=rays)]
    other = corners[rng.integers(len(corners), size=rays), rng.integers(3, size=rays)]
    share = np.where(rng.random(rays) < 0.3, 0.0, rng.random(rays))[:, None]
    target = marks + share * (other - marks)
    known = wrong = 0
    for wave in tracer.follow(origin, unit_rows(target - origin)):
        reach = np.where(np.isfinite(wave.hits.t), wave.hits.t, 1.0)
        middle = wave.rays.origin + 0.5 * reach[:, None] * wave.rays.direction
        inside, certain = truth(cubes, middle)
        known += int(certain.sum())
        wrong += int((certain & ((wave.media[:, 0] >= 0) != inside)).sum())
    return known, wrong


def truth(cubes: list[Cube], points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(n,) bool each: in glass, and clear of every face."""
    turns, certain = np.zeros(len(points)), np.full(len(points), True)
    for size, place, sense in cubes:
        height = np.abs(points - place).max(axis=1) - size / 2
        turns += np.where(height < 0, sense, 0)
        certain &= np.abs(height) > MARGIN
    return turns > 0, certain
