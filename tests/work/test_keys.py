"""Keys that cannot lie: what a piece of work is made from is found in the sources."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import pytest

from raywalk.pipeline import parts as keys
from raywalk.pipeline import slides as slide_pipeline
from raywalk.work import closure
from raywalk.work.closure import PACKAGE, Sources
from raywalk.work.digests import key_of
from raywalk.work.maker import OURS, Maker

ROOT = PACKAGE.parents[1]
FOLDERS = ("build/raywalk", "site_src", "models")
# Maker, what it leaves out, whose sentences it says.
PIECES = {
    "trace": (keys.TRACE, "", None),
    "trace without a mesh": (keys.TRACE, keys.MESH, None),
    "page data": (keys.PAGE_DATA, "", None),
    "page pictures": (keys.PAGE_PICTURES, "", None),
    "sights": (slide_pipeline.SEE, "", None),
    "lesson": (slide_pipeline.ASK, "", None),
    "slides": (slide_pipeline.WRITE, "", {"en"}),
    "course": (slide_pipeline.WRITE_COURSE, "", {"en"}),
}


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """The sources of pipeline and site, to be edited."""
    root = tmp_path_factory.mktemp("checkout")
    leave = shutil.ignore_patterns("__pycache__", "*.d.ts")
    for folder in FOLDERS:
        shutil.copytree(ROOT / folder, root / folder, ignore=leave)
    (root / "node_modules").symlink_to(ROOT / "node_modules")
    (root / "build/raywalk/__pycache__").touch()  # no folder: nothing is kept of what was parsed
    with pytest.MonkeyPatch.context() as patch:
        # Files are read anew for each key; what a text imports is the same whenever it is parsed.
        patch.setattr(closure, "found_in", cache(closure.found_in))
        yield root


def sources_of(root: Path) -> Sources:
    return Sources(root / "build" / "raywalk")


def parts(sources: Sources, piece: str) -> dict:
    maker, shut, languages = PIECES[piece]
    return maker.parts(shut, languages, sources)


def files_of(root: Path) -> set[Path]:
    return {path for each in FOLDERS for path in (root / each).rglob("*") if path.is_file()}


@contextmanager
def edited(files: Iterable[Path]) -> Iterator[None]:
    """Meanwhile each of them has one byte more, of no meaning in any language. It is put behind the
    others and cut off again: to write a file anew waits for the disk."""
    lengths = {file: file.stat().st_size for file in files}
    for file in lengths:
        with file.open("ab") as more:
            more.write(b"\n")
    yield
    for file, length in lengths.items():
        os.truncate(file, length)


def hashes_alone(made_from: dict, changed: dict) -> Iterator[tuple[str, dict]]:
    """Each file behind a piece of work, and what the piece is made from where it alone changed: a
    file's hash is a row of its own, so all can be edited at once."""
    for kind in ("code", "read"):
        assert made_from.get(kind, {}).keys() == changed.get(kind, {}).keys()
        for name, hash in changed.get(kind, {}).items():
            yield name, made_from | {kind: made_from[kind] | {name: hash}}


@pytest.mark.parametrize("piece", PIECES)
def test_a_byte_of_any_file_behind_a_piece_of_work_changes_its_key_and_of_no_other_file(
    copy, piece
):
    sources = sources_of(copy)
    made_from = parts(sources, piece)
    behind = {sources.place(name) for name in (*made_from["code"], *made_from["read"])}
    assert behind < files_of(copy)
    key = key_of(made_from)
    with edited(behind):
        changed = parts(sources_of(copy), piece)
    for name, alone in hashes_alone(made_from, changed):
        assert key_of(alone) != key, name
    with edited(files_of(copy) - behind):
        assert key_of(parts(sources_of(copy), piece)) == key


def test_the_viewers_key_changes_with_each_script_it_is_bundled_from_and_no_other_file(copy):
    """The bundler's own scripts too."""
    viewer = copy / "site_src"
    made_from = keys.viewer_parts(viewer)
    behind = {copy / name for name in made_from["code"]}
    names = {"bundle.mjs", "strip-rays.mjs", "slim/three.mjs", "viewer/main.ts", "kiosk/main.ts"}
    assert all(any(path.as_posix().endswith(name) for path in behind) for name in names)
    with edited(behind):
        changed = keys.viewer_parts(viewer)
    for name, alone in hashes_alone(made_from, changed):
        assert alone != made_from, name
    with edited(files_of(copy) - behind):
        assert keys.viewer_parts(viewer) == made_from


def test_a_scene_that_is_placed_otherwise_is_traced_again(copy):
    """`rounded()` times 1.25 makes every object larger; it was in no key once."""
    before = parts(sources_of(copy), "trace")
    file = copy / "build/raywalk/scene/exact.py"
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("dtype=np.float64) + 0.0", "dtype=np.float64) * 1.25 + 0.0"))
    assert file.read_text(encoding="utf-8") != text
    changed = parts(sources_of(copy), "trace")["code"].items() - before["code"].items()
    assert [name for name, _ in changed] == ["scene/exact.py"]
    file.write_text(text, encoding="utf-8")


def test_what_writes_a_scenes_data_is_in_its_key(copy):
    """`write_page_data` and `read_display` were in none once."""
    behind = sources_of(copy).closure(keys.PAGE_DATA.module).modules
    texts = "".join(file.read_text(encoding="utf-8") for file in behind)
    assert "def write_page_data(" in texts and "def read_display(" in texts


GLOSSARY = "site_src/words/glossary.toml"
CREDITS = "models/models.toml"


def test_a_page_or_a_sentence_traces_nothing():
    """Neither pages, words, slides nor the viewer are behind a trace; sights hold no sentence."""
    traced = parts(OURS, "trace")
    assert not [
        name for name in traced["code"] if name.split("/")[0] in ("site", "words", "slides")
    ]
    assert not traced["read"]
    assert not parts(OURS, "sights")["read"]
    assert set(parts(OURS, "page data")["read"]) == {GLOSSARY}  # whose terms it marks


def test_slides_are_keyed_by_the_languages_that_they_say():
    """What a language lacks is said in the default one."""
    maker = slide_pipeline.WRITE
    said = {code: maker.parts(languages={"en", code})["read"] for code in ("en", "de")}
    assert set(said["en"]) == {"site_src/words/en.json", GLOSSARY, CREDITS}
    assert set(said["de"]) == {*said["en"], "site_src/words/de.json"}


def test_packages_are_those_behind_the_imports_by_the_names_they_are_installed_under():
    """With what they require, and what decides on bytes besides: Python and zlib."""
    slides, traced = parts(OURS, "slides")["packages"], parts(OURS, "trace")["packages"]
    assert {"pillow", "python-pptx", "python-bidi", "reportlab", "lxml", "python", "zlib"} <= {
        *slides
    }
    assert slides["npm @expo-google-fonts/arimo"] not in ("", "none")
    assert {"numpy", "numba", "llvmlite", "trimesh", "embreex"} <= {*traced}
    assert not {"trimesh", "embreex"} & {*parts(OURS, "trace without a mesh")["packages"]}
    assert "none" not in {*slides.values(), *traced.values()}


def test_a_maker_whose_module_is_gone_is_refused():
    with pytest.raises(KeyError, match=r"no module raywalk.moved_away"):
        Maker("raywalk.moved_away", "write").parts()


def test_another_node_changes_the_keys_of_what_node_tells_and_of_nothing_else(
    tmp_path, monkeypatch
):
    """How numbers are rounded and written is the program's too."""
    before = {piece: key_of(parts(OURS, piece)) for piece in PIECES}
    (tmp_path / "node").write_bytes(b"another")
    (tmp_path / "node").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    changed = {piece for piece in PIECES if key_of(parts(OURS, piece)) != before[piece]}
    assert changed == {"lesson"}
