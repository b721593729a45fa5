"""Ways through a scene that a worksheet can follow: clear of what paper has no equation for."""

from __future__ import annotations

import numpy as np

from raywalk.scene.on_paper import equation
from raywalk.scene.placement import placement
from raywalk.trace.wavefront import Tracer

DECIMALS = 2  # of a printed box, which is rounded outwards
FAR = 1e4  # a ray that leaves is followed so far


def solid_boxes(tracer: Tracer) -> dict[int, np.ndarray]:
    """(2, 3) lowest and highest corner, by object: of meshes, and of shapes that were moved so that
    their equation is no longer one that fits a line."""
    boxes = {
        mesh.index: np.array([mesh.bvh.low[0], mesh.bvh.high[0]]) + mesh.centre
        for mesh in tracer.compiled.meshes
    }
    for k, obj in enumerate(tracer.scene.objects):
        if k not in boxes and equation(obj) is None:
            linear, centre = placement(obj)
            half = np.abs(linear).sum(axis=1)  # canonical shapes lie between -1 and 1
            boxes[k] = np.array([centre - half, centre + half])
    step = 10.0**-DECIMALS
    return {
        k: np.array([np.floor(low / step) * step, np.ceil(high / step) * step]).round(DECIMALS)
        for k, (low, high) in sorted(boxes.items())
    }


def is_clear(origin: np.ndarray, way: np.ndarray, boxes: list[np.ndarray]) -> bool:
    """Whether the stretch from origin (3,) over way (3,) touches none of the boxes."""
    return not any(_touches(origin, way, *box) for box in boxes)


def _touches(origin: np.ndarray, way: np.ndarray, low: np.ndarray, high: np.ndarray) -> bool:
    near, far = 0.0, 1.0
    for k in range(3):
        if way[k] == 0.0:
            if not low[k] <= origin[k] <= high[k]:
                return False
            continue
        ends = sorted(((low[k] - origin[k]) / way[k], (high[k] - origin[k]) / way[k]))
        near, far = max(near, ends[0]), min(far, ends[1])
    return near <= far
