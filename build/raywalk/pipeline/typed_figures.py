"""Figures in a lesson's words that somebody typed: they stay when the scene changes.

What may be typed: years; sizes of grids, 15 x 15; numbers that the step's own view sets (grid,
pixel, bounces, lights' factors), or its answer's, and the scene's bounce limit; names that hold a
number; scenes and steps by theirs. Numbers in words, one or ten, are no figures. A number of the
text's own example is written {1.5}.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from raywalk.scene.model import Scene
from raywalk.scene.slots import SLOT
from raywalk.words import Words

GROUPS = "\u2009\u202f\u00a0"  # spaces within a number
FIGURE = re.compile(rf"(?<![\w.,])\d(?:[\d.,{GROUPS}]*\d)?(?!\w)")
YEAR = re.compile(r"1[5-9]\d\d|20\d\d")
GRID = re.compile(rf"\d[\d{GROUPS}]*\s*[x×]\s*\d[\d{GROUPS}]*")
ADDRESS = re.compile(r"\]\([^)]*\)|https?://\S+")


def typed_figures(
    text: str, views: Sequence[Mapping[str, Any]], scene: Scene, words: Words
) -> list[str]:
    """Figures of a text that should be slots. views: of its step and of its answer; scene: in the
    text's language."""
    rest = SLOT.sub(" ", text)
    for pattern in (ADDRESS, GRID, *_numbered(scene, words)):
        rest = re.sub(pattern, " ", rest)
    given = {number for view in views for number in _given(view)} | {float(scene.render.depth)}
    return [
        figure
        for figure in FIGURE.findall(rest)
        if not YEAR.fullmatch(figure) and _value(figure, words) not in given
    ]


def _numbered(scene: Scene, words: Words) -> Iterable[re.Pattern[str]]:
    """Names with a number; scene 2; step 3."""
    things = (scene.objects, scene.lights, scene.materials)
    names = [each.name for of in things for each in of if re.search(r"\d", each.name)]
    for name in sorted(names, key=len, reverse=True):
        yield re.compile(re.escape(name), re.IGNORECASE)
    places = words.say("pages.scene.link", key="#", title=""), words.text("slides.stepOf", SLOTS)
    for place in places:
        head = re.escape(re.split(r"#|\{", place)[0].strip())
        yield re.compile(rf"\b{head}\w*\s+\d+", re.IGNORECASE)


SLOTS: dict[str, object] = {"step": "", "of": ""}


def _given(view: Mapping[str, Any]) -> set[float]:
    """Numbers that the step shows because its author said so."""
    switches = view.get("switches") or {}
    numbers = [
        view.get("resolution"), *(view.get("pixel") or ()), switches.get("bounces"),
        *(switches.get("lights") or {}).values(),
    ]  # fmt: skip
    return {float(number) for number in numbers if number is not None}


def _value(figure: str, words: Words) -> float:
    group = "" if words.numbers.decimal == "," else ","
    plain = re.sub(f"[{GROUPS}{group}]", "", figure).replace(words.numbers.decimal, ".")
    try:
        return float(plain)
    except ValueError:
        return float("nan")
