"""The course's deck: what comes, how long it takes, each lesson behind its divider, the rules."""

from __future__ import annotations

import pytest
from tests.slides.course import CourseDeck, course_decks

from raywalk.slides.deck import course_of
from raywalk.slides.figure import Deck, Text
from raywalk.slides.layout import LAYOUTS
from raywalk.slides.times import lesson_minutes, parted
from raywalk.slides.words import say, speaking


@pytest.fixture(scope="module", params=[("en", "16:9"), ("de", "4:3")], ids=["en 16:9", "de 4:3"])
def course(request: pytest.FixtureRequest) -> tuple[list[CourseDeck], Deck]:
    language, aspect = request.param
    own = [d for d in course_decks() if d.language == language and d.layout.name == aspect]
    with speaking(language):
        lessons = [each.slides for each in own]
        return own, course_of([each.sources for each in own], lessons, LAYOUTS[aspect])


def words_of(deck: Deck, title: str) -> list[str]:
    """On the slides with this title, gone on with or not."""
    slides = [s for s in deck.slides if s.title.startswith(title) and s.kind == "goals"]
    assert slides, title
    return [t.words for s in slides for t in s.items if isinstance(t, Text) and t.name == "words"]


def test_each_lesson_stands_behind_its_divider_without_its_numbers(course):
    own, deck = course
    dividers = [k for k, slide in enumerate(deck.slides) if slide.kind == "section"]
    assert [deck.slides[k].title for k in dividers] == [each.deck.title for each in own]
    for each, start in zip(own, dividers, strict=True):
        whole = [slide for slide in each.slides if slide.kind != "build"]
        assert list(deck.slides[start + 1 : start + 1 + len(whole)]) == whole
    assert not {"backup", "table", "sum"} & {slide.kind for slide in deck.slides}


def test_it_begins_with_the_agenda_and_ends_with_the_rules(course):
    own, deck = course
    with speaking(own[0].language):
        agenda, rules = words_of(deck, say("slides.scenes")), words_of(deck, say("slides.rules"))
    left = iter(agenda)
    assert all(any(words.endswith(each.deck.title) for words in left) for each in own)
    taught = " ".join(each.sources.scene.teaches for each in own)
    assert " ".join(rules).split() == taught.split()


def test_it_says_what_fits_into_a_lecture(course):
    """Each lesson by its place in the agenda, in order, in lectures of 45 and of 90 minutes."""
    own, deck = course
    with speaking(own[0].language):
        said = " ".join(words_of(deck, say("slides.times")))
    minutes = [lesson_minutes(each.sources.scene) for each in own]
    for most in (45, 90):
        lectures = " | ".join(", ".join(str(k + 1) for k in each) for each in parted(minutes, most))
        assert lectures in said


def test_lectures_take_lessons_in_order_as_long_as_they_fit():
    assert parted([20, 25, 1, 50, 10], 45) == [[0, 1], [2], [3], [4]]
    assert parted([20, 25, 45], 90) == [[0, 1, 2]]
    assert parted([], 45) == []
