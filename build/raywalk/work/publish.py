"""Puts a finished site in place of the old one; a failed build leaves the old one alone."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from raywalk.work.leftovers import owned_name, remove_leftovers

TRIES = 20  # two builds that end in the same moment; each try lasts two renames


@contextmanager
def staged(out: Path) -> Iterator[Path]:
    """A folder beside `out` to build into; it becomes `out` when the block ends well.

    Each build has its own, so that two of them do not write into one another's; the one that
    ends last stays.
    """
    out.parent.mkdir(parents=True, exist_ok=True)
    remove_leftovers(out.parent, f"{out.name}.")
    fresh = _folder_beside(out)
    try:
        yield fresh
        _swap(fresh, out)
    finally:
        shutil.rmtree(fresh, ignore_errors=True)


def _swap(fresh: Path, out: Path) -> None:
    """Two renames: for the moment between them there is no site, never half a one."""
    fresh.chmod(0o755)  # what mkdtemp makes only its owner may read; a site is for everyone
    old = _folder_beside(out)
    try:
        for _ in range(TRIES):
            if out.exists():
                _move(out, old / "site")
            if _move(fresh, out):
                return
            shutil.rmtree(old / "site", ignore_errors=True)
        raise OSError(f"{out} is being replaced by other builds all the time")
    finally:
        shutil.rmtree(old, ignore_errors=True)


def _move(folder: Path, place: Path) -> bool:
    """False if another build was quicker and moved it, or put its own site there."""
    try:
        folder.rename(place)
    except OSError:
        if folder.exists() and not place.exists():
            raise
        return False
    return True


def _folder_beside(out: Path) -> Path:
    return Path(tempfile.mkdtemp(dir=out.parent, **owned_name(f"{out.name}.")))
