"""Every worksheet of the course can be solved on paper: from its facts and formulas alone a student
finds the printed answers, in both languages."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from raywalk.pipeline.lessons import all_lessons
from raywalk.scene.read import read_scenes
from raywalk.slides.deck import Sources
from raywalk.slides.figure import Text, flat
from raywalk.slides.layout import WIDE
from raywalk.slides.sheet_questions import sheet_facts
from raywalk.slides.words import speaking, words
from raywalk.slides.worksheet import SIZE, SMALL, worksheet
from raywalk.work.store import Store

from .slides.conftest import last
from .slides.on_paper import Student, Thing, numbers, pattern
from .slides.sheet_texts import question_texts

ROOT = Path(__file__).parent.parent
LANGUAGES = ("en", "de")
IDS = [scene.id for scene in read_scenes(ROOT / "scenes")]
PRINTED = 0.0006  # half of the third decimal, and what printed axes lack


@cache
def lessons() -> dict[str, list[Sources]]:
    """From the built site's store."""
    return last(all_lessons(ROOT / "scenes", Store(ROOT / ".work")))


@cache
def sheet(id: str, language: str) -> tuple[Student, tuple[tuple[str, str], ...]]:
    """Who has read the facts of an answer sheet, and its questions with their printed answers."""
    sources = next(each for each in lessons()[language] if each.scene.id == id)
    with speaking(language):
        deck = worksheet(sources.lesson(WIDE), with_answers=True)
        texts = [i for s in deck.slides for i in flat(s.items) if isinstance(i, Text)]
        facts = [each.words for each in texts if each.size == SMALL and each.name == "words"]
        return Student(words(), facts), tuple(question_texts(texts, SIZE))


def cases() -> Iterator[tuple[str, str]]:
    yield from ((id, language) for id in IDS for language in LANGUAGES)


def met(student: Student, thing: Thing | None, t: float, point: np.ndarray, answer: str) -> None:
    """A printed hit is this one, to its last digit."""
    if thing is None:
        assert answer == student.words.say("slides.answerLeaves")
        return
    found = pattern(student.words, "slides.answerNearest").fullmatch(answer)
    assert found and found["name"] == thing.name, answer
    assert abs(numbers(found["t"])[0] - t) < PRINTED
    assert np.abs(np.array(numbers(found["point"])) - point).max() < PRINTED


def solve(student: Student, kind: str, asked: dict[str, str], answer: str) -> None:
    """Works one question out and compares. Raises AssertionError."""
    if kind == "bytes":
        colour = np.array(numbers(asked["colour"]))
        assert np.rint(np.clip(255 * colour, 0, 255)).tolist() == numbers(answer)
        return
    if kind in ("mean", "tests"):
        assert numbers(answer) == from_the_lesson(student, kind, asked)
        return
    d = student.ray(int(asked["x"]), int(asked["y"]), int(asked["n"]))
    if kind == "equation":
        equation(student, d, asked["name"], answer)
        return
    hits = student.all_hits(student.eye, d)
    if kind == "order":
        printed = [(part.strip(), numbers(part)[-1]) for part in answer.split("; ")]
        for (text, t), (want, thing) in zip(printed, hits, strict=False):
            assert thing.name in text and abs(t - want) < PRINTED
        assert len(hits) == len(printed) or hits[len(printed) - 1][1].kind == "flat"
        return
    t, first = hits[0] if hits else (np.inf, None)
    if kind == "nearest":
        met(student, first, t, student.eye + t * d if first else d, answer)
        return
    p, n = student.eye + t * d, first.normal(student.eye + t * d, d)
    assert student.named(asked["name"]) is first
    if kind == "lambert":
        to = lamp(student, asked) - p
        assert abs(n @ to / np.linalg.norm(to) - numbers(answer)[-1]) < PRINTED
        return
    if kind == "shadow":
        shadow(student, p, lamp(student, asked), first, answer)
        return
    way = d - 2 * (d @ n) * n
    if kind == "refracted":
        k, w = 1 / first.ior, -d @ n
        way = k * d + (k * w - np.sqrt(1 - k * k * (1 - w * w))) * n
    t, thing = student.all_hits(p, way, first)[0]
    met(student, thing, t, p + t * way, answer)


def from_the_lesson(student: Student, kind: str, asked: dict[str, str]) -> list[float]:
    """Worked out of the line that the sheet prints for this ray or tile."""
    key = {"mean": "sheet.worked.rays", "tests": "sheet.worked.boxes"}[kind]
    [told] = [
        found.groupdict() for line in student.lines
        if (found := pattern(student.words, key).fullmatch(line))
        and (found["x"], found["y"]) == (asked["x"], asked["y"])
    ]  # fmt: skip
    if kind == "mean":
        rays = np.array(
            [[int(part) for part in ray.split(",")] for ray in told["listed"].split(";")]
        )
        assert rays.shape == (9, 3)
        mean: list[float] = np.floor(rays.mean(axis=0) + 0.5).tolist()
        return mean
    return [float(sum(int(told[part]) for part in ("missed", "entered", "off", "triangles")))]


def equation(student: Student, d: np.ndarray, name: str, answer: str) -> None:
    """b, c and D by the sheet's formula, and the roots where there are some."""
    ball = student.named(name)
    away, radius = student.eye - ball.centre, float(np.linalg.norm(ball.linear[0]))
    b, c = float(away @ d), float(away @ away) - radius**2
    want = [b, c, b * b - c]
    if b * b > c:
        want += [-b - np.sqrt(b * b - c), -b + np.sqrt(b * b - c)]
    found = numbers(answer.replace("₁", "").replace("₂", ""))
    assert len(found) == len(want) and np.abs(np.array(found) - want).max() < PRINTED


def lamp(student: Student, asked: dict[str, str]) -> np.ndarray:
    the = student.words.the
    return next(at for name, at in student.lights.items() if asked["light"] in (name, the(name)))


def shadow(student: Student, p: np.ndarray, at: np.ndarray, first: Thing, answer: str) -> None:
    stops = {
        thing.name
        for t, thing in student.all_hits(p, at - p, first)
        if t < 1 and not (thing.ior and student.passes)
    }
    arrives = answer == student.words.say("slides.answerArrives")
    assert arrives == (not stops), stops
    if stops:
        found = pattern(student.words, "slides.answerBlocked").fullmatch(answer)
        assert found and student.named(found["name"]).name in stops


KINDS: dict[str, str] = {
    "nearest": "slides.askNearest", "order": "slides.askOrder", "shadow": "slides.askShadow",
    "lambert": "slides.askLambert", "reflected": "slides.askReflected",
    "refracted": "slides.askRefracted", "bytes": "slides.askBytes",
    "equation": "sheet.worked.askEquation", "mean": "sheet.worked.askMean",
    "tests": "sheet.worked.askTests",
}  # fmt: skip


def asked_of(student: Student, text: str) -> tuple[str, dict[str, Any]] | None:
    for kind, key in KINDS.items():
        if found := pattern(student.words, key).fullmatch(text):
            return kind, found.groupdict()
    return None


@pytest.mark.parametrize(("id", "language"), list(cases()))
def test_a_student_with_paper_finds_the_printed_answers(id: str, language: str) -> None:
    """Each question that the trace answers; at least one of a scene of which nothing is a mesh."""
    student, asked = sheet(id, language)
    solved = 0
    for text, answer in asked:
        if known := asked_of(student, text):
            solve(student, known[0], known[1], answer)
            solved += 1
    assert solved >= 2, "a worksheet that nothing can be worked out of"


def test_every_kind_of_question_is_asked_somewhere() -> None:
    found = set()
    for id in IDS:
        student, asked = sheet(id, "en")
        found |= {known[0] for text, _ in asked if (known := asked_of(student, text))}
    assert found == set(KINDS)


def test_both_languages_ask_the_same() -> None:
    """Of the same pixels, with the same numbers in the answers."""
    for id in IDS:
        asked = [
            [(known[0], known[1]["x"], known[1]["y"]) for text, _ in sheet(id, language)[1]
             if (known := asked_of(sheet(id, language)[0], text))]
            for language in LANGUAGES
        ]  # fmt: skip
        assert asked[0] == asked[1]


def test_facts_have_no_more_than_they_were_given() -> None:
    """No figure of a sheet is a rounded one but roots and turned axes: six decimals."""
    student, _ = sheet("08-glass", "en")
    glass = next(each for each in student.things if each.name == "glass sphere")
    assert glass.ior == 1.5168 and glass.centre.tolist() == [-0.12, -0.15, 0.8]
    assert not re.search(r"\d{7}", str(student.eye))


def test_a_tangent_pixel_is_never_asked() -> None:
    """The line through pixel (7, 7) of 15 touches scene 3's ellipsoid: right tracers differ there,
    and it was question 4 once."""
    from raywalk.trace.plan import LEAST_SHARE
    from raywalk.trace.sheet_sights import sights_of
    from raywalk.trace.wavefront import Tracer

    scene = next(each for each in read_scenes(ROOT / "scenes") if each.id == "03-two-lights")
    pixels = [7 * 15 + 7, 11 * 15 + 7, 14 * 15 + 14]
    tangent, floor, corner = sights_of(Tracer(scene, least_share=LEAST_SHARE), pixels, 15, [])
    assert not tangent.is_sure and floor.is_sure and corner.is_sure


def test_nothing_behind_an_opaque_wall_is_listed() -> None:
    """Up to the first plane that lets nothing through."""
    for id in IDS:
        sources = next(each for each in lessons()["en"] if each.scene.id == id)
        scene = sources.scene
        for fact in sheet_facts(sources.lesson(WIDE))["asked"]:
            things = [scene.objects[k] for k, _ in fact.get("hits", ())]
            walls = [
                type(thing.shape).__name__ == "Plane"
                and scene.materials[thing.material].transmit == 0
                for thing in things
            ]
            assert not any(walls[:-1])
