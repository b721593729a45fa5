"""Lesson Markdown as safe HTML: what an author writes can format text, and nothing else."""

from __future__ import annotations

import re
from copy import deepcopy
from functools import lru_cache
from html import unescape
from urllib.parse import quote
from xml.etree.ElementTree import Element

from markdown import Markdown
from markdown.inlinepatterns import InlineProcessor
from markdown.treeprocessors import Treeprocessor
from markdown.util import AtomicString

from raywalk.scene.formula import FORMULA, NoFormula, mathml

# A link may lead to another part of the course or to a secure address. Browsers drop spaces and
# control characters from an address and read a backslash as a slash, so //host, /\\host and the
# like lead to another host by whatever scheme the page has.
SAFE_LINK = re.compile(
    r"(https://(?![/\\])|#|\.{0,2}/(?![/\\])|[\w-]+(/|$|\.html))[^\x00-\x20\\]*", re.ASCII
)


# A picture is a file beside scene.toml, and stands below the scene's folder in the site.
PICTURE = re.compile(r"\w[\w .()+-]*\.(png|jpe?g|webp|svg)", re.IGNORECASE)
PICTURES = "pictures"


@lru_cache(maxsize=4096)  # pages and slides show the same texts, `serve` again after each save
def lesson_html(text: str, scene: str = "") -> str:
    """HTML of one step's text. Raw HTML is shown as it was typed, $...$ and $$...$$ become
    formulas. Pictures of the folder of the scene with this id are shown, on its page and on those
    beside it; all others, and without an id all, become their words. Raises NoFormula."""
    markdown = Markdown(output_format="html")
    # Without these two, a tag in the text stays text and is escaped.
    markdown.preprocessors.deregister("html_block")
    markdown.inlinePatterns.deregister("html")
    # Behind code, before all else: a formula's stars and underlines are its own.
    markdown.inlinePatterns.register(_Formulas(FORMULA.pattern, markdown), "formula", 185)
    markdown.block_level_elements = [tag for tag in markdown.block_level_elements if tag != "math"]
    markdown.ESCAPED_CHARS = [*markdown.ESCAPED_CHARS, "$"]
    markdown.treeprocessors.register(_Safe(markdown, scene), "safe", 0)
    return markdown.convert(text)


def inline_html(text: str, scene: str = "") -> str:
    """The same of a text in a line, as a choice's: without its paragraph, if it is one."""
    html = lesson_html(text, scene)
    alone = re.fullmatch(r"<p>((?:(?!</?p>).)*)</p>", html, re.DOTALL)
    return alone[1] if alone else html


def is_safe(address: str) -> bool:
    """Whether a link may lead there. Entities in it are read as a browser reads them."""
    return SAFE_LINK.fullmatch(unescape(address)) is not None


class _Formulas(InlineProcessor):  # type: ignore[misc]
    def handleMatch(self, match: re.Match[str], text: str) -> tuple[Element, int, int]:
        """What Markdown calls for each match."""
        latex = match["whole"] or match["one"]
        try:
            formula = deepcopy(mathml(latex, is_display=bool(match["whole"])))
        except NoFormula as problem:
            raise NoFormula(f"${latex}$ cannot be read: {problem}") from None
        for element in formula.iter():
            if element.text:
                element.text = AtomicString(element.text)
        return formula, match.start(0), match.end(0)


class _Safe(Treeprocessor):  # type: ignore[misc]
    """Takes out what could load or run something."""

    def __init__(self, markdown: Markdown, scene: str):
        super().__init__(markdown)
        self.scene = scene

    def run(self, root: Element) -> None:
        for element in root.iter():
            if element.tag == "img":
                source, words = unescape(element.get("src", "")), element.get("alt", "")
                element.attrib.clear()
                if self.scene and PICTURE.fullmatch(source):
                    element.set("src", f"../{self.scene}/{PICTURES}/{quote(source)}")
                    element.set("alt", words)
                    element.set("loading", "lazy")
                else:
                    element.tag, element.text = "span", words
            elif element.tag == "a" and not is_safe(element.get("href", "")):
                element.tag = "span"
                element.attrib.clear()
