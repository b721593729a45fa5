"""The table of mistakes says what is so: each is made somewhere, and shows where it says."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from tests.geometry.by_hand import SHAPES, scene_of

from raywalk.mistakes import table
from raywalk.mistakes.features import FEATURES, GRID, SEEN, Right, shown_in, shows
from raywalk.mistakes.habits import Habits
from raywalk.mistakes.table import BY_NAME, FAMILIES, TABLE, checked
from raywalk.mistakes.tracer import Version, picture, pictures
from raywalk.scene.model import Material

from .course import NAMES, right, scene
from .test_agreement import LAMPS

SOURCES = Path(table.__file__).parent
# A share of the pixels this near to SEEN may be counted either way: features are asked of what a
# mistake touches, and that differs from what it changes by the bytes' rounding.
EITHER_WAY = 0.2


def changed(name: str, mistake: str) -> float:
    """Share of the pixels of a scene that a mistake changes."""
    right, *wrong = all_pictures(name)
    return float((wrong[list(BY_NAME).index(mistake)] != right).any(axis=2).mean())


@cache
def all_pictures(name: str) -> list[np.ndarray]:
    """The right one, then each mistake's."""
    versions = [Version(), *(Version(frozenset([mistake])) for mistake in BY_NAME)]
    return pictures(scene(name), GRID, versions)


def test_there_are_all_families_with_names_of_their_own() -> None:
    """In the order of a ray's way; names are one word, what is done one line."""
    assert FAMILIES == (
        "camera", "nearest hit", "normal", "light", "shadow", "mirror", "glass", "colour",
    )  # fmt: skip
    assert len(BY_NAME) == len(TABLE) >= 30
    for mistake in TABLE:
        assert re.fullmatch(r"[a-z]+(-[a-z]+)*", mistake.name)
        assert mistake.does and not mistake.does.endswith(".") and len(mistake.does) < 80


def test_each_mistake_is_made_in_the_code_and_none_that_has_no_row() -> None:
    """The words that the code asks for are those of the table."""
    code = {path.name: path.read_text("utf-8") for path in SOURCES.glob("*.py")}
    asked = {name for text in code.values() for name in re.findall(r'"([\w-]+)" in mistakes', text)}
    believed = set(re.findall(r'^    "([\w-]+)":', code["believed.py"], flags=re.MULTILINE))
    assert asked | believed == set(BY_NAME)


def test_features_are_those_that_mistakes_need() -> None:
    """None is asked for that nobody finds, none is found that nobody asks for."""
    assert {name for mistake in TABLE for name in mistake.needs} == set(FEATURES)


@pytest.mark.parametrize("name", NAMES)
def test_a_mistake_shows_where_its_row_says_and_nowhere_else(name: str) -> None:
    """If the scene has what it needs it changes over 0.5 % of the pixels; if not, fewer."""
    wrong = []
    for mistake in TABLE:
        share, told = changed(name, mistake.name), shows(mistake.name, right(name))
        low, high = SEEN * (1 - EITHER_WAY), SEEN * (1 + EITHER_WAY)
        if share < low if told else share > high:
            wrong.append(f"{mistake.name}: {100 * share:.2f} % of pixels, table says {told}")
    assert not wrong, wrong


# (n.h)^100 is nothing where a surface faces away: no scene of the course shows it.
BROAD = Material("broad", diffuse=(0.2, 0.2, 0.2), specular=(1.0, 1.0, 1.0), shininess=2.0)
ELSEWHERE = {"highlight-turned-away": scene_of([SHAPES["sphere"]], [BROAD], LAMPS[1:])}


def test_every_mistake_shows_somewhere() -> None:
    """In a scene of the course, or in one made for it."""
    shown = {name for each in NAMES for name in shown_in_course(each)}
    assert set(BY_NAME) - shown == set(ELSEWHERE)
    for name, made in ELSEWHERE.items():
        wrong = picture(made, GRID, frozenset([name])).bytes
        assert (wrong != picture(made, GRID).bytes).any(axis=2).mean() > SEEN
        assert shows(name, Right(made))


def shown_in_course(name: str) -> list[str]:
    return [mistake.name for mistake in TABLE if shows(mistake.name, right(name))]


def test_speckles_lie_elsewhere_in_another_program() -> None:
    """Of the two mistakes that rounding decides, and of no other: in float32 other pixels are
    dark than in float64."""
    for mistake in TABLE:
        one, other = (
            picture(scene("04-one-bounce"), 33, frozenset([mistake.name]), Habits(precision)).bytes
            for precision in (np.float64, np.float32)
        )
        apart = np.abs(one.astype(int) - other).max(axis=2) > 2
        assert (apart.mean() > 0.02) == mistake.speckles, mistake.name


def test_what_shows_in_a_scene_is_asked_in_one_call() -> None:
    """The names, in the table's order; none of glass in a scene without."""
    found = shown_in(scene("02-shadows"))
    assert found == shown_in_course("02-shadows")
    assert "shadow-acne" in found and "total-black" not in found


def test_a_word_that_is_no_mistake_is_refused_by_name() -> None:
    """With the nearest that are."""
    with pytest.raises(ValueError, match=r"no mistake 'far-rot'; did you mean one of: far-root"):
        checked(["far-rot"])
    assert checked(["far-root"]) == frozenset(["far-root"])
