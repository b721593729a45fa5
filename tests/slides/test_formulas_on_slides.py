"""Formulas by name, each on a line of its own, bold, with the sentence that leads to it."""

from __future__ import annotations

import pytest
from tests.slides.course import course_decks, decks_of

from raywalk.slides.figure import Text

#: Scene, name in English and German, what stands on the slide.
FORMULAS = [
    ("01-shading", ("Lambert's law", "lambertschen Gesetz"), "max(0, n·l)"),
    ("01-shading", ("Blinn and Phong", "Blinn und Phong"), "max(0, n·h)ˢ"),
    ("02-shadows", ("in shadow", "im Schatten"), "ε < t < "),
    ("04-one-bounce", ("direction", "Richtung"), "d − 2(d·n) n"),
    ("08-glass", ("Snell's law", "snelliussche Gesetz"), "sin θ₁ = n sin θ₂"),
]


@pytest.mark.parametrize(("id", "names", "formula"), FORMULAS)
def test_a_formula_stands_on_a_slide_of_its_step(id, names, formula):
    decks = decks_of(id)
    for each in decks:
        name = names[each.language == "de"]
        with_it = [s for s in each.slides if any(formula in t.words for t in texts(s.items))]
        assert with_it, each.name
        [line] = [t for t in texts(with_it[0].items) if formula in t.words]
        assert len(line.lines) == 1 and all(run.bold for run in line.lines[0])
        step = [s for s in each.slides if s.title == with_it[0].title]
        assert any(name in t.words for s in step for t in texts(s.items)), each.name


def texts(items) -> list[Text]:
    return [item for item in items if isinstance(item, Text) and item.name == "words"]


def test_shadow_acne_is_named_where_the_shadow_test_is():
    """And what goes wrong without an epsilon, on the same step's slides."""
    for each in course_decks():
        if each.deck.id == "02-shadows":
            said = " ".join(t.words for s in each.slides for t in texts(s.items))
            where = said.index("ε < t < ")
            name = "shadow acne" if each.language == "en" else "Schattenakne"
            assert 0 < said.index(name) - where < 400
