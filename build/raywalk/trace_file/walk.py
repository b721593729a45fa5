"""The one pass through a trace file's columns.

Each step gives the coder a column of whole numbers to note and makes what a person sees of
it; later columns are predicted from what is known by then. So the encoder sees exactly what the
viewer (viewer/trace/decode.ts), which reads in this order, will see, and states its errors.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.trace.tree import SENT_ON, Kind, Visibility
from raywalk.trace_file import rebuild
from raywalk.trace_file.noting import ABSENT, Noting, Ray
from raywalk.trace_file.structure import Structure, grow, in_raster


def walk(header: dict[str, Any], coder: Noting) -> Ray:
    """All columns of types.ts's Trace by their names there, and level, history, surface."""
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
    hits_along(header, coder, ray, chosen, sides)
    points(header, coder, ray, tree)
    normals(header, coder, ray, tree)
    weights(header, coder, ray, tree)
    tiles(header, coder, ray, sides)
    lights(header, coder, ray, tree)
    ray["colour"] = rebuild.recombine(header, ray)
    return ray


def hits_along(
    header: dict[str, Any], coder: Noting, ray: Ray, chosen: np.ndarray, sides: np.ndarray
) -> None:
    """Every hit along each camera ray. One image a key (object, how often met before).

    chosen: (n * n,) each ray's row in the table of signatures.
    """
    n, images, met = header["n"], header["images"], header["tables"]["signature"]
    step = rebuild.camera_steps(header["camera"], n)
    size = rebuild.length(step)
    row, column = np.divmod(np.arange(n * n), n)
    features = [column.astype(float), row.astype(float)]
    along = images_along(met, images)
    z = np.ones((n * n, len(images)))
    for k, image in enumerate(images):
        group = np.where((along == k).any(axis=1), 0, ABSENT)[chosen]
        number = coder.numbers(f"depth{k}", ray, group, group, sides, features)
        here = group == 0
        z[here, k] = 1 / (number[here] * image["step"])
    nearest = z[np.arange(n * n), along[chosen, 0]]
    ray["cameraPoint"] = np.stack(
        [header["camera"]["eye"][k] + step[k] * nearest for k in range(3)], axis=1
    )
    ray["cameraT"] = nearest * size
    counts = np.array([len(hits) for hits in met], np.int64)[chosen]
    start = np.concatenate([[0], np.cumsum(counts)])
    of = np.repeat(np.arange(n * n), counts)
    image_of = along[chosen[of], np.arange(len(of)) - start[of]]
    t = z[of, image_of] * size[of]
    ray["hitsStart"], ray["hitsT"] = start, ascending(t, start)
    ray["hitsObject"] = np.array([image["object"] for image in images], np.int64)[image_of]


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


def points(header: dict[str, Any], coder: Noting, ray: Ray, tree: Structure) -> None:
    """Where rays end, and their lengths. Those of camera rays are known from depth images."""
    m, n = tree.count, header["n"]
    camera = np.arange(m) < n * n
    free = np.array([patch["points"] == "free" for patch in header["patches"]])[ray["patch"]]
    numbers = []
    for k in range(3):
        stored = ~camera & (free | (k < 2))
        kind = np.where(stored, ray["patch"], ABSENT)
        group = np.where(stored, ray["history"], ABSENT)
        numbers.append(coder.numbers(f"point{k}", ray, group, kind, tree.sides, []))
    point = np.zeros((m, 3))
    for k, patch in enumerate(header["patches"]):
        rows = np.flatnonzero(~camera & (ray["patch"] == k))
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


def normals(header: dict[str, Any], coder: Noting, ray: Ray, tree: Structure) -> None:
    patches = header["patches"]
    stored = np.array([patch["normals"] == "stored" for patch in patches])[ray["patch"]]
    kind = np.where(stored, 2 * ray["patch"] + (tree.level > 0), ABSENT)
    group = np.where(stored, ray["history"], ABSENT)
    u, v = (coder.numbers(f"normal{k}", ray, group, kind, tree.sides, []) for k in range(2))
    normal = np.zeros((tree.count, 3))
    for k, patch in enumerate(patches):
        rows = np.flatnonzero(ray["patch"] == k)
        if patch["normals"] == "stored":
            step = header["steps"]["normal"]
            at = rebuild.on_octahedron(u[rows] * step, v[rows] * step)
        elif patch["normals"] == "none":
            continue
        else:
            at = rebuild.normals_on(patch, ray["sign"][rows], list(ray["point"][rows].T))
        for c in range(3):
            normal[rows, c] = at[c]
    ray["normal"] = normal


def weights(header: dict[str, Any], coder: Noting, ray: Ray, tree: Structure) -> None:
    """Shares: constants of the material, or split between reflected and refracted."""
    materials = header["materials"]
    split = np.array([*(m["split"] for m in materials), 0.0])[ray["material"]]
    parted = (split > 0) & ((tree.children & (Kind.REFLECTED.bit | Kind.REFRACTED.bit)) > 0)
    parted &= (tree.children & Kind.TOTAL.bit) == 0
    kind = np.where(parted, ray["surface"], ABSENT)
    group = np.where(parted, ray["history"], ABSENT)
    share = coder.numbers("split", ray, group, kind, tree.sides, []) * header["steps"]["split"]
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
    whole = np.zeros(tree.count, np.int64)
    tests = coder.numbers("tests", ray, ray["history"], ray["patch"] + whole, tree.sides, [])
    ray["tests"] = tests.astype(np.int64)


def lights(header: dict[str, Any], coder: Noting, ray: Ray, tree: Structure) -> None:
    """What each light gives at each hit, and who stands between."""
    m, count = tree.count, len(header["lights"])
    hit = ray["object"] >= 0
    rows_seen = header["tables"]["visibility"]
    table = np.array([row[:2] for row in rows_seen], np.int64).reshape(-1, 2)
    pass_share = np.array([*(row[2] if len(row) > 2 else 1.0 for row in rows_seen), 1.0])
    surfaces, below = len(header["tables"]["surface"]), tree.level > 0
    point = [ray["point"][:, c].copy() for c in range(3)]
    features = [*(ray["normal"][:, c].copy() for c in range(3)), *point]
    step = np.array([*(mat["step"] for mat in header["materials"]), 0.0])[ray["material"]]
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
        group = np.where(blocked, ray["history"] * len(table) + seen, ABSENT)
        kind = np.where(blocked, 2 * seen + below, ABSENT)
        stretch_left = coder.numbers(f"blocked{l}", ray, group, kind, tree.sides, point)
        to_light = rebuild.length([light["position"][c] - point[c] for c in range(3)])
        part = 1 - (stretch_left * header["steps"]["blocked"]) / np.where(blocked, to_light, 1.0)
        ray["blockedAt"][:, l] = np.where(blocked, part, 1.0)

        for name in ("diffuse", "specular"):
            coloured = [any(mat[name]) and mat["local"] > 0 for mat in header["materials"]]
            lit = hit & np.array([*coloured, False])[ray["material"]]
            group = np.where(lit, ray["history"] * surfaces + ray["surface"], ABSENT)
            kind = np.where(lit, 2 * ray["surface"] + below, ABSENT)
            number = coder.numbers(f"{name}{l}", ray, group, kind, tree.sides, features)
            ray[name][:, l] = np.where(lit, number * step * passed, 0.0)


def tiles(header: dict[str, Any], coder: Noting, ray: Ray, sides: np.ndarray) -> None:
    """8-bit colours, each channel predicted from those before it too. They stand on their own:
    tiles can be shown before any light is decoded."""
    n = header["n"]
    group, kind = ray["history"][: n * n], ray["patch"][: n * n]
    channels: list[np.ndarray] = []
    for c in range(3):
        channels.append(coder.numbers(f"tile{c}", ray, group, kind, sides, channels.copy()))
    ray["tiles"] = np.stack(channels, axis=1).astype(np.int64).reshape(-1)
