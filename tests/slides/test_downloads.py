"""What a lesson's files are listed as: on its page, on the page of all slides, for the viewer."""

from __future__ import annotations

import pytest

from raywalk.site.downloads import sorted_downloads
from raywalk.slides.formats import FORMATS, PUBLISHED, TRANSLATED
from raywalk.words import read_words

SIZES = {
    "slides/04-balls.html": 143_200,
    "slides/04-balls.pdf": 1_240_000,
    "slides/04-balls-worksheet.pdf": 400,
    "slides/04-balls-figure-01.svg": 9_000,
}


def test_files_come_in_the_panels_order_with_sizes_in_words():
    panel = sorted_downloads("04-balls", SIZES, read_words())
    assert [(file["word"], file["size"]) for file in panel["files"]] == [
        ("html", "143 KB"), ("pdf", "1.2 MB"), ("worksheet", "1 KB"),
    ]  # fmt: skip
    assert panel["figures"] == ["slides/04-balls-figure-01.svg"]


def test_the_viewer_reads_folder_and_sizes_form_by_form():
    """A form that is not there has no number; a language's comma does not part the list."""
    panel = sorted_downloads("04-balls", SIZES, read_words("de"))
    assert panel["compact"] == "slides/|143 KB|1,2 MB|-|-|-|-|1 KB"


def test_a_file_that_nothing_links_is_refused():
    """It would weigh, and nobody would find it."""
    with pytest.raises(ValueError, match="would be published and never linked"):
        sorted_downloads("04-balls", SIZES | {"slides/04-balls-poster.pdf": 9}, read_words())


def test_answers_are_nowhere_on_the_site():
    """They are for teachers: in what `raywalk teacher` makes, and on demand."""
    with pytest.raises(ValueError, match="would be published and never linked"):
        sorted_downloads("04-balls", SIZES | {"slides/04-balls-answers.pdf": 9}, read_words())
    assert "answers" in FORMATS and "answers" not in {*PUBLISHED, *TRANSLATED}
