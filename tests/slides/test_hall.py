"""What a hall can read: all decks of the course, in every language and aspect, by their display
lists."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from tests.slides.course import CourseDeck, decks_of
from tests.slides.test_words_and_space import tight

from raywalk.scene.read import read_scenes
from raywalk.slides.choices import MARK
from raywalk.slides.figure import Dot, Group, Item, Picture, Polygon, Slide, Table, Text, flat
from raywalk.slides.layout import Box
from raywalk.slides.lesson_words import plain_text, words_and_pictures
from raywalk.slides.words import chosen_tile, say, speaking

from .course import ROOT

SOURCE_LINE = ("where", "place")
NUMBERS = ("table", "sum")  # kinds of slides behind the lesson
SIGNS = ("bullet", "letter")  # before items of lists and choices
SCENES = [scene.id for scene in read_scenes(ROOT / "scenes")]


@pytest.fixture(params=SCENES)
def of_scene(request: pytest.FixtureRequest) -> list[CourseDeck]:
    """One scene's decks."""
    return decks_of(request.param)


def spoken(decks: list[CourseDeck]) -> Iterator[tuple[CourseDeck, Slide]]:
    for each in decks:
        with speaking(each.language):
            for slide in each.deck.slides:
                yield each, slide


def figure_on(slide: Slide) -> Group | None:
    return next((i for i in slide.items if isinstance(i, Group) and i.is_figure), None)


def body(slide: Slide) -> list[Text]:
    """What stands on a slide besides title, source line and figure."""
    return [i for i in slide.items if isinstance(i, Text) and i.name not in SOURCE_LINE]


def where(each: CourseDeck, slide: Slide) -> str:
    return f"{each.name}, {slide.kind} {slide.title!r}"


def test_words_are_large_and_nothing_but_the_source_line_is_small(of_scene):
    """Body 24 points or more, behind the lesson, in figures and in credits 18; captions too."""
    for each, slide in spoken(of_scene):
        for text in body(slide):
            is_small = slide.kind in (*NUMBERS, "credits") or text.name == "caption"
            least = 18 if is_small else 24
            assert text.size >= least, (where(each, slide), text.words)
        for item in flat(slide.items):
            if isinstance(item, Text | Table) and item.name not in SOURCE_LINE:
                assert item.size >= 18, (where(each, slide), item.name)


def test_a_slide_has_at_most_40_words(of_scene):
    """Besides its title; signs (·, =) are none, tables behind the lesson numbers, credits small."""
    for each, slide in spoken(of_scene):
        if slide.kind not in (*NUMBERS, "credits"):
            said = [t for t in body(slide) if not t.is_title and t.name not in SIGNS]
            words = [word for t in said for word in t.words.split()]
            count = sum(any(char.isalnum() for char in word) for word in words)
            assert count <= 40, where(each, slide)


def test_a_figure_takes_three_fifths_of_its_slide(of_scene):
    """Every step and answer has one, or goes on with choices or pictures of its text."""
    for each, slide in spoken(of_scene):
        figure = figure_on(slide)
        if slide.kind in ("build", "step", "answer") and not slide.is_continued:
            assert figure, where(each, slide)
        if figure:
            view = next(i for i in figure.items if isinstance(i, Picture))
            whole = each.deck.width * each.deck.height
            assert view.box.width * view.box.height >= 0.6 * whole, where(each, slide)


def test_the_selected_pixel_is_seen_from_the_last_row(of_scene):
    """Each picture is at least 160 points wide, and its framed tile at least 7: of finer grids a
    part of the picture is shown, enlarged. A question whose tiles are empty shows none, one whose
    choices are pixels marks these and no other."""
    for each, slide in spoken(of_scene):
        pictures = [i for i in flat(slide.items) if is_named(i, Picture, say("slides.picture"))]
        asks_without = slide.kind == "question" and figure_on(slide)
        if slide.kind in ("build", "step", "answer") and figure_on(slide):
            assert len(pictures) == 1, where(each, slide)
        assert not (asks_without and pictures), where(each, slide)
        for picture in pictures:
            assert picture.box.width >= 160, where(each, slide)
        if pictures and slide.kind != "title":
            frames = [i for i in after(slide, pictures[0]) if is_frame(i, each)]
            letters = [i for i in flat(slide.items) if isinstance(i, Dot) and i.radius == MARK]
            if slide.kind == "question" and letters:
                assert not frames, where(each, slide)
                continue
            assert len(frames) == 2 * len(pictures), where(each, slide)
            xs = [x for x, _ in frames[0].points]
            assert max(xs) - min(xs) >= 7, where(each, slide)


def is_named(item: Item, kind: type, name: str) -> bool:
    return isinstance(item, kind) and getattr(item, "name", "") == name


def after(slide: Slide, picture: Item) -> list[Item]:
    items = list(flat(slide.items))
    return items[next(k for k, item in enumerate(items) if item is picture) :]


def is_frame(item: Item, each: CourseDeck) -> bool:
    names = {chosen_tile(stop.pixel) for stop in each.lesson.stops}
    return isinstance(item, Polygon) and item.name in names


def test_no_title_is_cut(of_scene):
    """A lesson's headlines fit one line; so does what is said behind them."""
    for each, slide in spoken(of_scene):
        [title] = [t for t in body(slide) if t.is_title]
        assert title.words == slide.title and not title.words.endswith("…"), where(each, slide)
        if slide.kind not in ("title", "section"):
            assert len(title.lines) == 1, where(each, slide)


def test_every_word_of_the_lesson_is_on_its_slides_once_and_in_order(of_scene):
    """So is every picture, with what it shows."""
    for each in of_scene:
        texts = [stop.text(each.lesson.scene) for stop in each.lesson.stops]
        with speaking(each.language):
            items = [item for slide in each.slides if slide.kind != "build" for item in body(slide)]
            parts = [words_and_pictures(text) for text in texts]
        said = " ".join(item.words for item in items if item.name in ("words", "bullet"))
        wanted = " ".join(paragraph.text for words, _ in parts for paragraph in words)
        assert said.split() == wanted.split(), each.name
        captions = [item.words for item in items if item.name == "caption"]
        assert captions == [shown.alt for _, pictures in parts for shown in pictures], each.name


def test_each_stop_has_one_figure_as_a_file_in_the_lessons_order(of_scene):
    """The printed page shows one for each step, question or not, and each answer."""
    for each in of_scene:
        kinds = [slide.kind for slide in each.slides if slide.figure]
        assert kinds == [stop.kind for stop in each.lesson.stops], each.name


def test_tables_and_sums_stand_behind_the_lesson(of_scene):
    """After a divider, and nothing else does; every pixel that is walked has its sum."""
    for each in of_scene:
        kinds = [slide.kind for slide in each.deck.slides]
        tables = [any(isinstance(i, Table) for i in flat(s.items)) for s in each.deck.slides]
        walks = {stop.walk for stop in each.lesson.stops if stop.rows and stop.kind != "question"}
        if not walks:
            assert "backup" not in kinds and not any(tables), each.name
            continue
        divider = kinds.index("backup")
        assert not any(tables[:divider]), each.name
        assert set(kinds[divider + 1 :]) <= set(NUMBERS), each.name
        sums = [s for s in each.deck.slides if s.kind == "sum" and not s.is_continued]
        assert len(sums) == len(walks), each.name
        # A pixel may be there twice: its title tells the switches, its source line the stop.
        assert len({title_and_setting(slide) for slide in sums}) == len(sums), each.name


def title_and_setting(slide: Slide) -> tuple[str, str]:
    """Of a sum: the title, and what its source line says behind the pixel: grid and stop."""
    line = next(t.words for t in slide.items if isinstance(t, Text) and t.name == "where")
    return slide.title, line.partition("×")[2]


def test_no_text_lies_on_another_or_outside_of_its_slide(of_scene):
    """In figures, too."""
    for each, slide in spoken(of_scene):
        page = Box(0, 0, each.deck.width, each.deck.height)
        items = [i for i in flat(slide.items) if isinstance(i, Text | Table)]
        boxes = [(i.name, tight(i) if isinstance(i, Text) else i.box) for i in items]
        for k, (name, box) in enumerate(boxes):
            assert page.holds(box), (where(each, slide), name)
            for other, its in boxes[k + 1 :]:
                assert not box.overlaps(its), (where(each, slide), name, other)


#: What only the live page has: paper has neither keys nor buttons.
CONTROLS = re.compile(
    r"\b(press|click|tap|drag|hover|keyboard|arrow keys?|button|slider|checkbox|menu|toolbar"
    r"|drück\w*|klick\w*|tipp\w* auf|zieh\w* den|taste\w*|pfeiltaste\w*|knopf|schaltfläche\w*"
    r"|schieberegler|menü)\b",
    re.IGNORECASE,
)


def test_no_key_or_button_is_named_on_paper(of_scene):
    for each in of_scene:
        scene = each.lesson.scene
        said = [text for step in scene.lesson for text in (step.text, step.answer, step.headline)]
        said += [
            word for step in scene.lesson for c in step.choices for word in (c.text, c.because)
        ]
        for words in [*said, *scene.goals, scene.teaches]:
            assert not CONTROLS.search(plain_text(words)), (each.name, words)


def test_notes_say_how_long_what_to_ask_and_where_it_is_live(of_scene):
    """Of each stop, on the first of its slides; of an answer what the wrong choices misunderstand;
    of a question nothing that answers it."""
    for each in of_scene:
        firsts = [slide for slide in each.slides if slide.figure]
        scene = each.lesson.scene
        for stop, slide in zip(each.lesson.stops, firsts, strict=True):
            address = slide.notes[-1].split()[-1]
            at = re.fullmatch(r"(de/)?scenes/(.+)/index\.html#step=(\d+)(&answer=1)?", address)
            assert at and (at[2], int(at[3])) == (scene.id, stop.step + 1), slide.notes[-1]
            assert bool(at[1]) == (each.language == "de") and bool(at[4]) == (stop.kind == "answer")
            said, step = " ".join(slide.notes), scene.lesson[stop.step]
            reasons = [plain_text(choice.because) for choice in step.choices]
            if stop.kind == "answer":
                assert all(reason in said for reason in reasons)
            if stop.kind == "question":
                assert not any(reason in said for reason in reasons)
