"""Terms of the glossary in a lesson's HTML: links to their entries, of which pages make cards."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass

from raywalk.scene.model import Scene
from raywalk.terms.glossary import Glossary, Term

TAG = re.compile(r"(<[^>]*>)")
# Within these nothing is marked: links in links, formulas, code.
SHUT = {"a", "code", "pre", "math", "svg", "button"}
PAGE = "glossary/index.html"


def marked(html: str, glossary: Glossary, to_glossary: str = f"../../{PAGE}") -> str:
    """The first place of each term in a step's HTML as a link. to_glossary: its page's address from
    a scene's page."""
    seen: set[str] = set()
    shut = 0
    parts = []
    for part in TAG.split(html):
        if tag := re.match(r"<(/?)([\w-]+)", part):
            if tag[2] in SHUT and not part.endswith("/>"):
                shut += -1 if tag[1] else 1
            parts.append(part)
        else:
            parts.append(part if shut else _linked(part, glossary, seen, to_glossary))
    return "".join(parts)


def _linked(text: str, glossary: Glossary, seen: set[str], to: str) -> str:
    made, at = "", 0
    for found in glossary.found_in(text):
        if found.term.id in seen or not found.term.is_marked:
            continue
        seen.add(found.term.id)
        words = text[found.start : found.end]
        made += f'{text[at : found.start]}<a class="term" href="{to}#{found.term.id}">{words}</a>'
        at = found.end
    return made + text[at:]


@dataclass(frozen=True)
class FirstSeen:
    """Where a lesson first uses a term."""

    scene: str  # id
    title: str
    step: int  # from 1


def first_seen(glossary: Glossary, scenes: Sequence[Scene]) -> dict[str, FirstSeen]:
    """By the term's id, in the order of the scenes; terms that no step has are left out."""
    places: dict[str, FirstSeen] = {}
    for scene in scenes:
        for k, step in enumerate(scene.lesson, start=1):
            for text in (step.text, step.answer):
                for found in glossary.found_in(text):
                    places.setdefault(found.term.id, FirstSeen(scene.id, scene.title, k))
    return places


def letters_of(terms: Sequence[Term]) -> dict[str, str]:
    """First letters, each with the id of the first term that begins so."""
    letters: dict[str, str] = {}
    for term in terms:
        letters.setdefault(term.term[0].upper(), term.id)
    return letters


def terms_script(terms: Sequence[Term]) -> str:
    """What the cards say, as a classic script: raywalkGlossary by id."""
    told = {term.id: [term.term, term.says] for term in terms}
    return f"raywalkGlossary={json.dumps(told, ensure_ascii=False, separators=(',', ':'))};\n"
