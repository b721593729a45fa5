"""Mesh files as people have them: what is unusable is dropped, what is inside out put right."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from tests.geometry.by_hand import affine, mesh_of, scene_of, unit, write_ply

from raywalk.errors import SourceErrors
from raywalk.geometry.compiled import CompiledScene, rays_from
from raywalk.geometry.containment import objects_around, winding_number
from raywalk.geometry.mesh_file import Triangles, load_triangles
from raywalk.scene.model import SceneObject
from raywalk.scene.shapes import Box, Plane, Sphere


def load(path: Path, smooth: bool = False, transform: np.ndarray | None = None) -> Triangles:
    matrix = np.eye(4) if transform is None else transform
    obj = SceneObject("mesh", mesh_of(path, smooth), 0, matrix)
    return load_triangles(scene_of([obj]), obj)


def cube() -> tuple[np.ndarray, np.ndarray]:
    """8 vertices, 12 faces, outward; the cube |x|, |y|, |z| <= 1."""
    made = trimesh.creation.box((2, 2, 2))
    return np.asarray(made.vertices, float), np.asarray(made.faces)


def normals(triangles: Triangles) -> np.ndarray:
    a, b, c = triangles.corners.transpose(1, 0, 2)
    return np.cross(b - a, c - a)


def is_outward(triangles: Triangles) -> bool:
    """Of a mesh that is convex round its centre."""
    return bool(((triangles.corners.mean(axis=1)) * normals(triangles) > 0).any(axis=1).all())


def test_a_clean_file_loses_nothing(tmp_path: Path) -> None:
    """All 12 faces of a cube stay, closed, with the place and size the file gives them."""
    found = load(write_ply(tmp_path / "cube.ply", *cube()))
    assert (len(found.faces), found.closed, found.dropped) == (12, True, {})
    assert np.sort((found.corners + found.centre).reshape(-1, 3), axis=0)[[0, -1]].tolist() == [
        [-1, -1, -1], [1, 1, 1],
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("corner", "reason"),
    [
        ([np.nan, 0, 0], "not finite"),
        ([np.inf, 0, 0], "not finite"),
        ([1e30, 0, 0], "too far out"),
        ([1e300, -1e300, 0], "too far out"),
    ],
)
def test_a_corner_that_is_no_place_is_dropped_by_name_and_count(
    tmp_path: Path, corner: list[float], reason: str
) -> None:
    """Two triangles to nowhere beside a cube: they are counted, and the cube is met as before."""
    vertices, faces = cube()
    path = write_ply(
        tmp_path / "broken.ply",
        np.concatenate([vertices, [corner]]),
        np.concatenate([faces, [[0, 1, 8], [2, 8, 3]]]),
    )
    found = load(path)
    assert found.dropped == {reason: 2}
    assert found.centre.tolist() == [0, 0, 0]
    assert (len(found.faces), found.closed) == (12, True)


def test_flat_and_doubled_triangles_are_dropped_by_name_and_count(tmp_path: Path) -> None:
    """A triangle with a corner twice, one with three corners in line, and one given again in
    another order are dropped; the cube stays closed."""
    vertices, faces = cube()
    middle = (vertices[faces[0][0]] + vertices[faces[0][1]]) / 2
    path = write_ply(
        tmp_path / "flat.ply",
        np.concatenate([vertices, [middle]]),
        np.concatenate([faces, [[0, 0, 1], [faces[0][0], faces[0][1], 8], np.roll(faces[3], 1)]]),
    )
    found = load(path)
    assert found.dropped == {"without area": 2, "duplicates": 1}
    assert (len(found.faces), found.closed) == (12, True)


def test_a_vertex_that_no_triangle_uses_moves_nothing(tmp_path: Path) -> None:
    """Stray points in a scan do not shift the mesh's centre, which would cost it digits."""
    vertices, faces = cube()
    path = write_ply(tmp_path / "stray.ply", np.concatenate([vertices, [[1e15, 1, 1]]]), faces)
    found = load(path)
    assert found.centre.tolist() == [0, 0, 0]
    assert np.abs(found.corners).max() == 1


def test_a_file_without_a_usable_triangle_is_an_error_that_says_so(tmp_path: Path) -> None:
    """It names the object and the file, and what is wrong."""
    path = write_ply(
        tmp_path / "line.ply", np.array([[0, 0, 0], [1, 0, 0], [2.0, 0, 0]]), np.array([[0, 1, 2]])
    )
    with pytest.raises(SourceErrors, match=r"line\.ply holds no usable triangle"):
        load(path)


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("inside_out", [False, True])
def test_normals_of_a_closed_mesh_point_outwards(
    tmp_path: Path, inside_out: bool, mirrored: bool
) -> None:
    """However the file winds its triangles, and whatever mirror the scene puts on it: else glass
    would be entered where it is left."""
    vertices, faces = cube()
    path = write_ply(tmp_path / "cube.ply", vertices, faces[:, ::-1] if inside_out else faces)
    matrix = affine(np.diag([1, 1, -1 if mirrored else 1]), (3, 0, 0))
    assert is_outward(load(path, transform=matrix))


def test_corners_that_only_look_different_are_joined(tmp_path: Path) -> None:
    """Triangles with corners of their own, some with -0.0: the mesh is closed all the same."""
    vertices, faces = cube()
    soup = (vertices + 1)[faces].reshape(-1, 3)
    soup[::2] = np.where(soup[::2] == 0, -0.0, soup[::2])
    path = write_ply(tmp_path / "soup.ply", soup, np.arange(36).reshape(-1, 3))
    found = load(path)
    assert (found.closed, len(found.faces)) == (True, 12)


def test_smooth_normals_are_unit_and_those_of_the_sphere(
    rng: np.random.Generator, tmp_path: Path
) -> None:
    """On a ball of 1,280 triangles the interpolated normal is the radius to 1e-2 (the square of
    an edge's angle, 0.14, over 2), and never looks away from the ray."""
    made = trimesh.creation.icosphere(3)
    path = write_ply(tmp_path / "ball.ply", np.asarray(made.vertices), np.asarray(made.faces))
    compiled = CompiledScene(scene_of([mesh_of(path, smooth=True)]))
    origin = 4 * unit(rng.normal(size=(4000, 3)))
    direction = unit(0.5 * rng.normal(size=(4000, 3)) - origin)
    hits = compiled.hits(rays_from(origin, direction))
    met = hits.object >= 0
    normal, point = hits.normal[met], hits.point[met]
    assert np.abs(np.linalg.norm(normal, axis=1) - 1).max() < 4e-16
    facing = (normal * direction[met]).sum(axis=1)
    assert facing.max() < 1e-15
    steep = facing < -0.2  # nearer to the outline normals are bent towards the ray
    assert np.linalg.norm(np.cross(normal, unit(point)), axis=1)[steep].max() < 1e-2


def test_a_points_containers_are_listed_from_the_largest(tmp_path: Path) -> None:
    """A point in a ball in a mesh cube in water (a half-space) lies in all three; on a border it
    lies in neither side; open shapes contain nothing."""
    path = write_ply(tmp_path / "cube.ply", *cube())
    scene = scene_of(
        [
            Sphere((0, 0, 0), 0.5),
            mesh_of(path),
            Plane((0, 2, 0), (0, 1, 0)),
            Box((4, 4, 4), (5, 5, 5)),
        ]
    )
    compiled = CompiledScene(scene)
    around = {
        (0.1, 0.2, 0.3): [2, 1, 0],
        (0.6, 0.6, 0.6): [2, 1],
        (3.0, 0.0, 0.0): [2],
        (3.0, 3.0, 3.0): [],
        (4.5, 4.5, 4.5): [3],
        (0.0, 2.0, 0.0): [],
    }
    for point, expected in around.items():
        assert objects_around(compiled, np.array(point)) == expected


def test_the_winding_number_is_whole(rng: np.random.Generator) -> None:
    """1 inside the bunny and 0 outside, for points anywhere off its surface, among them points
    from which a vertex, an edge and a face's plane lie in any direction one may probe."""
    made = trimesh.creation.torus(1.0, 0.3, 48, 24)
    corners = np.asarray(made.triangles)
    for point in rng.uniform(-1.4, 1.4, size=(200, 3)) * [1, 1, 0.4]:
        ring = np.hypot(point[0], point[1]) - 1
        height = np.hypot(ring, point[2])
        if abs(height - 0.3) > 0.02:  # facets stand 0.006 inside the round torus
            assert winding_number(corners, point) == pytest.approx(float(height < 0.3), abs=1e-12)
