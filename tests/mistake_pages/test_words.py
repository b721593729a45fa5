"""What is said of mistakes: of each, in each language, in the words of the glossary."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from raywalk.mistakes.table import BY_NAME, FAMILIES
from raywalk.site.mistakes import ALL, FIELDS, Said, read_said
from raywalk.terms.glossary import read_glossary
from raywalk.words import languages

SOURCE = Path(__file__).parents[2] / "site_src"


def own_words(code: str) -> Said:
    """Of a language alone."""
    said: Said = tomllib.loads((SOURCE / ALL / f"{code}.toml").read_text("utf-8"))
    return said


@pytest.mark.parametrize("code", languages())
def test_each_mistake_is_told_whole_and_nothing_else_is(code: str) -> None:
    """A table a mistake, with all its fields, and the families' names."""
    said = own_words(code)
    assert set(said) == {*BY_NAME, "families"}
    assert tuple(said["families"]) == FAMILIES
    for name in BY_NAME:
        assert tuple(said[name]) == FIELDS, name
        assert all(said[name].values()), name
        assert len(said[name]["title"]) < 60 and not said[name]["title"].endswith("."), name
        assert all(said[name][field].endswith((".", "!")) for field in FIELDS[1:]), name


def test_each_language_has_its_own_words() -> None:
    """No sentence of one stands in another's file, and there is a file a language."""
    assert {path.stem for path in (SOURCE / ALL).glob("*.toml")} == set(languages())
    told: set[str] = set()
    for code in languages():
        own = {text for name in BY_NAME for text in own_words(code)[name].values()}
        assert not own & told and len(own) == len(FIELDS) * len(BY_NAME), code
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
    assert read_said(SOURCE, "xx") == own_words("en")
