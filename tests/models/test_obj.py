"""OBJ files as other programs write them are read rightly, or refused in one sentence."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.models.solids import QUADS, area, cube, obj_text, triangles, volume, written

from raywalk.models.clean import clean
from raywalk.models.faults import ModelFault
from raywalk.models.model import Model
from raywalk.models.read import read_model

CUBE = obj_text(cube(), QUADS)


def read(folder: Path, content: str | bytes) -> Model:
    return read_model(written(folder / "made.obj", content))


def refused(folder: Path, content: str | bytes) -> str:
    with pytest.raises(ModelFault) as caught:
        clean(read(folder, content))
    return str(caught.value)


def is_the_cube(model: Model) -> bool:
    """12 triangles on 8 corners, closed, of volume 1."""
    fit = clean(model)
    whole = (len(fit.faces), len(fit.vertices), fit.shape.closed) == (12, 8, True)
    return whole and abs(volume(fit.vertices, fit.faces) - 1) < 1e-15


def test_negative_indices_count_back_from_their_own_line(tmp_path: Path) -> None:
    """Two blocks of "8 vertices, then faces -8 to -1" are two cubes of volume 1."""
    model = read(tmp_path, obj_text(cube(), QUADS, -8) + obj_text(cube(at=(2, 0, 0)), QUADS, -8))
    assert (len(model.vertices), len(model.faces)) == (16, 24)
    assert volume(model.vertices, model.faces) == pytest.approx(2, abs=1e-14)
    assert np.ptp(model.vertices, axis=0).tolist() == [3, 1, 1]


def test_positive_and_negative_indices_may_stand_in_one_face(tmp_path: Path) -> None:
    """With one block, -k is the vertex 9 - k: every other corner is written so."""
    faces = ["f " + " ".join(str(k + 1 if n % 2 else k - 8) for n, k in enumerate(face))
             for face in QUADS.tolist()]  # fmt: skip
    vertices = CUBE[: CUBE.index("f ")]
    assert is_the_cube(read(tmp_path, vertices + "\n".join(faces)))


def test_a_concave_polygon_covers_what_it_encloses_and_no_more(tmp_path: Path) -> None:
    """An L of two concave hexagons and six sides has the area 7.92 and the volume 1.08; a fan
    from a corner would cover the notch, with 9.36."""
    half = [(0.9, -0.9), (0.9, -0.3), (-0.3, -0.3), (-0.3, 0.9), (-0.9, 0.9), (-0.9, -0.9)]
    vertices = np.array([(x, y, z) for z in (0.3, -0.3) for x, y in half])
    for start in range(6):  # whichever corner comes first
        cap = [1 + (start + k) % 6 for k in range(6)]
        text = "".join(f"v {x} {y} {z}\n" for x, y, z in vertices.tolist())
        text += f"f {' '.join(map(str, cap))}\nf {' '.join(str(k + 6) for k in cap[::-1])}\n"
        text += "".join(
            f"f {k + 1} {k + 7} {(k + 1) % 6 + 7} {(k + 1) % 6 + 1}\n" for k in range(6)
        )
        model = read(tmp_path, text)
        assert area(model) == pytest.approx(7.92, abs=1e-14)
        fit = clean(model)
        assert fit.shape.closed
        assert volume(fit.vertices, fit.faces) == pytest.approx(1.08, abs=1e-14)


@pytest.mark.parametrize("seed", range(8))
def test_any_simple_polygon_keeps_its_area_and_all_of_its_sides(tmp_path: Path, seed: int) -> None:
    """Stars of 5 to 40 corners in any plane, some corners on straight lines: as many triangles as
    corners less two, and the closed prism on them is closed."""
    rng = np.random.default_rng(seed)
    count = int(rng.integers(5, 20))
    angle = (np.arange(count) + rng.uniform(0, 0.9, count)) * 2 * np.pi / count
    corners = np.column_stack([np.cos(angle), np.sin(angle)]) * rng.uniform(0.2, 1, (count, 1))
    between = (corners + np.roll(corners, -1, axis=0)) / 2
    flat = np.stack([corners, between], axis=1).reshape(-1, 2)  # every other on a straight line
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    n = len(flat)
    vertices = np.concatenate([np.column_stack([flat, np.full(n, z)]) for z in (0.0, 1.0)]) @ turn
    text = "".join(f"v {x} {y} {z}\n" for x, y, z in vertices.tolist())
    text += f"f {' '.join(str(k + 1) for k in range(n))}\n"
    text += f"f {' '.join(str(2 * n - k) for k in range(n))}\n"
    text += "".join(
        f"f {(k + 1) % n + 1} {k + 1} {k + 1 + n} {(k + 1) % n + 1 + n}\n" for k in range(n)
    )
    model = read(tmp_path, text)
    assert len(model.faces) == 2 * (n - 2) + 2 * n
    fit = clean(model)
    assert (len(fit.faces), fit.shape.closed) == (len(model.faces), True)
    x, y = flat.T
    enclosed = abs((x * np.roll(y, -1) - y * np.roll(x, -1)).sum()) / 2
    assert abs(volume(fit.vertices, fit.faces)) == pytest.approx(enclosed, rel=1e-12)


@pytest.mark.parametrize(
    "content",
    [
        CUBE.replace(" ", "\t"),
        CUBE.replace("\n", "\r\n"),
        CUBE.replace("\n", "\r"),
        "\ufeff" + CUBE,
        CUBE.encode("utf-16"),
        CUBE.replace("f 1 2", "f 1 \\\n2"),
        CUBE.replace("f 1 2", "f 1 \\\n2").replace("\n", "\r\n"),
        CUBE.replace("v ", "  v   "),
        CUBE + "# Gr\u00fc\u00dfe".encode("latin-1").decode("latin-1"),
        b"o W\xfcrfel\n" + CUBE.encode(),
        CUBE.replace("\nf", " # corner\nf", 1),
        CUBE[CUBE.index("f ") :] + CUBE[: CUBE.index("f ")],
        CUBE + "l 1 2\np 3\ncurv 0 1 2 3\nshadow_obj x\nf 1 2\n",
        CUBE + "vt broken\nvn 0 0\n",
        CUBE.replace("\nf", "\nvt 0 0\nf", 1).replace("f 1 2", "f 1/9 2/0"),
        CUBE.replace("f 1 2", "f 1// 2/"),
        CUBE.rstrip("\n"),
    ],
    ids=["tabs", "CRLF", "CR", "BOM", "UTF-16", "goes on", "goes on, CRLF", "spaces", "UTF-8",
         "Latin-1", "comment behind", "faces first", "lines and curves", "broken vt and vn",
         "vt out of range", "empty vt", "no line end"],
)  # fmt: skip
def test_a_cube_is_a_cube_however_it_is_written(tmp_path: Path, content: str | bytes) -> None:
    """12 triangles on 8 corners, closed, of volume 1."""
    assert is_the_cube(read(tmp_path, content))


def test_what_is_not_used_is_named(tmp_path: Path) -> None:
    """Lines, faces of two corners, normals of which a line is broken."""
    notes = read(tmp_path, CUBE + "l 1 2\nf 1 2\nvn 0 0\nf 1//1 2//1 3//1\n").ignored
    assert notes == (
        "lines are not read",
        "1 faces with fewer than three corners are left out",
        "own normals are not used: line 17 is broken",
    )


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (
            CUBE.replace("-0.5", "-0,5"),
            'made.obj, line 1: "-0,5" has a decimal comma; decimals have a point (-0.5): export it '
            "again with English number formats, or replace the commas",
        ),
        (
            CUBE.replace("v -0.5 -0.5 -0.5", "v 0 0", 1),
            'made.obj, line 1: "v 0 0" has 2 of a vertex\'s 3 coordinates; write x, y and z, or '
            "export the model again",
        ),
        (
            CUBE.replace("f 1 2", "f 9 2"),
            "made.obj, line 9: a face names vertex 9, and the file has 8 vertices; it is cut short "
            "or damaged: export the model again",
        ),
        (
            CUBE.replace("f 1 2", "f -9 2"),
            'made.obj, line 9: "-9" is no vertex: 8 vertices stand before it; the file is damaged: '
            "export the model again",
        ),
        (
            CUBE.replace("f 1 2", "f 0 2"),
            'made.obj, line 9: "0" is no vertex: they are counted from 1; the file is damaged: '
            "export the model again",
        ),
        (
            CUBE.replace("f 1 2", "f 1.5 2"),
            'made.obj, line 9: "1.5" is not a corner; a corner is v, v/t, v//n or v/t/n, each a '
            "whole number: export the model again",
        ),
        (
            CUBE.replace("f 1 2", f"f {10**30} 2"),
            f"made.obj, line 9: a face names vertex {2**62}, and the file has 8 vertices; it is "
            "cut short or damaged: export the model again",
        ),
        (
            CUBE.replace("-0.5", "0.5f"),
            'made.obj, line 1: "0.5f" is not a number; correct the line, or export the model again',
        ),
        (
            CUBE[: CUBE.index("f ")],
            "made.obj: it holds 8 vertices but no face; export a mesh of polygons, not points or "
            "curves",
        ),
        (
            "solid cube\n",
            "made.obj: it holds no line of an OBJ file that is a vertex or a face; export a mesh "
            "of polygons, not points or curves",
        ),
        (
            "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
            "made.obj holds no usable triangle (1 without area); export a mesh of triangles that "
            "have an area",
        ),
        ("", "made.obj: it is empty; copy or export it again"),
    ],
    ids=["comma", "two coordinates", "beyond", "before", "zero", "fraction", "huge", "suffix",
         "no face", "no OBJ", "no area", "empty"],
)  # fmt: skip
def test_what_is_wrong_is_one_sentence(tmp_path: Path, content: str, sentence: str) -> None:
    """File, line, value, cause and remedy."""
    assert refused(tmp_path, content) == sentence


def test_a_corner_that_is_no_number_costs_its_triangles_only(tmp_path: Path) -> None:
    """NaN, and what Microsoft's runtime writes for it: as everywhere, counted and left out."""
    for word in ("nan", "1.#QNAN", "-1.#IND00", "inf"):
        text = CUBE + f"v {word} 0 0\nf 1 2 9\n"
        assert clean(read(tmp_path, text)).dropped == {"not finite": 1}


def test_own_normals_and_smoothing_groups_are_read(tmp_path: Path) -> None:
    """A die with a normal a face and `s off`; and groups by name."""
    normals = [(-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1)]
    text = CUBE[: CUBE.index("f ")] + "".join(f"vn {x} {y} {z}\n" for x, y, z in normals)
    text += "s off\n" + "".join(
        "f " + " ".join(f"{k + 1}//{n + 1}" for k in face) + "\n" for n, face in enumerate(QUADS)
    )
    model = read(tmp_path, text)
    assert model.normals is not None and model.smoothing is not None
    at = model.normals.table[model.normals.row]
    a, b, c = model.vertices[model.faces].transpose(1, 0, 2)
    assert np.array_equal(at, np.repeat(np.cross(b - a, c - a)[:, None], 3, axis=1))
    assert model.smoothing.tolist() == [0] * 12
    grouped = read(
        tmp_path, CUBE.replace("\nf 1 2", "\ns 3\nf 1 2").replace("\nf 5", "\ns off\nf 5")
    )
    assert grouped.smoothing is not None
    assert grouped.smoothing.tolist() == [3, 3, *[0] * 10]


def test_materials_are_those_of_the_library_or_a_name(tmp_path: Path) -> None:
    """Colours by name, also from a library with spaces in its name; a missing one is named."""
    written(
        tmp_path / "my colours.mtl",
        "newmtl red\r\nKd 0.9 0.1 0.1\r\nNs 50\r\nKs 0.5\r\nd 0.5\r\n"
        "map_Kd -s 2 2 1 -clamp on a b.png\r\nnewmtl odd\nKd x\n",
    )
    two = obj_text(cube(), triangles(), head="mtllib my colours.mtl\nusemtl red\n")
    two += "usemtl odd\nf 1 2 3\nusemtl gone\nf 1 2 4\n"
    model = read(tmp_path, two)
    assert [each.name for each in model.materials] == ["red", "odd", "gone"]
    red, odd, gone = model.materials
    assert (red.diffuse, red.specular, red.shininess, red.opacity) == (
        (0.9, 0.1, 0.1), (0.5, 0.5, 0.5), 50, 0.5,
    )  # fmt: skip
    assert red.texture == tmp_path / "a b.png"
    assert (odd.diffuse, gone.diffuse) == (None, None)
    assert model.material_of().tolist() == [0] * 12 + [1, 2]
    assert model.beside == (tmp_path / "my colours.mtl",)
    assert model.ignored == (
        'line 25: usemtl names "gone", which "my colours.mtl" does not define (it has "red", "odd")'
        ": its faces have no colour of the file; correct the name, or export both files again",
    )
    missing = read(tmp_path, two.replace("my colours", "your colours"))
    assert missing.ignored == ('the material file "your colours.mtl" is not there',)
    assert [each.diffuse for each in missing.materials] == [None, None, None]
    cased = read(tmp_path, two.replace("my colours.mtl", "My Colours.MTL"))
    assert cased.ignored == (
        'the material file "My Colours.MTL" is not there, but "my colours.mtl" is: write it as '
        "the file is called",
    )
    assert read(tmp_path, "mtllib\n" + two).ignored[0] == "line 1: mtllib names no file"


def test_texture_coordinates_that_a_file_does_not_have_are_told(tmp_path: Path) -> None:
    """Faces name them, and there is not one."""
    named = obj_text(cube(), triangles()[:11]) + "f 1/1 2/2 4/3\n"
    assert read(tmp_path, named).ignored == ("texture coordinates are not used: line 20 is broken",)


def test_colours_behind_vertices_are_read(tmp_path: Path) -> None:
    """`v x y z r g b`, from 0 to 1 or to 255; not if only some vertices have one."""
    lines = CUBE.splitlines()
    half = "\n".join([*(f"{line} 1 0.5 0" for line in lines[:8]), *lines[8:]])
    for text in (half, half.replace(" 1 0.5 0", " 255 127.5 0")):
        model = read(tmp_path, text)
        assert model.colours is not None
        assert model.colours.table.tolist() == [[1, 0.5, 0]] * 8
        assert is_the_cube(model)
    assert read(tmp_path, half.replace(" 1 0.5 0", "", 1)).colours is None
