"""PLY, as text or binary in either order of bytes: polygons of any mixture, strips, colours.

Our own: plyfile is under the GPL, which would bind all of Raywalk; trimesh 5.2 cannot read binary
files of quads and triangles mixed, wants scipy where faces have colours, and says no line or value.
Format: Turk, "The PLY Polygon File Format", 1994.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from raywalk.models.faults import ModelFault
from raywalk.models.model import Model, PerCorner
from raywalk.models.ply_header import FLOATS, Element, Header, read_header
from raywalk.models.ply_rows import Rows, read_rows
from raywalk.models.polygons import triangulated

INDICES = ("vertex_indices", "vertex_index")
REDS = (("red", "green", "blue"), ("diffuse_red", "diffuse_green", "diffuse_blue"), ("r", "g", "b"))
TEXTURES = (("u", "v"), ("s", "t"), ("texture_u", "texture_v"))
FLOAT32 = 2.0**-23


def read_ply(path: Path, data: bytes) -> Model:
    """The model. Raises ModelFault with the line, or the element."""
    header = read_header(path, data)
    rows = read_rows(path, data, header)
    vertex = rows.get("vertex")
    if vertex is None or not all(name in vertex.single for name in "xyz"):
        raise ModelFault(
            path, "header", "there is no element `vertex` with x, y and z", "it is no mesh"
        )
    vertices = np.column_stack([vertex.single[name] for name in "xyz"])
    counts, corners, whose = _polygons(path, rows, len(vertices))
    triangles, polygon = triangulated(vertices, counts, corners)
    faces = corners[triangles]
    colours, colours_of = _colours(header, rows, faces, whose, polygon)
    normals = _columns(vertex, (("nx", "ny", "nz"),))
    places = _columns(vertex, TEXTURES)
    return Model(
        path, _name(header), vertices, faces,
        normals=None if normals is None else PerCorner(normals, faces),
        texture_places=None if places is None else PerCorner(places, faces),
        colours=colours, colours_of=colours_of, ignored=tuple(_ignored(header)),
        grain=FLOAT32 if _is_float32(header.element("vertex")) else 0.0,
    )  # fmt: skip


def _name(header: Header) -> str:
    order = {"ascii": "as text", "binary_little_endian": "binary", "binary_big_endian": "binary"}
    return f"PLY, {order[header.format]}"


def _polygons(
    path: Path, rows: dict[str, Rows], known: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray | None]:
    """Corners of each polygon, all in a row, and which face each was; None for strips. Takes the
    lists out of `rows`: of a large file they are most of it."""
    face, strips = rows.get("face"), rows.get("tristrips")
    listed = next((face.lists.pop(n) for n in INDICES if n in face.lists), None) if face else None
    whose: np.ndarray | None = None
    if listed is not None and len(listed.counts):
        counts, corners = listed.counts, listed.values
        keep = counts >= 3
        whose = np.flatnonzero(keep)
        if not keep.all():
            counts, corners = counts[keep], corners[np.repeat(keep, counts)]
    elif strips is not None:
        values = next((strips.lists[n].values for n in INDICES if n in strips.lists), np.zeros(0))
        corners = cut_strips(values.astype(np.int64)).reshape(-1)
        counts = np.full(len(corners) // 3, 3)
    else:
        raise ModelFault(
            path, "header", "there is no element `face`: it is a cloud of points",
            "export a mesh of polygons",
        )  # fmt: skip
    if not len(counts):
        raise ModelFault(path, "", "no face has three corners", "export a mesh of polygons")
    beyond = np.flatnonzero(~((corners >= 0) & (corners < known)))  # and what is no number
    if len(beyond):
        at = int(np.searchsorted(np.cumsum(counts), beyond[0], side="right"))
        at = at if whose is None else int(whose[at])
        raise ModelFault(
            path, f"face {at}",
            f"it names vertex {corners[beyond[0]]:.17g}, and there are 0 to {known - 1}",
            "the file is damaged: export the model again",
        )  # fmt: skip
    return counts, corners.astype(np.int32), whose


def cut_strips(values: np.ndarray) -> np.ndarray:
    """(t, 3): every three corners in a row, each second one turned; -1 begins a strip anew."""
    if len(values) < 3:
        return np.empty((0, 3), np.int64)
    trio = np.column_stack([values[:-2], values[1:-1], values[2:]])
    place = np.arange(len(values))
    begun = np.maximum.accumulate(np.where(values < 0, place + 1, 0))
    odd = (place[:-2] - begun[:-2]) % 2 == 1
    trio[odd] = trio[odd][:, [1, 0, 2]]
    return trio[(trio != -1).all(axis=1)]


def _colours(
    header: Header, rows: dict[str, Rows], faces: np.ndarray, whose: np.ndarray | None,
    polygon: np.ndarray,
) -> tuple[PerCorner | None, str]:  # fmt: skip
    """Of faces, if they have some, else of vertices."""
    for name in ("face", "vertex"):
        table = _columns(rows[name], REDS) if name in rows else None
        if table is None or (name == "face" and whose is None):
            continue
        red = next(names[0] for names in REDS if names[0] in rows[name].single)
        kind = next(p.kind for p in header.element(name).properties if p.name == red)
        most = 1.0 if kind in FLOATS else float(np.iinfo(np.dtype(kind)).max)
        table = np.clip(np.nan_to_num(table / most), 0.0, 1.0)
        if name == "vertex":
            return PerCorner(table, faces), "vertices"
        assert whose is not None
        return PerCorner(table, np.repeat(whose[polygon][:, None], 3, axis=1)), "faces"
    return None, ""


def _columns(rows: Rows, choices: tuple[tuple[str, ...], ...]) -> np.ndarray | None:
    for names in choices:
        if all(name in rows.single for name in names):
            return np.column_stack([rows.single[name] for name in names])
    return None


def _is_float32(vertex: Element) -> bool:
    return any(p.name in "xyz" and p.kind == "f4" for p in vertex.properties)


def _ignored(header: Header) -> list[str]:
    known = ("vertex", "face", "tristrips")
    return [
        f"its `{e.name}` is not read" for e in header.elements if e.name not in known and e.count
    ]
