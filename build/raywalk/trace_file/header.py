"""The header of a level's file: what the walk through its columns has to know."""

from __future__ import annotations

from typing import Any

import numpy as np

from raywalk.scene.camera import camera_frame, half_width
from raywalk.scene.model import Scene
from raywalk.trace.tree import RayTree
from raywalk.trace_file import rebuild, tables
from raywalk.trace_file.container import FORMAT, VERSION
from raywalk.trace_file.groups import rows_of_each
from raywalk.trace_file.level import side_of
from raywalk.trace_file.patches import Patch
from raywalk.trace_file.precision import MOST_POINT, POINT_SHARE, SPLIT, depth_step, normal_step
from raywalk.trace_file.walk import images_along, keys_along


def begin_header(
    tree: RayTree, scene: Scene, extent: float, patches: list[Patch], patch_of: np.ndarray,
    frame: dict[str, Any],
) -> tuple[dict[str, Any], dict[str, np.ndarray]]:  # fmt: skip
    """All of the header that the walk needs, and the symbols of every symbol column."""
    n = side_of(tree)
    signature, signature_of = tables.signatures(tree)
    surface, surface_of = tables.surfaces(tree, patches, patch_of)
    seen, seen_of = tables.seen(tree)
    symbols = {
        "signature": signature_of, "surface": surface_of, "children": tables.children_bits(tree),
        **{f"visibility{l}": seen_of[:, l] for l in range(len(scene.lights))},
    }  # fmt: skip
    ended = np.unique(patch_of[tree.cameras :])
    header: dict[str, Any] = {
        "format": FORMAT, "version": VERSION, "scene": scene.id, "n": n, "size": tree.size,
        "rays": len(tree.pixel), "hits": len(tree.hits_t), "camera": frame,
        "background": list(scene.background),
        "objects": [item.name for item in scene.objects],
        "lights": [
            {"name": light.name, "position": list(light.position), "colour": list(light.colour)}
            for light in scene.lights
        ],
        "materials": tables.material_rows(tree, scene),
        "patches": [
            tables.patch_row(p, extent, k in ended, scene) for k, p in enumerate(patches)
        ],
        "images": depth_images(tree, frame, n, patches, extent, signature, signature_of),
        "tables": {
            "signature": [list(row) for row in signature],
            "surface": [list(row) for row in surface],
            "visibility": [list(row if row[2] != 1 else row[:2]) for row in seen],
        },
        "steps": {
            "normal": normal_step(), "split": SPLIT,
            "blocked": 2 * min(POINT_SHARE * extent, MOST_POINT),
        },
    }  # fmt: skip
    return header, symbols


def picture_vectors(scene: Scene) -> dict[str, Any]:
    """Eye and view as the scene gives them, and the vectors that span the picture."""
    camera, spread = scene.camera, half_width(scene.camera)
    right, up, forward = camera_frame(camera)
    return {
        "eye": list(camera.eye), "target": list(camera.target), "up": list(camera.up),
        "fov": camera.fov, "forward": (forward + 0.0).tolist(),
        "right": (right * spread + 0.0).tolist(), "down": (-up * spread + 0.0).tolist(),
    }  # fmt: skip


def depth_images(
    tree: RayTree, frame: dict[str, Any], n: int, patches: list[Patch], extent: float,
    signature: list[tuple[int, ...]], signature_of: np.ndarray,
) -> list[dict[str, Any]]:  # fmt: skip
    """One a key (object, how often the ray met it before), with its step of 1 / z."""
    slant = rebuild.length(rebuild.camera_steps(frame, n))
    error: dict[int, float] = {}
    for patch in patches:
        allowed = tables.allowed_error(patch, extent)
        error[patch.object] = min(allowed, error.get(patch.object, allowed))
    keys = sorted({key for hits in signature for key in keys_along(list(hits))})
    images: list[dict[str, Any]] = [{"object": thing, "turn": turn} for thing, turn in keys]
    along = images_along([list(hits) for hits in signature], images)
    ray, place, t = tables.drawn_hits(tree, frame["eye"])
    image_of = along[signature_of[ray], place]
    for image, here in zip(images, rows_of_each(image_of, len(images)), strict=True):
        allowed = error.get(image["object"], min(POINT_SHARE * extent, MOST_POINT))
        slants = slant[ray[here]]
        image["step"] = depth_step(t[here] / slants, slants, allowed)
    return images
