"""What is said of mistakes, in a language, and which terms of the glossary they go with."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

from raywalk.mistakes.table import TABLE
from raywalk.words.catalogue import DEFAULT
from raywalk.work.snapshot import text_of

ALL = "mistakes"  # the folder of the site, and of what is said in it
FIELDS = ("title", "does", "seen", "why", "find")
LINES = ("right", "wrong")  # what a program must say, and what it says
OF_TABLE = "does"  # in the default language the table of mistakes has it
SIGNS = (("n.l", "n·l"), ("d.n", "d·n"), (" - ", " − "), (">=", "≥"))  # as they are typeset
Said = dict[str, dict[str, str]]


def read_said(site_source: Path, code: str) -> Said:
    """What is said of each mistake in a language, and its families' names; what it has not yet is
    the default one's, in which the table itself says what a program does."""
    said: Said = {mistake.name: {OF_TABLE: typeset(mistake.does)} for mistake in TABLE}
    for each in dict.fromkeys((DEFAULT, code)):
        file = site_source / ALL / f"{each}.toml"
        for name, own in tomllib.loads(text_of(file)).items() if file.is_file() else ():
            said[name] = said.get(name, {}) | own
    return said


def named(said: dict[str, str]) -> dict[str, str]:
    """What a check says of a mistake that it names."""
    return {field: said[field] for field in ("title", *LINES)}


def typeset(does: str) -> str:
    """What mistakes.json says in ASCII."""
    for plain, sign in SIGNS:
        does = does.replace(plain, sign)
    return does


def of_terms(site_source: Path) -> dict[str, list[str]]:
    """By the id of a term the mistakes that one makes with it."""
    found: dict[str, list[str]] = json.loads(text_of(site_source / ALL / "terms.json"))
    return found
