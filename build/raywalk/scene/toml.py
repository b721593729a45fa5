"""Reads a TOML file; a broken one becomes an error with its line."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

from raywalk.scene.problems import Problems
from raywalk.scene.typing_slips import slips_in
from raywalk.work.snapshot import text_of

_POSITION = re.compile(r"^(.*) \(at (?:line (\d+), column (\d+)|(end of document))\)$", re.DOTALL)


def read_toml(path: Path, problems: Problems) -> dict[str, Any] | None:
    """The file's table; None, with the problem noted, if it cannot be read."""
    text = ""
    try:
        text = text_of(path)
        return tomllib.loads(text)
    except OSError as error:
        problems.add((), f"cannot be read: {(error.strerror or str(error)).lower()}")
    except UnicodeDecodeError as error:
        problems.add((), f"is not UTF-8 text (byte {error.start})", hint="save it as UTF-8")
    except tomllib.TOMLDecodeError as error:
        _add_syntax_error(str(error), text, problems)
    except (ValueError, RecursionError):
        problems.add((), "holds a number too long or tables nested too deeply to be read")
    return None


def _add_syntax_error(said: str, text: str, problems: Problems) -> None:
    """The parser's own words, unless the line has a slip whose cause is known; then all slips."""
    match = _POSITION.match(said)
    what, line, column, end = match.groups() if match else (said, None, None, None)
    slips = [(slip, *_position(text, slip.place)) for slip in slips_in(text)]
    for slip, at, in_line in slips:
        problems.add((), f"line {at}, column {in_line}: {slip.what}", hint=slip.instead)
    if any(str(at) == line for _, at, _ in slips):
        return
    where = f"line {line}, column {column}" if line else "at the end" if end else "in the text"
    message = f"{where}: this is not TOML: {what[:1].lower()}{what[1:]}"
    problems.add((), message, hint=_hint(what))


def _position(text: str, place: int) -> tuple[int, int]:
    """Line and column, from 1."""
    before = text[:place]
    return before.count("\n") + 1, place - (before.rfind("\n") + 1) + 1


def _hint(what: str) -> str:
    if "Cannot overwrite" in what or "Cannot declare" in what or "Cannot mutate" in what:
        return "a key or table stands here a second time"
    if "Unclosed" in what:
        return "a bracket that is opened on a line before is not closed: ] or }"
    if "Invalid value" in what:
        return "texts stand in quotes, yes and no are true and false, decimals have a point"
    return ""
