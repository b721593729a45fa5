"""What is wrong with a person's own files, in words that person can act on.

An error names the file, the key in it, what is wrong, what is allowed, and where
possible a hint. All errors are gathered first and reported once, because fixing
ten mistakes in ten runs is ten times the work.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path


def shown_path(path: Path) -> str:
    """The path as a person would type it: relative to the current directory if below it."""
    absolute = Path(path).absolute()
    try:
        return absolute.relative_to(Path.cwd()).as_posix()
    except ValueError:
        return absolute.as_posix()


@dataclass(frozen=True)
class SourceError:
    """One problem in one file."""

    file: Path
    key: str  # e.g. "objects[2].material"; "" if the whole file is meant
    message: str  # what is wrong, with the value
    allowed: str = ""  # e.g. "known: glass, water"
    hint: str = ""  # e.g. 'did you mean "glass"?'

    def __str__(self) -> str:
        where = ": ".join(part for part in (shown_path(self.file), self.key) if part)
        advice = "  ".join(part for part in (self.hint, self.allowed) if part)
        return f"{where}: {self.message}" + (f"\n  {advice}" if advice else "")


class UserError(Exception):
    """An end that a person can act on: str() is all the command line prints."""


class SourceErrors(UserError):
    """Every problem found; str() is what the command line prints."""

    def __init__(self, errors: Iterable[SourceError]):
        self.errors = list(errors)
        super().__init__(self.errors)

    def __str__(self) -> str:
        count = f"{len(self.errors)} error{'s' if len(self.errors) != 1 else ''}"
        return "\n".join([*map(str, self.errors), f"{count}; nothing was traced"])
