"""OFF files with and without colours, right or damaged."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.models.solids import QUADS, cube, volume, written

from raywalk.models.clean import clean
from raywalk.models.faults import ModelFault
from raywalk.models.model import Model
from raywalk.models.read import read_model

PLACES = [" ".join(map(str, row)) for row in cube().tolist()]
FACES = [f"4 {' '.join(map(str, face))}" for face in QUADS.tolist()]
CUBE = "\n".join(["OFF", "8 6 12", *PLACES, *FACES]) + "\n"


def read(folder: Path, content: str) -> Model:
    return read_model(written(folder / "made.off", content))


@pytest.mark.parametrize(
    "content",
    [
        CUBE,
        CUBE.replace("OFF\n8 6 12", "OFF 8 6 12"),
        CUBE.replace("8 6 12", "# counts\n\n8 6"),
        CUBE.replace("\n", "\r\n").replace(" ", "\t"),
        "\n".join(["COFF", "8 6 0", *(f"{row} 255 0 0 255" for row in PLACES), *FACES]),
        "\n".join(["NOFF", "8 6 0", *(f"{row} 0 0 1" for row in PLACES), *FACES]),
    ],
    ids=["plain", "counts on the first line", "comments", "CRLF and tabs", "COFF", "NOFF"],
)
def test_a_cube_is_a_cube(tmp_path: Path, content: str) -> None:
    """12 triangles, closed, of volume 1."""
    fit = clean(read(tmp_path, content))
    assert (len(fit.faces), len(fit.vertices), fit.shape.closed) == (12, 8, True)
    assert volume(fit.vertices, fit.faces) == pytest.approx(1, abs=1e-15)


def test_colours_are_read(tmp_path: Path) -> None:
    """Behind vertices as whole numbers to 255, behind faces as shares."""
    model = read(
        tmp_path, "\n".join(["COFF", "8 6 0", *(f"{row} 255 0 51 255" for row in PLACES), *FACES])
    )
    assert model.colours is not None and model.colours_of == "vertices"
    assert model.colours.table.tolist() == [[1, 0, 0.2]] * 8
    model = read(tmp_path, "\n".join(["OFF", "8 6 0", *PLACES, *(f"{f} 0.5 0 1" for f in FACES)]))
    assert model.colours is not None and model.colours_of == "faces"
    assert model.colours.table.tolist() == [[0.5, 0, 1]] * 6


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        # A face is read as a vertex then, and the last of them is missing.
        (CUBE.replace("8 6", "9 6"), "line 16: the file ends before face 5 of 6; it is cut short: "
         "copy or export it again"),
        (CUBE.replace("8 6", "8 7"), "line 16: the file ends before face 6 of 7; it is cut short: "
         "copy or export it again"),
        (CUBE.replace("4 0 1 3 2", "4 0 1 3 8"), "line 11: a face names vertex 8, and there are 0 "
         "to 7; export the model again"),
        (CUBE.replace("4 0 1 3 2", "5 0 1 3 2"), 'line 11: "5 0 1 3 2" has 4 of its 5 corners; '
         "export the model again"),
        (CUBE.replace("-0.5", "-0,5"), 'line 3: "-0,5" has a decimal comma; decimals have a point '
         "(-0.5): export it again with English number formats, or replace the commas"),
        (CUBE.replace("OFF", "OFF BINARY"), 'line 1: "OFF BINARY" is not read; save it as an OFF '
         "file of text"),
        ("ply\n", 'line 1: "ply" stands where OFF should; it is no OFF file'),
    ],
    ids=["vertices lie", "faces lie", "beyond", "too few", "comma", "binary", "no OFF"],
)  # fmt: skip
def test_what_is_wrong_is_one_sentence(tmp_path: Path, content: str, sentence: str) -> None:
    """File, line, value, cause and remedy."""
    with pytest.raises(ModelFault) as caught:
        clean(read(tmp_path, content))
    assert str(caught.value) == f"made.off, {sentence}"
