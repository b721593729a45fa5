"""STL files, binary and as text, right or damaged."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.models.solids import cube, stl_bytes, triangles, volume, written

from raywalk.models.clean import clean
from raywalk.models.faults import ModelFault
from raywalk.models.model import Model
from raywalk.models.read import read_model

CORNERS = cube()[triangles()]


def text_of(corners: np.ndarray, name: str = "cube") -> str:
    facets = "".join(
        "facet normal 0 0 0\n outer loop\n"
        + "".join(f"  vertex {x} {y} {z}\n" for x, y, z in corner.tolist())
        + " endloop\nendfacet\n"
        for corner in corners
    )
    return f"solid {name}\n{facets}endsolid {name}\n"


def read(folder: Path, content: str | bytes) -> Model:
    return read_model(written(folder / "made.stl", content))


def is_the_cube(model: Model) -> bool:
    fit = clean(model)
    whole = (len(fit.faces), len(fit.vertices), fit.shape.closed) == (12, 8, True)
    return whole and abs(volume(fit.vertices, fit.faces) - 1) < 1e-15


@pytest.mark.parametrize(
    "content",
    [
        stl_bytes(CORNERS),
        stl_bytes(CORNERS, head=b"solid cube"),
        text_of(CORNERS),
        text_of(CORNERS).upper(),
        text_of(CORNERS).replace("\n", "\r\n").replace(" ", "\t"),
        "\ufeff" + text_of(CORNERS),
        text_of(CORNERS[:5], "one") + text_of(CORNERS[5:], "two"),
    ],
    ids=["binary", "binary that begins with solid", "text", "capitals", "CRLF and tabs", "BOM",
         "two solids"],
)  # fmt: skip
def test_a_cube_is_a_cube(tmp_path: Path, content: str | bytes) -> None:
    """12 triangles, whose 36 corners are 8."""
    assert is_the_cube(read(tmp_path, content))


@pytest.mark.parametrize("stated", [0, 2**32 - 1, 13])
def test_a_wrong_count_over_whole_triangles_is_told_and_not_believed(
    tmp_path: Path, stated: int
) -> None:
    """Some programs write the count first and do not come back to it."""
    model = read(tmp_path, stl_bytes(CORNERS, stated))
    assert is_the_cube(model)
    assert model.ignored == (f"the count in its header, {stated}, is wrong: 12 triangles follow",)


def test_what_follows_the_triangles_is_left_out(tmp_path: Path) -> None:
    """A count below what the file holds is believed."""
    assert len(read(tmp_path, stl_bytes(CORNERS, 5)).faces) == 5
    assert is_the_cube(read(tmp_path, stl_bytes(CORNERS) + b"made by nobody"))


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        (
            stl_bytes(CORNERS)[:-20],
            "made.stl, triangle 12 of 12: the file ends in it; it is cut short: copy or export it "
            "again",
        ),
        (
            b"nothing",
            "made.stl: it has 7 bytes, and an STL of one triangle has 134; it is cut short, or no "
            "STL file: export the model again",
        ),
        (
            text_of(CORNERS)[:-33],
            "made.stl, line 83: the file ends in triangle 12, before `endsolid`; it is cut short: "
            "copy or export it again",
        ),
        (
            text_of(CORNERS).replace("0.5", "0,5"),
            'made.stl, line 4: "-0,5" has a decimal comma; decimals have a point (-0.5): export it '
            "again with English number formats, or replace the commas",
        ),
        (
            text_of(CORNERS).replace("vertex -0.5 -0.5 -0.5", "vertex 0 0", 1),
            'made.stl, line 4: "vertex 0 0" has 2 of a vertex\'s 3 coordinates; write x, y and z, '
            "or export the model again",
        ),
        (
            text_of(CORNERS).replace("  vertex -0.5 -0.5 -0.5\n", "", 1),
            "made.stl, line 6: a facet of 2 vertices ends here, and one has three; export the "
            "model again as triangles",
        ),
        (
            text_of(CORNERS).replace("outer", "color", 1),
            'made.stl, line 3: "color loop" is no line of an STL file; a triangle is `facet '
            "normal`, `outer loop`, three times `vertex`, `endloop`, `endfacet`: export the model "
            "again",
        ),
        (text_of(CORNERS[:0]), "made.stl holds no usable triangle; export a mesh of triangles "
         "that have an area"),
    ],
    ids=["cut", "tiny", "text cut", "comma", "two coordinates", "two vertices", "word", "none"],
)  # fmt: skip
def test_what_is_wrong_is_one_sentence(tmp_path: Path, content: str | bytes, sentence: str) -> None:
    """File, line or triangle, value, cause and remedy."""
    with pytest.raises(ModelFault) as caught:
        clean(read(tmp_path, content))
    assert str(caught.value) == sentence


def test_colours_of_faces_are_read(tmp_path: Path) -> None:
    """VisCAM's 5 bits a channel with the top bit set; Magics' in the other order, over the
    header's."""
    red, green = 31 << 10, 31 << 5
    data = bytearray(stl_bytes(CORNERS))
    for k in range(12):
        data[84 + 50 * k + 48 : 84 + 50 * k + 50] = (0x8000 | (red if k % 2 else green)).to_bytes(
            2, "little"
        )
    model = read(tmp_path, bytes(data))
    assert model.colours is not None and model.colours_of == "faces"
    assert model.colours.table.tolist() == [[0, 1, 0], [1, 0, 0]] * 6
    data[:80] = b"COLOR=\x00\x00\xff\xff".ljust(80, b"\0")
    data[84 + 48 : 84 + 50] = (31).to_bytes(2, "little")
    model = read(tmp_path, bytes(data))
    assert model.colours is not None
    assert model.colours.table[:2].tolist() == [[1, 0, 0], [0, 0, 1]]


def test_parts_are_its_solids(tmp_path: Path) -> None:
    """By their names."""
    model = read(tmp_path, text_of(CORNERS[:5], "lower half") + text_of(CORNERS[5:], "upper"))
    assert model.parts == ("lower half", "upper")
    assert model.part_of().tolist() == [0] * 5 + [1] * 7
