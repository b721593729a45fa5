"""The scene cut along each row and column of the frustum: FORMAT of sections.js.

All camera rays of a row lie in one plane through the eye; so do those of a column. The viewer
draws them flat, with the outlines that are worked out here.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.geometry.cross_section import Cut, Outline, Sliced
from raywalk.scene.camera import camera_frame, half_width
from raywalk.trace.record import kept_pixels
from raywalk.trace.wavefront import Tracer

STEPS = 8192  # a coordinate is a whole number of reach / STEPS: finer than a screen's pixels
APART = 8  # steps between an outline's points; nearer ones of a fine mesh are left out
ROOMY = 1.0 + 1e-6  # of spheres that hold objects: more than what rounding takes from them
REACH = 2.5  # radii of the scene: beyond it no drawing shows anything

Json = dict[str, Any]


def sections_of(tracer: Tracer) -> Json:
    """Sections of every picture row and column that some frustum resolution uses.

    {"step", "eye", "frame": right, up, forward; "rows" and "columns": {pixel: [slope, outlines]}}
    where a section's plane is spanned by forward + slope * up and right (a row), or by
    forward + slope * right and up (a column). Coordinates in the plane are whole steps from the
    eye: first along the slope, then along right or up. An outline is [object, kind, x, y, ...];
    kind 0 closed, 1 open: each point as the difference to the one before; 2 an ellipse: centre
    and two conjugate half axes.
    """
    scene = tracer.scene
    eye = np.array(scene.camera.eye, float)
    right, up, forward = camera_frame(scene.camera)
    reach = REACH * tracer.scene_sphere[1]
    size = scene.render.size
    used = kept_pixels(size, scene.render.resolutions).reshape(size, size).any(axis=0)
    spread = half_width(scene.camera)
    meshes = {mesh.index: mesh.triangles for mesh in tracer.compiled.meshes}
    sliced = [Sliced(obj, meshes.get(k)) for k, obj in enumerate(scene.objects)]

    def sections(across: np.ndarray, along: np.ndarray, sign: int) -> Json:
        made = {}
        for pixel in np.flatnonzero(used).tolist():
            slope = sign * (2 * (pixel + 0.5) / size - 1) * spread
            cut = _cut(eye, forward + slope * across, along, reach)
            made[str(pixel)] = [slope, _section(sliced, _near(tracer, cut), cut)]
        return made

    return {
        "format": 1,
        "scene": scene.id,
        "step": reach / STEPS,
        "eye": list(scene.camera.eye),
        "frame": np.array([right, up, forward]).tolist(),
        "rows": sections(up, right, -1),
        "columns": sections(right, up, 1),
    }


def _cut(eye: np.ndarray, forward: np.ndarray, along: np.ndarray, reach: float) -> Cut:
    return Cut(eye, np.array([forward / np.linalg.norm(forward), along]), reach)


def _section(sliced: list[Sliced], near: np.ndarray, cut: Cut) -> list[list[int]]:
    found = []
    for k in near.tolist():
        for outline in sliced[k].outlines(cut):
            found += _whole_steps(k, outline, cut.reach / STEPS)
    return found


def _near(tracer: Tracer, cut: Cut) -> np.ndarray:
    """(n,) the objects that a cut may meet, in order: of thousands it passes most by."""
    table = tracer.compiled.primitives
    away = np.abs((table.centre - cut.origin) @ cut.normal)
    passed = np.zeros(len(table.row_of), bool)
    passed[table.object] = away > ROOMY * np.sqrt(table.reach_sq)
    return np.flatnonzero(~passed)


def _whole_steps(k: int, outline: Outline, step: float) -> list[list[int]]:
    steps = np.rint(outline.points / step).astype(int)
    if outline.kind == "ellipse":
        return [[k, 2, *steps.reshape(-1).tolist()]]
    steps = _apart(steps)
    if len(steps) < 2:
        return []
    apart = np.diff(steps, axis=0, prepend=[[0, 0]])
    return [[k, 0 if outline.kind == "closed" else 1, *apart.reshape(-1).tolist()]]


def _apart(points: np.ndarray) -> np.ndarray:
    """Leaves out points nearer than APART to the last one kept; the ends stay."""
    if len(points) < 5:
        return points
    rows = points.tolist()
    kept, (x, y) = [0], rows[0]
    for k, (to_x, to_y) in enumerate(rows[1:-1], 1):
        if abs(to_x - x) >= APART or abs(to_y - y) >= APART:
            kept.append(k)
            x, y = to_x, to_y
    return points[[*kept, len(points) - 1]]
