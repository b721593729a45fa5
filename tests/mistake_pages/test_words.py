"""What is said of mistakes: of each, in each language, in the words of the glossary."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from raywalk.mistakes.table import BY_NAME, FAMILIES
from raywalk.site.mistake_words import (
    ALL,
    FIELDS,
    LINES,
    OF_TABLE,
    Said,
    of_terms,
    read_said,
    typeset,
)
from raywalk.terms.glossary import read_glossary
from raywalk.words import languages
from raywalk.words.catalogue import DEFAULT

SOURCE = Path(__file__).parents[2] / "site_src"


def own_words(code: str) -> Said:
    """Of a language alone."""
    said: Said = tomllib.loads((SOURCE / ALL / f"{code}.toml").read_text("utf-8"))
    return said


def fields_in(code: str) -> tuple[str, ...]:
    """Those that stand in a language's file."""
    return tuple(field for field in FIELDS if code != DEFAULT or field != OF_TABLE)


@pytest.mark.parametrize("code", languages())
def test_each_mistake_is_told_whole_and_nothing_else_is(code: str) -> None:
    """A table a mistake, with all its fields, and the families' names."""
    said = own_words(code)
    assert set(said) == {*BY_NAME, "families"}
    assert tuple(said["families"]) == FAMILIES
    for name in BY_NAME:
        assert tuple(each for each in said[name] if each not in LINES) == fields_in(code), name
        assert all(said[name].values()), name
        assert len(said[name]["title"]) < 60 and not said[name]["title"].endswith("."), name
        sentences = [said[name][field] for field in FIELDS if field not in ("title", OF_TABLE)]
        assert all(text.endswith((".", "!")) for text in sentences), name
        does = read_said(SOURCE, code)[name][OF_TABLE]
        assert len(does) < 80 and does[0].islower() and does[-1] not in ".!", name


def test_each_language_has_its_own_words() -> None:
    """No sentence of one stands in another's file, and there is a file a language."""
    assert {path.stem for path in (SOURCE / ALL).glob("*.toml")} == set(languages())
    told: set[str] = set()
    for code in languages():
        said, fields = own_words(code), fields_in(code)
        own = {said[name][field] for name in BY_NAME for field in fields}
        assert not own & told and len(own) == len(fields) * len(BY_NAME), code
        told |= own


@pytest.mark.parametrize("code", languages())
def test_no_term_is_said_as_the_glossary_says_it_is_not(code: str) -> None:
    """As lessons are asked."""
    glossary, said = read_glossary(code), own_words(code)
    wrong = [
        f"{name}.{field}: {found}"
        for name in BY_NAME
        for field, text in said[name].items()
        for found in glossary.avoided_in(text)
    ]
    assert not wrong


def test_a_language_that_has_no_words_yet_is_told_in_the_first_one() -> None:
    """A translation that is under way has pages, too."""
    said = read_said(SOURCE, "xx")
    assert said == read_said(SOURCE, "en") and own_words("en")["families"] == said["families"]
    for name, own in own_words("en").items():
        assert own.items() <= said[name].items()


def test_terms_of_the_glossary_lead_to_mistakes_that_there_are() -> None:
    """Each mistake with one term, if it has one."""
    terms = of_terms(SOURCE)
    assert set(terms) <= {term.id for term in read_glossary("en").terms}
    named = [name for names in terms.values() for name in names]
    assert len(named) == len(set(named)) and set(named) <= set(BY_NAME)


def test_what_a_program_does_is_the_tables_own_in_english_and_typeset() -> None:
    """It stands once, in mistakes.json, which is plain ASCII."""
    assert read_said(SOURCE, "en")["upside-down"][OF_TABLE] == BY_NAME["upside-down"].does
    assert typeset("takes |n.l|: c - p, t >= 0") == "takes |n·l|: c − p, t ≥ 0"


def test_lines_to_change_stand_once_and_what_is_wrong_differs_from_what_is_right() -> None:
    """Every mistake has both; each language shows the same."""
    said = own_words(DEFAULT)
    lines = {name: tuple(said[name][each] for each in LINES) for name in BY_NAME}
    assert all(right and wrong for right, wrong in lines.values())
    assert len(set(lines.values())) == len(lines)
    assert all(right != wrong for right, wrong in lines.values())
    for code in languages():
        own, said = own_words(code), read_said(SOURCE, code)
        assert code == DEFAULT or not any(set(LINES) & set(own[name]) for name in BY_NAME)
        assert {name: tuple(said[name][each] for each in LINES) for name in lines} == lines
