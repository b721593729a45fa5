"""PLY files as text and binary, of any mixture of polygons, right or damaged."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
from tests.models.solids import QUADS, cube, triangles, volume, written

from raywalk.models.clean import clean
from raywalk.models.faults import ModelFault
from raywalk.models.model import Model
from raywalk.models.read import read_model

# Three quads and six triangles, as programs write what is neither all quads nor all triangles.
MIXED = [*QUADS[:2].tolist(), *triangles()[[2, 8, 3, 9]].tolist(), QUADS[4].tolist(),
         *triangles()[[5, 11]].tolist()]  # fmt: skip
FORMATS = ["ascii", "binary_little_endian", "binary_big_endian"]


def ply(
    form: str, vertices: np.ndarray, faces: list[list[int]], more: str = "",
    colours: list[tuple[int, int, int]] | None = None, kind: str = "float", end: str = "\n",
) -> bytes:  # fmt: skip
    """A file; more: lines of the header behind the vertices' places."""
    head = [
        "ply", f"format {form} 1.0", "comment made by a test", f"element vertex {len(vertices)}",
        *(f"property {kind} {axis}" for axis in "xyz"), *more.splitlines(),
        f"element face {len(faces)}", "property list uchar int vertex_indices",
    ]  # fmt: skip
    if colours:
        head += [f"property uchar {channel}" for channel in ("red", "green", "blue")]
    head = [*head, "end_header", ""]
    painted = colours or [()] * len(faces)
    if form == "ascii":
        rows = [" ".join(map(str, row)) for row in vertices.tolist()]
        rows += [" ".join(map(str, (len(f), *f, *c))) for f, c in zip(faces, painted, strict=True)]
        return end.join([*head[:-1], *rows, ""]).encode()
    order = "<" if form.endswith("little_endian") else ">"
    body = vertices.astype(f"{order}f{4 if kind == 'float' else 8}").tobytes()
    body += b"".join(
        struct.pack(f"{order}B{len(f)}i{len(c)}B", len(f), *f, *c)
        for f, c in zip(faces, painted, strict=True)
    )
    return end.join(head).encode() + body


def read(folder: Path, content: bytes) -> Model:
    return read_model(written(folder / "made.ply", content))


def is_the_cube(model: Model) -> bool:
    fit = clean(model)
    whole = (len(fit.faces), len(fit.vertices), fit.shape.closed) == (12, 8, True)
    return whole and abs(volume(fit.vertices, fit.faces) - 1) < 1e-15


@pytest.mark.parametrize("form", FORMATS)
@pytest.mark.parametrize("faces", [triangles().tolist(), QUADS.tolist(), MIXED],
                         ids=["triangles", "quads", "mixed"])  # fmt: skip
def test_a_cube_is_a_cube(tmp_path: Path, form: str, faces: list[list[int]]) -> None:
    """12 triangles, closed, of volume 1."""
    assert is_the_cube(read(tmp_path, ply(form, cube(), faces)))
    assert is_the_cube(read(tmp_path, ply(form, cube(), faces, end="\r\n", kind="double")))


@pytest.mark.parametrize("form", FORMATS)
def test_colours_of_faces_are_read(tmp_path: Path, form: str) -> None:
    """One on each, given to both halves of a quad."""
    colours = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (51, 0, 0), (0, 51, 0), (0, 0, 51)]
    model = read(tmp_path, ply(form, cube(), QUADS.tolist(), colours=colours))
    assert is_the_cube(model)
    assert model.colours is not None and model.colours_of == "faces"
    seen = model.colours.table[model.colours.row]
    expected = np.repeat(np.array(colours) / 255, 2, axis=0)
    assert np.array_equal(seen, np.repeat(expected[:, None], 3, axis=1))


def test_colours_and_normals_of_vertices_are_read(tmp_path: Path) -> None:
    """As floats from 0 to 1 too."""
    more = "".join(
        f"property float {name}\n" for name in ("nx", "ny", "nz", "red", "green", "blue")
    )
    rows = np.column_stack([cube(), 2 * cube(), np.full((8, 3), 0.25)])
    for form in FORMATS:
        model = read(tmp_path, ply(form, rows, QUADS.tolist(), more))
        assert model.colours is not None and model.normals is not None
        assert (model.colours_of, model.colours.table.tolist()) == ("vertices", [[0.25] * 3] * 8)
        assert model.normals.table.tolist() == (2 * cube()).tolist()


def test_strips_are_cut_into_triangles_of_one_sense(tmp_path: Path) -> None:
    """A strip over five quads, begun anew by -1: every second triangle is turned."""
    strip = "0 1 2 3 6 7 4 5 -1 1 5 3 7"
    head = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
    head += (
        "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    )
    rows = "".join(f"{x} {y} {z}\n" for x, y, z in cube().tolist())
    model = read(tmp_path, (head + rows + f"{len(strip.split())} {strip}\n").encode())
    assert len(model.faces) == 8
    a, b, c = model.vertices[model.faces].transpose(1, 0, 2)
    assert ((np.cross(b - a, c - a) * (a + b + c)).sum(axis=1) > 0).all()  # all outward


def test_other_elements_are_passed_over_and_named(tmp_path: Path) -> None:
    """Edges behind the faces, and a list between the columns of a face."""
    content = ply("binary_big_endian", cube(), MIXED)
    content = content.replace(b"end_header", b"element edge 1\nproperty int a\nend_header")
    model = read(tmp_path, content + b"\0\0\0\7")
    assert is_the_cube(model)
    assert model.ignored == ("its `edge` is not read",)


MADE = {form: ply(form, cube(), QUADS.tolist()) for form in FORMATS}
BEYOND = [[0, 1, 3, 99], *QUADS[1:].tolist()]


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (MADE["ascii"][:-30], "face 3 of 6: the file ends before it; it is cut short: copy or "
         "export it again"),
        (MADE["binary_little_endian"][:-30], "face: a list of 4 vertex_indices does not fit into "
         "what is left of the file; it is cut short or damaged: export it again"),
        (MADE["binary_little_endian"].replace(b"vertex 8", b"vertex 800000000000"),
         "vertex 16 of 800000000000: the file ends before the last of 800000000000; it is cut "
         "short: copy or export it again"),
        (MADE["ascii"].replace(b"face 6", b"face 7"), "face 6 of 7: the file ends before it; it is "
         "cut short: copy or export it again"),
        (ply("ascii", cube(), BEYOND), "face 0: it names vertex 99, and there are 0 to 7; the file "
         "is damaged: export the model again"),
        (ply("binary_big_endian", cube(), BEYOND), "face 0: it names vertex 99, and there are 0 to "
         "7; the file is damaged: export the model again"),
        (MADE["ascii"].replace(b"-0.5", b"-0,5", 1), 'line 11: "-0,5" has a decimal comma; '
         "decimals have a point (-0.5): export it again with English number formats, or replace "
         "the commas"),
        (MADE["ascii"].replace(b"-0.5 -0.5 -0.5", b"0 0", 1), 'line 11: "0 0" has 2 of 3 numbers; '
         "export the model again"),
        (MADE["ascii"].replace(b"\n4 ", b"\nx ", 1), 'line 19: "x" is not a number of '
         "vertex_indices; export the model again"),
        (MADE["ascii"].replace(b"\n4 0", b"\n9 0", 1), 'line 19: "9 0 1 3 2" ends before its '
         "vertex_indices; export the model again"),
        (MADE["ascii"].replace(b"float x", b"half x"), 'line 5: "half" is no type; known: char, '
         "int8, uchar, uint8, short, int16, ushort, uint16, int, int32, uint, uint32, float, "
         "float32, double, float64, int64, uint64"),
        (MADE["ascii"].replace(b"float x", b"float q"), "header: there is no element `vertex` with "
         "x, y and z; it is no mesh"),
        (ply("ascii", cube(), []), "header: there is no element `face`: it is a cloud of points; "
         "export a mesh of polygons"),
        (b"plyx", "line 0: the file ends in its header; it is cut short: copy or export it again"),
        (b"obj\n", 'line 1: "obj" stands where `ply` should; it is no PLY file'),
    ],
    ids=["text cut", "binary cut", "vertices lie", "faces lie", "beyond", "beyond, binary", "comma",
         "two numbers", "no count", "count lies", "type", "no x", "no face", "no header", "no PLY"],
)  # fmt: skip
def test_what_is_wrong_is_one_sentence(tmp_path: Path, content: bytes, sentence: str) -> None:
    """File, line or element, value, cause and remedy."""
    with pytest.raises(ModelFault) as caught:
        clean(read(tmp_path, content))
    assert str(caught.value) == f"made.ply, {sentence}"


def test_many_polygons_of_any_length_are_read_as_they_stand(
    tmp_path: Path, rng: np.random.Generator
) -> None:
    """2,000 polygons of 3 to 7 corners in runs of any length, binary: the very corners."""
    sizes = np.repeat(rng.integers(3, 8, 100), rng.geometric(0.05, 100))[:2000]
    vertices = rng.normal(size=(50, 3)).astype(np.float32).astype(float)
    faces = [rng.permutation(50)[:size].tolist() for size in sizes]
    from raywalk.models.ply_header import read_header
    from raywalk.models.ply_rows import read_rows

    for form in FORMATS:
        content = ply(form, vertices, faces)
        path = tmp_path / "many.ply"
        rows = read_rows(path, content, read_header(path, content))
        listed = rows["face"].lists["vertex_indices"]
        assert listed.counts.tolist() == sizes.tolist()
        assert listed.values.tolist() == [k for face in faces for k in face]
        assert np.array_equal(rows["vertex"].single["x"], vertices[:, 0])
