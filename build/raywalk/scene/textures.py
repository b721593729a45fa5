"""Textures that a scene file gives: pictures in its own folder."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from raywalk.errors import shown_path
from raywalk.scene.model import Texture
from raywalk.scene.pictures import FORMATS, PictureFault, read_texture
from raywalk.scene.problems import Location, Problems
from raywalk.scene.schema_objects import TextureTable
from raywalk.scene.wording import did_you_mean, joined, quoted


def texture_of(keys: dict[str, Any], folder: Path) -> Texture:
    """Of a TextureTable's keys."""
    return Texture(folder / keys["file"], keys["filter"], keys["repeat"])


def check_texture(table: TextureTable, at: Location, problems: Problems) -> bool:
    """Whether the picture is in the scene's folder and can be read; notes what is wrong."""
    folder = problems.file.absolute().parent
    place, what = (*at, "file"), f"the picture {quoted(table.file)}"
    try:
        path = (folder / table.file).resolve()
        if not path.is_relative_to(folder.resolve()):
            hint = "copy it beside scene.toml"
            allowed = f"allowed: a picture in {shown_path(folder)}"
            problems.add(
                place, f"{what} lies outside of the scene's folder", allowed=allowed, hint=hint
            )
            return False
        is_there = path.is_file()
    except (OSError, ValueError):  # a name that no file can have
        is_there = False
    if not is_there:
        there = sorted(each.name for each in folder.iterdir() if each.suffix.lower() in FORMATS)
        allowed = f"there are {joined(there)}" if there else "there is no picture"
        hint = did_you_mean(table.file, there)
        problems.add(place, f"{what} is not in the scene's folder", allowed=allowed, hint=hint)
        return False
    try:
        read_texture(texture_of(table.model_dump(), folder))
    except PictureFault as fault:
        problems.add(place, f"{what} {fault.cause}", hint=fault.remedy)
        return False
    return True
