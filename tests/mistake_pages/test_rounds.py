"""Which mistake is this? Questions have one right answer, and choices that one would weigh."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from raywalk.mistake_pages.best import Shown
from raywalk.mistake_pages.clarity import EYE, nearest, seen_apart
from raywalk.mistake_pages.rounds import CHOICES, MOST, Round, rounds_of
from raywalk.mistakes.table import BY_NAME
from raywalk.mistakes.tracer import picture
from raywalk.site.mistake_words import read_said
from raywalk.site.pages import home_of
from raywalk.words import languages

from ..mistakes.course import scene

ROOT = Path(__file__).parents[2]
PAGE = "mistakes/which/index.html"
QUESTION = re.compile(r'<article class="question".*?</article>', re.DOTALL)
CHOICE = re.compile(r"<li( data-right)?><span[^>]*>[A-D]</span> <span>… (.*?)</span></li>")

CAMERA = ["upside-down", "mirrored", "aspect", "fov-in-radians", "rows-and-columns-swapped"]


def told(**changes: Any) -> dict[str, Any]:
    """As clarity.json says it of a scene where five mistakes of the camera are seen well apart."""
    near = {name: [(other, 0.5) for other in CAMERA if other != name] for name in CAMERA}
    return {"eye": dict.fromkeys(CAMERA, 0.4), "near": near} | changes


def rounds(of: dict[str, Any]) -> tuple[Round, ...]:
    shown = {name: Shown("a", ("a",)) for name in of["eye"]}
    return rounds_of(shown, {"a": of})


def asked(code: str) -> list[str]:
    return QUESTION.findall((ROOT / "dist" / home_of(code) / PAGE).read_text("utf-8"))


def test_each_question_has_four_choices_and_its_own_mistake_among_them() -> None:
    """No choice twice; the same ones in each build."""
    (made,) = rounds(told())
    assert made.family == "camera" and len(made.questions) == len(CAMERA)
    for question in made.questions:
        assert len(set(question.choices)) == CHOICES and question.name in question.choices
    assert rounds(told()) == (made,)


def test_nobody_is_asked_what_cannot_be_seen_or_told_apart() -> None:
    """A picture that hardly differs is no question and no choice; of two that look alike one is not
    offered beside the other, and of what has too few choices left nothing is asked."""
    faint = told(eye=dict.fromkeys(CAMERA, 0.4) | {"aspect": 0.001})
    (made,) = rounds(faint)
    assert "aspect" not in {choice for question in made.questions for choice in question.choices}
    near = told()["near"]
    near["upside-down"] = [
        (other, 0.001 if other == "mirrored" else 0.5) for other, _ in near["upside-down"]
    ]
    (made,) = rounds(told(near=near))
    choices = {question.name: question.choices for question in made.questions}
    assert "mirrored" not in choices["upside-down"] and "mirrored" in choices["mirrored"]
    near["upside-down"] = near["upside-down"][:2]
    (made,) = rounds(told(near=near))
    assert "upside-down" not in {question.name for question in made.questions}


def test_a_family_of_one_question_is_left_out_and_a_course_without_any_has_no_round() -> None:
    """What shows too few mistakes asks nothing."""
    assert rounds({"eye": {"aspect": 0.4}, "near": {"aspect": []}}) == ()
    assert rounds_of({}, {}) == ()


def test_those_that_look_most_alike_are_told_first() -> None:
    """Of three pictures the nearer; what is seen apart is counted in pixels that an eye sees."""
    grey = np.full((4, 4, 3), 100)
    pictures = {"mirrored": grey, "aspect": grey + 3 * EYE, "upside-down": grey + EYE}
    assert [name for name, _ in nearest(pictures)["mirrored"]] == ["upside-down", "aspect"]
    near = grey.copy()
    near[0, 0, 1] += EYE
    assert seen_apart(grey, near) == 1 / 16 and seen_apart(grey, grey + EYE - 1) == 0


@pytest.mark.parametrize("code", languages())
def test_the_page_asks_in_each_language_and_no_choice_is_another_ones_words(code: str) -> None:
    """One right answer a question; six questions a family at most; as many in each language."""
    said = read_said(ROOT / "site_src", code)
    does = {said[name]["does"]: name for name in BY_NAME}
    assert len(does) == len(BY_NAME)
    questions = asked(code)
    assert len(questions) == len(asked("en")) >= 30
    for text in questions:
        choices = CHOICE.findall(text.replace("&#39;", "'").replace("&gt;", ">"))
        assert len({words for _, words in choices}) == CHOICES and all(
            words in does for _, words in choices
        )
        (right,) = [does[words] for marked, words in choices if marked]
        assert f'src="../../mistakes/{right}/wrong.webp"' in text.replace("../../../", "../../")
        assert f'href="../{right}/index.html"' in text
    for family in re.findall(r'id="([a-z-]+)-1"', "".join(questions)):
        assert sum(f'id="{family}-{k}"' in text for text in questions for k in range(1, 20)) <= MOST


@pytest.mark.parametrize("place", [0, 7, 21])
def test_the_picture_is_its_answers_and_no_other_choice_makes_it(place: int) -> None:
    """Traced anew at the size that is shown, each other choice differs where an eye sees it."""
    text = asked("en")[place]
    right = re.search(r"/mistakes/([\w-]+)/wrong\.webp", text)
    best = re.search(r"/mistakes/right-([\w-]+)\.webp", text)
    assert right and best
    with Image.open(ROOT / "dist" / "mistakes" / right[1] / "wrong.webp") as image:
        shown = np.asarray(image.convert("RGB")).astype(int)
    said = {
        own["does"]: name
        for name, own in read_said(ROOT / "site_src", "en").items()
        if "does" in own
    }
    for marked, words in CHOICE.findall(text):
        made = picture(scene(best[1]), 231, frozenset([said[words]])).bytes.astype(int)
        assert (seen_apart(made, shown) == 0) == bool(marked), words
