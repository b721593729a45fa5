"""Objects with a base colour for the rasterised stage: triangles with a colour at each vertex, so
that the viewer needs no picture to look them up in; and a small tile for an endless plane.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from raywalk.geometry.base_colour import BaseColours
from raywalk.geometry.corners import joined, of_quarters
from raywalk.geometry.texture_places import upright_on
from raywalk.scene.exact import rounded
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Shape

if TYPE_CHECKING:
    from raywalk.geometry.mesh_file import Triangles

FINE = 6000  # triangles from which on a textured mesh is not cut finer
MOST_ROUNDS = 5  # of cutting each triangle in four
AROUND, ALONG, ACROSS = 96, 48, 24  # cells round a shape, from pole to pole, and across a face
TILE = 64  # pixels of a plane's tile, across and down at most
INWARD = 1.0 - 1e-6  # a face's colours at its edges are its own


class Painted(NamedTuple):
    """Triangles f with vertices v, in the coordinates in which the object is drawn."""

    vertices: np.ndarray  # (v, 3)
    faces: np.ndarray  # (f, 3)
    normals: np.ndarray | None  # (v, 3); None if flat
    colours: np.ndarray  # (v, 3) uint8


def painted_mesh(obj: SceneObject, base: BaseColours, triangles: Triangles) -> Painted:
    """A mesh's triangles, relative to its centre; cut finer where a picture lies on few of them."""
    if by_vertex := _colours_by_vertex(obj, triangles):
        return by_vertex
    corners, source = triangles.corners, np.arange(len(triangles.faces))
    smooth = triangles.normals
    normals = None if smooth is None else smooth[triangles.normal_rows]
    if obj.base and obj.base.texture:
        for _ in range(MOST_ROUNDS):
            if len(corners) >= FINE:
                break
            corners, source = of_quarters(corners), np.repeat(source, 4)
            if normals is not None:
                normals = of_quarters(normals)
                normals /= np.maximum(np.linalg.norm(normals, axis=2, keepdims=True), 1e-12)
    flat = corners.reshape(-1, 3)
    # From a little within, or a face's colour would be its neighbour's at its edges.
    within = (INWARD * corners + (1.0 - INWARD) * corners.mean(axis=1, keepdims=True)).reshape(
        -1, 3
    )
    found = base.on_mesh(obj, triangles, triangles.corners, np.repeat(source, 3), within)
    return _painted(flat, None if normals is None else normals.reshape(-1, 3), found)


def _colours_by_vertex(obj: SceneObject, triangles: Triangles) -> Painted | None:
    """The triangles as they are, if no picture lies on them and each vertex has one colour and one
    normal: so have scans, of millions of triangles."""
    vertices, faces, given = triangles.vertices, triangles.faces, triangles.colours
    normals = triangles.normals
    if given is None or (obj.base and obj.base.texture):
        return None
    if normals is not None and not np.array_equal(triangles.normal_rows, faces):
        return None
    corners = np.rint(255.0 * np.where(np.isfinite(given), given, 1.0)).astype(np.uint8)
    colours = np.zeros((len(vertices), 3), np.uint8)
    colours[faces] = corners
    return Painted(vertices, faces, normals, colours) if (colours[faces] == corners).all() else None


def painted_shape(obj: SceneObject, base: BaseColours) -> Painted:
    """A finite shape's surface in its canonical coordinates."""
    sheets = list(_sheets(obj.shape))
    points = np.concatenate([points[cells].reshape(-1, 3) for points, _, cells, _ in sheets])
    normals = np.concatenate([normals[cells].reshape(-1, 3) for _, normals, cells, _ in sheets])
    asked = np.concatenate([asked[cells].reshape(-1, 3) for _, _, cells, asked in sheets])
    return _painted(points, normals, base.on_shape(obj, asked))


def _painted(points: np.ndarray, normals: np.ndarray | None, found: np.ndarray) -> Painted:
    """Of corners (3 f, 3) with their base colours."""
    colours = np.rint(255.0 * found).astype(np.uint8)
    some = [] if normals is None else [normals]
    kept, faces = joined(points, colours, *some)
    return Painted(points[kept], faces, None if normals is None else normals[kept], colours[kept])


def plane_tile(obj: SceneObject, base: BaseColours) -> tuple[np.ndarray, np.ndarray]:
    """(h, w, 3) uint8 of a plane's picture, row 0 below, and (2, 3) world vectors whose products
    with the way from the plane's `point` are how many pictures it goes to the right and up."""
    texture = obj.base.texture if obj.base else None
    assert texture is not None
    pixels = base.pixels_of(texture)
    rows, columns = (np.arange(min(TILE, size)) for size in pixels.shape[:2])
    places = np.stack(np.meshgrid(
        (columns + 0.5) / len(columns), (rows + 0.5) / len(rows), indexing="xy"
    ), axis=2)  # fmt: skip
    steps = (pixels.shape[0] // len(rows), pixels.shape[1] // len(columns))
    tile = _mean_of_cells(pixels[::-1], places.shape[:2], steps)
    linear = rounded(obj.shape.placement()[0])
    across = np.stack(upright_on(linear[:, 1])) * np.array(texture.repeat)[:, None]
    return tile, across @ np.linalg.inv(obj.transform[:3, :3])


def _mean_of_cells(pixels: np.ndarray, size: tuple[int, ...], steps: tuple[int, int]) -> np.ndarray:
    """Each of size[0] x size[1] cells the mean of its first steps[0] x steps[1] pixels."""
    rows, columns = (
        np.floor(np.arange(count) * whole / count).astype(int)
        for count, whole in zip(size, pixels.shape[:2], strict=True)
    )
    total = np.zeros((*size, 3))
    for down in range(steps[0]):
        for right in range(steps[1]):
            total += pixels[np.ix_(rows + down, columns + right)]
    return np.rint(total / (steps[0] * steps[1])).astype(np.uint8)


# Points, unit normals, triangles, and where the colour is asked for.
Sheet = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]


def _sheets(shape: Shape) -> list[Sheet]:
    """The canonical surface as nets of points."""
    low, high = shape.canonical.ends or (1.0, 1.0)
    match shape.canonical.name:
        case "sphere":
            turn, rise = _net(AROUND, ALONG)
            a, b = 2.0 * np.pi * turn - np.pi, np.pi * (rise - 0.5)
            points = np.column_stack([np.cos(b) * np.sin(a), np.sin(b), np.cos(b) * np.cos(a)])
            return [(points, points, _cells(AROUND, ALONG), _off_seam(points, a, INWARD))]
        case "box":
            return [_face(axis, sign) for axis in range(3) for sign in (-1.0, 1.0)]
        case "disc":
            return [_round(0.0, 1.0, 1.0)]
        case "triangle":
            corners = np.array([[[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]])
            for _ in range(MOST_ROUNDS):
                corners = of_quarters(corners)
            points = corners.reshape(-1, 3)
            up = np.tile([0.0, 0.0, 1.0], (len(points), 1))
            return [(points, up, np.arange(len(points)).reshape(-1, 3), points)]
        case "cylinder" | "tube":
            side = _side(low, high)
            if shape.canonical.name == "tube":
                return [side]
            ends = [_round(1.0, high, 1.0)] + ([_round(-1.0, low, -1.0)] if low > 0 else [])
            return [side, *ends]
    raise ValueError(f"{shape.canonical.name} is drawn by itself")


def _net(across: int, down: int) -> tuple[np.ndarray, np.ndarray]:
    """Shares (n,) of a net of points, row by row."""
    u, v = np.meshgrid(np.linspace(0, 1, across + 1), np.linspace(0, 1, down + 1))
    return u.reshape(-1), v.reshape(-1)


def _cells(across: int, down: int) -> np.ndarray:
    """(f, 3) two triangles a cell of such a net, anticlockwise where v runs up from u."""
    corner = (np.arange(down)[:, None] * (across + 1) + np.arange(across)).reshape(-1)
    a, b, c, d = corner, corner + 1, corner + across + 2, corner + across + 1
    return np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def _off_seam(points: np.ndarray, angle: np.ndarray, share: float) -> np.ndarray:
    """The points at -z moved a little to the side from which the net comes there."""
    nudged = np.stack([np.sin(share * angle), np.cos(share * angle)], axis=1)
    wide = np.hypot(points[:, 0], points[:, 2])
    return np.column_stack([wide * nudged[:, 0], points[:, 1], wide * nudged[:, 1]])


def _face(axis: int, sign: float) -> Sheet:
    """Of a box."""
    u, v = (2.0 * share - 1.0 for share in _net(ACROSS, ACROSS))
    points = np.zeros((len(u), 3))
    points[:, axis], points[:, (axis + 1) % 3], points[:, (axis + 2) % 3] = sign, sign * u, v
    normals = np.zeros_like(points)
    normals[:, axis] = sign
    asked = INWARD * points
    asked[:, axis] = sign
    return points, normals, _cells(ACROSS, ACROSS), asked


def _round(z: float, radius: float, facing: float) -> Sheet:
    """A disc across the axis."""
    turn, out = _net(AROUND, ACROSS // 2)
    a, r = -2.0 * np.pi * facing * turn, radius * out
    points = np.column_stack([r * np.cos(a), r * np.sin(a), np.full(len(r), z)])
    normals = np.tile([0.0, 0.0, facing], (len(r), 1))
    asked = points * [INWARD, INWARD, 1.0]
    return points, normals, _cells(AROUND, ACROSS // 2), asked


def _side(low: float, high: float) -> Sheet:
    """Of a cylinder or cone about z, radius `low` at z = -1 and `high` at 1."""
    turn, rise = _net(AROUND, ACROSS)
    a, z = 2.0 * np.pi * turn, 2.0 * rise - 1.0
    wide = low + (high - low) * rise
    points = np.column_stack([wide * np.cos(a), wide * np.sin(a), z])
    slope = np.hypot(1.0, (high - low) / 2.0)
    normals = np.column_stack([np.cos(a), np.sin(a), np.full(len(a), (low - high) / 2.0)]) / slope
    normals[:, 2] = (low - high) / 2.0 / slope
    return points, normals, _cells(AROUND, ACROSS), points * [1.0, 1.0, INWARD]
