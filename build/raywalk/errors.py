"""What is wrong with a person's own files, in words that person can act on.

An error names the file, the key in it, what is wrong, what is allowed, and where
possible a hint. All errors are gathered first and reported once, because fixing
ten mistakes in ten runs is ten times the work.
"""

from __future__ import annotations

import errno
import os
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

CONTROL = re.compile(r"[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
FULL = "make room on the disk, or put --out and --work on another; run it again to go on from here"
LOCKED = "allow this user to write there, or choose another --out or --work"
HINTS = {
    errno.ENOSPC: FULL, errno.EDQUOT: FULL, errno.EFBIG: FULL,
    errno.EROFS: LOCKED, errno.EACCES: LOCKED, errno.EPERM: LOCKED,
    errno.ENOTDIR: "a file stands where a folder is needed",
    errno.EISDIR: "a folder stands where a file is needed",
}  # fmt: skip


def shown_path(path: Path) -> str:
    """The path as a person would type it: relative to the current directory if below it."""
    absolute = Path(path).absolute()
    try:
        return absolute.relative_to(Path.cwd()).as_posix()
    except ValueError:
        return absolute.as_posix()


def visible(text: str) -> str:
    """With control characters, and those that turn the direction of writing, as Python writes
    them: a terminal would obey them."""
    return CONTROL.sub(lambda match: repr(match[0])[1:-1], text)


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
        return visible(f"{where}: {self.message}") + (f"\n  {visible(advice)}" if advice else "")


MOST = 500  # errors that are printed at once


class UserError(Exception):
    """An end that a person can act on: str() is all the command line prints."""


def disk_trouble(trouble: OSError) -> str:
    """What a disk that is full, may not be written or has failed means to who builds."""
    place = f"{shown_path(Path(os.fsdecode(trouble.filename)))}: " if trouble.filename else ""
    hint = HINTS.get(trouble.errno or 0, "")
    said = trouble.strerror or str(trouble)
    return f"{place}{said}" + (f"\n  hint: {hint}" if hint else "")


class SourceErrors(UserError):
    """Every problem found; str() is what the command line prints."""

    def __init__(self, errors: Iterable[SourceError]):
        self.errors = list(errors)
        super().__init__(self.errors)

    def __str__(self) -> str:
        count = f"{len(self.errors)} error{'s' if len(self.errors) != 1 else ''}"
        shown = [str(error) for error in self.errors[:MOST]]
        if len(self.errors) > MOST:
            shown.append(f"and {len(self.errors) - MOST:,} more")
        return "\n".join([*shown, f"{count}; nothing was traced"])
