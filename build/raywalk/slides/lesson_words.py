"""A lesson's Markdown as paragraphs of runs, and its first sentence as a slide's title."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from html.parser import HTMLParser
from typing import NamedTuple
from urllib.parse import unquote

from raywalk.scene.lesson_text import lesson_html
from raywalk.slides.figure import Run
from raywalk.slides.words import say

BLOCKS = {"p", "li", "h1", "h2", "h3", "h4", "h5", "h6", "pre", "blockquote", "td", "th"}


@dataclass(frozen=True)
class Paragraph:
    runs: tuple[Run, ...]
    bullet: str = ""  # "•" or "1." for an item of a list
    is_formula: bool = False  # one that stands by itself

    @property
    def text(self) -> str:
        return "".join(run.text for run in self.runs)


def paragraphs_of(markdown: str, on_page: bool = False) -> list[Paragraph]:
    """What a reader reads: links are their words, pictures their description.

    on_page: they are seen on the scene's page only, which is said.
    """
    reader = _Reader(on_page)
    reader.feed(lesson_html(markdown, "here" if on_page else ""))
    reader.close()
    reader.end_paragraph()
    return reader.paragraphs


class Shown(NamedTuple):
    """A picture of a lesson."""

    file: str  # its name in the scene's folder
    alt: str


def words_and_pictures(markdown: str) -> tuple[list[Paragraph], list[Shown]]:
    """The same, where pictures are shown: of one that stands by itself no word is left.
    An SVG is put in words, with where it is seen."""
    reader = _Reader()
    reader.feed(lesson_html(markdown, "here"))
    reader.close()
    reader.end_paragraph()
    return reader.paragraphs, reader.pictures


def plain_text(markdown: str, on_page: bool = False) -> str:
    """All words in one line, as on the slides of the step taken together. on_page: as above."""
    return " ".join(paragraph.text for paragraph in paragraphs_of(markdown, on_page))


def title_and_body(
    paragraphs: list[Paragraph], fits: Callable[[str], bool]
) -> tuple[str, list[Paragraph]]:
    """The first sentence if it fits as a title, and the rest; else "" and all."""
    if not paragraphs or paragraphs[0].bullet:
        return "", paragraphs
    first = paragraphs[0]
    match = re.match(r".+?[.?!…](?=\s|$)", first.text)
    sentence = match.group() if match else first.text
    if not fits(sentence):
        return "", paragraphs
    rest = _after(first.runs, len(sentence))
    return sentence, ([Paragraph(rest)] if rest else []) + paragraphs[1:]


def _after(runs: tuple[Run, ...], skipped: int) -> tuple[Run, ...]:
    """The runs without their first characters and the space that follows."""
    left: list[Run] = []
    for run in runs:
        text, skipped = run.text[skipped:], max(0, skipped - len(run.text))
        if not left:
            text = text.lstrip()
        if text:
            left.append(Run(text, run.bold, run.italic))
    return tuple(left)


class _Reader(HTMLParser):
    """Collects runs from the HTML that our own Markdown writer made."""

    def __init__(self, on_page: bool = False) -> None:
        super().__init__(convert_charrefs=True)
        self.on_page = on_page
        self.paragraphs: list[Paragraph] = []
        self.pictures: list[Shown] = []
        self.runs: list[Run] = []
        self.is_only_pictures = True  # in this paragraph
        self.bold = self.italic = 0
        self.lists: list[int] = []  # numbers of open lists; 0 for bullets
        self.bullet = ""
        self.is_formula = self.has_formula = False

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag in ("strong", "b", "h1", "h2", "h3", "h4", "h5", "h6"):
            self.bold += 1
        if tag in ("em", "i"):
            self.italic += 1
        if tag == "img":
            source, alt = (dict(attrs).get(key) or "" for key in ("src", "alt"))
            was, file = self.is_only_pictures, unquote(source.rpartition("/")[2])
            is_svg = file.lower().endswith(".svg")  # PDF and PowerPoint draw none: its words stay
            self.handle_data(say("slides.onPage", words=alt) if is_svg or self.on_page else alt)
            if not is_svg:
                self.pictures.append(Shown(file, alt))
                self.is_only_pictures = was
        if tag == "math":
            stands_alone = dict(attrs).get("display") == "block"
            self.bold += stands_alone
            self.handle_data(dict(attrs).get("alttext") or "")
            self.bold -= stands_alone
            self.has_formula, self.is_formula = stands_alone, True
        if tag in ("ul", "ol"):
            self.end_paragraph()
            self.lists.append(int(tag == "ol"))
        if tag == "li":
            self.end_paragraph()
            number = self.lists[-1] if self.lists else 0
            self.bullet = f"{number}." if number else "•"
            if number:
                self.lists[-1] += 1
        elif tag in BLOCKS and not (tag == "p" and self.bullet and not self.runs):
            self.end_paragraph()

    def handle_endtag(self, tag: str) -> None:
        if tag in ("strong", "b", "h1", "h2", "h3", "h4", "h5", "h6"):
            self.bold -= 1
        if tag in ("em", "i"):
            self.italic -= 1
        if tag == "math":
            self.is_formula = False
        if tag in BLOCKS:
            self.end_paragraph()
        if tag in ("ul", "ol") and self.lists:
            self.lists.pop()

    def handle_data(self, data: str) -> None:
        if self.is_formula:
            return  # its line has been taken
        text = re.sub(r"\s+", " ", data)
        if not self.runs:
            text = text.lstrip()
        if text:
            self.is_only_pictures &= not text.strip()
            self.runs.append(Run(text, self.bold > 0, self.italic > 0))

    def end_paragraph(self) -> None:
        """What was read so far is one paragraph."""
        if not self.is_only_pictures and "".join(run.text for run in self.runs).strip():
            last = self.runs[-1]
            self.runs[-1] = Run(last.text.rstrip(), last.bold, last.italic)
            alone = self.has_formula and len(self.runs) == 1
            self.paragraphs.append(Paragraph(tuple(self.runs), self.bullet, alone))
            self.bullet, self.has_formula = "", False
        self.runs, self.is_only_pictures = [], True
