"""raywalk compare: what the page check/ says, in words, as JSON, as test cases, as exit code."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from PIL import Image

from raywalk.__main__ import main
from raywalk.mistakes.habits import Habits
from raywalk.mistakes.tracer import picture
from raywalk.scene.read import read_scene
from raywalk.stops.process import Stops

ROOT = Path(__file__).parents[2]
SCENE = read_scene(ROOT / "scenes" / "03-two-lights")
STUDENTS = Habits(precision=np.float32, offset=1e-3)  # other arithmetic than ours


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of a class of four: right, wrong, wider than high, and no picture."""
    made = tmp_path_factory.mktemp("class")

    def saved(name: str, n: int, *mistakes: str) -> np.ndarray:
        values = picture(SCENE, n, frozenset(mistakes), STUDENTS).bytes
        Image.fromarray(values).save(made / name)
        return values

    saved("anna.png", 105)
    saved("bela.ppm", 128, "light-reversed")
    square = saved("wide.bmp", 100)
    Image.fromarray(np.pad(square, ((0, 0), (20, 20), (0, 0)))).save(made / "wide.bmp")
    (made / "dora.png").write_bytes(b"\x89PNG\r\n\x1a\n and no more")
    (made / "notes.md").write_text("not looked at")
    return made


@pytest.fixture(scope="module")
def node() -> Iterator[Stops]:
    """Answers all commands that run in this process: to start it takes longer than to ask."""
    with Stops(ROOT / "site_src" / "check.mjs") as node:
        yield node


@pytest.fixture
def compared(
    node: Stops, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Callable[..., subprocess.CompletedProcess[str]]:
    """A function: the command here, as if it were a process of its own."""
    monkeypatch.chdir(ROOT)
    monkeypatch.setattr("raywalk.stops.process.Stops", lambda script: nullcontext(node))

    def run(*words: str | Path) -> subprocess.CompletedProcess[str]:
        code = main(["compare", *map(str, words)])
        return subprocess.CompletedProcess(words, code, *capfd.readouterr())

    return run


def test_a_right_picture_ends_with_0(folder) -> None:
    command = [sys.executable, "-m", "raywalk", "compare", folder / "anna.png", "--scene", "03"]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)
    assert done.returncode == 0, done.stderr
    assert "This picture is right." in done.stdout


def test_a_wrong_one_ends_with_1_and_is_named(compared, folder) -> None:
    done = compared(folder / "bela.ppm", "--scene", "03-two-lights")
    assert done.returncode == 1
    assert "light-reversed" in done.stdout and "Not right yet" in done.stdout
    assert done.stderr.strip() == "1 of 1 pictures not right"


def test_in_german_objects_and_mistakes_have_their_german_names(compared, folder) -> None:
    done = compared(folder / "bela.ppm", "--scene", "03", "--language", "de")
    assert "Das Licht kommt von der Gegenseite" in done.stdout and "(light-reversed)" in done.stdout
    assert not any(obj.name in done.stdout for obj in SCENE.objects), done.stdout


def test_a_wider_picture_is_cut_to_its_middle_and_may_be_right(compared, folder) -> None:
    done = compared(folder / "wide.bmp", "--scene", "03")
    assert done.returncode == 0
    assert "the middle square, 100 × 100 pixels" in done.stdout


def test_a_class_is_a_table_a_line_a_picture(compared, folder) -> None:
    done = compared(folder, "--scene", "03")
    assert done.returncode == 1
    lines = done.stdout.splitlines()
    assert [Path(line.split()[0]).name for line in lines] == [
        "anna.png", "bela.ppm", "dora.png", "wide.bmp"
    ]  # fmt: skip
    assert "light-reversed" in lines[1] and "PNG file" in lines[2]


def test_json_says_all_and_nothing_else(compared, folder) -> None:
    done = compared(folder, "--scene", "03", "--json")
    found = json.loads(done.stdout)
    assert found["scene"] == "03-two-lights"
    right, wrong, broken, _ = found["pictures"]
    assert [each["isRight"] for each in (right, wrong, broken)] == [True, False, False]
    assert wrong["answers"][0]["names"] == ["light-reversed"]
    assert "fault" in broken and "comparison" not in broken
    assert [line["words"] for line in broken["lines"]] == [broken["fault"]]
    parts = list(dict.fromkeys(line["part"] for line in wrong["lines"]))
    assert parts == ["verdict", "how", "where", "looks", "walk"]


def test_junit_has_a_case_a_picture(compared, folder) -> None:
    done = compared(folder, "--scene", "03", "--junit", "--language", "de")
    suite = ElementTree.fromstring(done.stdout.encode())
    assert (suite.get("tests"), suite.get("failures"), suite.get("errors")) == ("4", "1", "1")
    [failure] = suite.iter("failure")
    assert failure.get("message", "").startswith("Noch nicht richtig")


def test_what_is_not_there_is_told_all_at_once(compared, folder, tmp_path) -> None:
    done = compared("nobody.png", tmp_path, "--scene", "03")
    assert done.returncode == 1 and not done.stdout
    assert "nobody.png: no such file" in done.stderr
    assert "no picture is in it" in done.stderr and "Traceback" not in done.stderr


@pytest.mark.parametrize(("named", "said"), [("0", "several scenes"), ("77", "no such scene")])
def test_a_scene_that_is_not_one_is_told_with_those_there_are(
    compared, folder, named, said
) -> None:
    done = compared(folder / "anna.png", "--scene", named)
    assert done.returncode == 1
    assert said in done.stderr and "03-two-lights" in done.stderr
