"""The viewer's types of what the pipeline writes are made anew at every type check."""

from __future__ import annotations

import base64
import gzip
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from pydantic import TypeAdapter, ValidationError

from raywalk.site.scene_types import BoxesData, LessonData, SceneData, SceneWords, SectionsData
from raywalk.site.viewer_types import viewer_types

ROOT = Path(__file__).parent.parent.parent
TYPES = "site_src/viewer/trace/pipeline-types.d.ts"


def held(script: Path) -> bytes:
    """The JSON in a script of the built site."""
    packed = re.search(r'"([A-Za-z0-9+/=]{40,})"', script.read_text(encoding="utf-8"))
    assert packed
    return gzip.decompress(base64.b64decode(packed[1]))


OF_ITS_KIND = SceneData | LessonData  # a scene's, or that of a lesson on another scene


@pytest.mark.parametrize(
    ("of", "files"),
    [
        (OF_ITS_KIND, "scene.js"),
        (SceneWords, "words-*.js"),
        (SectionsData, "sections.js"),
        (BoxesData, "boxes.js"),
    ],
)
def test_every_built_scene_is_what_the_types_say(of: type, files: str) -> None:
    scripts = sorted((ROOT / "dist" / "scenes").glob(f"*/{files}"))
    assert scripts, "run make first"
    for script in scripts:
        TypeAdapter(of).validate_json(held(script), strict=True, extra="forbid")


def test_a_scene_without_its_start_is_refused() -> None:
    """The check above can fail."""
    data = json.loads(held(ROOT / "dist" / "scenes" / "01-shading" / "scene.js"))
    del data["start"]
    with pytest.raises(ValidationError, match="start"):
        TypeAdapter(SceneData).validate_python(data)


@pytest.mark.parametrize(
    "line",
    [
        'readonly observer?: "start" | "camera" | ObserverTable;',  # a union, from the schema
        "readonly pixel?: readonly [number, number];",  # a tuple
        "readonly lights?: Readonly<Record<string, number>>;",  # a table with any keys
        "readonly camera: CameraData;",  # a table of its own
        "readonly signature: readonly (readonly number[])[];",  # of the trace file's header
        "readonly visibility: readonly (readonly [number, number, number?])[]",
    ],
)
def test_kinds_of_schema_become_types(line: str) -> None:
    assert line.removesuffix(";") in viewer_types()


def test_the_type_check_fails_where_the_viewer_uses_what_is_no_longer_written(
    tmp_path: Path,
) -> None:
    """With one field fewer in a view, in sections and in boxes the compiler names each."""
    viewer = Path("site_src", "viewer")
    shutil.copytree(ROOT / viewer, tmp_path / viewer)
    table = Path("build", "raywalk", "trace", "ray_kinds.json")
    (tmp_path / table).parent.mkdir(parents=True)
    shutil.copyfile(ROOT / table, tmp_path / table)
    (tmp_path / "node_modules").symlink_to(ROOT / "node_modules")
    (tmp_path / "package.json").write_text('{"type": "module"}', encoding="utf-8")
    subprocess.run(["node", str(ROOT / "site_src" / "word-keys.mjs")], check=True)
    shutil.copyfile(ROOT / viewer / "word-keys.d.ts", tmp_path / viewer / "word-keys.d.ts")
    fewer, gone = re.subn(r"readonly (slice\?|frame|parents):.*", "", viewer_types())
    assert gone == 3
    (tmp_path / TYPES).write_text(fewer, encoding="utf-8")
    command = ["node_modules/.bin/tsc", "--noEmit", "-p", str(viewer)]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode
    for field in ("slice", "frame", "parents"):
        assert f"'{field}' does not exist" in done.stdout
