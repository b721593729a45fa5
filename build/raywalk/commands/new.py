"""raywalk new: a course in a folder of its own, or another scene in it."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from raywalk.errors import UserError, shown_path

USAGE = "raywalk new COURSE, or in a course's folder raywalk new scene NAME"
SCENE = "scene"


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser(
        "new", help="begin a course, or a scene in it",
        usage=f"{USAGE} [--from SCENE | --model FILE]",
        description="A course is a folder with scenes/, in which each scene has a folder.",
    )  # fmt: skip
    parser.add_argument("words", nargs="+", metavar="NAME", help="a folder, or `scene` and a name")
    made_of = parser.add_mutually_exclusive_group()
    made_of.add_argument(
        "--from", dest="other", metavar="SCENE",
        help="begin with a copy of this one, of the course or of Raywalk's own: 02-shadows",
    )  # fmt: skip
    made_of.add_argument("--model", type=Path, metavar="FILE", help="begin with a model of yours")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """Writes it, and says what comes next. Raises UserError."""
    match chosen.words:
        case [folder] if not (chosen.other or chosen.model):
            yield from _course(Path(folder))
        case [word, name] if word == SCENE:
            yield from _scene(name, chosen)
        case _:
            raise UserError(f"this is no name of a course, nor of a scene\n  hint: {USAGE}")


def _course(folder: Path) -> Iterator[str]:
    from raywalk.course.new_course import begin_course

    yield f"{shown_path(begin_course(folder))}: a scene that says what its lines mean"
    yield f"next: cd {folder.as_posix()}; raywalk serve shows it, and follows as you write"


def _scene(name: str, chosen: Namespace) -> Iterator[str]:
    from raywalk.course.new_scene import begin_from, begin_scene, begin_with_model

    if chosen.other:
        file = begin_from(name, chosen.scenes, chosen.other)
    elif chosen.model:
        file = begin_with_model(name, chosen.scenes, chosen.model)
    else:
        file = begin_scene(name, chosen.scenes)
    yield f"{shown_path(file)}: raywalk serve shows it, and follows as you write"
