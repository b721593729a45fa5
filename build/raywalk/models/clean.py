"""A model made fit for tracing: corners joined, what is no triangle dropped, parts turned outwards.

In the model's own coordinates; what of it stands in a scene is another matter.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from raywalk.models.faults import ModelFault
from raywalk.models.model import Model
from raywalk.models.shells import Turned, turn_outwards
from raywalk.models.slivers import without_slivers
from raywalk.models.weld import sorted_rows, weld_cracks, weld_equal

# A triangle thinner than this share of its longest edge has no direction left in float64:
# its normal would be rounding. Slivers down to aspect 1e10 stay.
FLATTEST = 1e-14
# A corner further out than this many times the usual distance (1e30 in a broken export) leaves
# the rest of the mesh no digits.
FARTHEST = 1e12
MANY = 1 << 16  # triangles that are looked at together


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
        return np.asarray(self.vertices[self.shape.open_ends])


@np.errstate(over="ignore", invalid="ignore")  # places near the end of all numbers
def clean(model: Model, weld: float | None = None) -> Cleaned:
    """weld: nearer than this share of the model's size corners of open edges are one. Raises
    ModelFault if nothing is left."""
    vertices, faces = weld_equal(model.vertices, model.faces)
    vertices, faces, source, dropped = within_reach(vertices, faces)
    used = len(vertices)
    faces, count = weld_cracks(vertices, faces, weld, model.grain)
    faces, source, filled = without_slivers(vertices, faces, source, have_area(vertices, faces))
    keep, flat = worth_tracing(vertices, faces)
    if filled:
        flat["without area"] = flat.get("without area", 0) + filled
    faces, source, dropped = faces[keep], source[keep], dropped | flat
    del keep
    if not len(faces):
        why = ", ".join(f"{n} {reason}" for reason, n in dropped.items())
        raise ModelFault(
            model.path, "", "holds no usable triangle" + (f" ({why})" if why else ""),
            "export a mesh of triangles that have an area",
        )  # fmt: skip
    if count or flat:  # a corner that nothing uses any more must not move the model's middle
        faces, kept = _used_only(faces, len(vertices))
        vertices = vertices[kept]
    part = model.part_of() if model.part is None else model.part[source]
    shape = turn_outwards(vertices, faces, part)
    # While there were edges beside them, 32 bits were enough.
    faces, source = shape.faces.astype(np.int64), source.astype(np.int64)
    shape = replace(shape, faces=faces)
    return Cleaned(model, vertices, faces, source, shape.turned, shape, dropped, used, count)


def within_reach(
    vertices: np.ndarray, faces: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, dict[str, int]]:
    """Only vertices that some face uses, without faces that reach to infinity or next to it:
    vertices, faces, which those were, and how many were dropped why."""
    finite = np.isfinite(vertices).all(axis=1)[faces].all(axis=1)
    source = np.flatnonzero(finite).astype(np.int32)
    near = np.ones(len(source), bool)
    if len(source):
        kept = faces[source]
        some = kept[:: 1 + len(kept) // MANY]  # enough for a median, of which no digit counts
        middle = np.array([np.median(axis[some]) for axis in vertices.T])
        far = np.abs(vertices / 2 - middle / 2).max(axis=1)
        away = np.maximum(np.maximum(far[kept[:, 0]], far[kept[:, 1]]), far[kept[:, 2]])
        near = away <= FARTHEST * np.median(away[:: 1 + len(kept) // MANY])
        del kept, far, away
    source = source[near]
    faces, used = _used_only(faces[source], len(vertices))
    dropped = {"not finite": int((~finite).sum()), "too far out": int((~near).sum())}
    return vertices[used], faces, source, _counted(dropped)


def _used_only(faces: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Faces in numbers of the vertices that they use, and which (count,) bool those are."""
    used = np.zeros(count, bool)
    used[faces] = True
    return (np.cumsum(used, dtype=np.int32) - 1)[faces], used


def worth_tracing(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, dict[str, int]]:
    """Indices of faces that have an area and are there for the first time, and what was dropped."""
    keep = np.flatnonzero(have_area(vertices, faces))
    order, is_first = sorted_rows(np.sort(faces[keep], axis=1))
    first = order[is_first]
    dropped = {"without area": len(faces) - len(keep), "duplicates": len(keep) - len(first)}
    return keep[np.sort(first)], _counted(dropped)


def have_area(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """(f,) bool: whether a face's normal is more than rounding."""
    some = np.array_split(faces, 1 + len(faces) // MANY)
    return np.concatenate([_have_area(vertices, each) for each in some])


def _have_area(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    a, b, c = vertices[faces].transpose(1, 0, 2)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    longest = np.max([np.linalg.norm(e, axis=1) for e in (b - a, c - b, a - c)], axis=0)
    return np.asarray(area > FLATTEST * longest**2)


def _counted(dropped: dict[str, int]) -> dict[str, int]:
    return {reason: count for reason, count in dropped.items() if count}
