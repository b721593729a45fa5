"""Another scene of a course: like the first one, like one that is there, or about a model."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path
from typing import Any

from raywalk.course.new_course import BEGINNING
from raywalk.errors import SourceError, SourceErrors
from raywalk.home import HOME
from raywalk.models.beside import beside
from raywalk.models.clean import clean
from raywalk.models.faults import ModelFault
from raywalk.models.read import read_model
from raywalk.models.report import report
from raywalk.models.telling import box_in_scene, for_a_scene
from raywalk.scene.wording import did_you_mean, joined, quoted

FILE = "scene.toml"
NUMBERED = re.compile(r"(\d+)-")
KEY = re.compile(r'^key = "([^"]*)"', re.MULTILINE)
BEFORE = re.compile(r"^before = .*\n", re.MULTILINE)
ON = re.compile(r'^scene = "([^"]+)"', re.MULTILINE)
SLOT_OF = re.compile(r"\{[^{}\n]* in ([\w-]+)\}")


def begin_scene(name: str, scenes: Path) -> Path:
    """A scene as `raywalk new` begins with. Raises SourceErrors, as all of these."""
    return _written(_place(name, scenes), BEGINNING.read_text(encoding="utf-8"))


def begin_from(name: str, scenes: Path, other: str) -> Path:
    """A copy of the course's scene of that name or of Raywalk's, with its words in all languages
    and its pictures."""
    source = _source(other, scenes)
    text = (source / FILE).read_text(encoding="utf-8")
    wanted = {*ON.findall(text), *SLOT_OF.findall(text)} - {source.name}
    if missing := sorted(each for each in wanted if not (scenes / each / FILE).is_file()):
        message = f"speaks of {joined(map(quoted, missing))}, which this course does not have"
        raise SourceErrors([SourceError(source / FILE, "", message, hint=(
            f"raywalk new scene {missing[0]} --from {missing[0]}"
        ))])  # fmt: skip
    place = _place(name, scenes)
    shutil.copytree(source, place)
    return _written(place, BEFORE.sub("", text))


def begin_with_model(name: str, scenes: Path, model: Path) -> Path:
    """A scene about a model file, which is copied beside it; it is seen whole."""
    try:
        cleaned = clean(read_model(model))
    except ModelFault as fault:
        raise SourceErrors([SourceError(model, "", str(fault))]) from None
    place, facts = _place(name, scenes), report(cleaned)
    textures = {each.texture for each in cleaned.model.materials if each.texture}
    place.mkdir(parents=True)
    for file in {model, *beside(model), *filter(Path.is_file, textures)}:
        _copy(file, model.parent, place)
    return _written(place, _about_model(re.sub(r"^\d+-", "", place.name), facts))


def _place(name: str, scenes: Path) -> Path:
    """A new folder's: numbers, by which scenes stand in order, go on where none is given."""
    if not scenes.is_dir():
        message = "is no folder of scenes: a course has one"
        raise SourceErrors([SourceError(scenes, "", message, hint="raywalk new NAME makes one")])
    if not re.fullmatch(r"[\w-]+", name):
        allowed = "allowed: letters, digits, - and _, as in an address"
        message = f"{quoted(name)} is no name of a scene"
        raise SourceErrors([SourceError(scenes, "", message, allowed)])
    numbers = [int(found[1]) for each in scenes.iterdir() if (found := NUMBERED.match(each.name))]
    numbered = name if NUMBERED.match(name) else f"{max(numbers, default=0) + 1:02}-{name}"
    if (scenes / numbered).exists():
        raise SourceErrors([SourceError(scenes / numbered, "", "is there already")])
    return scenes / numbered


def _source(other: str, scenes: Path) -> Path:
    """The folder of a scene that is there; the course's come first."""
    for folder in (scenes, HOME / "scenes"):
        if (folder / other / FILE).is_file():
            return folder / other
    known = sorted({
        path.parent.name for of in (scenes, HOME / "scenes") for path in of.glob(f"*/{FILE}")
    })  # fmt: skip
    raise SourceErrors([SourceError(
        scenes, "--from", f"there is no scene {quoted(other)}",
        f"known: {joined(map(quoted, known))}", did_you_mean(other, known),
    )])  # fmt: skip


def _written(place: Path, text: str) -> Path:
    """Its file, with a key on the keyboard that no other scene has, or none."""
    taken = {key for path in place.parent.glob(f"*/{FILE}") for key in KEY.findall(_read(path))}
    free = (key for key in (*KEY.findall(text), *"1234567890") if key not in taken)
    key = next(free, "")
    place.mkdir(parents=True, exist_ok=True)
    (place / FILE).write_text(KEY.sub(f'key = "{key}"' if key else "", text), encoding="utf-8")
    return place / FILE


def _read(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace")


def _copy(file: Path, around: Path, place: Path) -> None:
    """To the same place beside the scene: OBJ and glTF name others of their files by that."""
    below = file.relative_to(around) if file.is_relative_to(around) else Path(file.name)
    (place / below).parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(file, place / below)


MODEL = """\
#:schema ../scene.schema.json
# Every key there is stands in ../README.md; `raywalk model {file}` tells what is in the model.
version = 1
key = "1"
title = {title}
teaches = "One sentence: what a student takes home."

[camera]
eye = {eye}
target = {target}

{object}

[[lights]]
position = {light}

[[lesson]]
headline = "One ray for one pixel"
text = "One ray starts at the eye and runs through its pixel."
view = {{ resolution = 15, pixel = [7, 7], rays = ["pixel"], observer = "start" }}
"""


def _about_model(name: str, facts: dict[str, Any]) -> str:
    """Seen from in front and a little above, lit from the left."""
    (low, high), moves = box_in_scene(facts), for_a_scene(facts)
    middle = [(a + b) / 2 for a, b in zip(low, high, strict=True)]
    across = max(b - a for a, b in zip(low, high, strict=True))

    def point(*steps: float) -> str:
        return _point([at + across * step for at, step in zip(middle, steps, strict=True)])

    lines = [line.strip() for line in moves][1:]
    return MODEL.format(
        file=facts["file"], title=json.dumps(name.replace("-", " ").capitalize()),
        eye=point(0, 0.4, 2.2), target=point(0, 0, 0), light=point(-2, 2.5, 2.5),
        object="\n".join([lines[0], f"name = {json.dumps(name)}", *lines[1:]]),
    )  # fmt: skip


def _point(numbers: list[float]) -> str:
    return "[" + ", ".join(f"{number:.4g}" for number in numbers) + "]"
