"""Which folder is ours to replace, and what in it is somebody else's.

A site carries a list of its own files. A folder without it that holds anything is refused; a file
beside ours that is not on it (a host's CNAME, a worktree's .git) moves on into the new site.
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path

from raywalk.errors import SourceError, SourceErrors

#: In a site's root: its files, one a line, below a line that says so.
MARKER = ".raywalk"
SAYS = "Written by Raywalk, which replaces these files at its next build and keeps all others:"
#: Sites from before there was a list have all of these.
BEFORE = ("LICENSES.txt", "sizes.json", "sw.js")


def refuse_foreign(out: Path) -> None:
    """Raises SourceErrors for a folder that holds something and is no site of ours."""
    hint = "hint: choose another --out, an empty folder or one that is not there yet"
    if out.exists() and not out.is_dir():
        raise SourceErrors([SourceError(out, "", "is a file; a site needs a folder", hint=hint)])
    if out.is_dir() and any(out.iterdir()) and not _is_ours(out):
        found = sorted(path.name for path in out.iterdir())
        message = (
            f"was not made by Raywalk (there is no {MARKER} in it, but {_some(found)}), and a "
            "build would replace all of it"
        )
        raise SourceErrors([SourceError(out, "", message, hint=hint)])


def mark(site: Path) -> None:
    """Writes the list of all files that the site has now."""
    names = [path.relative_to(site).as_posix() for path in _files(site)]
    (site / MARKER).write_text("\n".join([SAYS, *names, ""]), encoding="utf-8")


def keep_foreign(old: Path, fresh: Path) -> None:
    """Copies into the new site what somebody put beside our files of the old one."""
    marker = old / MARKER
    if not marker.is_file():
        return
    ours = {MARKER, *marker.read_text(encoding="utf-8").splitlines()[1:]}
    for path in _files(old):
        name = path.relative_to(old)
        if name.as_posix() not in ours and not (fresh / name).exists():
            (fresh / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(path, fresh / name, follow_symlinks=False)


def _is_ours(out: Path) -> bool:
    return (out / MARKER).is_file() or all((out / name).is_file() for name in BEFORE)


def _files(folder: Path) -> Iterator[Path]:
    """Files and links below a folder, in order."""
    return (path for path in sorted(folder.rglob("*")) if path.is_symlink() or path.is_file())


def _some(names: list[str]) -> str:
    shown = ", ".join(names[:3])
    return f"{shown} and {len(names) - 3} more" if len(names) > 3 else shown
