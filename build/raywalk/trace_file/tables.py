"""The header's tables: what many rays share and a symbol names."""

from __future__ import annotations

from collections import Counter
from dataclasses import asdict
from itertools import pairwise
from typing import Any

import numpy as np

from raywalk.scene.model import Scene
from raywalk.trace.tree import Kind, RayTree
from raywalk.trace_file import rebuild
from raywalk.trace_file.errors import TraceFileError
from raywalk.trace_file.patches import Patch
from raywalk.trace_file.precision import LEAVING, coordinate_step, light_step, point_error

SAME_SHARE = 1e-12  # weights closer together are one constant


def by_frequency(rows: list) -> tuple[list, np.ndarray]:
    """Distinct rows, the most frequent first, and each row's place among them."""
    counts = Counter(rows)
    table = sorted(counts, key=lambda row: (-counts[row], row))
    place = {row: k for k, row in enumerate(table)}
    return table, np.array([place[row] for row in rows], np.int64)


def signatures(tree: RayTree) -> tuple[list, np.ndarray]:
    """Objects along each camera ray, nearest first."""
    things, start = tree.hits_object.tolist(), tree.hits_start.tolist()
    return by_frequency([tuple(things[a:b]) for a, b in pairwise(start)])


def surfaces(tree: RayTree, patches: list[Patch], patch_of: np.ndarray) -> tuple[list, np.ndarray]:
    """(patch, material, inside, sign of the rule's normal)"""
    sign = np.ones(len(patch_of), np.int64)
    for k, patch in enumerate(patches):
        if patch.normals in ("one", "gradient"):
            rows = np.flatnonzero(patch_of == k)
            rule = rebuild.normals_on(asdict(patch), np.ones(len(rows)), list(tree.point[rows].T))
            sign[rows] = np.where(
                (np.stack(rule, axis=1) * tree.normal[rows]).sum(axis=1) < 0, -1, 1
            )
    columns = [patch_of, tree.material, tree.inside.astype(int), sign]
    return by_frequency(list(zip(*(column.tolist() for column in columns), strict=True)))


def seen(tree: RayTree) -> tuple[list, np.ndarray]:
    """(visibility, blocker, what glass lets pass) of each hit and light: (m, lights) places.

    Few values: what passes is a product of the materials' `transmit`.
    """
    hit = np.repeat(tree.object >= 0, tree.visibility.shape[1])
    passed = [float(format(share, ".12g")) for share in tree.passed.ravel().tolist()]
    pairs = list(
        zip(tree.visibility.ravel().tolist(), tree.blocker.ravel().tolist(), passed, strict=True)
    )
    place = np.zeros(len(pairs), np.int64)
    table, place[hit] = by_frequency(
        [pair for pair, is_hit in zip(pairs, hit, strict=True) if is_hit]
    )
    return table, place.reshape(tree.visibility.shape)


def patch_row(patch: Patch, extent: float, is_ended_by_children: bool) -> dict[str, Any]:
    """What the header says of a patch. A frame is only kept if a reflected ray ends there."""
    row: dict[str, Any] = {"object": patch.object, "points": patch.points, "normals": patch.normals}
    if is_ended_by_children:
        error = allowed_error(patch, extent)
        row["step"] = coordinate_step(patch.points, error, patch.axes)
        if patch.points != "free":
            row |= {"origin": list(patch.origin), "axes": list(patch.axes)}
    if patch.gradient:
        row["gradient"] = list(patch.gradient)
    return row


def allowed_error(patch: Patch, extent: float) -> float:
    error = point_error(extent, patch.way)
    return error * LEAVING if patch.object < 0 else error


def material_rows(tree: RayTree, scene: Scene) -> list[dict[str, Any]]:
    """Colours, and the shares of a hit's colour that are the same at all its hits."""
    rows = []
    for k, material in enumerate(scene.materials):
        split, shares = _shares(tree, k, material.reflect + material.transmit, material.name)
        local = _constant(tree.local_weight[tree.material == k], material.name, 0.0)
        most = sum(
            light_colour
            * max(kd + ks for kd, ks in zip(material.diffuse, material.specular, strict=True))
            for light_colour in (max(light.colour) for light in scene.lights)
        )
        rows.append({
            "name": material.name, "ambient": list(material.ambient),
            "diffuse": list(material.diffuse), "specular": list(material.specular),
            "local": local, "split": split, **shares, "step": light_step(local, most),
        })  # fmt: skip
    return rows


def _shares(tree: RayTree, material: int, both: float, name: str) -> tuple[float, dict[str, float]]:
    """Weights of children by kind; a positive split says that it is divided ray by ray."""
    of = np.where(tree.parent >= 0, tree.material[tree.parent], -1) == material
    weights = {
        kind.name.lower(): tree.weight[of & (tree.kind == kind)]
        for kind in (Kind.REFLECTED, Kind.REFRACTED, Kind.TOTAL)
    }
    parted = any(np.ptp(w) > SAME_SHARE for key, w in weights.items() if len(w) and key != "total")
    shares = {
        key: 0.0 if parted and key != "total" else _constant(w, name, 0.0)
        for key, w in weights.items()
    }
    return (both if parted else 0.0), shares


def _constant(values: np.ndarray, name: str, otherwise: float) -> float:
    if not len(values):
        return otherwise
    if np.ptp(values) > SAME_SHARE:
        raise TraceFileError("unfit", f"shares of material {name} differ from ray to ray")
    return float(values[0])
