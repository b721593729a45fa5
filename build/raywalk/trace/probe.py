"""Nearest hits of rays that somebody else names: for authors, and to check against truth."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from raywalk.errors import SourceError, SourceErrors
from raywalk.geometry.compiled import CompiledScene, Rays, rays_from
from raywalk.geometry.roots import NOWHERE, SOMEWHERE
from raywalk.geometry.starts import NAMED, start_on
from raywalk.scene.model import Scene
from raywalk.scene.wording import did_you_mean, joined, plain, quoted

# Squares of larger coordinates, and their products, would leave float64's range.
FARTHEST = 1e100


class Listed(NamedTuple):
    """Rays as a file lists them."""

    path: Path
    origin: np.ndarray  # (n, 3) float64
    direction: np.ndarray  # (n, 3) float64
    leaving: list[str | None]  # the object whose surface each starts on, if it is said


def read_rays(path: Path) -> Listed:
    """The rays of [{"origin": .., "direction": .., "leaving": ..}, ..]; `leaving` may be left out.

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
    leaving: list[str | None] = []
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
        named = ray.get("leaving") if isinstance(ray, dict) else None
        if named is not None and not isinstance(named, str):
            message = f"{json.dumps(named)[:80]} is not the name of an object"
            problems.append(SourceError(path, f"[{k}].leaving", message))
        leaving.append(named)
    if problems:
        raise SourceErrors(problems)
    origin, direction = (np.array(v, float).reshape(-1, 3) for v in parts.values())
    return Listed(path, origin, direction, leaving)


def probe(
    scene: Scene, origin: np.ndarray, direction: np.ndarray, listed: Listed | None = None
) -> list[dict[str, Any] | None]:
    """The nearest hit of each ray: t (in units of its direction), point, normal, object, inside.

    The normal is the shading normal and faces the ray; `inside` tells that the ray came from
    the surface's inner side, so the outward normal is its negative there. None for a miss.

    The least t: a surface that passes within 3.6e-15 (16 roundings) of the origin, as a share of
    the coordinates of origin and object, is where the ray starts; it leaves it to the side that
    the direction says and is not hit there. A ray whose origin is known less well names its object
    in `leaving`, and may start up to 1e-9 of those coordinates off it. Raises SourceErrors for
    names that the scene has not, and origins that are not on that object.
    """
    # Scaled by a power of two, which rounds nothing: a direction of length 1e-30 or 1e30
    # would lose its square, and Embree its hits.
    exponent = np.frexp(np.abs(direction).max(axis=1))[1]
    unit = np.ldexp(direction, -exponent[:, None])
    compiled = CompiledScene(scene)
    rays = rays_from(origin, unit)
    rays.leaving[:] = SOMEWHERE
    if listed is not None:
        _leave_named(scene, compiled, rays, listed)
    hits = compiled.hits(rays)
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


def _leave_named(scene: Scene, compiled: CompiledScene, rays: Rays, listed: Listed) -> None:
    """Fills in what the rays leave that say so."""
    names = [obj.name for obj in scene.objects]
    problems = []
    for k, name in enumerate(listed.leaving):
        if name is None:
            continue
        at = f"[{k}].leaving"
        if name not in names:
            message, known = f"no object is named {quoted(name)}", f"known: {joined(names[:20])}"
            hint = did_you_mean(name, names)
            problems.append(SourceError(listed.path, at, message, known, hint))
            continue
        start = start_on(compiled, names.index(name), rays.origin[k], rays.direction[k])
        if start is None:
            message = f"{plain(rays.origin[k].tolist())} is not on the surface of {quoted(name)}"
            allowed = f"at most {NAMED:g} of its coordinates' size off it"
            problems.append(SourceError(listed.path, at, message, allowed))
            continue
        rays.leaving[k] = names.index(name)
        rays.inner[k], rays.triangle[k] = start
    if problems:
        raise SourceErrors(problems)


def _vector(value: Any) -> list[float] | None:
    if not isinstance(value, list) or len(value) != 3:
        return None
    numbers = all(isinstance(x, int | float) and not isinstance(x, bool) for x in value)
    if not numbers or not all(abs(x) <= FARTHEST for x in value):  # NaN fails this too
        return None
    return [float(x) for x in value]
