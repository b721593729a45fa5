"""The folder that a course begins as: one scene, which teaches the format by its comments."""

from __future__ import annotations

import shutil
from pathlib import Path

from raywalk.errors import SourceError, SourceErrors
from raywalk.home import HOME

BEGINNING = HOME / "site_src" / "new" / "scene.toml"
FIRST = "01-my-first-scene"
#: Beside the scenes: every key there is, for people and for editors.
REFERENCE = ("README.md", "scene.schema.json", "lesson.schema.json")
IGNORED = "/dist/\n/dist-kiosk/\n/dist-teacher/\n/.work/\n"


def begin_course(folder: Path) -> Path:
    """Writes it; returns its scene's file. Raises SourceErrors where something is in the way."""
    if folder.is_file() or (folder.is_dir() and any(folder.iterdir())):
        raise SourceErrors([SourceError(
            folder, "", "is there already, and is not empty" if folder.is_dir() else "is a file",
            hint="name a folder that is not there yet",
        )])  # fmt: skip
    scenes = folder / "scenes"
    (scenes / FIRST).mkdir(parents=True)
    for name in REFERENCE:
        shutil.copyfile(HOME / "scenes" / name, scenes / name)
    (folder / ".gitignore").write_text(IGNORED, encoding="utf-8")
    shutil.copyfile(BEGINNING, scenes / FIRST / "scene.toml")
    return scenes / FIRST / "scene.toml"
