"""How wide words are, and where lines break.

Set in Arimo, whose widths are those of Arial and Liberation Sans: what fits here fits in
PowerPoint, in a browser and in LibreOffice.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from functools import cache, lru_cache
from pathlib import Path

from PIL import ImageFont

from raywalk.errors import SourceError, SourceErrors
from raywalk.home import HOME
from raywalk.slides.figure import Run

FOLDER = HOME / "node_modules" / "@expo-google-fonts" / "arimo"
# By (bold, italic).
FILES = {
    (False, False): "400Regular/Arimo_400Regular.ttf",
    (True, False): "700Bold/Arimo_700Bold.ttf",
    (False, True): "400Regular_Italic/Arimo_400Regular_Italic.ttf",
    (True, True): "700Bold_Italic/Arimo_700Bold_Italic.ttf",
}
FAMILY = "Arial, 'Liberation Sans', Arimo, Helvetica, sans-serif"


def font_file(bold: bool = False, italic: bool = False) -> Path:
    """The TrueType file of a style. Raises SourceErrors if npm has not installed it."""
    path = FOLDER / FILES[bold, italic]
    if not path.is_file():
        problem = SourceError(
            path, "", "the slides' font is missing", hint="run `make` or `npm ci`"
        )
        raise SourceErrors([problem])
    return path


def width(text: str, size: float, bold: bool = False, italic: bool = False) -> float:
    """Points."""
    return size * sum(_advance(char, bold, italic) for char in text)


@cache
def _advance(char: str, bold: bool, italic: bool) -> float:
    """Share of the size. Signs that are wide in every font count as a full square."""
    if unicodedata.combining(char):
        return 0.0
    if unicodedata.east_asian_width(char) in "WF":
        return 1.0
    return float(_face(bold, italic).getlength(char)) / 1000


@cache
def _face(bold: bool, italic: bool) -> ImageFont.FreeTypeFont:
    layout = ImageFont.Layout.BASIC  # no kerning, as our writers set none
    return ImageFont.truetype(font_file(bold, italic), 1000, layout_engine=layout)


def run_width(run: Run, size: float) -> float:
    return width(run.text, size, run.bold, run.italic)


def is_right_to_left(text: str) -> bool:
    """Whether its first letter with a direction is Hebrew, Arabic or alike."""
    for char in text:
        direction = unicodedata.bidirectional(char)
        if direction in ("R", "AL"):
            return True
        if direction == "L":
            return False
    return False


def shortened(text: str, size: float, most: float, bold: bool = False) -> str:
    """The text, cut with an ellipsis where it is wider than `most` points."""
    if width(text, size, bold) <= most:
        return text
    while text and width(text + "…", size, bold) > most:
        text = text[:-1]
    return text.rstrip() + "…"


def wrapped(runs: Iterable[Run], size: float, most: float) -> list[tuple[Run, ...]]:
    """Lines at most so many points wide, broken at spaces, within a word only if it is too long."""
    return list(_wrapped(tuple(runs), size, most))


@lru_cache(maxsize=4096)  # to part words evenly the same ones are laid out many times
def _wrapped(runs: tuple[Run, ...], size: float, most: float) -> tuple[tuple[Run, ...], ...]:
    lines: list[list[Run]] = [[]]
    room = most
    for word in _words(runs, size, most):
        need = sum(run_width(run, size) for run in word)
        bare = sum(run_width(Run(run.text.rstrip(), run.bold, run.italic), size) for run in word)
        if bare > room and lines[-1]:
            lines.append([])
            room = most
        lines[-1] += word
        room -= need
    return tuple(_joined(line) for line in lines if line)


def _words(runs: Iterable[Run], size: float, most: float) -> Iterable[list[Run]]:
    """Words with the spaces after them; a word may change its style in the middle. A number
    keeps its per cent sign."""
    word: list[Run] = []
    for run in runs:
        for piece in _pieces(run.text):
            word.append(Run(piece, run.bold, run.italic))
            if piece.endswith(" "):
                yield from _broken(word, size, most)
                word = []
    if word:
        yield from _broken(word, size, most)


def _pieces(text: str) -> list[str]:
    parts = re.split(r"(?<!\d) | (?!%)", text)
    return [part + " " for part in parts[:-1]] + ([parts[-1]] if parts[-1] else [])


def _broken(word: list[Run], size: float, most: float) -> Iterable[list[Run]]:
    """The word, in parts where it alone is wider than a line."""
    if sum(run_width(run, size) for run in word) <= most:
        yield word
        return
    part: list[Run] = []
    room = most
    for run in word:
        for char in run.text:
            need = width(char, size, run.bold, run.italic)
            if need > room and part:
                yield part
                part, room = [], most
            part.append(Run(char, run.bold, run.italic))
            room -= need
    yield part


def _joined(runs: Sequence[Run]) -> tuple[Run, ...]:
    """Neighbours of one style put together; the space at the line's end taken off."""
    joined: list[Run] = []
    for run in runs:
        last = joined[-1] if joined else None
        if last and (last.bold, last.italic) == (run.bold, run.italic):
            joined[-1] = Run(last.text + run.text, run.bold, run.italic)
        else:
            joined.append(run)
    if joined:
        last = joined[-1]
        joined[-1] = Run(last.text.rstrip(" "), last.bold, last.italic)
    return tuple(joined)
