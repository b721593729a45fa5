"""Reads scene files. All errors of all files are gathered and raised once."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from raywalk.errors import SourceError, SourceErrors, shown_path
from raywalk.scene.compile import compile_scene
from raywalk.scene.draft import read_tables
from raywalk.scene.model import Scene
from raywalk.scene.models import find_catalogue, read_catalogue
from raywalk.scene.problems import Problems
from raywalk.scene.toml import read_toml
from raywalk.scene.wording import did_you_mean, joined, quoted

SCENE_FILE = "scene.toml"


def read_scene(path: Path | str) -> Scene:
    """The scene in one file, or in the scene.toml of a folder.

    Raises SourceErrors with everything that is wrong with it.
    """
    path = Path(path)
    file = path / SCENE_FILE if path.is_dir() else path
    scene, errors = _read(file)
    if errors or scene is None:
        raise SourceErrors(errors)
    return scene


def read_scenes(folder: Path | str) -> list[Scene]:
    """Every scene of a folder of scene folders, ordered by folder name.

    Raises SourceErrors with everything that is wrong with any of them.
    """
    folder = Path(folder)
    files, errors = _scene_files(folder)
    scenes = []
    for file in files:
        scene, found = _read(file)
        errors += [error for error in found if error not in errors]  # models.toml is shared
        scenes += [scene] if scene else []
    errors += [*_shared_addresses(scenes), *_shared_keys(scenes)]
    if errors:
        raise SourceErrors(errors)
    return scenes


def _read(file: Path) -> tuple[Scene | None, list[SourceError]]:
    problems = Problems(file)
    raw = read_toml(file, problems)
    if raw is None:
        return None, problems.errors
    models, model_problems = read_catalogue(find_catalogue(file))
    whole, draft = read_tables(raw, problems)
    scene = compile_scene(whole, draft, models, problems)
    return scene, model_problems.errors + problems.errors


def _scene_files(folder: Path) -> tuple[list[Path], list[SourceError]]:
    """Scene files in order; a folder with TOML of another name is surely a slip."""
    if not folder.is_dir():
        return [], [SourceError(folder, "", "is not a folder of scenes")]
    files, errors = [], []
    for place in sorted(path for path in folder.iterdir() if path.is_dir()):
        if place.name.startswith("."):
            continue  # a version control's, an editor's
        if (place / SCENE_FILE).exists():
            files.append(place / SCENE_FILE)
        elif others := sorted(path.name for path in place.glob("*.toml")):
            message = f"has no {SCENE_FILE}, only {joined(others)}"
            hint = did_you_mean(others[0], [SCENE_FILE])
            errors.append(SourceError(place, "", message, hint=hint))
    return files, errors


def _shared_addresses(scenes: Iterable[Scene]) -> list[SourceError]:
    """Names that differ in spaces, or in small and capital letters, have one address."""
    errors: list[SourceError] = []
    owner: dict[str, Scene] = {}
    for scene in scenes:
        other = owner.setdefault(scene.id.casefold(), scene)
        if other is not scene:
            message = f"has the address {quoted(scene.id)} that {shown_path(other.path.parent)} has"
            errors.append(SourceError(scene.path.parent, "", message, hint="rename one of them"))
    return errors


def _shared_keys(scenes: Iterable[Scene]) -> list[SourceError]:
    """A key selects one scene only."""
    scenes = [scene for scene in scenes if scene.key]
    free = [key for key in "1234567890" if key not in {scene.key for scene in scenes}]
    errors: list[SourceError] = []
    owner: dict[str, Scene] = {}
    for scene in scenes:
        if scene.key in owner:
            message = f"{quoted(scene.key)} already selects {shown_path(owner[scene.key].path)}"
            hint = f"free: {joined(free)}" if free else "all keys are taken; leave it out"
            errors.append(SourceError(scene.path, "key", message, hint=hint))
        owner.setdefault(scene.key, scene)
    return errors
