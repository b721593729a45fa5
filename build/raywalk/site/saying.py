"""Sentences in templates: `say` as text, `tell` as HTML with bold, code, titles and links."""

from __future__ import annotations

import re
from typing import Any

from markupsafe import Markup, escape

from raywalk.words import Words
from raywalk.words.catalogue import SLOT

# **bold**, `code`, _title_, and [text](slot), where the slot of that name holds the address.
MARK = re.compile(
    r"\*\*(?P<b>.+?)\*\*|`(?P<code>.+?)`|(?<!\w)_(?P<cite>.+?)_(?!\w)|\[(?P<a>.+?)\]\((?P<to>\w+)\)"
)


def sayings(words: Words) -> dict[str, Any]:
    """What templates know of a language: words, words.say, and tell.

    tell(key, **slots) gives HTML: sentence and text slots are escaped, Markup slots (formulas)
    are put in as they are, marks become elements. No translation can bring an element of its own.
    """

    def tell(key: str, /, **slots: object) -> Markup:
        text = words.text(key, slots, links=True)
        made, at = Markup(""), 0
        for mark in MARK.finditer(text):
            made += _filled(text[at : mark.start()], slots) + _element(mark, slots)
            at = mark.end()
        return made + _filled(text[at:], slots)

    return {"words": words, "say": words.say, "tell": tell}


def _element(mark: re.Match[str], slots: dict[str, object]) -> Markup:
    if mark["a"]:
        return Markup('<a href="{}">{}</a>').format(slots[mark["to"]], _filled(mark["a"], slots))
    tag = next(name for name in ("b", "code", "cite") if mark[name])
    return Markup(f"<{tag}>{{}}</{tag}>").format(_filled(mark[tag], slots))


def _filled(text: str, slots: dict[str, object]) -> Markup:
    return Markup(SLOT.sub(lambda slot: str(escape(slots[slot[1]])), str(escape(text))))
