"""raywalk teacher: guide, sheets with answers, assignments and quizzes of a course, as one zip."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from raywalk.work.progress import Message

ARCHIVE = Path("dist-teacher") / "raywalk-teacher.zip"


def add_to(commands: Any) -> None:
    """Adds the command's arguments."""
    parser = commands.add_parser("teacher", help="guide, answers, quizzes for teachers, as one zip")
    parser.add_argument("--out", type=Path, default=ARCHIVE, help="the archive")
    parser.add_argument("--work", type=Path, default=Path(".work"), help="where traces are kept")
    parser.add_argument(
        "--url", default=os.environ.get("RAYWALK_URL", ""), metavar="https://HOST/PATH/",
        help="where the site is: for links (or RAYWALK_URL)",
    )  # fmt: skip
    parser.set_defaults(run=run)


def run(chosen: Namespace) -> Iterator[str | Message]:
    """Traces what is not kept, writes. Raises SourceErrors."""
    from raywalk.errors import SourceErrors
    from raywalk.pipeline.lessons import all_lessons
    from raywalk.pipeline.slide_products import missing_letters
    from raywalk.site.sitemap import base_of
    from raywalk.slides.layout import WIDE
    from raywalk.slides.pdf import MissingGlyphs
    from raywalk.slides.words import speaking
    from raywalk.teacher.archive import language_files, write_archive
    from raywalk.work.store import Store

    base = base_of(chosen.url)
    by_language = yield from all_lessons(chosen.scenes, Store(chosen.work))
    files: list[tuple[str, bytes]] = []
    for code, sources in by_language.items():
        if not sources:
            continue
        yield f"{code}: guide, sheets and quizzes of {len(sources)} lessons"
        with speaking(code):
            try:
                files += language_files([each.lesson(WIDE) for each in sources], base)
            except MissingGlyphs as lost:
                scenes = [each.scene for each in sources]
                raise SourceErrors([missing_letters(scenes, lost.characters)]) from None
    size = write_archive(files, chosen.out)
    yield f"{chosen.out.as_posix()}: {len(files) + 1} files, {size / 1e6:.1f} MB"
