"""A model made fit for tracing: corners joined, what is no triangle dropped, parts turned outwards.

In the model's own coordinates; what of it stands in a scene is another matter.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from raywalk.models.edges import edges_of, open_edges
from raywalk.models.faults import ModelFault
from raywalk.models.model import Model
from raywalk.models.shells import Turned, turn_outwards
from raywalk.models.weld import weld_cracks, weld_equal

# A triangle thinner than this share of its longest edge has no direction left in float64:
# its normal would be rounding. Slivers down to aspect 1e10 stay.
FLATTEST = 1e-14
# A corner further out than this many times the usual distance (1e30 in a broken export) leaves
# the rest of the mesh no digits.
FARTHEST = 1e12


@dataclass(frozen=True, eq=False)
class Cleaned:
    """What is left of a model, and what was done to it. f triangles."""

    model: Model
    vertices: np.ndarray  # (v, 3)
    faces: np.ndarray  # (f, 3) int64
    source: np.ndarray  # (f,) int64: which of the model's triangles each was
    turned: np.ndarray  # (f,) bool: wound the other way than there
    shape: Turned
    dropped: dict[str, int]  # reason -> triangles
    used: int  # corners at different places in the file, that triangles use
    joined: int  # of them, that were joined with a near one

    @property
    def open_edges(self) -> np.ndarray:
        """(k, 2, 3) ends of edges at which a surface ends."""
        return np.asarray(self.vertices[open_edges(edges_of(self.faces))])


@np.errstate(over="ignore", invalid="ignore")  # places near the end of all numbers
def clean(model: Model, weld: float | None = None) -> Cleaned:
    """weld: nearer than this share of the model's size corners of open edges are one. Raises
    ModelFault if nothing is left."""
    vertices, faces = weld_equal(model.vertices, model.faces)
    vertices, faces, source, dropped = within_reach(vertices, faces)
    used = len(vertices)
    faces, count = weld_cracks(vertices, faces, weld, model.grain)
    keep, flat = worth_tracing(vertices, faces)
    faces, source, dropped = faces[keep], source[keep], dropped | flat
    if not len(faces):
        why = ", ".join(f"{n} {reason}" for reason, n in dropped.items())
        raise ModelFault(
            model.path, "", "holds no usable triangle" + (f" ({why})" if why else ""),
            "export a mesh of triangles that have an area",
        )  # fmt: skip
    if count or flat:  # a corner that nothing uses any more must not move the model's middle
        kept, index = np.unique(faces, return_inverse=True)
        vertices, faces = vertices[kept], index.reshape(-1, 3)
    shape = turn_outwards(vertices, faces, model.part_of()[source])
    return Cleaned(model, vertices, shape.faces, source, shape.turned, shape, dropped, used, count)


def within_reach(
    vertices: np.ndarray, faces: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, dict[str, int]]:
    """Only vertices that some face uses, without faces that reach to infinity or next to it:
    vertices, faces, which those were, and how many were dropped why."""
    finite = np.isfinite(vertices[faces]).all(axis=(1, 2))
    corners = vertices[faces[finite]]
    near = np.ones(len(corners), bool)
    if len(corners):
        away = np.abs(corners / 2 - np.median(corners, axis=(0, 1)) / 2).max(axis=(1, 2))
        near = away <= FARTHEST * np.median(away)
    source = np.flatnonzero(finite)[near]
    used, index = np.unique(faces[source], return_inverse=True)
    dropped = {"not finite": int((~finite).sum()), "too far out": int((~near).sum())}
    return vertices[used], index.reshape(-1, 3), source, _told(dropped)


def worth_tracing(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, dict[str, int]]:
    """Indices of faces that have an area and are there for the first time, and what was dropped."""
    a, b, c = vertices[faces].transpose(1, 0, 2)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    longest = np.max([np.linalg.norm(e, axis=1) for e in (b - a, c - b, a - c)], axis=0)
    keep = np.flatnonzero(area > FLATTEST * longest**2)
    _, first = np.unique(np.sort(faces[keep], axis=1), axis=0, return_index=True)
    dropped = {"without area": len(faces) - len(keep), "duplicates": len(keep) - len(first)}
    return keep[np.sort(first)], _told(dropped)


def _told(dropped: dict[str, int]) -> dict[str, int]:
    return {reason: count for reason, count in dropped.items() if count}
