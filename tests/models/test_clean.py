"""What cleaning makes of models: corners joined, parts turned outwards, hollows kept."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from tests.models.solids import cube, obj_text, stl_bytes, triangles, volume, written

from raywalk.models.clean import Cleaned, clean
from raywalk.models.read import read_model


def cleaned(path: Path, weld: float | None = None) -> Cleaned:
    return clean(read_model(path), weld)


def of_obj(folder: Path, *solids: tuple[np.ndarray, np.ndarray]) -> Cleaned:
    """Solids one behind the other, each a part of its own name if it is not the only one."""
    text, first = "", 1
    for vertices, faces in solids:
        text += obj_text(vertices, faces, first)
        first += len(vertices)
    return cleaned(written(folder / "made.obj", text))


def flipped(faces: np.ndarray, chosen: list[int] | slice = slice(None)) -> np.ndarray:
    faces = faces.copy()
    faces[chosen] = faces[chosen][:, ::-1]
    return faces


def cracked(rng: np.random.Generator, size: float, place: float) -> np.ndarray:
    """Triangles of a cube whose corners each are off by a digit of float32."""
    corners = (cube(size / 2) + place)[triangles()].astype(np.float32)
    step = np.spacing(corners) * rng.integers(-1, 2, corners.shape)
    return (corners + step).astype(float)


@pytest.mark.parametrize(("size", "place"), [(13.7, 20.0), (1.0, 0.0), (0.01, 7.0), (2e3, 1e5)])
def test_cracks_of_the_last_digit_are_closed(
    rng: np.random.Generator, tmp_path: Path, size: float, place: float
) -> None:
    """A binary STL keeps 24 bits: corners that differ by one of them are one, however small the
    model is beside its place."""
    path = written(tmp_path / "made.stl", stl_bytes(cracked(rng, size, place)))
    fit = cleaned(path)
    assert (fit.shape.closed, len(np.unique(fit.faces)), len(fit.faces)) == (True, 8, 12)
    assert fit.joined == fit.used - 8 > 0
    assert not len(fit.open_edges)
    assert not cleaned(path, weld=0.0).shape.closed


def test_how_near_is_one_can_be_set(tmp_path: Path) -> None:
    """A lid 1e-4 above its box: open at the default of 1e-6 of the size, closed at 1e-3."""
    corners = cube()[triangles()]
    lid = (corners[:, :, 1] == 0.5).all(axis=1)
    corners[lid] += [0, 1e-4, 0]
    path = written(tmp_path / "made.stl", stl_bytes(corners))
    assert not cleaned(path).shape.closed
    assert len(cleaned(path).open_edges) == 8
    assert cleaned(path, weld=1e-3).shape.closed


def test_what_is_closed_is_not_joined(tmp_path: Path) -> None:
    """Two cubes 1e-9 apart stay two, and a cube of 1e-8 beside one of 1 stays a cube."""
    apart = of_obj(tmp_path, (cube(), triangles()), (cube(at=(1 + 1e-9, 0, 0)), triangles()))
    assert (len(apart.shape.shells), apart.joined, apart.shape.closed) == (2, 0, True)
    tiny = of_obj(tmp_path, (cube(), triangles()), (cube(1e-8, (2, 0, 0)), triangles()))
    assert (len(tiny.faces), tiny.joined, tiny.shape.closed) == (24, 0, True)


@pytest.mark.parametrize("seed", range(6))
def test_triangles_that_face_the_other_way_are_turned(tmp_path: Path, seed: int) -> None:
    """Whichever, and however many: the cube is closed, of volume 1, and what was turned is said."""
    rng = np.random.default_rng(seed)
    chosen = np.flatnonzero(rng.random(12) < rng.uniform(0.1, 0.9))
    fit = of_obj(tmp_path, (cube(), flipped(triangles(), chosen.tolist())))
    assert fit.shape.closed
    assert volume(fit.vertices, fit.faces) == pytest.approx(1, abs=1e-15)
    assert sorted(np.flatnonzero(fit.turned).tolist()) == chosen.tolist()


def test_each_part_is_turned_by_itself(tmp_path: Path) -> None:
    """Two cubes of which the left one is inside out: their volumes would add to 0."""
    fit = of_obj(
        tmp_path,
        (cube(at=(-1, 0, 0)), flipped(triangles())),
        (cube(at=(1, 0, 0)), triangles()),
    )
    assert volume(fit.vertices, fit.faces) == pytest.approx(2, abs=1e-14)
    assert fit.turned.tolist() == [True] * 12 + [False] * 12
    assert not fit.shape.layered


def test_cubes_that_share_an_edge_or_a_corner_are_closed(tmp_path: Path) -> None:
    """At the edge four triangles meet: each cube is closed by itself."""
    for at in ((1, 1, 0), (1, 1, 1)):
        fit = of_obj(tmp_path, (cube(), triangles()), (cube(at=at), flipped(triangles())))
        assert (fit.shape.closed, len(fit.shape.shells)) == (True, 2)
        assert volume(fit.vertices, fit.faces) == pytest.approx(2, abs=1e-14)


INNER = cube(0.3)


@pytest.mark.parametrize(
    ("outer", "inner", "enclosed", "hollow"),
    [
        (False, False, 1 + 0.6**3, False),
        (False, True, 1 - 0.6**3, True),
        (True, False, 1 - 0.6**3, True),
        (True, True, 1 + 0.6**3, False),
    ],
)
def test_a_shell_within_a_shell_keeps_its_sense_to_it(
    tmp_path: Path, outer: bool, inner: bool, enclosed: float, hollow: bool
) -> None:
    """Wound alike it is more of the same; wound against it a hollow, and stays one if the file as
    a whole is inside out. The outer one faces outwards at last."""
    outside, inside = triangles(), triangles()
    fit = of_obj(
        tmp_path,
        (cube(), flipped(outside) if outer else outside),
        (INNER, flipped(inside) if inner else inside),
    )
    assert volume(fit.vertices, fit.faces) == pytest.approx(enclosed, abs=1e-14)
    assert [shell.is_hollow for shell in fit.shape.shells] == [False, hollow]
    assert [shell.within for shell in fit.shape.shells] == [-1, 0]
    assert fit.shape.layered is not hollow


def test_a_part_of_another_name_is_no_hollow_of_one_that_is_inside_out(tmp_path: Path) -> None:
    """A head inside out with an eye in it: both face outwards."""
    text = "o head\n" + obj_text(cube(), flipped(triangles()))
    text += "o eye\n" + obj_text(INNER, triangles(), 9)
    fit = cleaned(written(tmp_path / "made.obj", text))
    assert volume(fit.vertices, fit.faces) == pytest.approx(1 + 0.6**3, abs=1e-14)
    assert fit.turned.tolist() == [True] * 12 + [False] * 12


def test_shells_that_cut_each_other_are_found(tmp_path: Path) -> None:
    """Two cubes of which a part is in both; what only touches is none."""
    cut = of_obj(tmp_path, (cube(), triangles()), (cube(at=(0.5, 0.4, 0.3)), triangles()))
    assert (cut.shape.overlapping, cut.shape.layered) == (((0, 1),), True)
    beside = of_obj(tmp_path, (cube(), triangles()), (cube(at=(1, 0.4, 0.3)), triangles()))
    assert (beside.shape.overlapping, beside.shape.layered) == ((), False)


def test_a_strip_of_one_side_is_left_as_it_is(tmp_path: Path) -> None:
    """A Moebius strip cannot be wound alike: it is open, and no triangle is turned."""
    turn = np.linspace(0, 2 * np.pi, 30, endpoint=False)
    half = np.array([np.cos(turn / 2), np.sin(turn / 2)]).T
    rim = [
        np.column_stack([(1 + w * half[:, 0]) * np.cos(turn), (1 + w * half[:, 0]) * np.sin(turn),
                         w * half[:, 1]])
        for w in (-0.3, 0.3)
    ]  # fmt: skip
    faces = []
    for k in range(30):
        a, b, n = k, k + 30, (k + 1) % 30
        c, d = (n, n + 30) if k < 29 else (30, 0)  # half a turn later the sides are exchanged
        faces += [[a, b, d], [a, d, c]]
    fit = of_obj(tmp_path, (np.concatenate(rim), np.array(faces)))
    assert (fit.shape.closed, fit.turned.any(), len(fit.shape.shells)) == (False, False, 1)


def test_an_open_mesh_is_wound_alike_and_told_where_it_is_open(tmp_path: Path) -> None:
    """A cube without its lid, one triangle of it turned round: four open edges, at the lid."""
    faces = flipped(triangles(), [0])
    vertices = cube()
    lid = (vertices[faces][:, :, 1] == 0.5).all(axis=1)
    fit = of_obj(tmp_path, (vertices, faces[~lid]))
    assert (fit.shape.closed, int(fit.turned.sum())) == (False, 1)
    assert fit.open_edges.shape == (4, 2, 3)
    assert (fit.open_edges[:, :, 1] == 0.5).all()


def test_one_stray_corner_far_out_does_not_weld_the_rest(tmp_path: Path) -> None:
    """A triangle to 1e9: the box is a thousand million times as large, but an open lid's corners,
    1e-3 above the others, stay apart."""
    corners = np.concatenate([cube()[triangles()], [[[1e9, 0, 0], [0, 1, 0], [0, 0, 1]]]])
    lid = (corners[:, :, 1] == 0.5).all(axis=1)
    corners[lid] += [0, 1e-3, 0]
    text = obj_text(corners.reshape(-1, 3), np.arange(39).reshape(-1, 3))
    fit = cleaned(written(tmp_path / "made.obj", text))
    assert (len(fit.faces), fit.joined) == (13, 0)


@pytest.mark.parametrize("joints", [1, 3])
def test_slivers_that_fill_a_joint_do_not_open_the_surface(tmp_path: Path, joints: int) -> None:
    """An edge of a cube with corners on it that only one of its faces has, and triangles without
    an area between: closed, of volume 1."""
    vertices, faces = cube(), triangles().tolist()
    one = faces.pop(0)
    at = vertices[one]
    start = next(k for k in range(3) if (at[k] != at[(k + 1) % 3]).sum() == 1)
    a, b, c = (one[(start + k) % 3] for k in range(3))
    along = np.linspace(0, 1, joints + 2)[1:-1, None]
    added = vertices[a] + along * (vertices[b] - vertices[a])
    chain = [a, *range(8, 8 + joints), b]
    faces += [[p, q, c] for p, q in pairwise(chain)]
    # What is left between the chain and the other face's edge, as a fan from its first corner.
    faces += [[a, q, p] for p, q in pairwise(chain[1:])]
    fit = of_obj(tmp_path, (np.concatenate([vertices, added]), np.array(faces)))
    assert fit.dropped == {"without area": joints}
    assert (fit.shape.closed, len(fit.faces), fit.turned.any()) == (True, 12 + 2 * joints, False)
    assert volume(fit.vertices, fit.faces) == pytest.approx(1, abs=1e-15)
