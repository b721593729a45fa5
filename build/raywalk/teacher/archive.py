"""What `raywalk teacher` hands over, as one zip whose bytes follow from what is in it."""

from __future__ import annotations

import io
import os
import zipfile
from collections.abc import Iterable, Iterator
from pathlib import Path

from raywalk.errors import UserError, shown_path
from raywalk.home import HOME
from raywalk.scene.credits import named_models
from raywalk.scene.model import Scene
from raywalk.slides.figure import Deck
from raywalk.slides.palette import PRINT
from raywalk.slides.pdf import deck_pdf
from raywalk.slides.step_slide import Lesson
from raywalk.slides.words import say, words
from raywalk.slides.worksheet import worksheet
from raywalk.teacher.assignment import assignment
from raywalk.teacher.gift import gift
from raywalk.teacher.guide import guide
from raywalk.teacher.links import links_page
from raywalk.teacher.qti import package
from raywalk.teacher.quiz import items_of
from raywalk.teacher.terms import glossary

TOP = "raywalk-teacher"
WHEN = (1980, 1, 1, 0, 0, 0)  # of all files: the same lessons give the same bytes
LICENCE = HOME / "LICENSE"

File = tuple[str, bytes]


def language_files(lessons: list[Lesson], base: str) -> Iterator[File]:
    """Everything in the language that is spoken, below its folder. base: of the site's address.
    Raises MissingGlyphs."""
    folder = words().code
    scenes = [lesson.scene for lesson in lessons]
    yield f"{folder}/README.txt", _text(say("teacher.readme").replace(" • ", "\n- ") + "\n")
    yield f"{folder}/guide.pdf", _pdf(guide(lessons, base))
    for lesson in lessons:
        id = lesson.scene.id
        yield f"{folder}/worksheets/{id}-worksheet.pdf", _pdf(worksheet(lesson, False))
        yield f"{folder}/answers/{id}-answers.pdf", _pdf(worksheet(lesson, True))
        yield f"{folder}/assignments/{id}-assignment.pdf", _pdf(assignment(lesson))
    quiz = [(lesson.scene.title, items_of(lesson)) for lesson in lessons]
    course = say("slides.course")
    yield f"{folder}/quiz/moodle-gift.txt", gift(quiz, course).encode()
    packed = ((name, text.encode()) for name, text in package(quiz, course, folder))
    yield f"{folder}/quiz/qti-2.1.zip", zipped(packed)
    yield f"{folder}/glossary.pdf", _pdf(glossary())
    yield f"{folder}/links.html", links_page(lessons, base).encode()
    yield f"{folder}/credits.txt", _text("\n".join(_credits(scenes)) + "\n")


def _pdf(deck: Deck) -> bytes:
    return deck_pdf(deck, PRINT)


def _text(text: str) -> bytes:
    """As Windows' editor wants it."""
    return text.replace("\n", "\r\n").encode("utf-8-sig")


def _credits(scenes: list[Scene]) -> list[str]:
    lines = [say("slides.madeWith"), say("slides.fontCredit")]
    for scene in scenes:
        for model in named_models(scene):
            lines.append(say("pages.figures.modelIs", title=model.title, credit=model.credit,
                             licence=model.licence))  # fmt: skip
    return list(dict.fromkeys(lines))


def zipped(files: Iterable[File]) -> bytes:
    """In their order."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as packed:
        for name, content in files:
            entry = zipfile.ZipInfo(name, WHEN)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3  # Unix, wherever it is made
            entry.external_attr = 0o100644 << 16
            packed.writestr(entry, content)
    return out.getvalue()


def write_archive(files: Iterable[File], archive: Path) -> int:
    """Writes the zip whole or not at all; returns its size in bytes. Raises UserError."""
    if archive.is_dir():
        raise UserError(f"{shown_path(archive)}: is a folder\n  hint: name a file, as teacher.zip")
    licence = (f"{TOP}/LICENSE.txt", _text(LICENCE.read_text(encoding="utf-8")))
    content = zipped([licence, *((f"{TOP}/{name}", data) for name, data in files)])
    archive.parent.mkdir(parents=True, exist_ok=True)
    beside = archive.parent / f"{archive.name}.{os.getpid()}.partial"
    try:
        beside.write_bytes(content)
        beside.replace(archive)
    finally:
        beside.unlink(missing_ok=True)
    return len(content)
