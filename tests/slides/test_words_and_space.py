"""What stands on slides: the lesson's words, all of them, large enough, nothing on another."""

from __future__ import annotations

import io

import numpy as np
import pytest
from pptx import Presentation
from pypdf import PdfReader

from raywalk.pipeline.slide_products import write_files
from raywalk.slides.blocks import TITLE_SIZES, flow
from raywalk.slides.clip import clipped_line
from raywalk.slides.figure import (
    Deck,
    Dot,
    Group,
    Line,
    Run,
    Slide,
    Table,
    Text,
    flat,
)  # fmt: skip
from raywalk.slides.formats import REMARKS
from raywalk.slides.html import deck_html
from raywalk.slides.labels import Label, Places
from raywalk.slides.layout import LAYOUTS, SMALLEST, Box
from raywalk.slides.legend import SAMPLE
from raywalk.slides.lesson_words import Paragraph, plain_text
from raywalk.slides.palette import DASH_LENGTHS, KINDS, PRINT, SCREEN
from raywalk.slides.pdf import MissingGlyphs, deck_pdf
from raywalk.slides.pptx import deck_pptx
from raywalk.slides.pptx_shapes import PRESET_DASH
from raywalk.slides.step_figure import CHOSEN_WIDTH
from raywalk.slides.typeface import width, wrapped

from .conftest import BALLS

LONG = " ".join(f"Sentence {k} says something that nobody can leave out." for k in range(160))


def texts(slide: Slide) -> list[Text]:
    return [item for item in flat(slide.items) if isinstance(item, Text)]


def words_on(slides: list[Slide]) -> str:
    """Title and body of a step's slides, without what is said again on a continued one."""
    parts = []
    for slide in slides:
        if not slide.is_continued:
            parts += [t.words for t in texts(slide) if t.is_title]
        parts += [t.words for t in texts(slide) if t.name in ("words", "bullet")]
    return " ".join(parts)


@pytest.mark.parametrize("aspect", ["16:9", "4:3"])
def test_the_slides_of_a_step_say_what_the_lesson_says(balls, aspect):
    """Every word once, in order; a step whose first sentence is too long for a title has the
    scene's."""
    slides = [s for s in balls.deck(aspect).slides if s.kind in ("step", "question", "answer")]
    stops = balls.lesson(aspect).stops
    assert len(slides) == len(stops)
    for slide, stop in zip(slides, stops, strict=True):
        assert words_on([slide]) == plain_text(stop.text(balls.scene))
        assert slide.kind == stop.kind
        assert slide.notes[1] == plain_text(stop.text(balls.scene))


@pytest.mark.parametrize("aspect", ["16:9", "4:3"])
def test_the_longest_first_sentence_that_is_a_title_is_not_cut(made, aspect):
    """It takes one line in the smallest size of titles; one letter more and the scene's name is the
    title."""
    most, size = LAYOUTS[aspect].title.width, TITLE_SIZES[-1]
    letters = int((most - width("Wide.", size, bold=True)) / width("m", size, bold=True))
    for sentence, fits in ((f"Wide{'m' * letters}.", True), (f"Wide{'m' * (letters + 1)}.", False)):
        text = f"{sentence} And the rest."
        deck = made(f'[[lesson]]\ntext = "{text}"\nview = {{ resolution = 7 }}').deck(aspect)
        [step] = [s for s in deck.slides if s.kind == "step"]
        assert step.title == (sentence if fits else "Two balls")
        assert words_on([step]) == (text if fits else f"Two balls {text}")
        assert not [t.words for t in texts(step) if "…" in t.words]


@pytest.mark.parametrize("aspect", ["16:9", "4:3"])
def test_nothing_is_small_cut_or_over_something_else(balls, aspect):
    """Text of at least 18 points but for the source line, within the slide; words never on
    words."""
    deck = balls.deck(aspect)
    page = Box(0, 0, deck.width, deck.height)
    for slide in deck.slides:
        boxes = [(t.words, tight(t)) for t in texts(slide)]
        boxes += [(i.name, i.box) for i in flat(slide.items) if isinstance(i, Table)]
        for words, box in boxes:
            assert page.holds(box), (slide.title, words)
        for k, (words, box) in enumerate(boxes):
            for others, other in boxes[k + 1 :]:
                assert not box.overlaps(other), (slide.title, words, others)
        sizes = [
            i.size
            for i in flat(slide.items)
            if isinstance(i, Text | Table) and i.name not in ("where", "place")
        ]
        assert min(sizes) >= SMALLEST


def tight(text: Text) -> Box:
    """The words' own box, a hair smaller: neighbours may touch."""
    from raywalk.slides.typeface import run_width

    wide = max(sum(run_width(run, text.size) for run in line) for line in text.lines)
    box = text.box
    share = {"left": 0.0, "centre": 0.5, "right": 1.0}[text.align]
    left = box.left + share * (box.width - wide)
    high = len(text.lines) * text.size * text.leading
    return Box(left + 0.1, box.top + 0.1, max(wide - 0.2, 0.1), max(high - 0.2, 0.1))


def test_labels_keep_clear_of_rays(deck: Deck):
    """No label of a figure is struck through by a ray of the selected pixel."""
    for slide in deck.slides:
        if not slide.figure:
            continue
        labels = [i for i in flat(slide.figure.items) if isinstance(i, Text) and "label" in i.name]
        groups = [
            i for i in slide.figure.items if isinstance(i, Group) and i.name.startswith("Ray ")
        ]
        rays = [line for group in groups for line in group.items if isinstance(line, Line)]
        for label in labels:
            assert not [ray for ray in rays if clipped_line(ray.start, ray.end, tight(label))]


def test_every_light_that_is_drawn_is_named(deck: Deck, balls):
    """Also over tiles and frustum, whose lines are faint: only rays keep a name away."""
    names = {light.name for light in balls.scene.lights}
    seen = 0
    for slide in deck.slides:
        if not slide.figure:
            continue
        drawn = {i.name for i in flat(slide.figure.items) if isinstance(i, Dot)} & names
        words_on = {i.words for i in flat(slide.figure.items) if isinstance(i, Text)}
        assert drawn <= words_on, slide.title
        seen += len(drawn)
    assert seen


def test_labels_take_a_faint_lines_place_only_if_there_is_no_other():
    """Beside thin rays where that is free; on them rather than nowhere; on a ray never."""
    frame, at = Box(0, 0, 200, 120), (100.0, 60.0)
    right = [((x, 0.0), (x, 120.0)) for x in range(104, 200, 4)]
    everywhere = [((0.0, y), (200.0, y)) for y in range(0, 120, 4)]
    for strokes, faint, places in (([], right, 1), ([], everywhere, 1), (everywhere, [], 0)):
        taken = Places(frame, np.zeros((1, 1, 4), np.uint8))
        taken.strokes, taken.faint = list(strokes), list(faint)
        words = [i for i in taken.put([Label("light 1", at)]) if isinstance(i, Text)]
        assert len(words) == places
        if faint is right:
            assert words[0].box.right < 104


def test_many_thin_rays_are_thinner_and_stay_lines(made):
    """Those of 441 pixels are narrower than those of 49."""
    step = '[[lesson]]\ntext = "All."\nview = {{ resolution = {n}, rays = ["all"] }}\n'
    deck = made(step.format(n=7) + step.format(n=21)).deck()
    widths = []
    for figure in [s.figure for s in deck.slides if s.kind == "step" and s.figure]:
        groups = [i for i in figure.items if isinstance(i, Group)]
        group = next(g for g in groups if g.name == "Rays of other pixels")
        lines = [i for i in flat(group.items) if isinstance(i, Line) and i.dash != "hidden"]
        widths.append(max(line.width for line in lines))
    assert len(widths) == 2 and widths[1] < 0.8 * widths[0]


@pytest.mark.parametrize("aspect", ["16:9", "4:3"])
def test_few_rays_stand_above_their_sum_and_more_before_it(made, aspect):
    """Five rays and their sum are one table above the other; six take a slide of their own. A long
    name is whole."""
    name = "wall behind the camera"
    scene = HALL.replace('name = "front"', f'name = "{name}"')
    for depth, kinds in ((4, ["sum"]), (5, ["table", "sum"])):
        deck = made(TO_AND_FRO, scene.replace("depth = 60", f"depth = {depth}")).deck(aspect)
        behind = [s for s in deck.slides if s.kind in ("table", "sum") and not s.is_continued]
        assert [s.kind for s in behind] == kinds
        table = next(i for i in behind[0].items if isinstance(i, Table))
        assert len(table.rows) == depth + 2 and name in [row[1].text for row in table.rows]


def test_sums_are_parted_between_paragraphs():
    """A paragraph that would be torn goes on whole, unless it is the first."""
    points = [Paragraph((Run("many words " * 30),)) for _ in range(3)]
    whole = flow(points, 14, 300)
    each = len(whole.lines) // 3
    first, rest = whole.split_between(whole.line_height * (each + 3))
    assert len(first.lines) == each and rest.lines[0][2]
    first, rest = whole.split_between(whole.line_height * 3)
    assert len(first.lines) == 3 and len(rest.lines) == 3 * each - 3


def test_powerpoint_keeps_words_at_the_top_and_numbers_with_their_sign(made):
    """Its own wrapping may take a line less than ours, and may break elsewhere."""
    words = "So it is that 5.9 % is mirrored, and 94.1 % goes in. " * 4
    deck = made(f'[[lesson]]\ntext = "Title. {words}"\nview = {{ resolution = 7 }}').deck()
    place = next(k for k, s in enumerate(deck.slides) if s.kind == "step")
    slide = Presentation(io.BytesIO(deck_pptx(deck, SCREEN))).slides[place]
    body = next(s for s in slide.shapes if s.name == "words")
    assert body._element.txBody.bodyPr.get("anchor") == "t"
    assert "5.9\N{NO-BREAK SPACE}%" in body.text_frame.text
    assert "5.9 %" not in body.text_frame.text


def test_very_long_words_go_on_on_the_next_slides(made):
    """160 sentences: every one is there once, over several slides, none cut."""
    lesson = f'[[lesson]]\ntext = "{LONG}"\nview = {{ resolution = 7, pixel = [2, 3] }}'
    deck = made(lesson).deck()
    steps = [s for s in deck.slides if s.kind == "step"]
    assert len(steps) > 2 and [s.is_continued for s in steps] == [False] + [True] * (len(steps) - 1)
    assert words_on(steps) == LONG
    page = Box(0, 0, deck.width, deck.height)
    assert all(page.holds(tight(t)) for s in steps for t in texts(s))


def test_one_word_longer_than_a_line_is_broken(made):
    """A word of 400 letters stays within its column."""
    lesson = f'[[lesson]]\ntext = "See: {"abcdefgh" * 50}"\nview = {{ resolution = 7 }}'
    deck = made(lesson).deck()
    page = Box(0, 0, deck.width, deck.height)
    for slide in deck.slides:
        assert all(page.holds(tight(t)) for t in texts(slide))
    steps = [s for s in deck.slides if s.kind == "step"]
    body = "".join(t.words for s in steps for t in texts(s) if t.name == "words")
    assert body.replace(" ", "") == "See:" + "abcdefgh" * 50


def test_a_number_keeps_its_per_cent_sign():
    """Wherever the line ends: "%" never begins one."""
    for most in range(80, 200, 3):
        lines = wrapped([Run("So 5.9 % is mirrored, 94.1 % goes in, 100 %.")], 16, most)
        starts = ["".join(run.text for run in line)[0] for line in lines]
        assert "%" not in starts, most


def test_the_legend_names_the_lines_that_are_drawn(deck: Deck):
    """Each kind of line in the figure has its word under it, and no other kind has."""
    for slide in deck.slides:
        if not slide.figure:
            continue
        legends = [
            i for i in slide.figure.items if isinstance(i, Group) and i.name == "Kinds of rays"
        ]
        rest = tuple(i for i in slide.figure.items if i not in legends)
        drawn = {i.colour for i in flat(rest) if isinstance(i, Line)} & set(KINDS)
        named = {i.colour for i in flat(tuple(legends)) if isinstance(i, Line)} - {"soft"}
        assert named == drawn, slide.title


def test_hebrew_reads_from_right_to_left(made):
    """Set right, marked in every format; in PDF in the order in which it is seen."""
    words = "קרן אחת פוגעת בכדור."
    lesson = f'[[lesson]]\ntext = "{words} {words} {words} {words}"\nview = {{ resolution = 7 }}'
    deck = made(lesson).deck()
    step = next(s for s in deck.slides if s.kind == "step")
    body = next(t for t in texts(step) if t.name == "words")
    assert body.right_to_left and body.align == "right"
    assert 'direction="rtl"' in deck_html(deck)
    seen = PdfReader(io.BytesIO(deck_pdf(deck, PRINT))).pages[deck.slides.index(step)]
    assert words.split()[0][::-1] in seen.extract_text() or words.split()[0] in seen.extract_text()
    slide = Presentation(io.BytesIO(deck_pptx(deck, SCREEN))).slides[deck.slides.index(step)]
    assert 'rtl="1"' in slide._element.xml


def test_letters_that_the_font_lacks_are_refused_in_pdf(made):
    """By name, before anything is written; the other formats are set by the reader's fonts."""
    deck = made('[[lesson]]\ntext = "A ray: 光線"\nview = { resolution = 7 }').deck()
    with pytest.raises(MissingGlyphs, match=r"光 \(U\+5149\), 線 \(U\+7DDA\)"):
        deck_pdf(deck, PRINT)
    assert "光線" in deck_html(deck)
    assert deck_pptx(deck, SCREEN)


def test_a_build_says_where_the_letters_stand_and_what_to_do(made, tmp_path):
    """File, step and letters, and the formats that can be had; only PDF is left out."""
    scene = made('[[lesson]]\ntext = "Ray."\n[[lesson]]\ntext = "قاعدة"\nview = {}')
    out = tmp_path / "out"
    out.mkdir()
    write_files(out, scene.deck(), ("html", "pdf", "pptx"), None, [scene.scene])
    assert sorted(path.suffix for path in out.iterdir()) == [".html", ".pptx", ".txt"]
    remark = (out / REMARKS).read_text(encoding="utf-8")
    for part in ("scene.toml", "lesson[1].text", "step 2: ", "U+0627", "--format html,svg,pptx"):
        assert part in remark


@pytest.mark.parametrize(
    ("old", "new", "key"),
    [
        ('title = "Two balls"', 'title = "光線"', "title"),
        ('name = "floor"', 'name = "أرض"', "objects[2].name"),
        ("position = [-2, 2, 1]", 'position = [-2, 2, 1]\nname = "光"', "lights[1].name"),
    ],
)
def test_letters_of_titles_and_names_are_found_too(made, tmp_path, old, new, key):
    """File and key as for a step's words."""
    assert old in BALLS
    step = '[[lesson]]\ntext = "Ray."\nview = { resolution = 7, pixel = [3, 6] }'
    scene = made(step, BALLS.replace(old, new))
    write_files(tmp_path, scene.deck(), ("pdf",), None, [scene.scene])
    remark = (tmp_path / REMARKS).read_text(encoding="utf-8")
    assert "scene.toml" in remark and key in remark and "U+" in remark


def test_a_legends_samples_tell_the_kinds_apart_without_colour():
    """No two kinds share a dash, and each sample holds a dash whole, its gap and the next one's
    beginning, in PDF and SVG by our lengths, in PowerPoint by its own, in shares of the width."""
    for dashes in (DASH_LENGTHS, PRESET_DASH):
        assert len({dashes[kind] for kind in KINDS}) == len(KINDS)
    powerpoint = {
        "solid": 0,
        "dash": 7,
        "lgDash": 11,
        "sysDash": 4,
        "sysDot": 2,
        "dashDot": 11,
    }  # ECMA-376, 20.1.10.48
    for kind in KINDS:
        assert sum(DASH_LENGTHS[kind]) < SAMPLE
        assert powerpoint[PRESET_DASH[kind]] * CHOSEN_WIDTH < SAMPLE


def test_a_walk_of_many_rays_still_fits(made):
    """Two mirrors face to face and 60 bounces: behind the lesson every ray stands once, in order,
    on as many slides as it takes; so do those of the sum. Before the step come four slides."""
    deck = made(TO_AND_FRO, HALL).deck()
    tables = [i for s in deck.slides if s.kind == "table" for i in s.items if isinstance(i, Table)]
    numbers = [row[0].text for table in tables for row in table.rows[1:]]
    assert numbers == [str(k) for k in range(1, 62)]
    sums = [s for s in deck.slides if s.kind == "sum"]
    assert len(sums) > 1 and all(s.is_continued for s in sums[1:])
    page = Box(0, 0, deck.width, deck.height)
    for slide in deck.slides:
        assert all(page.holds(i.box) for i in flat(slide.items) if isinstance(i, Table))
    assert len([s for s in deck.slides if s.kind == "build"]) == 4


TO_AND_FRO = """
[[lesson]]
text = "To and fro."
view = { resolution = 7, pixel = [3, 3], tiles = "filled" }
"""
HALL = """
version = 1
title = "Hall of mirrors"
teaches = "To and fro."
[camera]
eye = [0, 0, 1]
target = [0, 0, 0]
[render]
size = 21
resolutions = [7]
depth = 60
[[objects]]
name = "front"
type = "plane"
point = [0, 0, -1]
normal = [0, 0, 1]
material = { reflect = 1 }
[[objects]]
name = "back"
type = "plane"
point = [0, 0, 2]
normal = [0, 0, -1]
material = { reflect = 1 }
[[lights]]
position = [0, 1, 0]
"""
