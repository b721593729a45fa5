"""What is generated from the schema is fresh, and agrees with the reader."""

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from raywalk.errors import SourceErrors
from raywalk.scene.docs import EXAMPLE, files, json_schema
from raywalk.scene.read import read_scene
from raywalk.scene.schema import LessonFile, SceneFile

SCENES = Path(__file__).parents[2] / "scenes"
BAD = Path(__file__).parent / "bad"


@pytest.mark.parametrize("path", files(SCENES), ids=lambda path: path.name)
def test_generated_files_are_fresh(path):
    """If this fails: python -m raywalk.scene.docs, in the project's folder."""
    assert path.read_text(encoding="utf-8") == files(SCENES)[path]


def test_the_example_of_the_readme_is_a_scene(tmp_path):
    """An example that does not work teaches the wrong thing."""
    path = tmp_path / "scene.toml"
    path.write_text(re.sub("^```.*$", "", EXAMPLE, flags=re.MULTILINE), encoding="utf-8")
    assert len(read_scene(path).objects) == 1


@pytest.mark.parametrize("path", sorted(SCENES.glob("*/scene.toml")), ids=lambda p: p.parent.name)
def test_the_json_schema_accepts_every_scene(path):
    """An editor must not underline what the reader takes."""
    jsonschema = pytest.importorskip("jsonschema")
    raw = tomllib.loads(path.read_text(encoding="utf-8"))
    jsonschema.validate(raw, json_schema(LessonFile if "scene" in raw else SceneFile))


@pytest.mark.parametrize(
    "name",
    ["unknown-key-misspelt", "number-negative", "depth-too-large", "view-ray-unknown", "version-2"],
)
def test_the_json_schema_refuses_what_an_editor_can_know(name):
    """Unknown keys, types and ranges; what follows from geometry is the reader's."""
    jsonschema = pytest.importorskip("jsonschema")
    raw = tomllib.loads((BAD / f"{name}.toml").read_text(encoding="utf-8"))
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(raw, json_schema(SceneFile))


def test_the_json_schema_offers_no_null():
    """TOML has none: a key is given or left out."""
    assert '"null"' not in json.dumps(json_schema(SceneFile))
    assert '"default": null' not in json.dumps(json_schema(SceneFile))


def test_reading_scenes_does_not_load_the_tracer():
    """A run with nothing to trace must start at once."""
    heavy = "trimesh numba embreex PIL"
    code = f"import sys, raywalk.scene; sys.exit(any(m in sys.modules for m in '{heavy}'.split()))"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_several_errors_are_counted():
    """The last line says what happened to the work."""
    with pytest.raises(SourceErrors) as caught:
        read_scene(BAD / "several-at-once.toml")
    assert len(caught.value.errors) == 8
    assert str(caught.value).endswith("\n8 errors; nothing was traced")
