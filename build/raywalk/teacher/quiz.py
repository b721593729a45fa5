"""A lesson's quiz: its questions with choices, and a worksheet's whose answer is a number or a yes.
GIFT and QTI write the same items."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from raywalk.scene.model import Scene
from raywalk.slides.sheet_question import Fact
from raywalk.slides.sheet_questions import own_questions, sheet_facts
from raywalk.slides.step_slide import Lesson
from raywalk.slides.words import say, words

# Who rounds to three digits on the way is off by less.
TOLERANCE = 0.005  # of the value, and of 1 where that is less
DISTANCES = {"nearest": "teacher.quizNearest", "reflected": "teacher.quizReflected",
             "refracted": "teacher.quizRefracted"}  # fmt: skip


@dataclass(frozen=True)
class Option:
    text: str
    right: bool
    because: str


@dataclass(frozen=True)
class Item:
    """Of a quiz. Either options, of which one is right, or a value with a tolerance."""

    id: str  # unique in the course: an XML name
    title: str
    asks: str
    options: tuple[Option, ...] = ()
    value: float = 0.0
    tolerance: float = 0.0
    feedback: str = ""  # when all is answered


def items_of(lesson: Lesson) -> list[Item]:
    """In the lesson's order, then what is to be worked out."""
    return [*_chosen(lesson), *_worked_out(lesson)]


def _chosen(lesson: Lesson) -> Iterator[Item]:
    for question in own_questions(lesson):
        stop = question.stop
        if not question.choices or not stop:
            continue
        x, y = stop.pixel
        where = say("teacher.quizWhere", title=lesson.scene.title, step=stop.step + 1, x=x, y=y,
                    n=stop.n)  # fmt: skip
        yield Item(
            _id(lesson.scene, f"step-{stop.step + 1}"), _title(lesson.scene, stop.step + 1),
            f"{question.asks} {where}",
            tuple(Option(each.label, each.right, each.because) for each in question.choices),
            feedback=question.answer,
        )  # fmt: skip


def _worked_out(lesson: Lesson) -> Iterator[Item]:
    scene, facts = lesson.scene, sheet_facts(lesson)
    given = say("teacher.quizGiven", title=scene.title)
    for k, fact in enumerate(facts["asked"]):
        told = _told(scene, facts["n"], fact)
        if told:
            asks, more = told
            title = f"{scene.title}: {say('teacher.sheet')} {k + 1}"
            yield Item(_id(scene, f"sheet-{k + 1}"), title, f"{asks} {given}", **more)


def _told(scene: Scene, n: int, fact: Fact) -> tuple[str, dict[str, Any]] | None:
    """What is asked, and what the answer is; None: no quiz asks this."""
    at: dict[str, Any] = {"x": fact["pixel"][0], "y": fact["pixel"][1], "n": n}
    the = words().the
    match fact["of"]:
        case "nearest" | "reflected" | "refracted" if fact.get("t") is not None:
            return say(DISTANCES[fact["of"]], **at), numeric(fact["t"])
        case "lambert":
            light = the(scene.lights[fact["light"]].name)
            return say("teacher.quizLambert", light=light, **at), numeric(fact["cosine"])
        case "bytes":
            red = {"value": float(fact["bytes"][0])}
            return say("teacher.quizBytes", red=f"{fact['colour'][0]:.3f}"), red
        case "shadow":
            light = the(scene.lights[fact["light"]].name)
            return say("teacher.quizShadow", light=light, **at), _yes_or_no(scene, fact)
    return None


def numeric(value: float) -> dict[str, Any]:
    """To three decimals, as the sheet's answers."""
    shown = round(value, 3)
    return {"value": shown, "tolerance": round(max(TOLERANCE, TOLERANCE * abs(shown)), 3)}


def _yes_or_no(scene: Scene, fact: Fact) -> dict[str, Any]:
    arrives = fact["blocker"] is None
    if arrives:
        because = say("slides.answerArrives")
    else:
        blocker = words().the(scene.objects[fact["blocker"]].name)
        because = say("slides.answerBlocked", name=blocker)
    yes = Option(say("teacher.yes"), arrives, because)
    return {"options": (yes, Option(say("teacher.no"), not arrives, because))}


def _id(scene: Scene, of: str) -> str:
    return f"raywalk-{words().code}-{scene.id}-{of}"


def _title(scene: Scene, step: int) -> str:
    return say("teacher.stepOf", title=scene.title, step=step)
