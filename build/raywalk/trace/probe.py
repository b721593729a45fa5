"""Nearest hits of rays that somebody else names: for authors, and to check against truth."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from raywalk.errors import SourceError, SourceErrors
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.nearest import NOWHERE
from raywalk.scene.model import Scene

# Squares of larger coordinates, and their products, would leave float64's range.
FARTHEST = 1e100


def read_rays(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Origins and directions, (n, 3) float64 each, from [{"origin": .., "direction": ..}, ..].

    Raises SourceErrors that name every ray that is not one.
    """
    try:
        listed = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as problem:
        raise SourceErrors([SourceError(path, "", f"cannot be read as JSON ({problem})")]) from None
    if not isinstance(listed, list):
        message = "is not a list of rays"
        hint = 'write [{"origin": [0, 0, 5], "direction": [0, 0, -1]}]'
        raise SourceErrors([SourceError(path, "", message, hint=hint)])
    problems: list[SourceError] = []
    parts: dict[str, list[list[float]]] = {"origin": [], "direction": []}
    for k, ray in enumerate(listed):
        for key, vectors in parts.items():
            vector = _vector(ray.get(key) if isinstance(ray, dict) else None)
            if vector is None:
                message = f"{json.dumps(ray)[:80]} has no {key} of three finite numbers"
                allowed = f"each at most {FARTHEST:g} in size"
                problems.append(SourceError(path, f"[{k}].{key}", message, allowed=allowed))
            elif key == "direction" and not any(vector):
                problems.append(SourceError(path, f"[{k}].direction", "has length 0"))
            else:
                vectors.append(vector)
    if problems:
        raise SourceErrors(problems)
    return tuple(np.array(v, float).reshape(-1, 3) for v in parts.values())  # type: ignore


def probe(scene: Scene, origin: np.ndarray, direction: np.ndarray) -> list[dict[str, Any] | None]:
    """The nearest hit of each ray: t (in units of its direction), point, normal, object, inside.

    The normal is the shading normal and faces the ray; `inside` tells that the ray came from
    the surface's inner side, so the outward normal is its negative there. None for a miss.
    """
    # Scaled by a power of two, which rounds nothing: a direction of length 1e-30 or 1e30
    # would lose its square, and Embree its hits.
    exponent = np.frexp(np.abs(direction).max(axis=1))[1]
    hits = CompiledScene(scene).hits(rays_from(origin, np.ldexp(direction, -exponent[:, None])))
    t = np.ldexp(hits.t, -exponent)
    return [
        None
        if hits.object[k] == NOWHERE
        else {
            "t": float(t[k]),
            "point": hits.point[k].tolist(),
            "normal": hits.normal[k].tolist(),
            "object": scene.objects[hits.object[k]].name,
            "inside": bool(hits.inside[k]),
        }
        for k in range(len(t))
    ]


def _vector(value: Any) -> list[float] | None:
    if not isinstance(value, list) or len(value) != 3:
        return None
    numbers = all(isinstance(x, int | float) and not isinstance(x, bool) for x in value)
    if not numbers or not all(abs(x) <= FARTHEST for x in value):  # NaN fails this too
        return None
    return [float(x) for x in value]
