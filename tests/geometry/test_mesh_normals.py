"""Which normals a mesh is shaded with: its file's own, its groups', or averaged ones."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from tests.geometry.by_hand import affine, mesh_of, scene_of, unit
from tests.models.solids import QUADS, cube, obj_text, triangles, written

from raywalk.geometry.compiled import CompiledScene, Hits, rays_from
from raywalk.geometry.mesh_file import load_triangles
from raywalk.geometry.mesh_normals import averaged_normals, creased_normals, face_normals
from raywalk.scene.model import SceneObject
from raywalk.scene.read import read_scene

NORMALS = [(-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1)]


def die(inside_out: bool = False) -> str:
    """A cube with a normal for each of its faces."""
    vertices = obj_text(cube(), QUADS)
    vertices = vertices[: vertices.index("f ")]
    vertices += "".join(f"vn {x} {y} {z}\n" for x, y, z in NORMALS)
    faces = QUADS[:, ::-1] if inside_out else QUADS
    return vertices + "".join(
        "f " + " ".join(f"{k + 1}//{n + 1}" for k in face) + "\n" for n, face in enumerate(faces)
    )


def seen(
    folder: Path, text: str, rng: np.random.Generator, matrix: np.ndarray | None = None,
    smooth: bool = True, crease: float = 180.0,
) -> Hits:  # fmt: skip
    """2,000 rays from all around at a smooth mesh of this text, that hit it."""
    mesh = replace(mesh_of(written(folder / "made.obj", text), smooth), crease=crease)
    obj = SceneObject("made", mesh, 0, np.eye(4) if matrix is None else matrix)
    compiled = CompiledScene(scene_of([obj]))
    centre, size = compiled.meshes[0].centre, compiled.meshes[0].size
    origin = 4 * size * unit(rng.normal(size=(2000, 3)))
    aim = 0.4 * size * unit(rng.normal(size=(2000, 3)))
    hits = compiled.hits(rays_from(origin + centre, unit(aim - origin)))
    return hits.take(hits.object >= 0)


@pytest.mark.parametrize("inside_out", [False, True])
@pytest.mark.parametrize(
    "matrix",
    [np.eye(4), affine(np.diag([1, 2, -3]), (5, 0, 0)), affine([[0, 2, 1], [1, 0, 0], [0, 1, 1]])],
    ids=["as it is", "mirrored", "sheared"],
)
def test_a_die_with_its_own_normals_is_flat(
    rng: np.random.Generator, tmp_path: Path, inside_out: bool, matrix: np.ndarray
) -> None:
    """The shading normal is the face's to rounding (1e-15 by the inverse transpose), however the
    object is placed and the file is wound."""
    hits = seen(tmp_path, die(inside_out), rng, matrix)
    assert len(hits.t) > 1000
    assert np.abs(hits.normal - hits.geometric).max() < 4e-15


def test_without_them_it_is_shaded_round_or_flat_as_the_scene_says(
    rng: np.random.Generator, tmp_path: Path
) -> None:
    """Averaged over right angles where the scene says so (crease = 180), flat where it says
    nothing, and by smooth = false, which goes before normals of its own."""
    bare = obj_text(cube(), triangles())
    hits = seen(tmp_path, bare, rng, crease=40.0)
    assert np.abs(hits.normal - hits.geometric).max() < 4e-15
    hits = seen(tmp_path, bare, rng)
    assert np.abs(hits.normal - hits.geometric).max() > 0.3
    for text in (bare, die()):
        hits = seen(tmp_path, text, rng, smooth=False)
        assert np.array_equal(hits.normal, hits.geometric)


def test_smoothing_groups_are_smooth_in_themselves_only(
    rng: np.random.Generator, tmp_path: Path
) -> None:
    """`s off` makes a cube flat; four sides in one group are round about the axis, and their lids,
    in another, flat."""
    assert_flat = seen(tmp_path, "s off\n" + obj_text(cube(), QUADS), rng)
    assert np.abs(assert_flat.normal - assert_flat.geometric).max() < 1e-15
    text = obj_text(cube(), QUADS)
    lines = text.splitlines()
    sides = [lines[8 + k] for k in (0, 1, 4, 5)]
    grouped = [*lines[:8], "s 1", *sides, "s 2", lines[10], lines[11]]
    hits = seen(tmp_path, "\n".join(grouped), rng)
    lid = np.abs(hits.geometric[:, 1]) > 0.9
    assert np.abs(hits.normal - hits.geometric)[lid].max() < 1e-15
    assert np.abs(hits.normal[~lid][:, 1]).max() < 1e-15
    assert np.abs(hits.normal - hits.geometric)[~lid].max() > 0.3


def test_normals_that_are_none_cost_only_themselves(
    rng: np.random.Generator, tmp_path: Path
) -> None:
    """Of length 0, or looking inwards: the face's own stands in, or they are turned."""
    for broken in ("vn 0 0 0", "vn 0 -3 0"):
        hits = seen(tmp_path, die().replace("vn 0 1 0", broken), rng)
        assert np.abs(hits.normal - hits.geometric).max() < 4e-15


def prism(sides: int) -> tuple[np.ndarray, np.ndarray]:
    """A pipe's stump without normals, as CAD programs write parts: closed, z from 0 to 1."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(sides)])
    vertices = np.concatenate([ring, ring + np.array([0, 0, 1]), [[0, 0, 0], [0, 0, 1]]])
    faces = []
    for k in range(sides):
        a, b, foot, top = k, (k + 1) % sides, 2 * sides, 2 * sides + 1
        faces += [(a, b, sides + b), (a, sides + b, sides + a), (b, a, foot)]
        faces += [(sides + a, sides + b, top)]
    return vertices, np.array(faces)


def corner_normals(sides: int, crease: float) -> tuple[np.ndarray, np.ndarray]:
    """(f, 3, 3) normals at the corners of a prism, and its triangles' own (f, 3)."""
    vertices, faces = prism(sides)
    normals, rows = creased_normals(vertices, faces, crease)
    return normals[rows], face_normals(vertices[faces])


@pytest.mark.parametrize("sides", [9, 10, 24, 100])
def test_a_pipe_without_normals_is_round_with_flat_ends(sides: int) -> None:
    """Its sides turn by 40 degrees at most: at each corner the normal is radial, to rounding; the
    ends, at 90 degrees, are flat up to their rims."""
    normals, flat = corner_normals(sides, 40.0)
    is_end = np.abs(flat[:, 2]) > 0.5
    assert np.abs(normals[is_end] - flat[is_end][:, None]).max() < 1e-14
    vertices, faces = prism(sides)
    radial = vertices[faces[~is_end]] * [1, 1, 0]
    assert np.abs(normals[~is_end] - radial).max() < 1e-14


@pytest.mark.parametrize("sides", [4, 6, 8])
def test_a_part_with_sharp_edges_is_flat(sides: int) -> None:
    """Sides that turn by 45 degrees and more are faces, as a nut's are."""
    normals, flat = corner_normals(sides, 40.0)
    assert np.abs(normals - flat[:, None]).max() < 1e-14


@pytest.mark.parametrize("sides", [4, 8, 24])
def test_at_180_degrees_no_edge_is_sharp(sides: int) -> None:
    """The very numbers of a plain average."""
    vertices, faces = prism(sides)
    normals, rows = creased_normals(vertices, faces, 180.0)
    assert rows is faces
    assert (normals == averaged_normals(vertices, faces)).all()


def test_an_edge_that_fades_is_sharp_only_where_it_turns(rng: np.random.Generator) -> None:
    """A tent: two sheets that meet at a ridge of which one end lies flat. Where the triangles turn
    by less than the crease the corners share a normal, whatever the order of the triangles."""
    vertices = np.array(
        [[0, 0, 0], [1, 0, 0], [2, 0, 0.8], [0, 1, 0], [1, 1, 0], [2, 1, 0], [0, -1, 0], [1, -1, 0],
         [2, -1, 0]], float,
    )  # fmt: skip
    faces = np.array(
        [[0, 4, 3], [0, 1, 4], [1, 5, 4], [1, 2, 5], [6, 1, 0], [6, 7, 1], [7, 2, 1], [7, 8, 2]]
    )
    faces = faces[rng.permutation(len(faces))]
    normals, rows = creased_normals(vertices, faces, 40.0)
    at = {int(v): {tuple(np.round(normals[r], 12)) for r in rows[faces == v]} for v in range(9)}
    assert len(at[0]) == 1  # flat there
    assert len(at[2]) == 2  # the ridge's high end
    assert len(at[1]) in (1, 2)
    assert np.abs(np.linalg.norm(normals, axis=1) - 1).max() < 1e-15 * 4


@pytest.mark.parametrize(("crease", "sharp"), [(None, True), (60, True), (91, False), (180, False)])
def test_a_scene_says_what_is_sharp(tmp_path: Path, crease: float | None, sharp: bool) -> None:
    """A cube as STL, which has no normals of its own at its corners."""
    write_stl(tmp_path / "cube.stl", np.array(cube())[np.array(triangles())])
    given = "" if crease is None else f"crease = {crease}\n"
    path = tmp_path / "scene.toml"
    path.write_text(
        'version = 1\ntitle = "t"\nteaches = "t"\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n'
        f'[[objects]]\ntype = "mesh"\nfile = "cube.stl"\nmaterial = "white"\n{given}',
        encoding="utf-8",
    )
    scene = read_scene(path)
    made = load_triangles(scene, scene.objects[0])
    assert made.normals is not None
    flat = face_normals(made.corners)
    apart = np.abs(made.normals[made.normal_rows] - flat[:, None]).max()
    assert (apart < 1e-14) == sharp


def write_stl(path: Path, corners: np.ndarray) -> None:
    """Binary, of triangles (f, 3, 3)."""
    rows = np.zeros(len(corners), np.dtype([("n", "<f4", 3), ("at", "<f4", (3, 3)), ("x", "<u2")]))
    rows["at"] = corners
    path.write_bytes(bytes(80) + np.uint32(len(corners)).tobytes() + rows.tobytes())
