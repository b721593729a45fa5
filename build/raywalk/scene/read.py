"""Reads scene files. All errors of all files are gathered and raised once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from raywalk.errors import SourceError, SourceErrors, shown_path
from raywalk.scene.compile import compile_lesson, compile_scene, light_names
from raywalk.scene.draft import read_lesson, read_tables
from raywalk.scene.model import Scene
from raywalk.scene.models import find_catalogue, read_catalogue
from raywalk.scene.order import in_order, misplaced
from raywalk.scene.problems import Problems
from raywalk.scene.sweeps import read_sweeps
from raywalk.scene.toml import read_toml
from raywalk.scene.wording import did_you_mean, joined, quoted

SCENE_FILE = "scene.toml"
ON = "scene"  # the key by which a file is known as a lesson on another scene


@dataclass(frozen=True)
class _Reading:
    """What came of one file."""

    scene: Scene | None
    errors: list[SourceError]
    lights: list[str] | None  # names, as the file gives them; None where they are not known


def read_scene(path: Path | str) -> Scene:
    """The scene in one file, or in the scene.toml of a folder; a lesson on another scene with it.

    Raises SourceErrors with everything that is wrong with it.
    """
    path = Path(path)
    file = path / SCENE_FILE if path.is_dir() else path
    read = _read(file, {})
    if read.errors or read.scene is None:
        raise SourceErrors(read.errors)
    return read.scene


def read_scenes(folder: Path | str) -> list[Scene]:
    """Every scene of a folder of scene folders, in the course's order.

    Raises SourceErrors with everything that is wrong with any of them.
    """
    folder = Path(folder)
    files, errors = _scene_files(folder)
    scenes: list[Scene] = []
    known: dict[Path, _Reading] = {}
    for file in files:
        read = _read(file, known)
        errors += [each for each in read.errors if each not in errors]  # models.toml is shared
        scenes += [read.scene] if read.scene else []
    errors += misplaced(scenes, [file.parent.name for file in files])
    scenes = in_order(scenes)
    errors += [*_shared_addresses(scenes), *_shared_keys(scenes)]
    if errors:
        raise SourceErrors(errors)
    return scenes


def read_own_scenes(folder: Path | str) -> list[Scene]:
    """Those that are traced: without lessons on others. Raises SourceErrors as `read_scenes`."""
    return [scene for scene in read_scenes(folder) if not scene.base]


def _read(file: Path, known: dict[Path, _Reading]) -> _Reading:
    """known: files that were read already, by path; this one joins them."""
    if file not in known:
        problems = Problems(file)
        raw = read_toml(file, problems)
        if raw is None:
            known[file] = _Reading(None, problems.errors, None)
        elif ON in raw:
            known[file] = _read_lesson(raw, problems, known)
        else:
            known[file] = _read_scene(raw, problems)
    return known[file]


def _read_scene(raw: dict[str, Any], problems: Problems) -> _Reading:
    models, model_problems = read_catalogue(find_catalogue(problems.file))
    whole, draft = read_tables(raw, problems)
    scene = compile_scene(whole, draft, models, problems)
    sweeps = read_sweeps(scene, raw, draft, models, problems)
    scene = replace(scene, sweeps=sweeps) if scene and not problems.errors else None
    lights = list(light_names(draft).values()) if whole else None
    return _Reading(scene, model_problems.errors + problems.errors, lights)


def _read_lesson(raw: dict[str, Any], problems: Problems, known: dict[Path, _Reading]) -> _Reading:
    """A lesson on another scene. Where that has mistakes they are told as its own."""
    whole, steps = read_lesson(raw, problems)
    base = _base(raw[ON], problems, known) if isinstance(raw[ON], str) else None
    scene = compile_lesson(
        whole, steps, base.scene if base else None, base.lights if base else None, problems
    )
    return _Reading(scene, (base.errors if base else []) + problems.errors, None)


def _base(named: str, problems: Problems, known: dict[Path, _Reading]) -> _Reading | None:
    """The scene that a lesson names; None, with the problem noted, if it cannot be that."""
    folder = problems.file.parent.parent
    files = [
        file for file in _scene_files(folder)[0] if file.parent.name != problems.file.parent.name
    ]
    file = next((each for each in files if each.parent.name == named), None)
    if file is not None and not _is_lesson(file):
        return _read(file, known)
    own = [each.parent.name for each in files if not _is_lesson(each)]
    said = "is no scene of its own, but a lesson too" if file else "there is no such scene"
    problems.add(
        (ON,), f"{quoted(named)}: {said}", allowed=f"known: {joined(map(quoted, own))}",
        hint=did_you_mean(named, own),
    )  # fmt: skip
    return None


def _is_lesson(file: Path) -> bool:
    return ON in (read_toml(file, Problems(file)) or {})


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
