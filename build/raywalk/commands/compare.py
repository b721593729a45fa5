"""raywalk compare: what the page check/ says of a picture, in a terminal: for graders, and wherever
students' programs are tested."""

from __future__ import annotations

import json
from argparse import Namespace
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raywalk.errors import SourceError, SourceErrors, UserError, shown_path
from raywalk.home import HOME

if TYPE_CHECKING:
    from raywalk.check.report import Report
    from raywalk.scene.model import Scene
    from raywalk.stops.process import Stops
    from raywalk.work.progress import Message
    from raywalk.work.store import Entry

SITE_SOURCE = HOME / "site_src"
#: Endings of files that a class's folder is searched for; a file that is named may have any.
PICTURES = (".png", ".jpg", ".jpeg", ".ppm", ".pgm", ".pnm", ".bmp", ".tga", ".pfm", ".csv", ".txt")


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    from raywalk.words import languages

    parser = commands.add_parser(
        "compare", help="a student's picture, or a folder of them, beside the right one",
        description="Ends with 0 if all pictures are right, else with 1.",
    )  # fmt: skip
    parser.add_argument("picture", type=Path, nargs="+", help="a file, or a folder of a class's")
    parser.add_argument("--scene", required=True, help="a scene's id, or how it begins: 02")
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--json", action="store_true", help="everything, as JSON")
    form.add_argument("--junit", action="store_true", help="a test case a picture, as JUnit's XML")
    parser.add_argument("--language", choices=languages(), default="en", help="of the sentences")
    parser.add_argument(
        "--work", type=Path, default=Path(".work"), help="where right pictures are kept"
    )
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str | Message]:
    """Traces what is not kept, then tells of each picture. Raises UserError if one is not right."""
    from raywalk.check.report import as_json, as_junit, as_table, as_text
    from raywalk.scene.read import read_scene
    from raywalk.stops.process import Stops

    scene = read_scene(scene_named(chosen.scene, chosen.scenes))
    files = list(pictures_in(chosen.picture))
    asked = {"do": "check", "language": chosen.language, "names": _names(scene, chosen.language)}
    entry = yield from right_pictures(scene, chosen)
    asked |= {"data": str(entry.folder)}
    with Stops(SITE_SOURCE / "check.mjs") as node:
        reports = [_asked(node, file, asked) for file in files]
    if chosen.json:
        yield as_json(scene, reports)
    elif chosen.junit:
        yield as_junit(scene, reports)
    elif len(reports) > 1:
        yield as_table(reports)
    else:
        yield as_text(reports[0])
    wrong = [each for each in reports if not each.is_right]
    if wrong:
        raise NotRight(f"{len(wrong)} of {len(reports)} pictures not right")


class NotRight(UserError):
    """A picture is not the right one: no mistake in how the command was used."""


def scene_named(named: str, folder: Path) -> Path:
    """The file of the one scene in a folder whose id begins so, or that is named by its path."""
    from raywalk.commands.check import scene_file

    given = scene_file(named, folder)
    if given.exists():
        return given
    found = sorted(path.parent for path in folder.glob(f"{glob_safe(named)}*/scene.toml"))
    if len(found) == 1:
        return found[0] / "scene.toml"
    known = ", ".join(path.name for path in found or sorted(folder.iterdir()) if path.is_dir())
    said = "several scenes begin so" if found else "there is no such scene"
    raise SourceErrors([SourceError(folder, "--scene", f"{named!r}: {said}", f"known: {known}")])


def glob_safe(text: str) -> str:
    """With the signs that stand for others taken as they are."""
    return "".join(f"[{each}]" if each in "*?[" else each for each in text)


def pictures_in(named: list[Path]) -> Iterator[Path]:
    """Files, and the pictures in folders by their names. Raises SourceErrors naming all that are
    not there."""
    problems = [SourceError(path, "", "no such file") for path in named if not path.exists()]
    empty = [path for path in named if path.is_dir() and not any(_within(path))]
    endings = ", ".join(PICTURES)
    problems += [SourceError(path, "", "no picture is in it", f"read: {endings}") for path in empty]
    if problems:
        raise SourceErrors(problems)
    for path in named:
        yield from _within(path) if path.is_dir() else [path]


def _within(folder: Path) -> Iterator[Path]:
    return (each for each in sorted(folder.rglob("*")) if each.suffix.lower() in PICTURES)


def right_pictures(scene: Scene, chosen: Namespace) -> Generator[str | Message, None, Entry]:
    """The entry that the page has, made unless it is kept; of a lesson on another scene, of that.
    Other programs read what --json and --junit print, so nothing else is told then."""
    from raywalk.pipeline.checking import check_chain
    from raywalk.pipeline.parts import trace_parts
    from raywalk.pipeline.trace_task import trace_into
    from raywalk.work.chains import run_chains
    from raywalk.work.digests import key_of
    from raywalk.work.pool import Workers, cores
    from raywalk.work.progress import say_nothing
    from raywalk.work.store import Store

    store, own = Store(chosen.work), scene.base or scene
    is_quiet = chosen.json or chosen.junit
    parts = trace_parts(own)
    if not (store.find(key_of(parts)) or is_quiet):
        yield f"tracing {own.id}"
    trace_into(store, {own.id: parts}, own, cores, say_nothing)
    with Workers() as workers:
        made = run_chains([check_chain(store, own, store.get(key_of(parts)))], workers)
        [entry] = yield from _silently(made) if is_quiet else made
    return entry


def _silently(work: Generator[Any, None, Any]) -> Generator[str, None, Any]:
    """Its result alone."""
    yield from ()
    while True:
        try:
            next(work)
        except StopIteration as end:
            return end.value


def _names(scene: Scene, language: str) -> dict[str, Any]:
    """What check.mjs calls objects and mistakes."""
    from raywalk.mistakes.table import BY_NAME
    from raywalk.scene.translation import read_spoken
    from raywalk.site.mistake_words import named, read_said

    [spoken] = read_spoken([scene], language)
    said = read_said(SITE_SOURCE, language)
    return {
        "scene": spoken.scene.title,
        "objects": [each.name for each in spoken.scene.objects],
        "mistakes": {name: named(said[name]) for name in BY_NAME},
    }


def _asked(node: Stops, file: Path, asked: dict[str, Any]) -> Report:
    """What is found about a picture; a file that cannot be read is a finding, too."""
    from raywalk.check.report import Report

    answer: dict[str, Any] = json.loads(node.ask(asked | {"picture": str(file)}, file))
    return Report(shown_path(file), answer)
