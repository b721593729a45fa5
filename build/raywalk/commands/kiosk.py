"""raywalk kiosk: the built site as one archive for a locked touch screen."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from raywalk.commands.build_site import SITE_SOURCE

ARCHIVE = Path("dist-kiosk") / "raywalk-kiosk.zip"


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("kiosk", help="pack the built site for a kiosk, as one zip")
    parser.add_argument("--site", type=Path, default=Path("dist"), help="the built site")
    parser.add_argument("--out", type=Path, default=ARCHIVE, help="the archive")
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str]:
    """Packs it."""
    from raywalk.site.kiosk import write_archive

    size = write_archive(chosen.site, SITE_SOURCE, chosen.out)
    place = chosen.out.as_posix()
    yield f"{place}: {size / 1e6:.1f} MB; unpack it anywhere, START-HERE.txt says how"
