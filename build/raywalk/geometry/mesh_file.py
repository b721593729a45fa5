"""A mesh object of a scene as clean float64 triangles, where it stands."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, partial

import numpy as np

from raywalk.errors import SourceError, SourceErrors
from raywalk.geometry.mesh_corners import at_corners
from raywalk.geometry.mesh_normals import (
    averaged_normals,
    creased_normals,
    grouped_normals,
    own_normals,
)
from raywalk.geometry.mesh_world import in_world, off_world
from raywalk.models.clean import Cleaned, worth_tracing
from raywalk.models.edges import balanced, edges_of, open_edges
from raywalk.models.faults import ModelFault
from raywalk.models.kept import read_cleaned
from raywalk.models.pieces import chosen
from raywalk.scene.model import Base, Scene, SceneObject
from raywalk.scene.shapes import Mesh


@dataclass(frozen=True)
class Triangles:
    """Triangles in the world's directions and scale, around `centre`."""

    centre: np.ndarray  # (3,) world
    vertices: np.ndarray  # (v, 3) relative to centre
    faces: np.ndarray  # (f, 3) int64
    normals: np.ndarray | None  # (n, 3) unit normals; None if flat
    normal_rows: np.ndarray  # (f, 3) int64: of each corner; `faces` where each vertex has one
    colours: np.ndarray | None  # (f, 3, 3) of each corner, where the file's are shown
    places: np.ndarray | None  # (f, 3, 2) of each corner in a texture's picture, where one is
    closed: bool
    layered: bool  # closed shells of it lie in one another, or overlap
    dropped: dict[str, int]  # reason -> triangles
    world: np.ndarray  # (v, 3) the vertices in the world, where others share them
    world_rest: np.ndarray  # (v, 3) what float64 leaves over of that
    off: float  # how far the vertices round the centre are off them at most

    @property
    def corners(self) -> np.ndarray:
        """(f, 3, 3) rows a, b, c relative to centre."""
        return np.ascontiguousarray(self.vertices[self.faces])


def load_triangles(scene: Scene, obj: SceneObject) -> Triangles:
    """Reads, cleans, subdivides and places one mesh object. Raises SourceErrors if unusable."""
    shape = obj.shape
    assert isinstance(shape, Mesh)
    try:
        return _placed(obj, shape, read_cleaned(shape.path, shape.weld))
    except ModelFault as fault:
        key = f'objects "{obj.name}".{"file" if shape.model == fault.path.name else "model"}'
        raise SourceErrors(
            [SourceError(scene.path, key, fault.message, hint=fault.remedy)]
        ) from None


@np.errstate(over="ignore", invalid="ignore")  # places near the end of all numbers
def _placed(obj: SceneObject, shape: Mesh, cleaned: Cleaned) -> Triangles:
    vertices, faces = cleaned.vertices, cleaned.faces
    if shape.subdivide:
        vertices, faces = _subdivided(cleaned, shape.subdivide)
    row = np.repeat(np.arange(len(cleaned.faces)), len(faces) // len(cleaned.faces))
    child = np.arange(len(faces))
    closed, dropped = cleaned.shape.closed, cleaned.dropped
    if shape.piece:
        mine = chosen(cleaned, shape.piece)[row]
        faces, row, child = faces[mine], row[mine], child[mine]
        closed = balanced(edges_of(faces))
        dropped = dropped if shape.piece.first else {}
        vertices, faces = _compact(vertices, faces)
    middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    linear, offset = obj.transform[:3, :3], obj.transform[:3, 3]
    placed = (vertices - middle) @ linear.T
    kept, flattened = worth_tracing(placed, faces)
    if not len(kept):
        raise ModelFault(
            shape.path, "", "holds no usable triangle once the object's transform is applied",
            "scale it less unevenly",
        )  # fmt: skip
    faces, row, child = faces[kept], row[kept], child[kept]
    mirrored = bool(np.linalg.det(linear) < 0)
    if mirrored:  # keep normals outward
        faces = faces[:, ::-1]
    centre, rest = _centre(linear, middle, offset)
    world, world_rest = in_world(linear, offset, vertices)
    base = obj.base or Base()
    values_of = partial(at_corners, cleaned, shape.subdivide, child, mirrored)
    normals, rows = _normals(shape, cleaned, placed, faces, row, linear)
    return Triangles(
        centre=centre,
        vertices=placed + rest,
        faces=np.ascontiguousarray(faces),
        normals=normals,
        normal_rows=np.ascontiguousarray(rows),
        colours=values_of(cleaned.model.colours) if base.colours else None,
        places=values_of(cleaned.model.texture_places) if base.texture else None,
        closed=closed and not flattened,
        layered=cleaned.shape.layered,
        dropped={**dropped, **flattened},
        world=world,
        world_rest=world_rest,
        off=off_world(placed + rest, centre, world, world_rest),
    )


@lru_cache(2)  # a mesh that moves is placed anew at each stop of a sweep, and is smooth before that
def _subdivided(cleaned: Cleaned, rounds: int) -> tuple[np.ndarray, np.ndarray]:
    """By Loop's scheme, shell by shell: at a corner where two touch neither pulls at the other."""
    import trimesh  # only here: reading needs none of it

    shells, vertices = cleaned.shape.shells, cleaned.vertices
    groups = [cleaned.faces] if len(shells) == 1 else [cleaned.faces[s.triangles] for s in shells]
    made, count = [], 0
    try:
        for group in groups:
            used, index = (vertices, group) if len(shells) == 1 else _compact(vertices, group)
            smooth = trimesh.Trimesh(used, index, process=False)
            smooth = smooth.subdivide_loop(iterations=rounds)
            made.append((np.asarray(smooth.vertices, float), np.asarray(smooth.faces) + count))
            count += len(smooth.vertices)
    except ValueError:
        raise ModelFault(
            cleaned.model.path, "", "it has edges at which more than two triangles meet, and "
            "cannot be subdivided", "leave `subdivide` out",
        ) from None  # fmt: skip
    faces = np.concatenate([each for _, each in made])
    # Back into the order of the triangles that they were made of.
    whose = np.repeat(
        np.concatenate([s.triangles for s in shells]), len(faces) // len(cleaned.faces)
    )
    order = np.argsort(whose, kind="stable") if len(shells) > 1 else np.arange(len(faces))
    return np.concatenate([each for each, _ in made]), faces[order]


def _compact(vertices: np.ndarray, faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    used, index = np.unique(faces, return_inverse=True)
    return vertices[used], index.reshape(-1, 3)


def _normals(
    shape: Mesh, cleaned: Cleaned, placed: np.ndarray, faces: np.ndarray, row: np.ndarray,
    linear: np.ndarray,
) -> tuple[np.ndarray | None, np.ndarray]:  # fmt: skip
    """Unit normals and each corner's row; None of what is flat. row: (f,) of each face in what was
    cleaned."""
    model, source = cleaned.model, cleaned.source[row]
    if shape.smooth is False:
        return None, faces
    if shape.subdivide:
        return averaged_normals(placed, faces), faces
    if model.flat and not shape.smooth:
        return None, faces
    if model.normals is not None:
        rows = model.normals.row[source]
        # The winding of these faces, not of the file's.
        is_back = cleaned.turned[row] ^ bool(np.linalg.det(linear) < 0)
        rows = np.where(is_back[:, None], rows[:, ::-1], rows)
        return own_normals(model.normals.table, rows, placed[faces], linear)
    if model.smoothing is not None:
        return grouped_normals(placed, faces, model.smoothing[source])
    return creased_normals(placed, faces, shape.crease)


def _centre(
    linear: np.ndarray, middle: np.ndarray, offset: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """linear @ middle + offset, each (3,), and what its rounding leaves over (1e-9 at 1e7)."""
    exact = [
        sum(
            (Fraction(a) * Fraction(m) for a, m in zip(row, middle.tolist(), strict=True)),
            Fraction(b),
        )
        for row, b in zip(linear.tolist(), offset.tolist(), strict=True)
    ]
    centre = [float(each) for each in exact]
    rest = [float(each - Fraction(c)) for each, c in zip(exact, centre, strict=True)]
    return np.array(centre), np.array(rest)


def where_open(triangles: Triangles) -> str:
    """How many edges are open, and where the first of them is: (x, y, z) in the world."""
    ends = open_edges(edges_of(triangles.faces), triangles.faces)
    if not len(ends):
        return "its triangles do not agree on which side is outside"
    place = triangles.vertices[ends].mean(axis=1) + triangles.centre
    first = place[np.lexsort(place.T)[0]]
    place = ", ".join(f"{value:.6g}" for value in np.round(first, 9) + 0.0)
    return f"{len(ends)} open edge{'s' if len(ends) > 1 else ''}, the first at [{place}]"
