"""The files: complete in themselves, small, the same bytes each time, readable by everyone."""

from __future__ import annotations

import io
import re
import zipfile
from xml.etree import ElementTree

import pytest
from pptx import Presentation
from pptx.enum.shapes import PP_PLACEHOLDER
from pypdf import PdfReader

from raywalk.pipeline.slide_products import deck_files
from raywalk.slides.figure import Deck, Text
from raywalk.slides.formats import FORMATS, PER_SHEET
from raywalk.slides.handout import handout_pdf
from raywalk.slides.html import deck_html
from raywalk.slides.palette import PRINT, SCREEN
from raywalk.slides.pdf import deck_pdf
from raywalk.slides.pptx import deck_pptx
from raywalk.trace.pixel_tree import pixel_tree

from .conftest import Made

MIRROR = "The mirror sends the ray on."


@pytest.fixture(scope="module")
def files(balls) -> dict[str, bytes]:
    """Of one lesson, in all formats."""
    return files_of(balls)


def files_of(made: Made) -> dict[str, bytes]:
    return dict(deck_files(made.deck(), FORMATS, None, made.lesson()))


def test_twice_made_is_the_same_to_the_byte(balls, files):
    """Nothing of the clock, of random numbers or of an order by chance."""
    first, second = files, files_of(balls)
    assert sorted(first) == sorted(second)
    assert [name for name in first if first[name] != second[name]] == []


def test_no_file_is_over_a_megabyte(files):
    """A lesson can be sent by mail."""
    for name, data in files.items():
        assert len(data) < 1_000_000, name


def test_html_needs_nothing_from_elsewhere(deck: Deck):
    """Data only: no address, no script, no style but its own, which its policy names."""
    page = deck_html(deck)
    links = re.findall(r'(?:href|src)="([^"]*)"', page)
    assert links and all(link.startswith(("data:", "#")) for link in links)
    assert "<script" not in page and " style=" not in page and "url(" not in page
    assert "default-src 'none'" in page and "style-src 'sha256-" in page
    assert page.count("<section ") == len(deck.slides)


def test_svg_figures_are_well_formed_and_alone(balls):
    figures = dict(deck_files(balls.deck(), ("svg",), None, None))
    assert len(figures) == 5  # four steps, one of them with an answer
    for data in figures.values():
        root = ElementTree.fromstring(data)
        assert root.find("{http://www.w3.org/2000/svg}desc").text
        for element in root.iter():
            assert element.get("href", "data:").startswith("data:")
            assert "style" not in element.attrib and "script" not in element.tag


def test_pdf_has_title_language_outline_and_text(deck: Deck):
    reader = PdfReader(io.BytesIO(deck_pdf(deck, PRINT)))
    assert reader.metadata.title == "Two balls"
    assert reader.trailer["/Root"]["/Lang"] == "en"
    assert [entry.title for entry in reader.outline] == [s.title for s in deck.slides]
    place = next(k for k, slide in enumerate(deck.slides) if slide.title == MIRROR and slide.figure)
    assert "It brings back what it meets." in " ".join(reader.pages[place].extract_text().split())
    fonts = {
        str(font.get_object()["/BaseFont"])
        for page in reader.pages
        for font in page["/Resources"]["/Font"].values()
    }
    assert all("Arimo" in name or name == "/Helvetica" for name in fonts)
    for page in reader.pages:  # Helvetica is named by ReportLab on every page, never used
        assert b"/F1 1" not in page.get_contents().get_data().replace(b"/F1 12 Tf 14.4 TL", b"")


def test_pptx_has_titles_notes_names_and_descriptions(deck: Deck):
    shown = Presentation(io.BytesIO(deck_pptx(deck, SCREEN)))
    for slide, made in zip(deck.slides, shown.slides, strict=True):
        assert made.shapes.title.text_frame.text == slide.title
        if slide.notes:
            assert made.notes_slide.notes_text_frame.text == "\n".join(slide.notes)
        ids = re.findall(r'<p:cNvPr id="(\d+)"', made._element.xml)
        assert len(ids) == len(set(ids))
        assert not re.search(r'id="(?!1")\d+" name=""', made._element.xml)  # 1: the slide itself
    step = shown.slides[
        next(k for k, slide in enumerate(deck.slides) if slide.title == MIRROR and slide.figure)
    ]
    figure = next(shape for shape in step.shapes if shape.name == "Figure")
    assert "mirror" in figure._element.xpath("./p:nvGrpSpPr/p:cNvPr")[0].get("descr")
    assert {"Frustum", "Ray 1, camera ray", "Ray 2, reflected"} <= {s.name for s in figure.shapes}
    behind = shown.slides[len(deck.slides) - 1]
    assert any(shape.has_table for shape in behind.shapes)


def test_pptx_has_its_words_in_the_places_of_its_master(deck: Deck):
    """Title, body and notes are placeholders: the outline has them, and who changes the master's
    font changes all slides'. One layout, where ours stand, on our ground."""
    shown = Presentation(io.BytesIO(deck_pptx(deck, SCREEN)))
    [layout] = shown.slide_layouts
    frames = [(round(p.left / 12700), round(p.top / 12700)) for p in layout.placeholders]
    assert frames == [(32, 8), (32, 388)]
    for slide, made in zip(deck.slides, shown.slides, strict=True):
        kinds = [p.placeholder_format.type for p in made.placeholders]
        said = [i for i in slide.items if isinstance(i, Text) and i.name == "words"]
        assert kinds.count(PP_PLACEHOLDER.TITLE) == 1
        assert kinds.count(PP_PLACEHOLDER.BODY) == bool(said)
        if said:
            body = next(p for p in made.placeholders if p.placeholder_format.idx == 1)
            spoken = body.text_frame.text.replace("\N{NO-BREAK SPACE}", " ")
            assert spoken.startswith(said[0].words)
        if slide.notes:
            assert made.notes_slide.notes_placeholder is not None
    ground = shown.slide_master.background.fill.fore_color.rgb
    assert f"#{ground}".lower() == SCREEN["ground"].lower()


def test_pptx_is_a_zip_with_one_date_in_one_order(deck: Deck):
    with zipfile.ZipFile(io.BytesIO(deck_pptx(deck, SCREEN))) as packed:
        names = packed.namelist()
        assert names[0] == "[Content_Types].xml" and names[1:] == sorted(names[1:])
        assert {info.date_time for info in packed.infolist()} == {(2020, 1, 1, 0, 0, 0)}


@pytest.mark.parametrize("per_sheet", PER_SHEET)
def test_handouts_have_as_many_sheets_as_they_need(deck: Deck, per_sheet: int):
    pages = PdfReader(io.BytesIO(handout_pdf(deck, per_sheet))).pages
    assert len(pages) == -(-len(deck.slides) // per_sheet)


def test_the_worksheets_answers_are_the_traces(balls):
    """The nearest hit of a pixel that is asked for, traced anew."""
    from raywalk.slides.sheet_questions import questions

    asked = questions(balls.lesson())
    assert len(asked) >= 7
    for question in asked:
        match = re.search(r"pixel \((\d+), (\d+)\) of the 7 × 7 grid meet first", question.asks)
        if match and "distance" in question.answer:
            met = pixel_tree(balls.scene, 7, 7, int(match[1]), int(match[2]))["tree"]
            assert question.answer.startswith(f"{met['object']}, at distance {met['t']:.3f}, ")
    assert asked[-1].answer == "Yes. Both lights reach it."


def test_a_worksheet_of_several_sheets_numbers_them(balls):
    """Title and "1 / 2" at each foot; no number where there is one sheet only."""
    from raywalk.slides.figure import Slide
    from raywalk.slides.worksheet import numbered, worksheet

    sheets = worksheet(balls.lesson(), with_answers=False).slides
    assert len(sheets) > 1
    for k, sheet in enumerate(sheets, start=1):
        said = [item.words for item in sheet.items if isinstance(item, Text)]
        assert said[-2:] == [sheet.title, f"{k} / {len(sheets)}"]
    alone = Slide("Alone", ())
    assert numbered([alone]) == [alone]


def test_no_question_stands_alone_on_a_worksheets_last_page():
    """It takes the one before along; a sheet of one page, or of two questions, stays."""
    from raywalk.slides.worksheet import _parted

    for count in range(1, 30):
        pages = _parted([([], 100.0)] * count)
        assert sum(map(len, pages)) == count
        assert len(pages) == 1 or len(pages[-1]) > 1
