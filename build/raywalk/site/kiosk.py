"""The kiosk's archive: the built site, how to start it, and a sheet that says so."""

from __future__ import annotations

import os
import re
import zipfile
from collections.abc import Iterator
from pathlib import Path

from raywalk.errors import UserError, shown_path
from raywalk.site.offline import MANIFEST, WORKER
from raywalk.site.preview import NAME as PREVIEW
from raywalk.site.sitemap import FILE as SITEMAP
from raywalk.words import languages

TOP, SITE = "raywalk-kiosk", "course"
LIMIT = 64_000_000  # bytes: what an old USB stick takes; slides are most of it
WHEN = (1980, 1, 1, 0, 0, 0)  # of all files: the same site gives the same bytes
LEVEL = 9
# What only a host or another program needs: no page of the archive links to it.
NOT_NEEDED = (".json.gz", PREVIEW, WORKER, MANIFEST, SITEMAP)
# The list of the site's files, a host's settings, a worktree's .git; numbers for graders; and the
# page for pictures of one's own, which nobody brings to a kiosk.
HIDDEN = (".", "homework/", "check/")
TO_HIDDEN = re.compile(
    r'(?:<p>)?<a class="[^"]*\bto-check\b[^"]*"[^>]*>[^<]*</a>(?:</p>)?'
    r'|<script src="[^"]*assets/check-[^>]*></script>'
)
SCRIPTS = (".sh", ".command")


def write_archive(site: Path, source: Path, archive: Path) -> int:
    """Writes the zip; returns its size in bytes. Raises UserError where the site is missing or the
    archive would be over its limit; then none is written."""
    pages = sorted(site.glob("scenes/*/index.html"))
    if not pages:
        raise UserError(
            f"{shown_path(site)}: no built site is there\n  hint: run `raywalk build`, or `make`"
        )
    start = _first_scene(site) or "index.html"
    if archive.is_dir():
        raise UserError(f"{shown_path(archive)}: is a folder\n  hint: name a file, as kiosk.zip")
    archive.parent.mkdir(parents=True, exist_ok=True)
    beside = archive.parent / f"{archive.name}.{os.getpid()}.partial"
    try:
        with zipfile.ZipFile(beside, "w", zipfile.ZIP_DEFLATED, compresslevel=LEVEL) as packed:
            for name, content in _files(site, source, start):
                packed.writestr(_entry(name), content)
        size = beside.stat().st_size
        if size > LIMIT:
            raise UserError(
                f"{shown_path(archive)}: {size:,} bytes; a kiosk's archive takes {LIMIT:,} at most"
                "\n  nothing was written"
            )
        beside.replace(archive)
    finally:
        beside.unlink(missing_ok=True)
    return size


def _first_scene(site: Path) -> str:
    """The page of the first scene, below the site."""
    gallery = (site / "index.html").read_text(encoding="utf-8")
    _, _, after = gallery.partition('class="scene-card" href="')
    return after.partition('"')[0]


def _files(site: Path, source: Path, start: str) -> Iterator[tuple[str, bytes]]:
    """Names within the archive, in order, and contents."""
    for path in sorted((source / "kiosk").iterdir()):
        text = path.read_text(encoding="utf-8")
        text = text.replace("@START@", start).replace("@START_WINDOWS@", start.replace("/", "\\"))
        if path.suffix not in SCRIPTS:
            text = text.replace("\n", "\r\n")  # Windows' editor and shell want these
        yield f"{TOP}/{path.name}", text.encode("utf-8-sig" if path.suffix == ".txt" else "utf-8")
    for path in sorted(site.rglob("*")):
        name = path.relative_to(site).as_posix()
        if path.is_file() and not _is_hidden(name) and not name.endswith(NOT_NEEDED):
            content = path.read_bytes()
            if path.suffix == ".html":
                content = TO_HIDDEN.sub("", content.decode()).encode()
            yield f"{TOP}/{SITE}/{name}", content


def _is_hidden(name: str) -> bool:
    """In any language, and what only such a page loads."""
    in_language = name.partition("/")[2] if name.partition("/")[0] in languages() else name
    return in_language.startswith(HIDDEN) or name.startswith("assets/check-")


def _entry(name: str) -> zipfile.ZipInfo:
    entry = zipfile.ZipInfo(name, WHEN)
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.create_system = 3  # Unix, wherever it is made: only so can a script be made to run
    entry.external_attr = (0o100755 if name.endswith(SCRIPTS) else 0o100644) << 16
    return entry
