"""The bytes that are hashed are the bytes that are used."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from raywalk.__main__ import main
from raywalk.pipeline import parts as keys
from raywalk.pipeline.trace_task import trace_into
from raywalk.scene.read import read_scene
from raywalk.work import snapshot
from raywalk.work.closure import Sources
from raywalk.work.digests import key_of
from raywalk.work.maker import OURS, Maker
from raywalk.work.making import Edited, made
from raywalk.work.progress import say_nothing
from raywalk.work.store import Store

ROOT = OURS.root
SCENE = """
version = 1
key = "1"
title = "Ball"
teaches = "What is kept."
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
[render]
size = 63
resolutions = [7, 21]
[[objects]]
name = "ball"
type = "sphere"
center = [0, 0, 0]
radius = 0.9
material = "white"
[[lights]]
position = [1, 2, 3]
[[lesson]]
text = "One ray."
view = { resolution = 7, pixel = [3, 3] }
"""
# An author's sentences, saved again and again while one process builds, as `raywalk serve` does.
AUTHOR = """
from pathlib import Path
import raywalk
from raywalk.__main__ import main
assert Path(raywalk.__file__).is_relative_to(Path.cwd()), raywalk.__file__
words = Path("site_src/words/en.json")
before = words.read_text(encoding="utf-8")
for edit in ("First", "Second"):
    text = before.replace('"head": "Walk every ray."', f'"head": "{edit} head"')
    words.write_text(text.replace('"notes": "Notes"', f'"notes": "{edit} notes"'), "utf-8")
    assert main(["site", "--scenes", "scenes", "--out", "dist", "--work", "work"]) == 0
"""
BUILD = """
from raywalk.__main__ import main
main(["site", "--scenes", "scenes", "--out", "dist", "--work", "work", "--explain"])
"""


def test_within_a_build_a_file_is_read_once_and_outside_of_one_each_time(tmp_path: Path):
    """Text and hash are of the same bytes, whatever is saved meanwhile."""
    file = tmp_path / "page.html"
    file.write_bytes(b"one\r\n")
    with snapshot.one_build():
        assert snapshot.text_of(file) == "one\n"
        file.write_bytes(b"two")
        assert snapshot.text_of(file) == "one\n"
        assert snapshot.digest_of(file) == hashlib.sha256(b"one\r\n").hexdigest()
        handed = snapshot.held()
    assert snapshot.text_of(file) == "two" and snapshot.held() is None
    snapshot.hold(handed)  # what a worker process is given
    try:
        assert snapshot.text_of(file) == "one\n"
    finally:
        snapshot.hold(None)


def test_what_cannot_be_read_is_a_state_of_the_sources_too(tmp_path: Path):
    assert snapshot.digest_of(tmp_path / "gone") == "missing"


@pytest.fixture
def edited(tmp_path, monkeypatch):
    """Sources of one module, and the parts of a piece of work that it makes."""
    package = tmp_path / "build" / "raywalk"
    package.mkdir(parents=True)
    (package / "writer.py").write_text("ONE = 1\n")
    sources = Sources(package)
    monkeypatch.setattr("raywalk.work.making.OURS", sources)
    own = Maker("raywalk.writer", "write").parts(sources=sources)
    return package / "writer.py", {"what": "page", "of": "it", **own}


def test_work_whose_code_was_edited_while_it_was_made_is_not_kept(tmp_path, edited):
    """A worker imports modules later than the key is taken: new code's work, old code's key."""
    file, parts = edited
    store = Store(tmp_path / "work")

    def make(folder: Path) -> None:
        file.write_text("ONE = 2\n")
        (folder / "made").write_text("by whom?")

    with pytest.raises(Edited, match=r"writer\.py was edited while page of it was made"):
        made(store, parts, make)
    assert store.find(key_of(parts)) is None and not list(store.folder.iterdir())


def test_a_trace_whose_mesh_was_saved_while_it_was_traced_is_not_kept(tmp_path, monkeypatch):
    """Its bytes are hashed first and read later."""
    (tmp_path / "models").symlink_to(ROOT / "models")
    place = tmp_path / "scenes" / "01-ball"
    place.mkdir(parents=True)
    shutil.copyfile(ROOT / "models" / "bunny.ply", place / "own.ply")
    shape = 'type = "sphere"\ncenter = [0, 0, 0]\nradius = 0.9'
    text = SCENE.replace(shape, 'type = "mesh"\nfile = "own.ply"')
    (place / "scene.toml").write_text(text, encoding="utf-8")
    scene, store = read_scene(place), Store(tmp_path / "work")
    parts = {scene.id: keys.trace_parts(scene)}

    def trace(*_: object, **how: object) -> None:
        with (place / "own.ply").open("a") as file:
            file.write("\n")

    monkeypatch.setattr("raywalk.pipeline.trace_task.TRACE", trace)
    with pytest.raises(Edited, match=r"own\.ply of ball was edited while trace of 01-ball"):
        trace_into(store, parts, scene, lambda: 1, say_nothing)
    assert not list(store.folder.iterdir())


def test_work_of_sources_that_stand_is_kept(tmp_path, edited):
    store = Store(tmp_path / "work")
    made(store, edited[1], lambda folder: (folder / "made").write_text("by the key's code"))
    assert store.find(key_of(edited[1]))


@pytest.fixture(scope="module")
def checkout(tmp_path_factory, with_viewer):
    """A copy of the sources with a course of one scene, traced before; nothing real is edited."""
    root = tmp_path_factory.mktemp("checkout")
    leave = shutil.ignore_patterns("__pycache__")
    for folder in ("build/raywalk", "site_src"):
        shutil.copytree(ROOT / folder, root / folder, ignore=leave)
    for name in ("node_modules", "package.json", "package-lock.json", "LICENSE"):
        (root / name).symlink_to(ROOT / name)
    (root / "scenes" / "01-ball").mkdir(parents=True)
    (root / "scenes" / "01-ball" / "scene.toml").write_text(SCENE, encoding="utf-8")
    with_viewer(root / "work")
    assert main(["site", *places(root)]) == 0
    return root


def places(root: Path) -> list[str]:
    named = {"--scenes": "scenes", "--out": "dist", "--work": "work"}
    return [text for key, name in named.items() for text in (key, str(root / name))]


def site(root: Path, code: str) -> str:
    """What a Python that has the copy's sources prints."""
    environment = {**os.environ, "PYTHONPATH": str(root / "build")}
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=root, env=environment, capture_output=True, text=True,
        check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_sentences_are_those_of_the_last_save_on_pages_and_slides(checkout):
    """The catalogue was kept in memory past an edit: pages and slides had the first one, were kept
    as the second, and came back after `rm -rf dist`."""
    site(checkout, AUTHOR)
    for _ in range(2):
        page = (checkout / "dist" / "index.html").read_text(encoding="utf-8")
        slides = (checkout / "dist" / "slides" / "01-ball.html").read_text(encoding="utf-8")
        assert "Second head" in page and "First head" not in page
        assert "Second notes" in slides and "First notes" not in slides
        assert "nothing is made again" in site(checkout, BUILD)
        shutil.rmtree(checkout / "dist")
        assert "1 unchanged" in site(checkout, BUILD)


def test_an_edit_of_the_code_is_made_again_and_named(checkout):
    """Of slides, and of a scene's data for the page: what is not behind either stays."""
    file = checkout / "build/raywalk/site/scene_data.py"
    file.write_text(file.read_text(encoding="utf-8") + "# more\n", encoding="utf-8")
    said = site(checkout, BUILD)
    assert "01-ball: page data made: code: site/scene_data.py changed" in said
    assert "0 traced" in said and "slides of" not in said
