"""raywalk model: what a file holds, as lines, JSON and a picture; a fault is one sentence."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from tests.models.solids import QUADS, cube, obj_text, triangles, written

from raywalk.__main__ import main

TWO = (
    "o left\nusemtl red\n" + obj_text(cube(at=(-1, 0, 0)), triangles())
    + "o right\nusemtl green\n" + obj_text(cube(at=(1, 0, 0)), triangles()[:, ::-1], 9)
)  # fmt: skip


def answer(capsys: pytest.CaptureFixture[str], *words: object) -> tuple[int, str, str]:
    code = main(["model", *map(str, words)])
    printed = capsys.readouterr()
    return code, printed.out, printed.err


def test_it_tells_what_a_file_holds(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Format, counts, box, parts, materials, whether it is closed, what was done, what to write."""
    path = written(tmp_path / "two.obj", TWO)
    code, out, _ = answer(capsys, path)
    assert code == 0
    assert (
        out
        == """\
two.obj: OBJ
  triangles: 24, on 16 corners
  box: [-1.5, -0.5, -0.5] to [1.5, 0.5, 0.5]
  size: 3 x 1 x 1 of its units (the file does not say which)
  parts: 2
    left: 12 triangles
    right: 12 triangles
  materials: 2
    red: 12 triangles
    green: 12 triangles
  normals: it has none: averaged, but at edges sharper than `crease` (40 degrees)
  surface: closed: it may be of glass, 2 shells
  cleaned: 12 triangles turned to face outwards
  in a scene:
    [[objects]]
    type = "mesh"
    file = "two.obj"
    # without `material` it is shown in the file's own materials, or dress some:
    # materials = { red = "mirror" }
"""
    )


def test_it_tells_of_a_picture_that_is_not_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "two.mtl").write_text("newmtl red\nmap_Kd gone.png\nnewmtl green\n")
    path = written(tmp_path / "two.obj", "mtllib two.mtl\n" + TWO)
    assert "    red: 12 triangles, texture gone.png (not there)\n" in answer(capsys, path)[1]
    (tmp_path / "gone.png").write_bytes(b"")
    assert "texture gone.png\n" in answer(capsys, path)[1]


@pytest.mark.parametrize(
    ("scale", "place", "told"),
    [
        (1.0, (0.2, 0.0, 0.0), ""),
        (40.0, (100.0, 20.0, -7.0), "[{ scale = 0.05 }, { translate = [-100, 0, 7] }]"),
        (0.001, (0.0, 0.0, 0.0), "[{ scale = 2000.0 }, { translate = [0, 0.0005, 0] }]"),
        (2.0, (50.0, 1.0, 0.0), "[{ scale = 1.0 }, { translate = [-50, 0, 0] }]"),
    ],
)
def test_a_model_that_would_not_be_seen_is_given_a_transform(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], scale: float,
    place: tuple[float, float, float], told: str,
) -> None:  # fmt: skip
    """Of a usual size, its foot on the ground: a cube of this side round this place."""
    path = written(tmp_path / "cube.obj", obj_text(cube() * scale + place, triangles()))
    _, out, _ = answer(capsys, path)
    line = next((each for each in out.splitlines() if "transform" in each), "")
    assert line.partition("   #")[0].strip() == (f"transform = {told}" if told else "")


def test_as_json_it_tells_the_same(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Numbers as numbers; places of open edges."""
    lid = (cube()[triangles()][:, :, 1] == 0.5).all(axis=1)
    path = written(tmp_path / "open.obj", obj_text(cube(), triangles()[~lid]))
    code, out, _ = answer(capsys, path, "--json")
    facts = json.loads(out)
    assert (code, facts["format"], facts["triangles"], facts["vertices"]) == (0, "OBJ", 10, 8)
    assert (facts["closed"], facts["open_edges"]["count"], facts["size"]) == (False, 4, [1, 1, 1])
    assert facts["open_edges"]["places"][0] == [0, 0.5, -0.5]


def test_open_edges_are_red_in_its_picture(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """None of a closed cube; some of one without its lid."""
    lid = (cube()[triangles()][:, :, 1] == 0.5).all(axis=1)
    red = []
    for k, faces in enumerate((triangles(), triangles()[~lid])):
        path = written(tmp_path / f"{k}.obj", obj_text(cube(), faces))
        picture = tmp_path / f"{k}.png"
        assert answer(capsys, path, "--picture", picture)[0] == 0
        seen = np.asarray(Image.open(picture)).astype(int)
        red.append(int((seen[:, :, 0] - seen[:, :, 1] > 100).sum()))
    assert red[0] == 0 < red[1]


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("bad.obj", "v 0,5 0 0\n", 'bad.obj, line 1: "0,5" has a decimal comma; decimals have a '
         "point (0.5): export it again with English number formats, or replace the commas\n"),
        ("bad.txt", "", 'bad.txt: a file that ends in .txt is not read; export it as one of .obj, '
         ".stl, .ply, .off, .gltf, .glb, .3mf\n"),
        ("gone.obj", None, "gone.obj: there is no such file; look at its name and place\n"),
        ("folder.obj", b"", "folder.obj: is a directory; choose another file\n"),
        ("x" * 5000 + ".obj", None, "x" * 37 + "...: file name too long; choose another file\n"),
    ],
    ids=["comma", "ending", "gone", "folder", "5,000 characters"],
)  # fmt: skip
def test_a_fault_is_one_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str, content: str | bytes | None,
    sentence: str,
) -> None:  # fmt: skip
    """On the error channel, with the code of bad input."""
    if content == b"":
        (tmp_path / name).mkdir()
    elif content is not None:
        written(tmp_path / name, content)
    code, out, err = answer(capsys, tmp_path / name)
    assert (code, out, err) == (1, "", sentence)


def test_control_characters_of_a_file_are_not_sent_to_the_terminal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In names and in values of faults."""
    text = "o \x1b[31mred\x07\n" + obj_text(cube(), QUADS)
    _, out, _ = answer(capsys, written(tmp_path / "made.obj", text))
    assert "\\x1b[31mred\\x07: 12 triangles" in out
    _, _, err = answer(capsys, written(tmp_path / "bad.obj", "v \x1b[2J 0 0\n"))
    assert '"\\x1b[2J" is not a number' in err
    assert "\x1b" not in out + err
