"""Both programs' rays of one pixel as a drawing: lines over the scene in clay."""

from __future__ import annotations

from io import BytesIO
from itertools import pairwise
from typing import Any

import numpy as np
from PIL import Image

from raywalk.mistake_pages.observer import (
    SAMPLES,
    View,
    along,
    best_view,
    clay_picture,
    seen_from,
)
from raywalk.mistake_pages.segments import Segment, segments_of
from raywalk.mistake_pages.walked import Walked
from raywalk.scene.model import Scene

SIDE = 480  # the drawing's units across
CLAY = 160  # pixels across: it is soft behind the lines
QUALITY = 60  # of lossy WebP: it is no picture of the scene, only where things are


def figure_of(scene: Scene, right: Walked, wrong: Walked) -> tuple[dict[str, Any], bytes]:
    """The drawing as data, and its ground as WebP."""
    segments = segments_of(right, wrong)
    view = seen_from(scene, best_view(scene, segments), CLAY)
    eye = view.project(np.array([scene.camera.eye]))[0]
    lamps = [light.position for light in scene.lights] if len(scene.lights) < 5 else []
    at = list(view.project(np.array(lamps))) if lamps else []
    points = np.array([end for each in segments for end in (each.start, each.end)])
    middle = (points.min(axis=0) + points.max(axis=0)) / 2
    reach = float(np.linalg.norm(points - middle, axis=1).max())
    drawing = {
        "side": SIDE,
        "lines": [piece for each in segments for piece in pieces(view, each)],
        "eye": _placed(eye),
        "lamps": [_placed(place) for place in at if 0 <= place.min() and place.max() <= 1],
    }
    return drawing, webp(clay_picture(view, middle, reach))


def pieces(view: View, segment: Segment) -> list[dict[str, Any]]:
    """A line where it is seen and where something stands before it."""
    points = along(segment)
    places, hidden = view.project(points), view.is_hidden(points)
    hidden[-1] = hidden[-2]  # the end lies on what it meets
    borders = [0, *(np.flatnonzero(np.diff(hidden)) + 1).tolist(), SAMPLES - 1]
    return [
        {
            "from": _placed(places[a]), "to": _placed(places[b]), "kind": segment.kind,
            "who": segment.who, "hidden": bool(hidden[a]), "ends": b == SAMPLES - 1,
        }
        for a, b in pairwise(borders)
        if b > a
    ]  # fmt: skip


def webp(rgba: np.ndarray) -> bytes:
    """A lossy picture with what is clear in it."""
    out = BytesIO()
    Image.fromarray(rgba, "RGBA").save(out, "WEBP", quality=QUALITY, method=4, alpha_quality=95)
    return out.getvalue()


def _placed(place: np.ndarray) -> list[float]:
    return [round(float(part) * SIDE, 1) for part in place]
