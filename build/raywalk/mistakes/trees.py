"""What was traced as a RayTree, the pipeline's own columns: wrong rays are written, read and
replayed like right ones."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from raywalk.mistakes.camera import picture_span
from raywalk.mistakes.colour import to_bytes
from raywalk.mistakes.habits import EXACT, Habits
from raywalk.mistakes.nearest import all_hits
from raywalk.mistakes.rays import NOTHING, Rays
from raywalk.mistakes.table import Mistakes
from raywalk.mistakes.tracer import Wave, trace
from raywalk.mistakes.vectors import column, dot, length, unit
from raywalk.mistakes.world import World
from raywalk.scene.model import Camera, Scene
from raywalk.trace.kinds import BRANCH_OF, BRANCHES
from raywalk.trace.tree import RayTree, dense

BEYOND = 1.25  # times the radius of the scene's sphere: where the line of a ray that leaves ends


@dataclass(frozen=True, eq=False)
class Walk:
    """All that a program did for an n x n picture."""

    scene: Scene  # as the program takes it: its materials and lights are those of the tree
    tree: RayTree  # of the n * n pixels of a picture of size n
    picture: np.ndarray  # (n, n, 3) uint8
    frame: dict[str, Any]  # what spans the picture, as trace files say it


def walk(
    scene: Scene, n: int, mistakes: Mistakes = frozenset(), habits: Habits = EXACT,
    least_share: float = 0.0,
) -> Walk:  # fmt: skip
    """Raises SourceErrors and ValueError as tracer.picture does."""
    world, waves = trace(scene, n, np.arange(n * n), mistakes, habits, least_share)
    tree = tree_of(world, waves, n, mistakes, habits)
    linear = waves[0].colour.T.reshape(n, n, 3)
    frame = frame_of(world.scene.camera, n, mistakes)
    return Walk(world.scene, tree, to_bytes(linear, mistakes, habits), frame)


def frame_of(camera: Camera, n: int, mistakes: Mistakes) -> dict[str, Any]:
    """Eye and view as the scene gives them, and the vectors that the program spans the picture
    with."""
    span = picture_span(camera, n, mistakes)
    given = {key: getattr(camera, key) for key in ("eye", "target", "up", "fov")}
    named = {key: (vector + 0.0).tolist() for key, vector in span._asdict().items()}
    return {key: list(v) if isinstance(v, tuple) else v for key, v in given.items()} | named


def tree_of(world: World, waves: list[Wave], n: int, mistakes: Mistakes, habits: Habits) -> RayTree:
    """One tree of all waves: depth by depth, path by path, as RayTree says."""
    levels, path, place = [], np.zeros(0, np.int64), np.zeros(0, np.int64)
    start, pixel = 0, np.arange(len(waves[0].sent.parent))
    for depth, wave in enumerate(waves):
        columns, parent = columns_of(world, wave, depth), wave.sent.parent
        if depth:
            path = dense(BRANCHES * path[parent] + BRANCH_OF[wave.sent.kind])
            order = np.lexsort([place[parent], path])
            pixel = pixel[parent]
            columns["parent"] = (place[parent] + start).astype(np.int32)
            start += len(place)
        else:
            path, order = np.zeros(len(parent), np.int64), np.arange(len(parent))
        columns["pixel"] = pixel.astype(np.int32)
        place = np.empty(len(order), np.int64)
        place[order] = np.arange(len(order))
        levels.append({key: values[order] for key, values in columns.items()})
    with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
        along = hits_along(world, waves[0], mistakes, habits)
    whole = {key: np.concatenate([level[key] for level in levels]) for key in levels[0]}
    return RayTree(size=n, **whole, **along)


def columns_of(world: World, wave: Wave, depth: int) -> dict[str, np.ndarray]:
    """One wave as columns of RayTree, in float64; parents are those of wave 0."""
    sent, hits, lighting, count = wave.sent, wave.hits, wave.lighting, len(wave.hits.t)
    gone = hits.object == NOTHING
    point = np.where(gone, ends_of_lines(world, sent.rays), hits.point)
    normal = np.where(gone, 0, unit(np.where(gone, 1, hits.normal)))
    columns = {
        "parent": sent.parent.astype(np.int32),
        "kind": sent.kind.astype(np.uint8),
        "depth": np.full(count, depth, np.uint8),
        "object": hits.object.astype(np.int32),
        "material": hits.material.astype(np.int32),
        "inside": hits.inside,
        "t": (hits.t * length(sent.rays.direction)).astype(float),
        "weight": sent.weight.astype(float),
        "local_weight": lighting.local_weight.astype(float),
        "tests": np.full(count, len(world.bodies), np.int32),
        "visibility": lighting.visibility.T,
        "blocker": lighting.blocker.T.astype(np.int32),
    }
    for name in ("blocked_at", "passed", "diffuse", "specular", "local"):
        columns[name] = getattr(lighting, name).T.astype(float)
    for name, vectors in (("point", point), ("normal", normal), ("colour", wave.colour)):
        columns[name] = vectors.T.astype(float)
    if any(obj.base for obj in world.scene.objects):
        columns["base"] = np.repeat(lighting.base[:, None], 3, axis=1).astype(float)
    return columns


def ends_of_lines(world: World, rays: Rays) -> np.ndarray:
    """(3, n) where rays cross a sphere round everything finite, for those that leave the scene; one
    that starts beyond it is drawn by its radius."""
    centre, radius = finite_sphere(world)
    d = unit(rays.direction)
    offset = rays.origin - centre
    along = dot(offset, d)
    reach = (BEYOND * radius) ** 2 - dot(offset, offset) + along**2
    far = np.where(reach > 0, np.sqrt(np.maximum(reach, 0)) - along, radius)
    return np.asarray(rays.origin + np.where(far > 0, far, radius) * d)


def finite_sphere(world: World) -> tuple[np.ndarray, float]:
    """Centre (3, 1) and radius of a sphere round objects (not planes), lights, eye and target."""
    camera = world.scene.camera
    given = [camera.eye, camera.target, *(light.position for light in world.scene.lights)]
    points = [np.array(given, float)]
    for body in world.bodies:
        if body.kind != "plane":
            centre, half = body.centre[:, 0], np.abs(body.to_world).sum(axis=1)
            points += [np.array([centre - half, centre + half])]
    every = np.concatenate(points)
    low, high = every.min(axis=0), every.max(axis=0)
    return column((low + high) / 2), float(np.linalg.norm(high - low) / 2)


def hits_along(
    world: World, wave: Wave, mistakes: Mistakes, habits: Habits
) -> dict[str, np.ndarray]:
    """All hits along the camera rays, nearest first. With a mistake in choosing one: that which was
    chosen, and what lies beyond it."""
    rays, hits = wave.sent.rays, wave.hits
    ray, t, who = all_hits(world, rays, mistakes, habits)
    # The chosen one first, even where another ties with it; what another program passed over goes.
    is_chosen = (t == hits.t[ray]) & (who == hits.object[ray])
    kept = is_chosen | (t >= hits.t[ray])
    ray, t, who, is_chosen = ray[kept], t[kept], who[kept], is_chosen[kept]
    order = np.lexsort([~is_chosen, t, ray])
    ray, t, who = ray[order], t[order], who[order]
    counts = np.bincount(ray, minlength=len(hits.t))
    return {
        "hits_start": np.concatenate([[0], np.cumsum(counts)]).astype(np.int32),
        "hits_t": (t * length(rays.direction)[ray]).astype(float),
        "hits_object": who.astype(np.int32),
    }
