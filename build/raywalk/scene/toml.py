"""Reads a TOML file; a broken one becomes an error with its line."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

from raywalk.scene.problems import Problems
from raywalk.work.snapshot import text_of

_POSITION = re.compile(r"^(.*) \(at (?:line (\d+), column (\d+)|(end of document))\)$", re.DOTALL)


def read_toml(path: Path, problems: Problems) -> dict[str, Any] | None:
    """The file's table; None, with the problem noted, if it cannot be read."""
    try:
        return tomllib.loads(text_of(path))
    except OSError as error:
        problems.add((), f"cannot be read: {(error.strerror or str(error)).lower()}")
    except UnicodeDecodeError as error:
        problems.add((), f"is not UTF-8 text (byte {error.start})", hint="save it as UTF-8")
    except tomllib.TOMLDecodeError as error:
        _add_syntax_error(str(error), problems)
    except (ValueError, RecursionError):
        problems.add((), "holds a number too long or tables nested too deeply to be read")
    return None


def _add_syntax_error(text: str, problems: Problems) -> None:
    match = _POSITION.match(text)
    what, line, column, end = match.groups() if match else (text, None, None, None)
    where = f"line {line}, column {column}" if line else "at the end" if end else "in the text"
    message = f"{where}: this is not TOML: {what[:1].lower()}{what[1:]}"
    problems.add((), message, hint=_hint(what))


def _hint(what: str) -> str:
    if "Cannot overwrite" in what or "Cannot declare" in what or "Cannot mutate" in what:
        return "a key or table stands here a second time"
    if "Invalid value" in what:
        return "texts stand in quotes, yes and no are true and false, decimals have a point"
    return ""
