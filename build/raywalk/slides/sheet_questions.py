"""A worksheet's questions: those that the trace answers, and the lesson's own."""

from __future__ import annotations

import json
from typing import Any

from raywalk.scene.model import Scene
from raywalk.slides.choices import choice_words
from raywalk.slides.formats import SIGHTS
from raywalk.slides.lesson_words import plain_text
from raywalk.slides.sheet_facts import Facts
from raywalk.slides.sheet_question import Fact, Question
from raywalk.slides.sheet_worked import worked_questions
from raywalk.slides.step_slide import Lesson
from raywalk.slides.words import numbers, say, words

ASKS = {
    "nearest": "slides.askNearest", "order": "slides.askOrder", "shadow": "slides.askShadow",
    "lambert": "slides.askLambert", "reflected": "slides.askReflected",
    "refracted": "slides.askRefracted", "bytes": "slides.askBytes",
}  # fmt: skip


def sheet_facts(lesson: Lesson) -> Facts:
    """What the tracer answered (trace/sheet_pixels.py)."""
    facts: Facts = json.loads((lesson.views / SIGHTS).read_bytes())["worksheet"]
    return facts


def questions(lesson: Lesson) -> list[Question]:
    """From the trace of the lesson's first grid, of what the lesson works out, and its own."""
    facts = sheet_facts(lesson)
    asked = [traced_question(lesson.scene, facts["n"], fact) for fact in facts["asked"]]
    return asked + worked_questions(lesson) + own_questions(lesson)


def own_questions(lesson: Lesson) -> list[Question]:
    """Those that the lesson asks."""
    scene, stops = lesson.scene, {s.step: s for s in lesson.stops if s.kind == "question"}
    return [
        Question(
            plain_text(step.text, on_page=True), plain_text(step.answer, on_page=True),
            choices=tuple(choice_words(scene, step)), stop=stops[k],
        )
        for k, step in enumerate(scene.lesson)
        if step.answer
    ]  # fmt: skip


def traced_question(scene: Scene, n: int, fact: Fact) -> Question:
    x, y = fact["pixel"]
    at: dict[str, Any] = {"x": x, "y": y, "n": n}
    the, of = words().the, fact["of"]
    if of in ("shadow", "lambert", "reflected", "refracted"):
        at["name"] = the(scene.objects[fact["object"]].name)
    if of in ("shadow", "lambert"):
        at["light"] = the(scene.lights[fact["light"]].name)
    if of == "bytes":
        at["colour"] = numbers().vector(fact["colour"])
    return Question(say(ASKS[of], **at), _answer(scene, fact), fact)


def _answer(scene: Scene, fact: Fact) -> str:
    match fact["of"]:
        case "nearest":
            return _meets(scene, fact, fact["object"])
        case "order":
            return "; ".join(
                say("event.meetsFirst.hit", name=scene.objects[k].name, t=numbers().number(t))
                for k, t in fact["hits"]
            )
        case "shadow" if fact["blocker"] is None:
            return say("slides.answerArrives")
        case "shadow":
            blocker = words().the(scene.objects[fact["blocker"]].name)
            return say("slides.answerBlocked", name=blocker)
        case "lambert":
            return say("slides.answerLambert", cosine=numbers().number(fact["cosine"]))
        case "bytes":
            return say("slides.answerBytes", bytes=", ".join(map(str, fact["bytes"])))
    return _meets(scene, fact, fact["met"])


def _meets(scene: Scene, fact: Fact, thing: int | None) -> str:
    if thing is None:
        return say("slides.answerLeaves")
    return say(
        "slides.answerNearest", name=scene.objects[thing].name, t=numbers().number(fact["t"]),
        point=numbers().vector(fact["point"]),
    )  # fmt: skip
