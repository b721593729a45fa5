"""Pictures in lessons: ![what it shows](sketch.png), a file beside scene.toml."""

from __future__ import annotations

import re
from collections.abc import Iterable
from html import unescape
from pathlib import Path
from urllib.parse import unquote

from raywalk.scene.lesson_text import PICTURES, lesson_html
from raywalk.scene.model import Scene
from raywalk.scene.problems import Location, Problems
from raywalk.scene.wording import did_you_mean, joined, quoted

#: Bytes: what comes with a page must come quickly.
LARGEST = 300_000
#: How files of each kind begin, whatever they are called.
BEGINS = {
    "png": (b"\x89PNG\r\n",), "jpg": (b"\xff\xd8\xff",), "jpeg": (b"\xff\xd8\xff",),
    "webp": (b"RIFF",), "svg": (b"<svg", b"<?xml", b"<!--", b"\xef\xbb\xbf<"),
}  # fmt: skip
SOURCE = re.compile(rf'<img [^>]*src="\.\./[^"/]*/{PICTURES}/([^"]+)"')


def pictures_in(texts: Iterable[str]) -> list[str]:
    """The names of the files that lesson texts show, each once."""
    with_some = (text for text in texts if "![" in text)
    found = [name for text in with_some for name in SOURCE.findall(lesson_html(text, "here"))]
    return list(dict.fromkeys(unquote(unescape(name)) for name in found))


def pictures_of(scene: Scene) -> list[Path]:
    """The files that a scene's lesson shows."""
    texts = [text for step in scene.lesson for text, _ in step.said().values()]
    return [scene.path.parent / name for name in pictures_in(texts)]


def check_pictures(text: str, at: Location, problems: Problems) -> None:
    """Each must be there, small, and what its name says."""
    folder = problems.file.absolute().parent
    for name in pictures_in([text]):
        file = folder / name
        what = f"the picture {quoted(name)}"
        if not file.is_file():
            there = sorted(path.name for path in folder.iterdir() if _kind(path) in BEGINS)
            allowed = f"there are {joined(there)}" if there else "there is no picture"
            hint = did_you_mean(name, there)
            problems.add(at, f"{what} is not in the scene's folder", allowed=allowed, hint=hint)
        elif (size := file.stat().st_size) > LARGEST:
            hint = "save it with fewer pixels, or as WebP"
            message = f"{what} has {size:,} bytes; at most {LARGEST:,} come quickly enough"
            problems.add(at, message, hint=hint)
        elif not file.read_bytes()[:100].lstrip().startswith(BEGINS[_kind(file)]):
            problems.add(at, f"{what} does not begin as a .{_kind(file)} file does")


def _kind(path: Path) -> str:
    return path.suffix.lower().removeprefix(".")
