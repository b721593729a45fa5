"""Lesson Markdown as safe HTML: what an author writes can format text, and nothing else."""

from __future__ import annotations

import re
from functools import lru_cache
from xml.etree.ElementTree import Element

from markdown import Markdown
from markdown.treeprocessors import Treeprocessor

# A link may lead to another part of the course or to a secure address.
SAFE_LINK = re.compile(r"(https://|#|\.{0,2}/|[\w-]+(/|$|\.html))", re.ASCII)


@lru_cache(maxsize=4096)  # pages and slides show the same texts, `serve` again after each save
def lesson_html(text: str) -> str:
    """HTML of one step's text. Raw HTML is shown as it was typed, pictures become their words."""
    markdown = Markdown(output_format="html")
    # Without these two, a tag in the text stays text and is escaped.
    markdown.preprocessors.deregister("html_block")
    markdown.inlinePatterns.deregister("html")
    markdown.treeprocessors.register(_Safe(markdown), "safe", 0)
    return markdown.convert(text)


class _Safe(Treeprocessor):  # type: ignore[misc]
    """Takes out what could load or run something."""

    def run(self, root: Element) -> None:
        for element in root.iter():
            if element.tag == "img":
                element.tag, words = "span", element.get("alt", "")
                element.attrib.clear()
                element.text = words
            elif element.tag == "a" and not SAFE_LINK.match(element.get("href", "")):
                element.tag = "span"
                element.attrib.clear()
