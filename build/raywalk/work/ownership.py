"""Which folder is ours to replace, and what in it is somebody else's.

A site carries a list of its own files. A folder without it that holds anything is refused; a file
beside ours that is not on it (a host's CNAME, a worktree's .git) moves on into the new site.
"""

from __future__ import annotations

import filecmp
import shutil
from collections.abc import Iterable, Iterator
from pathlib import Path

from raywalk.errors import SourceError, SourceErrors, shown_path

#: In a site's root: its files, one a line, below a line that says so.
MARKER = ".raywalk"
SAYS = "Written by Raywalk, which replaces these files at its next build and keeps all others:"
#: Sites from before there was a list have all of these, and nothing of ours beside the others.
BEFORE = ("LICENSES.txt", "sizes.json", "sw.js")
OTHERS = (
    "index.html", "manifest.webmanifest", "sitemap.xml", "assets", "de", "model", "offline",
    "scenes", "sizes", "slides",
)  # fmt: skip
HINT = "hint: choose another --out, an empty folder or one that is not there yet"


def refuse_nested(out: Path, read: dict[str, Path]) -> None:
    """Raises SourceErrors for a place within what a build reads, or about it.

    read: folders by what they are, such as "the folder of scenes".
    """
    for what, folder in read.items():
        named = f"{what} ({shown_path(folder)})"
        inner, outer = out.resolve(), folder.resolve()
        if inner.is_relative_to(outer):
            message = f"lies in {named}, which builds read: they would read the site too"
        elif outer.is_relative_to(inner):
            message = f"holds {named}, which builds read: a site stands by itself"
        else:
            continue
        raise SourceErrors([SourceError(out, "", message, hint=HINT)])


def refuse_foreign(out: Path) -> None:
    """Raises SourceErrors for a folder that holds something and is no site of ours."""
    there = next(place for place in (out, *out.absolute().parents) if place.exists())
    if not there.is_dir():
        raise SourceErrors([SourceError(there, "", "is a file; a site needs a folder", hint=HINT)])
    if out.is_dir() and any(out.iterdir()) and not _is_ours(out):
        found = sorted(path.name for path in out.iterdir())
        other = "which is no list of ours" if (out / MARKER).exists() else f"and no {MARKER}"
        message = (
            f"was not made by Raywalk (it holds {_some(found)}, {other}), and a build would "
            "replace all of it"
        )
        raise SourceErrors([SourceError(out, "", message, hint=HINT)])


def mark(site: Path) -> None:
    """Writes the list of all files that the site has now."""
    _list(site, [path.relative_to(site).as_posix() for path in _files(site)])


def mark_too(site: Path, written: Iterable[Path]) -> None:
    """Adds files to that list which came to a finished site: the next build replaces them."""
    names = {path.relative_to(site).as_posix() for path in written if path.is_file()}
    _list(site, sorted({*(_listed(site) or ()), *names}))


def _list(site: Path, names: Iterable[str]) -> None:
    (site / MARKER).write_text("\n".join([SAYS, *names, ""]), encoding="utf-8")


def keep_foreign(old: Path, fresh: Path) -> None:
    """Copies into the new site what somebody put beside our files of the old one. Raises
    SourceErrors where a file of ours has the same name by now."""
    listed = _listed(old)
    ours = {MARKER, *(listed or ())}
    folders = {parent.as_posix() for name in ours for parent in Path(name).parents}
    taken = []
    for path in _all(old):
        name = path.relative_to(old)
        place = fresh / name
        if name.as_posix() in ours or (listed is None and name.parts[0] in (*BEFORE, *OTHERS)):
            continue
        if path.is_dir() and not path.is_symlink():
            # Also one that is empty: a repository without its refs/ is none.
            if name.as_posix() not in folders and (place.is_dir() or not place.exists()):
                place.mkdir(parents=True, exist_ok=True)
        elif not (place.exists() or place.is_symlink()):
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(path, place, follow_symlinks=False)
        elif not _is_same(path, place):
            taken.append(SourceError(
                old, name.as_posix(), "is not ours, and a new file of the site is called so",
                hint="hint: move it somewhere else, or choose another --out",
            ))  # fmt: skip
    if taken:
        raise SourceErrors(taken)


def _is_same(one: Path, other: Path) -> bool:
    return one.is_file() and other.is_file() and filecmp.cmp(one, other, shallow=False)


def _is_ours(out: Path) -> bool:
    return _listed(out) is not None or all((out / name).is_file() for name in BEFORE)


def _listed(site: Path) -> list[str] | None:
    """The files that a site says are ours; None if it has no list, or something else of its
    name."""
    try:
        said, *names = (site / MARKER).read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError, ValueError):
        return None
    return names if said == SAYS else None


def _files(folder: Path) -> Iterator[Path]:
    """Files and links below a folder, in order."""
    return (path for path in _all(folder) if path.is_symlink() or path.is_file())


def _all(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*"))


def _some(names: list[str]) -> str:
    shown = ", ".join(names[:3])
    return f"{shown} and {len(names) - 3} more" if len(names) > 3 else shown
