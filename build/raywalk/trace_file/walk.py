"""The one pass through a trace file's columns.

Each step gives the coder a column's true numbers, in steps, to note, and makes of the whole ones
what a person sees; later columns are predicted from what is known by then. So the encoder sees
exactly what the viewer (viewer/trace/decode.ts), which reads in this order, will see, and states
its errors.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.trace.tree import SENT_ON, Kind, RayTree, Visibility
from raywalk.trace_file import rebuild
from raywalk.trace_file.groups import rows_of_each
from raywalk.trace_file.noting import ABSENT, Noting, Ray
from raywalk.trace_file.structure import Structure, grow, in_raster
from raywalk.trace_file.tables import drawn_hits


def walk(header: dict[str, Any], coder: Noting, true: RayTree, tile: np.ndarray) -> Ray:
    """All columns of types.ts's Trace by their names there, and level, history, surface.

    true: what is to be written; tile: (n * n, 3) 8-bit.
    """
    n, tables = header["n"], header["tables"]
    sides = in_raster(n)
    zeros = np.zeros(n * n, np.int64)
    chosen = coder.symbols("signature", 0, zeros, zeros, sides)
    first = np.array([hits[0] if hits else ABSENT for hits in tables["signature"]], np.int64)
    surfaces = np.array(tables["surface"], np.int64).reshape(-1, 4)
    patch_of = surfaces[:, 0]
    tree = grow(n, first[chosen], patch_of, coder.symbols)
    ray: Ray = {
        "kind": tree.kind, "parent": tree.parent, "pixel": tree.pixel, "level": tree.level,
        "surface": tree.surface, "history": tree.history, "children": tree.children,
        "depth": np.minimum(tree.level, 255), "patch": patch_of[tree.surface],
        "material": surfaces[tree.surface, 1], "inside": surfaces[tree.surface, 2],
        "sign": surfaces[tree.surface, 3],
        "object": np.array([p["object"] for p in header["patches"]])[patch_of[tree.surface]],
    }  # fmt: skip
    hits_along(header, coder, ray, chosen, sides, true)
    points(header, coder, ray, tree, true)
    normals(header, coder, ray, tree, true)
    tests(coder, ray, tree, true)
    bases(header, coder, ray, tree, true)
    tiles(header, coder, ray, sides, tile)
    weights(header, coder, ray, tree, true)
    lights(header, coder, ray, tree, true)
    ray["colour"] = rebuild.recombine(header, ray)
    return ray


def hits_along(
    header: dict[str, Any], coder: Noting, ray: Ray, chosen: np.ndarray, sides: np.ndarray,
    true: RayTree,
) -> None:  # fmt: skip
    """Every hit along each camera ray. One image a key (object, how often met before), of 1 / z.

    chosen: (n * n,) each ray's row in the table of signatures.
    """
    n, images, met = header["n"], header["images"], header["tables"]["signature"]
    step = rebuild.camera_steps(header["camera"], n)
    size = rebuild.length(step)
    row, column = np.divmod(np.arange(n * n), n)
    features = [column.astype(float), row.astype(float)]
    along = images_along(met, images)
    who, place, far = drawn_hits(true, header["camera"]["eye"])
    image_of = along[chosen[who], place]
    # At least one step: none would be a hit at no distance at all.
    steps = np.maximum(size[who] / far / np.array([i["step"] for i in images])[image_of], 1.0)
    # One image at a time: there are as many as objects in the picture, and more.
    z, zeros = np.ones(len(who)), np.zeros(n * n, np.int64)
    for k, ends in enumerate(rows_of_each(image_of, len(images))):
        depth, here = np.zeros(n * n), np.zeros(n * n, bool)
        depth[who[ends]], here[who[ends]] = steps[ends], True
        number = coder.numbers(f"depth{k}", depth, here, zeros, zeros, sides, features)
        z[ends] = 1 / (number[who[ends]] * images[k]["step"])
    nearest = np.ones(n * n)
    nearest[who[place == 0]] = z[place == 0]
    ray["cameraPoint"] = np.stack(
        [header["camera"]["eye"][k] + step[k] * nearest for k in range(3)], axis=1
    )
    ray["cameraT"] = nearest * size
    counts = np.array([len(hits) for hits in met], np.int64)[chosen]
    start = np.concatenate([[0], np.cumsum(counts)])
    met_by = slice(len(true.hits_t))  # before the ends of what leaves
    ray["hitsStart"], ray["hitsT"] = start, ascending(z[met_by] * size[who[met_by]], start)
    ray["hitsObject"] = np.array([i["object"] for i in images], np.int64)[image_of[met_by]]


def images_along(met: list[list[int]], images: list[dict[str, Any]]) -> np.ndarray:
    """(signatures, longest) the depth images of a ray's hits, then ABSENT."""
    place = {(image["object"], image["turn"]): k for k, image in enumerate(images)}
    keys = [keys_along(hits) for hits in met]
    along = np.full((len(keys), max((len(own) for own in keys), default=1)), ABSENT)
    for row, own in enumerate(keys):
        along[row, : len(own)] = [place[key] for key in own]
    return along


def keys_along(hits: list[int]) -> list[tuple[int, int]]:
    """(object, how often met before) of a ray's hits; one that leaves has a key of its own."""
    turns: dict[int, int] = {}
    keys = []
    for thing in hits or [ABSENT]:
        turns[thing] = turns.get(thing, -1) + 1
        keys.append((thing, turns[thing]))
    return keys


def ascending(t: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Hits closer together than the step may have changed places: no t before its forerunner."""
    out = t.copy()
    longest = int(np.diff(start).max(initial=0))
    for k in range(1, longest):
        rows = start[:-1][np.diff(start) > k] + k
        out[rows] = np.maximum(out[rows], out[rows - 1])
    return out


def points(
    header: dict[str, Any], coder: Noting, ray: Ray, tree: Structure, true: RayTree
) -> None:  # fmt: skip
    """Where rays end, and their lengths. Those of camera rays are known from depth images."""
    m, n = tree.count, header["n"]
    camera = np.arange(m) < n * n
    free = np.array([patch["points"] == "free" for patch in header["patches"]])[ray["patch"]]
    numbers = [
        coder.numbers(
            f"point{k}", at, ~camera & (free | (k < 2)), ray["history"], ray["patch"], tree.sides
        )
        for k, at in enumerate(coordinates(header, true, np.where(camera, ABSENT, ray["patch"])))
    ]
    point = np.zeros((m, 3))
    patch_of = np.where(camera, ABSENT, ray["patch"])
    patches = header["patches"]
    for patch, rows in zip(patches, rows_of_each(patch_of, len(patches)), strict=True):
        if not len(rows):
            continue
        at = rebuild.points_on(patch, [number[rows] for number in numbers])
        for c in range(3):
            point[rows, c] = at[c]
    point[: n * n] = ray.pop("cameraPoint")
    ray["point"] = point
    origin = point[ray["parent"]]
    t = rebuild.length([point[:, c] - origin[:, c] for c in range(3)])
    t[: n * n] = ray.pop("cameraT")
    ray["t"] = np.where(ray["object"] < 0, np.inf, t)


def coordinates(header: dict[str, Any], true: RayTree, patch_of: np.ndarray) -> np.ndarray:
    """(3, m) points in steps of their patches' own coordinates; the third only where it is free."""
    out = np.zeros((3, len(patch_of)))
    patches = header["patches"]
    for patch, rows in zip(patches, rows_of_each(patch_of, len(patches)), strict=True):
        if not len(rows):
            continue
        at = true.point[rows].T
        if patch["points"] != "free":
            axes, away = np.array(patch["axes"]).reshape(-1, 3), at.T - patch["origin"]
            if patch["points"] == "flat":
                at = axes @ away.T
            else:
                at = np.stack(rebuild.to_octahedron(np.linalg.solve(axes.T, away.T).T))
        out[: len(at), rows] = at / patch["step"]
    return out


def normals(
    header: dict[str, Any], coder: Noting, ray: Ray, tree: Structure, true: RayTree
) -> None:  # fmt: skip
    patches, step = header["patches"], header["steps"]["normal"]
    stored = np.array([patch["normals"] == "stored" for patch in patches])[ray["patch"]]
    kind = 2 * ray["patch"] + (tree.level > 0)
    hit = (true.normal**2).sum(axis=1) > 0
    folded = rebuild.to_octahedron(np.where(hit[:, None], true.normal, [0.0, 0.0, 1.0]))
    u, v = (
        coder.numbers(f"normal{k}", at / step, stored, ray["history"], kind, tree.sides)
        for k, at in enumerate(folded)
    )
    normal = np.zeros((tree.count, 3))
    for patch, rows in zip(patches, rows_of_each(ray["patch"], len(patches)), strict=True):
        if patch["normals"] == "stored":
            at = rebuild.on_octahedron(u[rows] * step, v[rows] * step)
        elif patch["normals"] == "none":
            continue
        else:
            at = rebuild.normals_on(patch, ray["sign"][rows], list(ray["point"][rows].T))
        for c in range(3):
            normal[rows, c] = at[c]
    ray["normal"] = normal


def tests(coder: Noting, ray: Ray, tree: Structure, true: RayTree) -> None:
    every = np.ones(tree.count, bool)
    number = coder.numbers("tests", true.tests, every, ray["history"], ray["patch"], tree.sides)
    ray["tests"] = number.astype(np.int64)


def weights(
    header: dict[str, Any], coder: Noting, ray: Ray, tree: Structure, true: RayTree
) -> None:  # fmt: skip
    """Shares: constants of the material, or split between reflected and refracted."""
    materials, step = header["materials"], header["steps"]["split"]
    split = np.array([*(m["split"] for m in materials), 0.0])[ray["material"]]
    parted = (split > 0) & ((tree.children & (Kind.REFLECTED.bit | Kind.REFRACTED.bit)) > 0)
    parted &= (tree.children & Kind.TOTAL.bit) == 0
    mirror = np.zeros(tree.count)  # the reflected share; from the refracted child where it is alone
    for sent in (Kind.REFRACTED, Kind.REFLECTED):
        rows = np.flatnonzero(true.kind == sent)
        of, own = true.parent[rows], true.weight[rows]
        mirror[of] = own if sent == Kind.REFLECTED else split[of] - own
    share = coder.numbers(
        "split", mirror / step, parted, ray["history"], ray["surface"], tree.sides
    )
    share = share * step
    weight = np.ones(tree.count)
    for sent in SENT_ON:
        rows = np.flatnonzero(tree.kind == sent)
        parent = tree.parent[rows]
        constants = [*(m[sent.name.lower()] for m in materials), 0.0]
        weight[rows] = np.array(constants)[ray["material"][parent]]
        if sent in (Kind.REFLECTED, Kind.REFRACTED):
            mirrored = share[parent]
            of_split = mirrored if sent == Kind.REFLECTED else split[parent] - mirrored
            weight[rows] = np.where(parted[parent], of_split, weight[rows])
    ray["weight"] = weight
    ray["localWeight"] = np.array([*(m["local"] for m in materials), 0.0])[ray["material"]]


def bases(
    header: dict[str, Any], coder: Noting, ray: Ray, tree: Structure, true: RayTree
) -> None:  # fmt: skip
    """What ambient and diffuse are multiplied by, each channel predicted from those before it too;
    of the objects alone that have a base colour."""
    ray["base"] = np.ones((tree.count, 3))
    steps = np.array([patch.get("base", 0) for patch in header["patches"]])[ray["patch"]]
    stored = steps > 0
    if true.base is None or not stored.any():
        return
    for c in range(3):
        before = [ray["base"][:, k].copy() for k in range(c)]
        number = coder.numbers(
            f"base{c}", true.base[:, c] * steps, stored, ray["history"], ray["patch"], tree.sides,
            before,
        )  # fmt: skip
        ray["base"][:, c] = np.where(stored, number / np.maximum(steps, 1), 1.0)


def lights(
    header: dict[str, Any], coder: Noting, ray: Ray, tree: Structure, true: RayTree
) -> None:  # fmt: skip
    """What each light gives at each hit, and who stands between."""
    m, count = tree.count, len(header["lights"])
    hit = ray["object"] >= 0
    rows_seen = header["tables"]["visibility"]
    table = np.array([row[:2] for row in rows_seen], np.int64).reshape(-1, 2)
    pass_share = np.array([*(row[2] if len(row) > 2 else 1.0 for row in rows_seen), 1.0])
    surfaces, below = len(header["tables"]["surface"]), tree.level > 0
    point = [ray["point"][:, c].copy() for c in range(3)]
    features = [*(ray["normal"][:, c].copy() for c in range(3)), *point]
    step = np.array([*(mat["step"] for mat in header["materials"]), 1.0])[ray["material"]]
    stretch = header["steps"]["blocked"]
    for name in ("visibility", "blocker"):
        ray[name] = np.zeros((m, count), np.int64)
    for name in ("blockedAt", "passed", "diffuse", "specular"):
        ray[name] = np.zeros((m, count))
    for l, light in enumerate(header["lights"]):
        group, kind = np.where(hit, ray["history"], ABSENT), np.where(hit, ray["surface"], ABSENT)
        seen = coder.symbols(f"visibility{l}", 0, group, kind, tree.sides)
        visibility = np.where(hit, table[seen, 0] if len(table) else 0, Visibility.BEHIND)
        ray["visibility"][:, l] = visibility
        ray["blocker"][:, l] = np.where(hit, table[seen, 1] if len(table) else -1, -1)
        passed = ray["passed"][:, l] = pass_share[np.where(hit, seen, -1)]

        blocked = hit & (visibility == Visibility.BLOCKED)
        to_light = rebuild.length([light["position"][c] - point[c] for c in range(3)])
        left = coder.numbers(
            f"blocked{l}", (1 - true.blocked_at[:, l]) * to_light / stretch, blocked,
            ray["history"] * len(table) + seen, 2 * seen + below, tree.sides, point,
        )  # fmt: skip
        part = 1 - (left * stretch) / np.where(blocked, to_light, 1.0)
        ray["blockedAt"][:, l] = np.where(blocked, part, 1.0)

        for name in ("diffuse", "specular"):
            lit = hit & rebuild.kept_factor(header, name, ray["material"])
            number = coder.numbers(
                f"{name}{l}", getattr(true, name)[:, l] / true.passed[:, l] / step, lit,
                ray["history"] * surfaces + ray["surface"], 2 * ray["surface"] + below,
                tree.sides, features,
            )  # fmt: skip
            ray[name][:, l] = np.where(lit, number * step * passed, 0.0)


def tiles(
    header: dict[str, Any], coder: Noting, ray: Ray, sides: np.ndarray, tile: np.ndarray
) -> None:  # fmt: skip
    """8-bit colours, each channel predicted from those before it too. They stand on their own:
    tiles can be shown before any light is decoded."""
    cameras = header["n"] ** 2
    group, kind, every = ray["history"][:cameras], ray["patch"][:cameras], np.ones(cameras, bool)
    channels: list[np.ndarray] = []
    for c in range(3):
        before = channels.copy()
        channels.append(coder.numbers(f"tile{c}", tile[:, c], every, group, kind, sides, before))
    ray["tiles"] = np.stack(channels, axis=1).astype(np.int64).reshape(-1)
