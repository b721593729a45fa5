"""Quizzes as learning platforms read them."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from raywalk.slides.words import speaking
from raywalk.teacher.gift import escaped, gift
from raywalk.teacher.qti import package
from raywalk.teacher.quiz import Item, Option, items_of, numeric

from .gift_reader import NotGift, plain, read
from .qti_reader import NS, check_item, score

HOSTILE = r'a ~ b = c # d { e } f : g \ h -> "i" <j> & k %50% // l'
CHOICE = Item("raywalk-en-x-1", f"T: {HOSTILE}", HOSTILE, (
    Option(HOSTILE, False, HOSTILE), Option("right = {x}", True, "#why"), Option("10 %", False, ""),
), feedback=HOSTILE)  # fmt: skip
NUMBER = Item("raywalk-en-x-2", "n", "How far?", value=-4.518, tolerance=0.023)
BYTE = Item("raywalk-en-x-3", "b", "Which byte?", value=26.0)
LESSONS = [("A: title / with a slash", [CHOICE, NUMBER, BYTE])]


def test_every_mark_of_gift_is_taken_literally():
    """What is written comes back as it was; only the arrow, which has no escape, is another."""
    assert plain(escaped(HOSTILE)) == HOSTILE.replace("->", "→")
    assert plain(escaped("one\n\ntwo")) == "one\ntwo"


@pytest.mark.parametrize("bare", ["a = b", "a\\b", "{", "a ~ b", "x: y", "#1"])
def test_the_reader_refuses_what_moodle_would_misread(bare: str):
    with pytest.raises(NotGift):
        plain(bare)


def test_gift_says_what_the_items_say():
    choice, number, byte = read(gift(LESSONS, "Course"))
    said = HOSTILE.replace("->", "→")
    assert choice.category == "Course/A: title - with a slash"
    assert (choice.title, choice.text, choice.feedback) == (f"T: {said}", said, said)
    assert [(a.text, a.weight, a.feedback) for a in choice.answers] == [
        (said, 0.0, said), ("right = {x}", 1.0, "#why"), ("10 %", 0.0, ""),
    ]  # fmt: skip
    assert number.number == (-4.518, 0.023) and byte.number == (26.0, 0.0)


def test_qti_items_are_what_the_specification_demands_and_score_right():
    files = dict(package(LESSONS, "Course", "en"))
    items = {name: ET.fromstring(text) for name, text in files.items() if name.startswith("items")}
    for item in items.values():
        check_item(item)
    choice, number, byte = items.values()
    assert [score(choice, mark) for mark in "ABC"] == [(0.0, HOSTILE), (1.0, "#why"), (0.0, "")]
    assert choice.findtext(f".//{NS}prompt") == HOSTILE
    tried = ["-4.518", "-4.4951", "-4.5409", "-4.494", "4.518"]
    assert [score(number, each)[0] for each in tried] == [1, 1, 1, 0, 0]
    assert [score(byte, each)[0] for each in ("26", "27")] == [1, 0]


def test_a_package_lists_all_that_is_in_it_once():
    """Manifest and test name each item by its place; names are unique, and XML names."""
    files = dict(package(LESSONS, "Course", "en"))
    manifest, test = (ET.fromstring(files[name]) for name in ("imsmanifest.xml", "test.xml"))
    listed = [each.get("href") for each in manifest.iter() if each.tag.endswith("}file")]
    assert sorted(listed) == sorted(set(files) - {"imsmanifest.xml"})
    ids = [each.get("identifier") for each in manifest.iter() if each.get("identifier")]
    assert len(ids) == len(set(ids)) and all(id.isascii() and id[0].isalpha() for id in ids)
    needed = [each.get("identifierref") for each in manifest.iter() if each.get("identifierref")]
    assert set(needed) == set(ids) - {"r-test", "raywalk-manifest-en"}
    assert [each.get("href") for each in test.iter(f"{NS}assessmentItemRef")] == [
        name for name in files if name.startswith("items/")
    ]


def test_a_tolerance_takes_three_digits_and_no_other_answer():
    """Half a percent, and never less than 0.005."""
    assert numeric(4.517644)["value"] == 4.518
    for value in (0.004, 0.5, 4.5176, 120.0):
        told = numeric(value)
        assert (
            abs(float(f"{value:.3g}") - told["value"]) <= told["tolerance"] <= 0.006 * max(1, value)
        )


def test_a_lessons_quiz_has_its_questions_and_its_sheets(balls):
    """The lesson of two balls has no choices, so what is worked out is asked alone; ids differ."""
    items = items_of(balls.lesson())
    assert len({item.id for item in items}) == len(items) >= 4
    assert all(item.options or item.value for item in items)
    assert not any("{" in item.asks for item in items)


def test_the_archive_is_the_same_each_time(balls, tmp_path: Path):
    """Same lessons, same bytes, in both languages; each has its parts."""
    from raywalk.teacher.archive import language_files, write_archive

    def made(name: str) -> bytes:
        files = []
        for code in ("en", "de"):
            with speaking(code):
                files += language_files([balls.lesson()], "https://school.example/rays/")
        write_archive(files, tmp_path / name)
        return (tmp_path / name).read_bytes()

    assert made("one.zip") == made("two.zip")
    with speaking("de"):
        names = [name for name, _ in language_files([balls.lesson()], "")]
    assert names == [
        "de/README.txt", "de/guide.pdf", "de/worksheets/04-balls-worksheet.pdf",
        "de/answers/04-balls-answers.pdf", "de/assignments/04-balls-assignment.pdf",
        "de/quiz/moodle-gift.txt", "de/quiz/qti-2.1.zip", "de/glossary.pdf",
        "de/links.html", "de/credits.txt",
    ]  # fmt: skip
