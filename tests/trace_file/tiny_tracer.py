"""A few lines of ray tracer that make ray trees to test the codec with.

Spheres, unrotated ellipsoids and planes; mirrors, glass, shadows, a checker.
It is not the project's tracer and judges no picture: it only has to give trees
that keep the invariants of `RayTree` and are as smooth as real ones.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from raywalk.scene.model import Camera, Light, Material, Render, Scene, SceneObject
from raywalk.scene.shapes import Ellipsoid, Plane, Sphere, Triple
from raywalk.trace.kinds import BRANCH_OF, BRANCHES
from raywalk.trace.tree import Kind, RayTree, Visibility, dense
from raywalk.trace_file.level import rows_of

EPSILON = 1e-9  # keeps a ray from meeting the surface it leaves
LEAVING = 12.0  # length of the drawn line of a ray that leaves, world units
DARK = np.zeros(3)


def make_scene(
    objects: list[tuple[object, int]],
    materials: list[Material],
    lights: list[Light],
    depth: int = 8,
    shadows: bool = True,
    background: Triple = (0.0, 0.0, 0.0),
    size: int = 105,
    eye: Triple = (0.0, 0.0, 5.0),
) -> Scene:
    """A scene from (shape, material index) pairs, seen from `eye` along -z."""
    named = tuple(
        SceneObject(f"object {k}", shape, material)  # type: ignore[arg-type]
        for k, (shape, material) in enumerate(objects)
    )
    return Scene(
        id="90-test",
        path=Path("scene.toml"),
        key="",
        title="Test",
        teaches="",
        camera=Camera(eye=eye, target=(eye[0], eye[1], 0.0)),
        render=Render(shadows=shadows, depth=depth, size=size),
        background=background,
        materials=tuple(materials),
        objects=named,
        lights=tuple(lights),
        lesson=(),
    )


@dataclass
class Rays:
    """One group on its way: rows of the tree not yet traced."""

    pixel: np.ndarray
    parent: np.ndarray
    kind: np.ndarray
    origin: np.ndarray
    direction: np.ndarray
    weight: np.ndarray
    inside: np.ndarray  # travels inside glass


def camera_rays(scene: Scene) -> Rays:
    """One ray through the middle of each pixel, raster order."""
    n = scene.render.size
    half = np.tan(np.radians(scene.camera.fov) / 2)
    row, column = np.divmod(np.arange(n * n), n)
    x = (2 * (column + 0.5) / n - 1) * half
    y = -(2 * (row + 0.5) / n - 1) * half
    direction = unit(np.stack([x, y, -np.ones(n * n)], axis=1))
    origin = np.tile(np.array(scene.camera.eye), (n * n, 1))
    return Rays(
        np.arange(n * n, dtype=np.int32),
        np.full(n * n, -1, np.int32),
        np.full(n * n, Kind.CAMERA, np.uint8),
        origin,
        direction,
        np.ones(n * n),
        np.zeros(n * n, bool),
    )


def unit(v: np.ndarray) -> np.ndarray:
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def dot(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.asarray((a * b).sum(axis=-1))


def crossings(shape: object, o: np.ndarray, d: np.ndarray) -> np.ndarray:
    """(rays, 2) distances to one shape, ascending; inf where there is none."""
    if isinstance(shape, Plane):
        normal = unit(np.array(shape.normal, float))
        with np.errstate(divide="ignore", invalid="ignore"):
            t = dot(np.array(shape.point) - o, normal) / dot(d, normal)
        t = np.where(t > EPSILON, t, np.inf)
        return np.stack([t, np.full_like(t, np.inf)], axis=1)
    center, radii = ball(shape)
    oc, dc = (o - center) / radii, d / radii
    a, b, c = dot(dc, dc), dot(oc, dc), dot(oc, oc) - 1
    root = np.sqrt(np.where(b * b - a * c > 0, b * b - a * c, np.nan))
    t = np.stack([(-b - root) / a, (-b + root) / a], axis=1)
    return np.sort(np.where(t > 1e-7, t, np.inf), axis=1)


def ball(shape: object) -> tuple[np.ndarray, np.ndarray]:
    if isinstance(shape, Sphere):
        return np.array(shape.center), np.full(3, shape.radius)
    assert isinstance(shape, Ellipsoid)
    return np.array(shape.center), np.array(shape.radii)


def outward(shape: object, point: np.ndarray) -> np.ndarray:
    if isinstance(shape, Plane):
        return np.tile(unit(np.array(shape.normal, float)), (len(point), 1))
    center, radii = ball(shape)
    return unit((point - center) / radii**2)


def all_crossings(scene: Scene, o: np.ndarray, d: np.ndarray) -> np.ndarray:
    """(objects, rays, 2)"""
    return np.stack([crossings(thing.shape, o, d) for thing in scene.objects])


def trace_tiny(scene: Scene) -> tuple[RayTree, np.ndarray]:
    """The scene's ray tree and its 8-bit picture (size, size, 3)."""
    rays = camera_rays(scene)
    hits = hits_along(all_crossings(scene, rays.origin, rays.direction))
    groups: list[dict[str, np.ndarray]] = []
    first = 0
    for depth in range(scene.render.depth + 1):
        group = trace_group(scene, rays, depth)
        groups.append(group)
        rays = spawn(scene, rays, group, first)
        first += len(group["pixel"])
        if depth == scene.render.depth or not len(rays.pixel):
            break
    columns = {key: np.concatenate([g[key] for g in groups]) for key in groups[0]}
    gather_colours(scene, columns)
    tree = RayTree(size=scene.render.size, **columns, **hits)
    picture = np.floor(np.clip(tree.colour[: tree.cameras], 0, 1) * 255 + 0.5)
    n = scene.render.size
    return tree, picture.astype(np.uint8).reshape(n, n, 3)


def hits_along(t: np.ndarray) -> dict[str, np.ndarray]:
    """Every crossing of the camera rays, nearest first."""
    k, m, _ = t.shape
    flat = t.transpose(1, 0, 2).reshape(m, 2 * k)
    order = np.argsort(flat, axis=1, kind="stable")
    flat = np.take_along_axis(flat, order, axis=1)
    met = np.isfinite(flat)
    start = np.concatenate([[0], np.cumsum(met.sum(axis=1))]).astype(np.int32)
    return {
        "hits_start": start,
        "hits_t": flat[met],
        "hits_object": (order // 2)[met].astype(np.int32),
    }


def trace_group(scene: Scene, rays: Rays, depth: int) -> dict[str, np.ndarray]:
    m = len(rays.pixel)
    t = all_crossings(scene, rays.origin, rays.direction)[:, :, 0]
    nearest, far = t.argmin(axis=0), t.min(axis=0)
    hit = np.isfinite(far)
    thing = np.where(hit, nearest, -1).astype(np.int32)
    point = rays.origin + np.where(hit, far, LEAVING)[:, None] * rays.direction
    normal = np.zeros((m, 3))
    for k, item in enumerate(scene.objects):
        normal[thing == k] = outward(item.shape, point[thing == k])
    inside = hit & (dot(normal, rays.direction) > 0)
    normal = np.where(inside[:, None], -normal, normal)
    material = np.where(hit, material_at(scene, thing, point), -1).astype(np.int32)
    of = per_material(scene, material, lambda s: 1 - s.reflect - s.transmit)
    columns = {
        "pixel": rays.pixel, "parent": rays.parent, "kind": rays.kind,
        "depth": np.full(m, depth, np.uint8), "object": thing, "material": material,
        "inside": inside, "t": far, "point": point, "normal": normal,
        "weight": rays.weight, "local_weight": np.where(hit, of, 0.0),
        "tests": np.full(m, len(scene.objects), np.int32),
    }  # fmt: skip
    columns.update(light_columns(scene, rays, columns))
    return columns


def material_at(scene: Scene, thing: np.ndarray, point: np.ndarray) -> np.ndarray:
    own = np.array([item.material for item in scene.objects])[thing]
    for k, item in enumerate(scene.objects):
        if item.checker:
            cells = np.floor(point[:, [0, 2]] / item.checker.size).sum(axis=1)
            own = np.where((thing == k) & (cells % 2 == 1), item.checker.material, own)
    return own


def per_material(
    scene: Scene, material: np.ndarray, of: Callable[[Material], object]
) -> np.ndarray:
    return np.array([of(s) for s in scene.materials], float)[material]


def light_columns(
    scene: Scene, rays: Rays, columns: dict[str, np.ndarray]
) -> dict[str, np.ndarray]:
    m, count = len(rays.pixel), len(scene.lights)
    hit, point, normal = columns["object"] >= 0, columns["point"], columns["normal"]
    out = {
        "visibility": np.full((m, count), Visibility.BEHIND, np.uint8),
        "passed": np.ones((m, count)),
        "blocker": np.full((m, count), -1, np.int32),
        "blocked_at": np.ones((m, count)),
        "diffuse": np.zeros((m, count)),
        "specular": np.zeros((m, count)),
    }
    shine = per_material(scene, columns["material"], lambda s: s.shininess)
    local = per_material(scene, columns["material"], lambda s: s.ambient)
    for k, light in enumerate(scene.lights):
        way = np.array(light.position) - point
        distance = np.linalg.norm(way, axis=1)
        towards = way / distance[:, None]
        facing = dot(normal, towards)
        lit = hit & (facing > 0)
        half = unit(towards - rays.direction)
        out["diffuse"][:, k] = np.where(lit, light.intensity * facing, 0)
        glance = np.maximum(dot(normal, half), 0)
        out["specular"][:, k] = np.where(lit, light.intensity * glance**shine, 0)
        seen = np.where(lit, Visibility.UNTESTED, Visibility.BEHIND)
        if scene.render.shadows:
            t = all_crossings(scene, point + 1e-7 * normal, towards)[:, :, 0]
            stop, at = t.argmin(axis=0), t.min(axis=0) / distance
            blocked = lit & (at < 1)
            seen = np.where(lit, np.where(blocked, Visibility.BLOCKED, Visibility.REACHED), seen)
            out["blocker"][:, k] = np.where(blocked, stop, -1)
            out["blocked_at"][:, k] = np.where(blocked, at, 1)
        out["visibility"][:, k] = seen
        kd = per_material(scene, columns["material"], lambda s: s.diffuse)
        ks = per_material(scene, columns["material"], lambda s: s.specular)
        shown = np.isin(seen, (Visibility.REACHED, Visibility.UNTESTED))[:, None]
        terms = out["diffuse"][:, k, None] * kd + out["specular"][:, k, None] * ks
        local = local + shown * terms * np.array(light.colour)
    out["local"] = np.where(hit[:, None], local, 0)
    out["colour"] = np.where(
        hit[:, None], columns["local_weight"][:, None] * local, np.array(scene.background)
    )
    return out


def spawn(scene: Scene, rays: Rays, group: dict[str, np.ndarray], first: int) -> Rays:
    """The reflected children of a group, then its refracted ones."""
    material, normal = group["material"], group["normal"]
    hit = group["object"] >= 0
    kr = np.where(hit, per_material(scene, material, lambda s: s.reflect), 0)
    kt = np.where(hit, per_material(scene, material, lambda s: s.transmit), 0)
    ior = per_material(scene, material, lambda s: s.ior)
    eta = np.where(group["inside"], ior, 1 / ior)
    cos = -dot(rays.direction, normal)
    under = 1 - eta**2 * (1 - cos**2)
    total = (kt > 0) & (under < 0)
    ahead = np.sqrt(np.maximum(under, 0))
    mirrored = rays.direction + 2 * cos[:, None] * normal
    bent = eta[:, None] * rays.direction + (eta * cos - ahead)[:, None] * normal
    fresnel = per_material(scene, material, lambda s: s.fresnel) > 0
    split = (kr + kt) * reflectance(eta, cos, ahead)
    up = np.where(total, kr + kt, np.where(fresnel, split, kr))
    down = np.where(total, 0, kr + kt - up)
    kinds = np.where(total, Kind.TOTAL, Kind.REFLECTED)
    a = children(rays, group, first, mirrored, up, kinds)
    b = children(rays, group, first, bent, down, np.full(len(up), Kind.REFRACTED))
    return Rays(*(np.concatenate(pair) for pair in zip(a, b, strict=True)))


def reflectance(eta: np.ndarray, cos: np.ndarray, ahead: np.ndarray) -> np.ndarray:
    across = (eta * cos - ahead) / (eta * cos + ahead + 1e-30)
    along = (cos - eta * ahead) / (cos + eta * ahead + 1e-30)
    return np.asarray((across**2 + along**2) / 2)


def children(
    rays: Rays,
    group: dict[str, np.ndarray],
    first: int,
    direction: np.ndarray,
    weight: np.ndarray,
    kinds: np.ndarray,
) -> list[np.ndarray]:
    go = np.flatnonzero(weight > 0)
    return [
        rays.pixel[go],
        (first + go).astype(np.int32),
        kinds[go].astype(np.uint8),
        group["point"][go],
        direction[go],
        weight[go],
        rays.inside[go],
    ]


def gather_colours(scene: Scene, columns: dict[str, np.ndarray]) -> None:
    """Adds each ray's colour to its parent's, deepest first."""
    for depth in range(int(columns["depth"].max()), 0, -1):
        rows = np.flatnonzero(columns["depth"] == depth)
        share = columns["weight"][rows, None] * columns["colour"][rows]
        np.add.at(columns["colour"], columns["parent"][rows], share)


def in_file_order(tree: RayTree) -> RayTree:
    """Depth by depth, path by path (RR, RT, TR, TT ...), each in its parents' order."""
    rank = np.zeros(len(tree.pixel), np.int64)  # a ray's place within its depth
    path = np.zeros(len(tree.pixel), np.int64)
    ordered: list[np.ndarray] = []
    rows = np.flatnonzero(tree.parent < 0)
    while len(rows):
        if ordered:
            branch = BRANCH_OF[tree.kind[rows]]
            path[rows] = dense(BRANCHES * path[tree.parent[rows]] + branch)
        place = rank[tree.parent[rows]] if ordered else tree.pixel[rows]
        rows = rows[np.lexsort((place, path[rows]))]
        rank[rows] = np.arange(len(rows))
        ordered.append(rows)
        of_these = np.zeros(len(tree.pixel) + 1, bool)  # the last serves parent -1
        of_these[rows] = True
        rows = np.flatnonzero(of_these[tree.parent])
    return rows_of(tree, np.concatenate(ordered))
