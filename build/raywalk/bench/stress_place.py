"""Scale and offset: a scene a millionth as large, or ten thousand kilometres away."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from raywalk.bench.cases import Case, none_of, per_million
from raywalk.bench.convex import wrong_verdicts
from raywalk.bench.embree32 import Embree32, sphere_t
from raywalk.bench.families import around
from raywalk.bench.glass_bodies import SOLIDS
from raywalk.bench.made_scenes import CHALK, compiled_mesh, icosphere, nearest_t, placed, scene_of
from raywalk.bench.twofold import error_of, nearest_root, sphere_roots
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.scene.model import Light, SceneObject
from raywalk.scene.shapes import Sphere
from raywalk.trace.lighting import light_hits
from raywalk.trace.tables import compile_lights, compile_materials
from raywalk.trace.tree import Visibility

SCALES = (1e-6, 1e-3, 1.0, 1e3, 1e6)
OFFSETS = (1e4, 1e5, 1e6, 1e7)
# Where a ray meets the sphere flatter than this, a rounding of its input moves t by more.
NOT_GRAZING = 0.1
CONVEX = {kind: make()[0] for kind, make in SOLIDS.items()}


def cases(count: int, seed: int) -> Iterator[Case]:
    """Scales, then offsets."""
    for place, scale in enumerate(SCALES):
        yield scaled_sphere(scale, count, seed + place)
        yield false_shadows(scale, count, seed + place)
    for place, offset in enumerate(OFFSETS):
        yield moved_sphere(offset, count, seed + place)
        yield moved_mesh(offset, count, seed + place)


def scaled_sphere(scale: float, count: int, seed: int) -> Case:
    """Relative error of t on a sphere, all rays against 32 digits."""
    rng = np.random.default_rng(seed)
    origin, direction = around(rng, count)
    centre, radius = np.array([0.3, -0.2, 0.1]) * scale, 0.9 * scale
    origin = origin * scale
    t = nearest_t([Sphere((centre[0], centre[1], centre[2]), radius)], origin, direction)
    near, far, depth = sphere_roots(origin, direction, centre, radius)
    true = nearest_root(near, far)
    plain = (depth > NOT_GRAZING**2) & np.isfinite(t)
    single = sphere_t(origin, direction, centre, radius)
    both = plain & np.isfinite(single)
    relative = error_of(t, true)[plain] / true.hi[plain]
    relative32 = error_of(single, true)[both] / true.hi[both]
    return Case(
        "scene scale", f"x {scale:g}, sphere", "relative error of t, max",
        4e-15, float(relative.max()), count, seed, float(relative32.max()), "same formula",
    )  # fmt: skip


def false_shadows(scale: float, count: int, seed: int) -> Case:
    """Convex bodies alone with a light: whatever faces it is lit, so each shadow is false."""
    share, blocked, lit, blocked32, lit32 = count // (len(CONVEX) + 1), 0, 0, 0, 0
    light = Light("lamp", (4.0 * scale, 5.0 * scale, 3.0 * scale))
    solid = icosphere(3)
    for place in range(len(CONVEX) + 1):
        rng = np.random.default_rng([seed, place])
        origin, direction = around(rng, share, aim=0.6)
        if place < len(CONVEX):
            shape = SceneObject("body", list(CONVEX.values())[place], 0, placed(scale))
            scene = scene_of([shape], [light])
            compiled = CompiledScene(scene)
        else:
            scene = scene_of([CONVEX["sphere"]], [light])  # stands for the mesh: one material
            compiled = compiled_mesh(solid, placed(scale))
        rays = rays_from(origin * scale, direction)
        hits = compiled.hits(rays)
        lights, materials = compile_lights(scene), compile_materials(scene)
        seen = light_hits(scene, compiled, materials, lights, rays, hits).visibility[:, 0]
        blocked += int((seen == Visibility.BLOCKED).sum())
        lit += int((seen == Visibility.REACHED).sum())
        if place == len(CONVEX):
            blocked32, lit32 = shadows32(solid * scale, hits.point, seen, light)
    name = f"x {scale:g}, {len(CONVEX) + 1} convex bodies"
    case = none_of(blocked + lit, blocked, seed, "scene scale", name, "false shadows")
    wrong32 = per_million(blocked32, blocked32 + lit32)
    return replace(case, float32=wrong32, float32_by="Embree, fixed offset 1e-4, mesh")


def shadows32(
    corners: np.ndarray, point: np.ndarray, seen: np.ndarray, light: Light
) -> tuple[int, int]:
    """Blocked and lit points of the mesh by float32 Embree, from 1e-4 before each point."""
    facing = (seen == Visibility.REACHED) | (seen == Visibility.BLOCKED)
    away = np.array(light.position) - point[facing]
    reach = np.linalg.norm(away, axis=1)
    toward = away / reach[:, None]
    blocked = Embree32(corners).occluded(point[facing] + 1e-4 * toward, toward, reach - 1e-4)
    return int(blocked.sum()), int((~blocked).sum())


def moved_sphere(offset: float, count: int, seed: int) -> Case:
    """Hit or miss of a unit sphere far from the origin, all rays against 32 digits."""
    rng = np.random.default_rng(seed)
    centre = np.array([offset, -offset, offset])
    origin, direction = around(rng, count)
    origin = origin + centre  # rounded here; the truth is that of the rounded rays
    t = nearest_t([Sphere((offset, -offset, offset), 1.0)], origin, direction)
    _, _, depth = sphere_roots(origin, direction, centre, 1.0)
    wrong = (np.isfinite(t) != (depth >= 0)) & (np.abs(depth) > 4e-15)
    wrong32 = np.isfinite(sphere_t(origin, direction, centre, 1.0)) != (depth >= 0)
    return none_of(
        count, wrong, seed, "scene offset", f"moved by {offset:g}, sphere", "wrong hit or miss",
        wrong32, "same formula",
    )  # fmt: skip


def moved_mesh(offset: float, count: int, seed: int) -> Case:
    """Hit or miss of a convex mesh far from the origin, all rays against clipping."""
    rng = np.random.default_rng(seed)
    solid = icosphere(2)
    middle = np.array([offset, -offset, offset])
    origin, direction = around(rng, count)
    origin = origin + middle
    compiled = compiled_mesh(solid, placed(1.0, middle))
    hit = np.isfinite(compiled.nearest(rays_from(origin, direction))[0])
    local = origin - compiled.meshes[0].centre  # exact: neighbours of one size
    solid = compiled.meshes[0].corners
    hit32 = np.isfinite(Embree32(solid + middle).nearest(origin, direction)[0])
    wrong, wrong32 = (wrong_verdicts(solid, local, direction, each) for each in (hit, hit32))
    return none_of(
        count, wrong, seed, "scene offset", f"moved by {offset:g}, mesh of 320",
        "wrong hit or miss", wrong32, "Embree",
    )  # fmt: skip


assert CHALK.diffuse != (0.0, 0.0, 0.0)  # a black body would ask no light, and nothing be tested
