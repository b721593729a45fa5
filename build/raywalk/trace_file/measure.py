"""What the codec lost, measured: the header's `errors`. Too much is refused, not written."""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.trace.tree import RayTree, Visibility
from raywalk.trace_file.level import TraceFileError
from raywalk.trace_file.noting import Ray
from raywalk.trace_file.precision import COLOUR
from raywalk.trace_file.rebuild import kept_factor
from raywalk.trace_file.tables import SAME_SHARE

EXACT = ("kind", "parent", "depth", "object", "material", "inside", "visibility", "blocker")


def measured_errors(
    tree: RayTree, header: dict[str, Any], ray: Ray, tile: np.ndarray
) -> dict[str, float]:
    """Largest difference of each column to the tree, or TraceFileError if it is no rounding."""
    for name in EXACT:
        _must_agree(name, getattr(tree, name), ray[name], tree.object >= 0)

    def factor(name: str) -> float:
        kept = kept_factor(header, name, tree.material)
        return _most((ray[name] - getattr(tree, name))[kept].ravel())

    hit = tree.object >= 0
    blocked = tree.visibility == Visibility.BLOCKED
    to_light = _to_lights(tree, header)
    found = {
        "point": _most(ray["point"] - tree.point, hit),
        "leaving": _most(ray["point"] - tree.point, ~hit),
        "t": _most(ray["t"][hit] - tree.t[hit]),
        "normal": _most(ray["normal"] - tree.normal),
        "weight": _most(ray["weight"] - tree.weight),
        "localWeight": _most((ray["localWeight"] - tree.local_weight)[hit]),
        "blocked": _most(((ray["blockedAt"] - tree.blocked_at) * to_light)[blocked]),
        "diffuse": factor("diffuse"),
        "specular": factor("specular"),
        "hits": _most(ray["hitsT"] - tree.hits_t),
        "colour": _most((ray["colour"] - tree.colour).reshape(-1)),
    }
    if tree.base is not None and (ray["base"] != tree.base).any():
        raise TraceFileError("column base does not come back")
    if _most((ray["passed"] - tree.passed)[hit].reshape(-1)) > SAME_SHARE:
        raise TraceFileError("column passed does not come back")
    # Of light brighter than white, as a program with a mistake in it has it, the same share.
    bright = np.maximum(1.0, np.abs(tree.colour))
    if _most(((ray["colour"] - tree.colour) / bright).reshape(-1)) > COLOUR:
        raise TraceFileError(f"colours do not add up: off by {found['colour']:.2g}")
    if (ray["tiles"] != tile.reshape(-1)).any():
        raise TraceFileError("tiles do not come back")
    sums = 255 * np.clip(ray["colour"][: len(tile)], 0.0, 1.0)
    if np.abs(sums - tile).max(initial=0.0) > 0.5 + 255 * COLOUR:
        raise TraceFileError("tiles are not the rounded sums of their rays' colours")
    return {name: float(format(error * 1.005, ".3g")) for name, error in found.items()}


def _must_agree(name: str, true: np.ndarray, rebuilt: np.ndarray, hit: np.ndarray) -> None:
    if name in ("visibility", "blocker"):
        true, rebuilt = true[hit], rebuilt[hit]
    if (true.astype(np.int64) != rebuilt).any():
        raise TraceFileError(f"column {name} does not come back: the tree breaks a rule")


def _to_lights(tree: RayTree, header: dict[str, Any]) -> np.ndarray:
    position = np.array([light["position"] for light in header["lights"]]).reshape(-1, 3)
    return np.asarray(np.linalg.norm(tree.point[:, None] - position, axis=2))


def _most(difference: np.ndarray, rows: np.ndarray | None = None) -> float:
    """Longest vector or largest number."""
    if rows is not None:
        difference = difference[rows]
    if difference.ndim == 2 and difference.shape[1] == 3:
        difference = np.sqrt((difference**2).sum(axis=1))
    return float(np.abs(difference).max(initial=0.0))
