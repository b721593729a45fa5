"""A model drawn from three sides, its open edges in red: where to mend it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from raywalk.models.clean import Cleaned
from raywalk.models.edges import edges_of, ends_of

SIDE, GAP = 480, 24  # pixels of a view, and around it
# Along which axes a view's columns and rows run: from the front, the side and above.
VIEWS = (("front (x, y)", 0, 1, 1.0), ("right (z, y)", 2, 1, -1.0), ("top (x, z)", 0, 2, 1.0))
EDGE, OPEN, PAPER = (200, 204, 210), (208, 32, 32), (255, 255, 255)
MOST_EDGES = 60_000  # grey ones that are drawn: more is a stain


def draw(cleaned: Cleaned, path: Path) -> None:
    """Writes a PNG. Raises OSError."""
    edges = edges_of(cleaned.faces)
    is_open = edges.uses % 2 == 1
    closed = np.flatnonzero(~is_open)
    closed = closed[:: max(1, len(closed) // MOST_EDGES)]
    inner = ends_of(edges, cleaned.faces, closed)
    corners = cleaned.vertices[cleaned.faces].reshape(-1, 3)
    low, size = corners.min(axis=0), float(np.ptp(corners, axis=0).max())
    middle = (low + corners.max(axis=0)) / 2
    picture = Image.new("RGB", (3 * SIDE + 4 * GAP, SIDE + 2 * GAP), PAPER)
    pen = ImageDraw.Draw(picture)
    for k, (name, across, up, sign) in enumerate(VIEWS):
        left = GAP + k * (SIDE + GAP)
        place = (cleaned.vertices - middle) / size * SIDE
        x = left + SIDE / 2 + sign * place[:, across]
        y = GAP + SIDE / 2 - place[:, up] * (1.0 if up == 1 else -1.0)
        for ends, colour, width in ((inner, EDGE, 1), (cleaned.shape.open_ends, OPEN, 3)):
            for a, b in ends.tolist():
                pen.line((x[a], y[a], x[b], y[b]), colour, width)
        pen.text((left, GAP / 3), name, (60, 60, 60))
    picture.save(path, "PNG")
