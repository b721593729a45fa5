"""The header's tables: what many rays share and a symbol names."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from raywalk.scene.model import BASE_STEPS, Scene
from raywalk.trace.tree import SENT_ON, RayTree
from raywalk.trace_file import rebuild
from raywalk.trace_file.groups import rows_of_each
from raywalk.trace_file.level import TraceFileError
from raywalk.trace_file.precision import LEAVING, coordinate_step, light_step, point_error
from raywalk.trace_file.structure import bits_of

if TYPE_CHECKING:
    from raywalk.trace_file.patches import Patch

SAME_SHARE = 1e-12  # weights closer together are one constant
LARGE = 2**31  # codes of rows are made small again before they overflow
ENDED = -2  # stands where a camera ray meets nothing more


def by_frequency(columns: list[np.ndarray]) -> tuple[list[tuple[int, ...]], np.ndarray]:
    """Distinct rows of whole-number columns (m,), the most frequent first, then by their values;
    and each row's place among them (m,)."""
    code = np.zeros(len(columns[0]), np.int64)
    for column in columns:
        low, high = int(column.min(initial=0)), int(column.max(initial=0))
        code = code * (high - low + 1) + (column - low)
        if code.max(initial=0) > LARGE:
            code = np.unique(code, return_inverse=True)[1]
    _, first, place, counts = np.unique(
        code, return_index=True, return_inverse=True, return_counts=True
    )
    rows = list(zip(*(column[first].tolist() for column in columns), strict=True))
    order = sorted(range(len(rows)), key=lambda k: (-counts[k], rows[k]))
    rank = np.empty(len(rows), np.int64)
    rank[order] = np.arange(len(rows))
    return [rows[k] for k in order], rank[place]


def signatures(tree: RayTree) -> tuple[list[tuple[int, ...]], np.ndarray]:
    """Objects along each camera ray, nearest first."""
    counts = np.diff(tree.hits_start)
    along = np.full((tree.cameras, int(counts.max(initial=0)) + 1), ENDED)
    ray = np.repeat(np.arange(tree.cameras), counts)
    along[ray, np.arange(len(ray)) - tree.hits_start[ray]] = tree.hits_object
    table, place = by_frequency(list(along.T))
    return [tuple(thing for thing in row if thing != ENDED) for row in table], place


def children_bits(tree: RayTree) -> np.ndarray:
    """Which kinds of child each ray has, a bit each."""
    bits = np.zeros(len(tree.pixel), np.int64)
    for kind in SENT_ON:
        parents = tree.parent[tree.kind == kind]
        if len(np.unique(parents)) < len(parents) or (bits[parents] & bits_of(kind.branch)).any():
            raise TraceFileError("a ray has two children of one branch")
        bits[parents] |= kind.bit
    return bits


def drawn_hits(tree: RayTree, eye: list[float]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Camera rays (h,), which of their hits (h,) and how far (h,): all hits, and then the ends of
    the lines that are drawn of rays which leave the scene."""
    counts = np.diff(tree.hits_start)
    ray, gone = np.repeat(np.arange(tree.cameras), counts), np.flatnonzero(counts == 0)
    place = np.concatenate([np.arange(len(ray)) - tree.hits_start[ray], np.zeros(len(gone), int)])
    ends = np.linalg.norm(tree.point[gone] - eye, axis=1)
    return np.concatenate([ray, gone]), place, np.concatenate([tree.hits_t, ends])


def surfaces(tree: RayTree, patches: list[Patch], patch_of: np.ndarray) -> tuple[list, np.ndarray]:
    """(patch, material, inside, sign of the rule's normal)"""
    sign = np.ones(len(patch_of), np.int64)
    for patch, rows in zip(patches, rows_of_each(patch_of, len(patches)), strict=True):
        if patch.normals in ("one", "gradient"):
            rule = rebuild.normals_on(asdict(patch), np.ones(len(rows)), list(tree.point[rows].T))
            sign[rows] = np.where(
                (np.stack(rule, axis=1) * tree.normal[rows]).sum(axis=1) < 0, -1, 1
            )
    return by_frequency([patch_of, tree.material, tree.inside.astype(int), sign])


def seen(tree: RayTree) -> tuple[list, np.ndarray]:
    """(visibility, blocker, what glass lets pass) of each hit and light: (m, lights) places.

    Few values: what passes is a product of the materials' `transmit`.
    """
    shape = tree.visibility.shape
    hit = np.repeat(tree.object >= 0, shape[1])
    exact, which = np.unique(tree.passed.ravel()[hit], return_inverse=True)
    shares, same = np.unique([float(format(x, ".12g")) for x in exact], return_inverse=True)
    table, place = by_frequency(
        [tree.visibility.ravel()[hit], tree.blocker.ravel()[hit], same.astype(np.int64)[which]]
    )
    places = np.zeros(len(hit), np.int64)
    places[hit] = place
    return [(*seen, float(shares[k])) for *seen, k in table], places.reshape(shape)


def patch_row(
    patch: Patch, extent: float, is_ended_by_children: bool, scene: Scene
) -> dict[str, Any]:
    """What the header says of a patch. A frame is only kept if a reflected ray ends there."""
    row: dict[str, Any] = {"object": patch.object, "points": patch.points, "normals": patch.normals}
    if is_ended_by_children:
        error = allowed_error(patch, extent)
        row["step"] = coordinate_step(patch.points, error, patch.axes)
        if patch.points != "free":
            row |= {"origin": list(patch.origin), "axes": list(patch.axes)}
    if patch.object >= 0 and scene.objects[patch.object].base:
        row["base"] = BASE_STEPS
    if patch.gradient:
        row["gradient"] = list(patch.gradient)
    return row


def allowed_error(patch: Patch, extent: float) -> float:
    error = point_error(extent, patch.curvature)
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
    weights = {kind.name.lower(): tree.weight[of & (tree.kind == kind)] for kind in SENT_ON}
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
        raise TraceFileError(f"shares of material {name} differ from ray to ray")
    return float(values[0])
