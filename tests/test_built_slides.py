"""The slides that `make` built into dist/: every deck complete, small, legible, alone."""

from __future__ import annotations

import io
import re
import zipfile
from pathlib import Path

import pytest
from pypdf import PdfReader

from raywalk.pipeline.figures import filled_here
from raywalk.scene.read import read_scenes
from raywalk.slides.glossary_sheets import lesson_terms
from raywalk.slides.words import speaking
from raywalk.work.store import Store

DIST = Path(__file__).parent.parent / "dist"
SCENES = read_scenes(Path(__file__).parent.parent / "scenes")
LANGUAGES = {"en": DIST / "slides", "de": DIST / "de" / "slides"}
SHEETS = {
    "en": ("handout-2", "handout-3", "handout-6", "worksheet"),
    "de": ("worksheet",),
}
MAIL = 1_000_000  # bytes: a lesson can be sent by mail
COURSE = 4_500_000  # two hundred slides and more, of 21 lessons
ALL = {"en": 41_500_000, "de": 33_500_000}  # with them the whole site fits a kiosk's 64 MB
LEAST, SOURCE = 1800, 1200  # hundredths of a point, as PPTX counts; of the source line


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_lesson_has_all_its_files_each_below_a_megabyte(language):
    """Slides in three formats and their sheets; the course's decks have a limit of their own."""
    folder = LANGUAGES[language]
    for scene in SCENES:
        names = [f"{scene.id}.{form}" for form in ("html", "pdf", "pptx")]
        names += [f"{scene.id}-{sheet}.pdf" for sheet in SHEETS[language]]
        for name in names:
            assert 0 < (folder / name).stat().st_size < MAIL, name
    for name in ("course.pdf", "course.pptx"):
        assert MAIL < (folder / name).stat().st_size < COURSE, name
    assert sum(path.stat().st_size for path in folder.iterdir()) < ALL[language]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.id)
def test_formats_of_a_lesson_have_the_same_slides(scene, language):
    """As many pages as sections as slides; a slide for each step and each answer at least."""
    folder = LANGUAGES[language]
    page = (folder / f"{scene.id}.html").read_text(encoding="utf-8")
    assert f'<html lang="{language}">' in page
    sections = page.count("<section ")
    with zipfile.ZipFile(folder / f"{scene.id}.pptx") as packed:
        slides = [n for n in packed.namelist() if re.fullmatch(r"ppt/slides/slide\d+\.xml", n)]
    reader = PdfReader(io.BytesIO((folder / f"{scene.id}.pdf").read_bytes()))
    assert reader.trailer["/Root"]["/Lang"] == language
    assert len(reader.pages) == len(slides) == sections
    stops = sum(1 + bool(step.answer) for step in scene.lesson)
    assert sections >= stops + 3  # title, goals, credits


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.id)
def test_a_handout_ends_on_the_terms_of_its_lesson_and_what_they_mean(scene):
    """Letters and digits are compared: where a line ends is the paper's affair."""
    reader = PdfReader(DIST / "slides" / f"{scene.id}-handout-3.pdf")
    printed = letters(" ".join(page.extract_text() for page in reader.pages[-3:]))
    with speaking("en"):
        terms = lesson_terms(filled_here(Store(DIST.parent / ".work"), scene))
    assert terms
    assert not [each.term for each in terms if letters(each.term + each.says) not in printed]


def letters(text: str) -> str:
    return re.sub(r"\W+", "", text)


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_word_on_any_slide_is_smaller_than_18_points_but_the_source_line(language):
    """In PPTX as set, in HTML as drawn; PDF is drawn from the same lists."""
    folder = LANGUAGES[language]
    with zipfile.ZipFile(folder / "course.pptx") as packed:
        for name in packed.namelist():
            if re.fullmatch(r"ppt/slides/slide\d+\.xml", name):
                sizes = map(int, re.findall(r'<a:rPr[^>]* sz="(\d+)"', packed.read(name).decode()))
                assert [size for size in sizes if size < LEAST and size != SOURCE] == [], name
    for scene in SCENES:
        page = (folder / f"{scene.id}.html").read_text(encoding="utf-8")
        sizes = {round(100 * float(size)) for size in re.findall(r'font-size="([\d.]+)"', page)}
        assert {size for size in sizes if size < LEAST} <= {SOURCE}


@pytest.mark.parametrize("language", LANGUAGES)
def test_nothing_is_loaded_from_elsewhere(language):
    """No address in a page's attributes, no outside target in a presentation, no link in a PDF."""
    folder = LANGUAGES[language]
    for scene in SCENES:
        page = (folder / f"{scene.id}.html").read_text(encoding="utf-8")
        links = re.findall(r'(?:href|src)="([^"]*)"', page)
        assert all(link.startswith(("data:", "#")) for link in links)
        with zipfile.ZipFile(folder / f"{scene.id}.pptx") as packed:
            relations = [n for n in packed.namelist() if n.endswith(".rels")]
            assert not any(b'TargetMode="External"' in packed.read(name) for name in relations)
        assert b"/URI" not in (folder / f"{scene.id}.pdf").read_bytes()
