"""Puts a finished site in place of the old one; a failed build leaves the old one alone."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from raywalk.errors import SourceError, SourceErrors
from raywalk.work.exchange import exchange
from raywalk.work.leftovers import abandoned, owned_name
from raywalk.work.ownership import HINT, keep_foreign, mark, refuse_foreign

TRIES = 20  # two builds that end in the same moment; each try lasts two renames
SITE, REPLACED = "site", "replaced"  # in a folder beside: a site that may be needed again, or not


@contextmanager
def staged(out: Path) -> Iterator[Path]:
    """A folder beside `out` to build into; it becomes `out` when the block ends well.

    Each build has its own, so that two of them do not write into one another's; the one that
    ends last stays. Raises SourceErrors where `out` is not ours to replace.
    """
    out = ready(out)
    out.parent.mkdir(parents=True, exist_ok=True)
    beside = _folder_beside(out)
    fresh = beside / REPLACED
    fresh.mkdir()
    try:
        yield fresh
        mark(fresh)
        keep_foreign(out, fresh)
        _swap(fresh, out, beside)
    finally:
        _put_back(beside, out)
        shutil.rmtree(beside, ignore_errors=True)


def ready(out: Path) -> Path:
    """Where the site goes: where a link leads, the link stays. What a killed build left is mended.
    Raises SourceErrors where something else is there."""
    try:
        out = out.resolve()
        out.exists()
    except (OSError, RuntimeError, ValueError) as problem:  # links in a circle, a name too long
        message = f"is no place for a site ({getattr(problem, 'strerror', None) or problem})"
        raise SourceErrors([SourceError(out, "", message, hint=HINT)]) from None
    restore(out)
    refuse_foreign(out)
    return out


def restore(out: Path) -> None:
    """Clears away what killed builds left beside a site; one that was killed between its two
    renames took the site along: it is put back."""
    for place in abandoned(out.parent, f"{out.name}."):
        _put_back(place, out)
        shutil.rmtree(place, ignore_errors=True)


def _swap(fresh: Path, out: Path, beside: Path) -> None:
    """In one step, or in two renames: for the moment between them there is no site, never half
    a one."""
    if exchange(fresh, out):
        return
    for _ in range(TRIES):
        if out.exists():
            _move(out, beside / SITE)
        if _move(fresh, out):
            if (beside / SITE).exists():
                (beside / SITE).rename(beside / REPLACED)
            return
        shutil.rmtree(beside / SITE, ignore_errors=True)
    raise OSError(f"{out} is being replaced by other builds all the time")


def _put_back(beside: Path, out: Path) -> None:
    """The old site, where no new one came in its place."""
    if (beside / SITE).is_dir() and not out.exists():
        _move(beside / SITE, out)


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
