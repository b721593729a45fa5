"""Shadow rays of meshes, lights on surfaces, and rays that leave what they just hit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from raywalk.bench.cases import Case, none_of, per_million
from raywalk.bench.embree32 import Embree32
from raywalk.bench.families import around, directions
from raywalk.bench.made_scenes import compiled_mesh, icosphere, placed, scene_of
from raywalk.bench.stress_place import CONVEX
from raywalk.geometry.compiled import CompiledScene, Hits, Rays, rays_from
from raywalk.geometry.roots import NOWHERE
from raywalk.scene.model import Light, Scene
from raywalk.scene.shapes import Plane, Sphere
from raywalk.trace.lighting import light_hits
from raywalk.trace.tables import compile_lights, compile_materials
from raywalk.trace.tree import SHOT, Visibility

# Scale and offset.
PLACES = {
    "as is": (1.0, 0.0),
    "x 1e-6": (1e-6, 0.0),
    "x 1e6": (1e6, 0.0),
    "moved by 1e7": (1.0, 1e7),
}
HEIGHTS = (1e-3, 1e-6, 1e-9, 1e-12)
OFFSET32 = 1e-4  # what a float32 tracer starts its shadow rays with


def cases(count: int, seed: int) -> Iterator[Case]:
    """Acne and leaks, lights close to surfaces, second hits."""
    for place, name in enumerate(PLACES):
        yield acne_and_leaks(name, count, seed + place)
    for place, height in enumerate(HEIGHTS):
        yield light_near_plane(height, count, seed + place)
        yield light_near_sphere(height, count, seed + place)
    yield light_on_far_side(count, seed)
    yield from leaving(count, seed)


def visibility(scene: Scene, compiled: CompiledScene, rays: Rays, hits: Hits) -> np.ndarray:
    """(n, lights), by the tracer's own stage."""
    lights, materials = compile_lights(scene), compile_materials(scene)
    return light_hits(scene, compiled, materials, lights, rays, hits).visibility


def seen_in(scene: Scene, rays: Rays) -> tuple[np.ndarray, Hits]:
    """The same where these rays meet a scene's surfaces, and their hits."""
    compiled = CompiledScene(scene)
    hits = compiled.hits(rays)
    return visibility(scene, compiled, rays, hits), hits


def acne_and_leaks(name: str, count: int, seed: int) -> Case:
    """A convex mesh: what faces the light is lit. A mesh round it: then nothing is."""
    scale, offset = PLACES[name]
    rng = np.random.default_rng(seed)
    inner, outer = icosphere(3), 3.0 * icosphere(2)
    middle = np.array([offset, -offset, offset])
    origin, direction = around(rng, count, distance=1.5, aim=0.95)
    rays = rays_from(origin * scale + middle, direction)
    position = middle + scale * np.array([4.0, 5.0, 3.0])
    light = Light("lamp", (position[0], position[1], position[2]))
    scene = scene_of([Sphere((0.0, 0.0, 0.0), 1.0)], [light])  # stands for the mesh: one material
    alone = compiled_mesh(inner, placed(scale, middle))
    closed = compiled_mesh(np.concatenate([inner, outer]), placed(scale, middle))
    hits = alone.hits(rays)
    seen = visibility(scene, alone, rays, hits)[:, 0]
    acne = int((seen == Visibility.BLOCKED).sum())
    leaks = int((visibility(scene, closed, rays, closed.hits(rays)) == Visibility.REACHED).sum())
    facing = np.isin(seen, SHOT)
    asked = int(facing.sum())
    wrong32 = acne_and_leaks32(inner, outer, scale, middle, hits.point[facing], position)
    return none_of(
        2 * asked, acne + leaks, seed, "mesh shadows", name, "acne and light leaks", wrong32,
        f"Embree, offset {OFFSET32:g}", note=f"{acne} points of acne, {leaks} of leaks",
    )  # fmt: skip


def acne_and_leaks32(
    inner: np.ndarray, outer: np.ndarray, scale: float, middle: np.ndarray,
    point: np.ndarray, light: np.ndarray,
) -> int:  # fmt: skip
    """The same by float32 Embree in world coordinates."""
    away = light - point
    reach = np.linalg.norm(away, axis=1)
    toward = away / reach[:, None]
    start = point + OFFSET32 * toward
    alone = Embree32(inner * scale + middle)
    closed = Embree32(np.concatenate([inner, outer]) * scale + middle)
    acne = alone.occluded(start, toward, reach).sum()
    return int(acne + (~closed.occluded(start, toward, reach)).sum())


def light_near_plane(height: float, count: int, seed: int) -> Case:
    """A light this far above, and below, a floor seen from above: lit all over, or dark."""
    rng = np.random.default_rng(seed)
    origin = np.column_stack(
        [rng.uniform(-1, 1, count), np.full(count, 2.0), rng.uniform(-1, 1, count)]
    )
    direction = directions(rng, count)
    direction[:, 1] = -np.abs(direction[:, 1]) - 0.01
    rays = rays_from(origin, direction / np.linalg.norm(direction, axis=1, keepdims=True))
    lights = [Light("above", (0.1, -1.0 + height, 0.2)), Light("below", (0.1, -1.0 - height, 0.2))]
    scene = scene_of([Plane((0.0, -1.0, 0.0), (0.0, 1.0, 0.0))], lights)
    seen, _ = seen_in(scene, rays)
    wrong = (seen[:, 0] != Visibility.REACHED) | (seen[:, 1] == Visibility.REACHED)
    name = f"{height:g} above and below a plane"
    return none_of(count, wrong, seed, "light near a surface", name, "wrong points")


def light_near_sphere(height: float, count: int, seed: int) -> Case:
    """The same at a unit sphere: a point is lit where its tangent plane has the light in front."""
    rng = np.random.default_rng(seed)
    top = np.array([0.6, 0.8, 0.0])
    lights = [
        Light("above", (0.6 * (1 + height), 0.8 * (1 + height), 0.0)),
        Light("below", (0.6 * (1 - height), 0.8 * (1 - height), 0.0)),
    ]
    # Half of the points near the light: it lights a cap of about sqrt(2 height) only.
    near = rng.random(count) < 0.5
    spread = np.where(near, 4.0 * np.sqrt(height), 1.0)
    normal = top + spread[:, None] * rng.normal(size=(count, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    rays = rays_from(3.0 * normal, -normal)
    seen, hits = seen_in(scene_of([Sphere((0.0, 0.0, 0.0), 1.0)], lights), rays)
    above = np.array([light.position for light in lights]) @ hits.point.T - 1.0
    sure = np.abs(above) > 1e-15
    wrong = ((seen.T == Visibility.REACHED) != (above > 0)) & sure
    return none_of(
        sure, wrong, seed, "light near a surface", f"{height:g} above and below a sphere",
        "wrong points", note=f"{int((above[0] > 0).sum()):,} points see the upper light",
    )  # fmt: skip


def light_on_far_side(count: int, seed: int) -> Case:
    """A light exactly on a ball over a floor: the floor sees it if it is on the near side."""
    rng = np.random.default_rng(seed)
    x, z = rng.uniform(-3, 3, (2, count))
    origin = np.column_stack([x, np.full(count, -0.5), z])
    rays = rays_from(origin, np.tile([0.0, -1.0, 0.0], (count, 1)))
    lights = [Light("south pole", (0.0, 0.0, 0.0)), Light("north pole", (0.0, 2.0, 0.0))]
    ball, floor = Sphere((0.0, 1.0, 0.0), 1.0), Plane((0.0, -1.0, 0.0), (0.0, 1.0, 0.0))
    seen, _ = seen_in(scene_of([ball, floor], lights), rays)
    wrong = (seen[:, 0] != Visibility.REACHED) | (seen[:, 1] != Visibility.BLOCKED)
    name = "on the near and far pole of a ball"
    return none_of(count, wrong, seed, "light near a surface", name, "wrong points")


def leaving(count: int, seed: int) -> Iterator[Case]:
    """Outwards from a convex body no ray may meet it again, inwards every ray must.

    pbrt's test Reintersect (src/pbrt/shapes_test.cpp) for spheres and other quadrics.
    """
    share = max(count // (len(CONVEX) + 1), 1)
    bodies = {name: CompiledScene(scene_of([shape])) for name, shape in CONVEX.items()}
    bodies["mesh of 1,280"] = compiled_mesh(icosphere(3))
    for place, (name, compiled) in enumerate(bodies.items()):
        rng = np.random.default_rng([seed, place])
        hits = compiled.hits(rays_from(*around(rng, share, aim=0.6)))
        met = hits.object != NOWHERE
        away = directions(rng, share)
        side = (away * hits.geometric).sum(axis=1)
        inwards = side < 0
        rays = Rays(hits.point, away, hits.object, inwards, hits.triangle).take(met)
        again = compiled.nearest(rays)[1] != NOWHERE
        case = none_of(
            int(met.sum()), again != inwards[met], seed, "leaving a surface", name,
            "met again outwards, or not met inwards",
        )  # fmt: skip
        if place == len(CONVEX):
            unlifted = Embree32(icosphere(3)).proposed(hits.point[met], away[met]) >= 0
            wrong32 = per_million(int((unlifted != inwards[met]).sum()), case.rays)
            case = replace(case, float32=wrong32, float32_by="Embree without offset")
        yield case
