"""The glossary: each term of the course, how it is said in each language, and what not to say.

All of it stands in site_src/words/glossary.toml; pages, cards on words, sheets and the check of
texts are made from that.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Generic, TypeVar

from raywalk.home import HOME
from raywalk.work.snapshot import text_of

FILE = HOME / "site_src" / "words" / "glossary.toml"
# Endings that a term's last word takes where the glossary lists no forms.
ENDINGS = {"en": "(?:s|es)?", "de": "(?:s|es|e|en|n)?"}
STARRED = r"\w{0,4}"  # what a * stands for: any ending
LETTER = r"[\w\u00ad]"  # with soft hyphens
Of = TypeVar("Of")


@dataclass(frozen=True)
class Term:
    """One entry in one language."""

    id: str
    term: str  # as the glossary has it
    says: str
    forms: tuple[str, ...]  # patterns of how it stands in texts
    avoid: tuple[tuple[str, str], ...]  # patterns of what not to say, and why; "" where obvious
    is_marked: bool = True  # in lessons


@dataclass(frozen=True)
class Found:
    """A term in a text."""

    start: int
    end: int
    term: Term


@dataclass(frozen=True)
class Avoided:
    """What a text says that it should not."""

    words: str  # as they stand there
    say: str  # instead
    why: str

    def __str__(self) -> str:
        because = f" ({self.why})" if self.why else ""
        return f'"{self.words}": say "{self.say}"{because}'


@dataclass(frozen=True)
class Wording:
    """What no text says, though it is of no term."""

    avoid: str  # as in a term; where there is a pattern, an example of it
    say: str  # instead
    why: str
    like: str  # a regular expression without groups of its own, or ""


class Glossary:
    """The terms of a language, in the order of their words."""

    def __init__(self, code: str, terms: Sequence[Term], wordings: Sequence[Wording] = ()) -> None:
        self.code, self.wordings = code, wordings
        self.terms = sorted(terms, key=lambda term: term.term.casefold())
        self._forms = _Patterns(
            code,
            [
                (_pattern(code, form), len(form), term)
                for term in terms
                for form in term.forms or (term.term,)
            ],
        )
        self._avoided = _Patterns(
            code,
            [
                (_pattern(code, form), len(form), (term.term, why))
                for term in terms
                for form, why in term.avoid
            ]
            + [
                (each.like or _pattern(code, each.avoid), len(each.avoid), (each.say, each.why))
                for each in wordings
            ],
        )

    def found_in(self, text: str) -> Iterator[Found]:
        """Every place of the text where a term stands, the longest where several would fit."""
        for start, end, term in self._forms.found_in(text):
            yield Found(start, end, term)

    def first_in(self, text: str) -> Iterator[Found]:
        """The first place of each."""
        seen: set[str] = set()
        for found in self.found_in(text):
            if found.term.id not in seen:
                seen.add(found.term.id)
                yield found

    def avoided_in(self, text: str) -> Iterator[Avoided]:
        """What should be said otherwise."""
        for start, end, (say, why) in self._avoided.found_in(text):
            yield Avoided(" ".join(text[start:end].split()), say, why)


# Of a sentence: behind no word and no comma. Elsewhere a capital letter makes another word of it,
# "ein Streifen" of "streifen".
BEGINNING = r"(?<![^\W_]\s)(?<![,;]\s)"


class _Patterns(Generic[Of]):
    """Words, each as a pattern with its length and what it belongs to, all looked for at once."""

    def __init__(self, code: str, forms: Sequence[tuple[str, int, Of]]) -> None:
        longest_first = sorted(forms, key=lambda form: -form[1])
        self.of = [of for _, _, of in longest_first]
        alternatives = "|".join(f"({pattern})" for pattern, _, _ in longest_first)
        # English has small and capital letters alike; in German they tell words apart.
        flags = re.IGNORECASE if code != "de" else 0
        whole = rf"(?<!{LETTER})(?:{alternatives})(?!{LETTER})" if forms else "(?!)"
        self.all = re.compile(whole, flags)

    def found_in(self, text: str) -> Iterator[tuple[int, int, Of]]:
        for match in self.all.finditer(text):
            assert match.lastindex  # one alternative has matched
            yield match.start(), match.end(), self.of[match.lastindex - 1]


def _pattern(code: str, form: str) -> str:
    """A form's words as they may stand in a text: over two lines, at a sentence's beginning."""
    words = [re.escape(word).replace(r"\*", STARRED) for word in form.split()]
    if "*" not in form:
        words[-1] += ENDINGS.get(code, "")
    first = words[0]
    if code == "de" and first[:1].islower():
        words[0] = f"(?:{first[0]}|{BEGINNING}{first[0].upper()}){first[1:]}"
    return r"\s+".join(words)


def read_glossary(code: str = "en") -> Glossary:
    """In a language; a term that it lacks is left out."""
    return _glossary(code, text_of(FILE))


@lru_cache(maxsize=8)  # by its text: a file that is saved anew is read anew
def _glossary(code: str, text: str) -> Glossary:
    read = tomllib.loads(text)
    terms = [_term(entry, entry[code]) for entry in read["terms"] if code in entry]
    return Glossary(code, terms, [_wording(each) for each in read["wordings"].get(code, ())])


def _wording(said: dict[str, str]) -> Wording:
    return Wording(said["avoid"], said["say"], said.get("why", ""), said.get("like", ""))


def _term(entry: dict[str, Any], said: dict[str, Any]) -> Term:
    forms, avoid = tuple(said.get("forms", ())), tuple(said.get("avoid", {}).items())
    is_marked = entry.get("marked", True)
    return Term(entry["id"], said["term"], said["says"], forms, avoid, is_marked)
