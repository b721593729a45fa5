"""Which normals a mesh is shaded with: its file's own, its groups', or averaged ones."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.geometry.by_hand import affine, mesh_of, scene_of, unit
from tests.models.solids import QUADS, cube, obj_text, triangles, written

from raywalk.geometry.compiled import CompiledScene, Hits, rays_from
from raywalk.scene.model import SceneObject

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
    smooth: bool = True,
) -> Hits:  # fmt: skip
    """2,000 rays from all around at a smooth mesh of this text, that hit it."""
    mesh = mesh_of(written(folder / "made.obj", text), smooth)
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
    """Averaged over right angles, unless smooth = false, which goes before normals of its own."""
    bare = obj_text(cube(), triangles())
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
