"""From whole numbers to numbers a person sees. The viewer's rebuild.ts does the same,
operation by operation: only + - * / and sqrt, in this order, so that both give the same
bits. numpy functions that may sum in another order (dot, sum, norm) stay out of here.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.trace.kinds import BRANCH_OF, BRANCHES
from raywalk.trace.tree import LIT

Columns = list[np.ndarray]  # x, y, z


def camera_steps(frame: dict[str, Any], n: int) -> Columns:
    """Directions of the n x n camera rays, of length 1 along `forward`."""
    row, column = np.divmod(np.arange(n * n), n)
    x = (2 * (column + 0.5)) / n - 1
    y = (2 * (row + 0.5)) / n - 1
    return [(frame["forward"][k] + frame["right"][k] * x) + frame["down"][k] * y for k in range(3)]


def length(v: Columns) -> np.ndarray:
    return np.asarray(np.sqrt((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]))


def on_octahedron(u: np.ndarray, v: np.ndarray) -> Columns:
    """Unit vectors from coordinates on the unfolded octahedron |x| + |y| + |z| = 1."""
    z = (1 - np.abs(u)) - np.abs(v)
    below = np.where(z < 0, -z, 0.0)
    x = np.where(u >= 0, u - below, u + below)
    y = np.where(v >= 0, v - below, v + below)
    size = length([x, y, z])
    return [x / size, y / size, z / size]


def to_octahedron(v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The inverse, for the encoder. v: (m, 3)"""
    x, y, z = (v / np.abs(v).sum(axis=1, keepdims=True)).T
    fold_x = np.where(x >= 0, 1 - np.abs(y), np.abs(y) - 1)
    fold_y = np.where(y >= 0, 1 - np.abs(x), np.abs(x) - 1)
    return np.where(z < 0, fold_x, x), np.where(z < 0, fold_y, y)


def points_on(patch: dict[str, Any], numbers: Columns) -> Columns:
    """World points from a patch's stored coordinates."""
    at = [number * patch["step"] for number in numbers]
    if patch["points"] == "free":
        return at
    origin, axes = patch["origin"], patch["axes"]
    if patch["points"] == "flat":
        return [(origin[k] + axes[k] * at[0]) + axes[3 + k] * at[1] for k in range(3)]
    s = on_octahedron(at[0], at[1])
    return [
        ((origin[k] + axes[k] * s[0]) + axes[3 + k] * s[1]) + axes[6 + k] * s[2] for k in range(3)
    ]


def normals_on(patch: dict[str, Any], sign: np.ndarray, point: Columns) -> Columns:
    """Normals that follow from the patch. sign: 1 or -1 per ray."""
    g = patch["gradient"]
    if patch["normals"] == "one":
        return [g[k] * sign for k in range(3)]
    v = [
        ((g[3 * k] * point[0] + g[3 * k + 1] * point[1]) + g[3 * k + 2] * point[2]) + g[9 + k]
        for k in range(3)
    ]
    size = length(v)
    return [(v[k] / size) * sign for k in range(3)]


def recombine(header: dict[str, Any], ray: dict[str, np.ndarray]) -> np.ndarray:
    """(m, 3) colours from lighting terms and weights.

    local = ambient * B + light by light V * (diffuse * (kd * B) + specular * ks) * light colour,
    B the base colour;
    then rows from the last to the first add weight * colour to their parent's
    localWeight * local: the last branch's child first, so the refracted before the reflected.
    """
    colour = np.zeros((len(ray["parent"]), 3))
    materials, hit = header["materials"], ray["material"] >= 0
    for c in range(3):
        table = [np.array([*(m[key][c] for m in materials), 0.0]) for key in COLOURS]
        ambient, kd, ks = (column[ray["material"]] for column in table)
        base = ray["base"][:, c]
        local, kd = ambient * base, kd * base
        for l, light in enumerate(header["lights"]):
            lit = np.isin(ray["visibility"][:, l], LIT)
            term = (ray["diffuse"][:, l] * kd + ray["specular"][:, l] * ks) * light["colour"][c]
            local = np.where(lit, local + term, local)
        colour[:, c] = np.where(hit, ray["localWeight"] * local, header["background"][c])
    _gather(colour, ray)
    return colour


COLOURS = ("ambient", "diffuse", "specular")


def kept_factor(header: dict[str, Any], name: str, material: np.ndarray) -> np.ndarray:
    """(m,) bool: where a lighting factor ("diffuse", "specular") is kept: it multiplies a colour,
    and is not in the dark. material: (m,), -1 where nothing is hit."""
    coloured = [any(of[name]) and of["local"] > 0 for of in header["materials"]]
    return np.asarray(np.array([*coloured, False])[material])


def _gather(colour: np.ndarray, ray: dict[str, np.ndarray]) -> None:
    """Depth by depth from the deepest; a parent has at most one child of each branch."""
    of = BRANCH_OF[ray["kind"]]
    for level in range(int(ray["level"].max(initial=0)), 0, -1):
        for branch in reversed(range(BRANCHES)):
            rows = np.flatnonzero((ray["level"] == level) & (of == branch))
            share = ray["weight"][rows, None] * colour[rows]
            colour[ray["parent"][rows]] = colour[ray["parent"][rows]] + share
