"""raywalk check: validates scenes without tracing them."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from raywalk.errors import SourceError, SourceErrors
from raywalk.pipeline.mistakes import misnamed
from raywalk.pipeline.wording import avoided_words
from raywalk.scene.model import Scene
from raywalk.scene.read import read_scene, read_scenes
from raywalk.scene.translation import Spoken, missing_translations, read_spoken
from raywalk.scene.wording import counted
from raywalk.words import languages, missing_sentences
from raywalk.words.catalogue import DEFAULT


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("check", help="validate scenes")
    parser.add_argument("scene", nargs="*", help="scene ids or files; all scenes if none is named")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """A line a scene that is in order. Raises SourceErrors with all that is not."""
    scenes, problems = _read(chosen)
    problems += misnamed(scenes)
    warnings: list[str] = []
    spoken = {DEFAULT: [Spoken(scene, True) for scene in scenes]}
    untold: list[str] = []
    for code in languages():
        try:
            if code != DEFAULT:
                spoken[code] = read_spoken(scenes, code)
            untold += missing_translations(spoken[code], code)
            untold += [f"warning: {line}" for line in avoided_words(spoken[code], code)]
            untold += [f"{code}.json: not translated: {key}" for key in missing_sentences(code)]
        except SourceErrors as raised:
            problems += raised.errors
    for k, scene in enumerate(scenes):
        try:
            warnings += check_scene(scene, {code: each[k] for code, each in spoken.items()})
        except SourceErrors as raised:
            problems += raised.errors
    warnings += untold
    if problems:
        raise SourceErrors(problems)
    yield from warnings
    for scene in scenes:
        holds = f"{counted(len(scene.objects), 'object')}, {counted(len(scene.lights), 'light')}"
        yield f"{scene.id}: {holds}: in order"
        yield from (f"  {line}" for line in _mesh_lines(scene))
        yield from (f"  {line}" for line in _sweep_lines(scene))


def check_scene(scene: Scene, spoken: dict[str, Spoken]) -> list[str]:
    """What only compiled geometry and rays know. Raises SourceErrors for unreadable meshes, open
    glass, buried cameras and slots that ask for what there is not; returns the warnings that a
    build gives too, and those of the lesson's words. spoken: the scene by language."""
    # numba and Embree: only where needed
    from raywalk.pipeline.lesson_checks import lesson_warnings
    from raywalk.trace.scene_warnings import scene_warnings
    from raywalk.trace.wavefront import Tracer

    tracer = Tracer(scene)
    warnings = [f"{scene.id}: warning: {warning}" for warning in scene_warnings(tracer)]
    return warnings + lesson_warnings(tracer, spoken)


def _mesh_lines(scene: Scene) -> list[str]:
    if not scene.has_mesh:
        return []
    from raywalk.geometry.mesh_report import mesh_lines

    return mesh_lines(scene)


def _sweep_lines(scene: Scene) -> list[str]:
    if not scene.sweeps or scene.base:
        return []
    from raywalk.sweeps.cost import cost_line
    from raywalk.trace.plan import LEAST_SHARE
    from raywalk.trace.wavefront import Tracer

    tracer = Tracer(scene, least_share=LEAST_SHARE)
    return [cost_line(scene, each, tracer) for each in scene.sweeps]


def scene_file(named: str, folder: Path) -> Path:
    """A scene's file from its id, its folder or the file itself."""
    direct = Path(named)
    if direct.is_file() or (direct / "scene.toml").is_file():
        return direct
    return folder / named / "scene.toml" if not direct.suffix else direct


def _read(chosen: Namespace) -> tuple[list[Scene], list[SourceError]]:
    if not chosen.scene:
        return read_scenes(chosen.scenes), []
    scenes, problems = [], []
    for named in chosen.scene:
        try:
            scenes.append(read_scene(scene_file(named, chosen.scenes)))
        except SourceErrors as raised:
            problems += raised.errors
    return scenes, problems
