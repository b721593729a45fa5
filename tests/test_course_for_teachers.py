"""What teachers get of the whole course, in both languages: pages that nothing is cut off, quizzes
that platforms read, and the same figures as on the sheets."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from functools import cache
from itertools import pairwise

import pytest

from raywalk.slides.figure import Deck, Line, Picture, Text, flat
from raywalk.slides.handout import A4
from raywalk.slides.layout import WIDE
from raywalk.slides.sheet_questions import sheet_facts
from raywalk.slides.step_slide import Lesson
from raywalk.slides.times import LECTURES
from raywalk.slides.typeface import width
from raywalk.slides.words import say, speaking
from raywalk.slides.worksheet import worksheet
from raywalk.teacher.assignment import assignment
from raywalk.teacher.gift import gift
from raywalk.teacher.guide import guide
from raywalk.teacher.qti import item_xml, package
from raywalk.teacher.quiz import items_of
from raywalk.teacher.terms import glossary
from raywalk.teacher.timing import schedule, shared
from raywalk.terms.glossary import read_glossary

from .teacher.gift_reader import read
from .teacher.qti_reader import check_item, score
from .test_sheets_on_paper import LANGUAGES, lessons

EDGE = 28.0  # points of paper that a printer may not reach


@cache
def course(language: str) -> list[Lesson]:
    with speaking(language):
        return [each.lesson(WIDE) for each in lessons()[language]]


def check_pages(deck: Deck) -> None:
    """Everything stands on the paper, and no line of words runs out of it."""
    for page in deck.slides:
        for item in flat(page.items):
            if isinstance(item, Picture):
                assert item.box.right <= A4[0] - EDGE and item.box.bottom <= A4[1] - EDGE
            if isinstance(item, Line):
                assert max(item.start[1], item.end[1]) <= A4[1] - EDGE
            if isinstance(item, Text):
                assert item.baseline(len(item.lines) - 1) <= A4[1] - EDGE, item.words
                for line in item.lines:
                    wide = sum(width(run.text, item.size, bold=run.bold) for run in line)
                    assert item.box.left + wide <= A4[0] - EDGE, item.words


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_guide_has_two_pages_a_lesson_and_nothing_is_cut(language: str) -> None:
    with speaking(language):
        deck = guide(course(language), "https://school.example/a/long/path/to/rays/")
    assert len(deck.slides) == 2 * len(course(language))
    check_pages(deck)
    for page, lesson in zip(deck.slides[1::2], course(language), strict=True):
        words = " ".join(item.words for item in flat(page.items) if isinstance(item, Text))
        asked = [step for step in lesson.scene.lesson if step.answer]
        assert words.count("?") >= len(asked)
        for step in asked:  # "this ray" is of a pixel that is told
            (x, y), n = step.view["pixel"], step.view["resolution"]
            with speaking(language):
                assert say("slides.pixelOf", x=x, y=y, n=n) in words


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_guide_tells_of_each_lesson_all_that_a_teacher_needs(language: str) -> None:
    """Of the course's first lesson no other is presupposed."""
    with speaking(language):
        heads = {"slides.goals", "teacher.keyQuestions", "teacher.misconceptions"}
        wanted = {say(key) for key in heads | {"teacher.materials"}}
        wanted |= {say("teacher.timing", minutes=length) for length in LECTURES}
        pages = guide(course(language), "").slides
        for k, (first, second) in enumerate(zip(pages[::2], pages[1::2], strict=True)):
            items = [*flat(first.items), *flat(second.items)]
            texts = {item.words for item in items if isinstance(item, Text)}
            more = {say("teacher.before")} if k else set()
            assert not [head for head in wanted | more if not any(head in each for each in texts)]
            assert any(say("teacher.expected") in each for each in texts)


@pytest.mark.parametrize("language", LANGUAGES)
def test_nothing_is_cut_off_any_sheet(language: str) -> None:
    """Worksheets, answers and assignments."""
    with speaking(language):
        for lesson in course(language):
            for deck in (worksheet(lesson, False), worksheet(lesson, True), assignment(lesson)):
                check_pages(deck)
                assert len(deck.slides) <= 6, deck.id


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_glossary_is_whole_on_its_sheets(language: str) -> None:
    with speaking(language):
        deck = glossary()
    check_pages(deck)
    texts = [i.words for page in deck.slides for i in flat(page.items) if isinstance(i, Text)]
    assert all(term.term in " ".join(texts) for term in read_glossary(language).terms)


@pytest.mark.parametrize("length", LECTURES)
def test_a_timing_fills_its_lesson_to_the_minute(length: int) -> None:
    """Every part has a minute at least, and each step has its place."""
    for lesson in course("en"):
        rows = schedule(lesson.scene, length)
        assert sum(minutes for _, minutes in rows) == length
        assert all(minutes > 0 for _, minutes in rows)


def test_minutes_are_shared_without_a_rest() -> None:
    assert shared(10, [1.0, 1.0, 1.0]) == [4, 3, 3]
    assert shared(7, [2.0, 5.0]) == [2, 5]


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_whole_quiz_is_gift_and_qti_and_both_say_the_same(language: str) -> None:
    """Read by strict readers; the right answer scores, all others do not."""
    with speaking(language):
        quiz = [(lesson.scene.title, items_of(lesson)) for lesson in course(language)]
    items = [item for _, each in quiz for item in each]
    questions = read(gift(quiz, "Raywalk"))
    assert len(questions) == len(items) == len({item.id for item in items}) >= 100
    assert len(dict(package(quiz, "Raywalk", language))) == len(items) + 2
    for question, item in zip(questions, items, strict=True):
        xml = ET.fromstring(item_xml(item, language))
        check_item(xml)
        if item.options:
            assert [(a.text, a.weight) for a in question.answers] == [
                (o.text.replace("->", "→"), float(o.right)) for o in item.options
            ]
            marks = "ABCDEFG"[: len(item.options)]
            assert [score(xml, mark)[0] for mark in marks] == [o.right for o in item.options]
        else:
            assert question.number == (item.value, item.tolerance)
            assert score(xml, f"{item.value:.12g}")[0] == 1
            assert score(xml, f"{item.value + item.tolerance + 0.01:.12g}")[0] == 0


def test_no_tolerance_takes_a_second_root() -> None:
    """Where a ray goes into an object and out again, the far distance is a wrong answer."""
    for lesson in course("en"):
        numbers = [item for item in items_of(lesson) if not item.options]
        for fact in sheet_facts(lesson)["asked"]:
            at = [t for _, t in fact.get("hits", ())]
            gaps = [b - a for a, b in pairwise(at)]
            assert all(gap > 0.01 for gap in gaps)
        assert all(item.tolerance < 0.006 * max(1.0, abs(item.value)) for item in numbers)


def test_an_assignments_pixels_are_those_of_raywalk_pixel() -> None:
    """To all digits, by the tracer that `raywalk pixel` uses."""
    from raywalk.trace.pixel_tree import pixel_tree

    lesson = next(each for each in course("en") if each.scene.id == "08-glass")
    facts = sheet_facts(lesson)
    for check in facts["checks"][:3]:
        told = pixel_tree(lesson.scene, facts["n"], facts["n"], *check["pixel"])
        # Rays whose share is below 1/4096 are left out of pictures, of `raywalk pixel` none.
        assert abs(told["tree"]["t"] - check["t"]) < 1e-12
        assert max(abs(a - b) for a, b in zip(told["colour"], check["colour"], strict=True)) < 1e-3


def test_no_slot_is_left_open_anywhere() -> None:
    for language in LANGUAGES:
        with speaking(language):
            deck = guide(course(language), "")
        words = [i.words for page in deck.slides for i in flat(page.items) if isinstance(i, Text)]
        assert not [each for each in words if re.search(r"\{\w+[}.]", each)]
