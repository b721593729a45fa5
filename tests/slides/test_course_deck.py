"""The course's deck: what comes, how long it takes, each lesson behind its divider, the rules."""

from __future__ import annotations

import pytest
from tests.slides.course import CourseDeck, course_decks

from raywalk.scene.credits import named_models
from raywalk.scene.model import Scene
from raywalk.slides.course import chapters
from raywalk.slides.deck import course_of
from raywalk.slides.figure import Deck, Text
from raywalk.slides.layout import LAYOUTS
from raywalk.slides.times import LECTURES, lesson_minutes, parted
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


def test_it_begins_with_the_agenda_and_each_chapter_ends_with_its_rules(course):
    """Chapters stay whole in the agenda, under their names."""
    own, deck = course
    with speaking(own[0].language):
        agenda, rules = words_of(deck, say("slides.scenes")), words_of(deck, say("slides.rules"))
        names = [say(f"pages.chapters.{name}") for name, _ in chapters(scenes_of(own))]
    assert agenda == [
        text for name, (_, group) in zip(names, chapters(scenes_of(own)), strict=True)
        for text in (name, *(scene.title for scene in group))
    ]  # fmt: skip
    taught = " ".join(each.sources.scene.teaches for each in own)
    assert " ".join(rules).split() == taught.split()
    pages = [s for s in deck.slides if s.title.startswith(agenda_title(own)) and s.kind == "goals"]
    firsts = [next(t for t in page.items if t.name == "words").words for page in pages]
    assert set(firsts) <= set(names)


def scenes_of(own: list[CourseDeck]) -> list[Scene]:
    return [each.sources.scene for each in own]


def agenda_title(own: list[CourseDeck]) -> str:
    with speaking(own[0].language):
        return say("slides.scenes")


def test_a_divider_says_where_one_is(course):
    """Chapter, place and the key of the scene that texts name."""
    own, deck = course
    dividers = [slide for slide in deck.slides if slide.kind == "section"]
    for k, (each, slide) in enumerate(zip(own, dividers, strict=True), start=1):
        with speaking(each.language):
            texts = [i for i in slide.items if isinstance(i, Text)]
            title = next(text for text in texts if text.is_title)
            said = " ".join(text.words for text in texts if text.box.top < title.box.top)
            assert say("slides.lessonOf", place=k, of=len(own)) in said
            key = each.sources.scene.key
            assert not key or said.endswith(say("slides.sceneKey", key=key))


def test_it_says_what_fits_into_a_lecture(course):
    """Each lesson with its name and place, in order, in lectures of 45 and of 90 minutes."""
    own, deck = course
    scenes = scenes_of(own)
    minutes = [lesson_minutes(scene) for scene in scenes]
    for most in LECTURES:
        with speaking(own[0].language):
            _, *said = words_of(deck, say("slides.times", minutes=most))
        lectures = parted(minutes, most)
        assert said == [" · ".join(scenes[k].title for k in lecture) for lecture in lectures]


def test_credits_take_two_slides_at_most_and_their_notes_say_all(course):
    own, deck = course
    slides = [slide for slide in deck.slides if slide.kind == "credits"]
    assert 1 <= len(slides) <= 2
    said = " ".join(t.words for s in slides for t in s.items if isinstance(t, Text))
    notes = " ".join(slides[0].notes)
    models = [model for scene in scenes_of(own) for model in named_models(scene)]
    assert models
    for model in models:
        assert model.title in said and model.credit in said and model.licence in notes


def test_lectures_take_lessons_in_order_as_long_as_they_fit():
    assert parted([20, 25, 1, 50, 10], 45) == [[0, 1], [2], [3], [4]]
    assert parted([20, 25, 45], 90) == [[0, 1, 2]]
    assert parted([], 45) == []
