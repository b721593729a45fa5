"""A lesson's pictures are on slides of their own: whole, not distorted, in every format."""

from __future__ import annotations

import io
import re

import pytest
from PIL import Image, ImageDraw
from pptx import Presentation
from pypdf import PdfReader
from tests.slides.conftest import BALLS, Made, last

from raywalk.commands.slides import traced
from raywalk.pipeline.slides import plans_of
from raywalk.scene.read import read_scene
from raywalk.slides.figure import Picture, Slide
from raywalk.slides.handout import handout_pdf
from raywalk.slides.html import deck_html
from raywalk.slides.layout import LAYOUTS, Box
from raywalk.slides.lesson_words import plain_text, words_and_pictures
from raywalk.slides.palette import PRINT, SCREEN
from raywalk.slides.pdf import deck_pdf
from raywalk.slides.pptx import deck_pptx
from raywalk.stops.process import Stops
from raywalk.work.store import Store

LESSON = """
[[lesson]]
text = '''
Equal angles. So it is drawn in books.

![a ray and its mirror ray](angle.png)

A photograph, ![a lake](<big lake.jpg>), and a plan: ![the plan](plan.svg)
'''
view = { resolution = 7, pixel = [3, 3], rays = ["all"], tiles = "empty" }
"""
ON_PAGE = "(shown on the scene\u2019s page)"
SIZES = {"angle.png": (300, 200), "big lake.jpg": (2400, 600)}


@pytest.fixture(scope="module")
def sketched(tmp_path_factory: pytest.TempPathFactory) -> Made:
    folder = tmp_path_factory.mktemp("sketched")
    place = folder / "scenes" / "04-balls"
    place.mkdir(parents=True)
    drawn = Image.new("RGBA", SIZES["angle.png"])  # black lines on nothing
    ImageDraw.Draw(drawn).line([(10, 10), (150, 190), (290, 10)], "black", 4)
    drawn.save(place / "angle.png")
    Image.new("RGB", SIZES["big lake.jpg"], (30, 90, 160)).save(place / "big lake.jpg")
    (place / "plan.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>', "utf-8")
    (place / "scene.toml").write_text(BALLS + LESSON, encoding="utf-8")
    return Made(read_scene(place), Store(folder / "work"))


def shown_on(slide: Slide) -> list[Picture]:
    return [item for item in slide.items if isinstance(item, Picture)]


@pytest.mark.parametrize("aspect", LAYOUTS)
def test_each_picture_has_a_slide_behind_its_step(sketched: Made, aspect: str) -> None:
    """In the text's order, in its own proportions, within the slide, with its words beneath; a
    point a pixel at most. Of an SVG there are the words."""
    deck = sketched.deck(aspect)
    slides = [slide for slide in deck.slides if any(p.name in SIZES for p in shown_on(slide))]
    assert [shown_on(slide)[0].name for slide in slides] == list(SIZES)
    whole = Box(0, 0, deck.width, deck.height)
    for slide in slides:
        [picture] = shown_on(slide)
        wide, high = SIZES[picture.name]
        assert picture.box.width / picture.box.height == pytest.approx(wide / high, rel=0.01)
        assert picture.box.width <= wide + 1e-9 and whole.holds(picture.box)
        others = [item.box for item in slide.items if hasattr(item, "box") and item is not picture]
        assert not any(picture.box.overlaps(box) for box in others)
        assert picture.alt in [getattr(item, "words", "") for item in slide.items]
        assert slide.is_continued and slide.notes == (picture.alt,)
    step = next(slide for slide in deck.slides if slide.title == "Equal angles.")
    said = " ".join(getattr(item, "words", "") for item in step.items)
    # They stand in a sentence; a drawing that is not among the slides is on the page.
    assert "a lake," in said and f"the plan {ON_PAGE}" in said
    assert "a ray and its mirror ray" not in said  # it is shown instead
    assert "a ray and its mirror ray" in step.notes[1]


def test_a_picture_alone_leaves_no_words_and_others_their_own() -> None:
    paragraphs, shown = words_and_pictures("See ![x](a.png) here.\n\n![y](b.png)\n\n![z](c.svg)")
    assert [each.text for each in paragraphs] == ["See x here.", f"z {ON_PAGE}"]
    assert [each.file for each in shown] == ["a.png", "b.png"]


def test_a_worksheet_says_where_its_questions_pictures_are_seen() -> None:
    """It has words alone, of whatever kind a picture is."""
    assert plain_text("See ![x](a.png).", on_page=True) == f"See x {ON_PAGE}."


def test_every_format_has_the_pictures(sketched: Made) -> None:
    """Lines without a ground are on white: on dark slides they would not be seen. A large
    photograph is made smaller."""
    deck = sketched.deck()
    for palette in (SCREEN, PRINT):
        pages = PdfReader(io.BytesIO(deck_pdf(deck, palette))).pages
        images = [image.image for page in pages for image in page.images]
        sizes = [image.size for image in images]
        assert (300, 200) in sizes and (1600, 400) in sizes
        drawn = images[sizes.index((300, 200))].convert("RGB")
        assert drawn.getpixel((0, 0)) == (255, 255, 255)
        assert max(drawn.getpixel((150, 188))) < 60
    alts = [
        shape._element.nvPicPr.cNvPr.get("descr")
        for slide in Presentation(io.BytesIO(deck_pptx(deck, SCREEN))).slides
        for shape in slide.shapes
        if shape.shape_type == 13
    ]
    assert {"a ray and its mirror ray", "a lake"} <= set(alts)
    page = deck_html(deck)
    assert all(
        re.search(f'aria-label="{alt}"', page) for alt in ("a ray and its mirror ray", "a lake")
    )
    handout = PdfReader(io.BytesIO(handout_pdf(deck, 2)))
    assert sum(len(page.images) for page in handout.pages) > 2


def test_another_picture_makes_other_slides(sketched: Made) -> None:
    """Its content is in their key."""
    file = sketched.scene.path.parent / "angle.png"
    kept, key = file.read_bytes(), key_of_slides(sketched)
    assert key_of_slides(sketched) == key
    Image.new("L", (300, 200), 128).save(file)
    try:
        assert key_of_slides(sketched) != key
    finally:
        file.write_bytes(kept)


def key_of_slides(made: Made) -> str:
    with Stops() as stops:
        [plan] = last(plans_of(made.store, stops, [last(traced(made.store, made.scene))]))
    return plan.key
