"""What a lesson works out, on its worksheet: what its own questions need, and questions about the
rest of it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Any

from raywalk.scene.model import Scene
from raywalk.slides.sheet_question import Question
from raywalk.slides.step_slide import Lesson
from raywalk.slides.stops import Stop
from raywalk.slides.words import numbers, place, say, words
from raywalk.slides.worked_average import mean_of, rays_of, samples_of
from raywalk.slides.worked_equation import equation_of
from raywalk.slides.worked_figures import view_of
from raywalk.slides.worked_panel import walks_tree
from raywalk.slides.worked_tree import CUT_OFF, ENTERED, MISSED, visits_of

NINE = 9  # rays of a tile that a person averages on paper
# A discriminant of printed numbers is off by some hundredths: nearer to 0 it has no sure sign.
LEAST = 0.1

Json = dict[str, Any]


def worked_given(lesson: Lesson) -> list[str]:
    """A line each; [] of a lesson that works nothing out."""
    lines = [_example(lesson.scene, *pair) for pair in _pairs(lesson)[:1]]
    lines += [_rays_of_tile(lesson, stop) for stop in _tiles(lesson)]
    walked = _walked(lesson)
    lines += [_boxes(lesson, stop) for stop in walked]
    return lines + [_levels(lesson, stop) for stop in walked[:1]]


def worked_questions(lesson: Lesson) -> list[Question]:
    """Answered by the numbers that the lesson's page shows."""
    scene = lesson.scene
    asked = [_where_met(scene, *pair) for pair in _pairs(lesson)[1:]]
    for stop in _tiles(lesson):
        mean = ", ".join(map(str, mean_of(lesson.worked, stop, NINE)))
        asked.append(Question(say("sheet.worked.askMean", **place(stop)), mean))
    for stop in _walked(lesson):
        tests = visits_of(lesson.worked, stop.pixel)[-1].tests
        asked.append(Question(say("sheet.worked.askTests", **place(stop)), str(tests)))
    return asked


def _shown(lesson: Lesson, works: str) -> Iterator[Stop]:
    """Stops at which something is worked out, none whose question is still open."""
    for stop in lesson.stops:
        if view_of(lesson.scene, stop).get("works") == works and stop.kind != "question":
            yield stop


def _pairs(lesson: Lesson) -> list[tuple[Stop, Json, Json]]:
    """Rays with the spheres that a step is about, each once: a sure hit or a sure miss."""
    pairs: dict[object, tuple[Stop, Json, Json]] = {}
    for stop in _shown(lesson, "equation"):
        ray = equation_of(lesson.worked, stop)
        meant = view_of(lesson.scene, stop).get("highlight") or ()
        for sphere in ray["spheres"] if ray else ():
            is_meant = lesson.scene.objects[sphere["object"]].name in meant
            if ray and is_meant and abs(sphere["discriminant"]) > LEAST:
                pairs.setdefault((stop.pixel, sphere["object"]), (stop, ray, sphere))
    return list(pairs.values())


def _example(scene: Scene, stop: Stop, ray: Json, sphere: Json) -> str:
    name, direction = _the(scene, sphere), numbers().vector(ray["direction"])
    found = _found(sphere)
    return say("sheet.worked.example", **place(stop), name=name, direction=direction, found=found)


def _where_met(scene: Scene, stop: Stop, ray: Json, sphere: Json) -> Question:
    asks = say("sheet.worked.askEquation", **place(stop), name=_the(scene, sphere))
    return Question(asks, _found(sphere))


def _the(scene: Scene, sphere: Json) -> str:
    return words().the(scene.objects[sphere["object"]].name)


def _found(sphere: Json) -> str:
    """b, c and D; and the roots, if there are any."""
    said = say("sheet.worked.found", **{
        key: numbers().number(sphere[name])
        for key, name in (("b", "b"), ("c", "c"), ("d", "discriminant"))
    })  # fmt: skip
    if not sphere["t"]:
        return said + say("sheet.worked.noRoot")
    first, second = map(numbers().number, sphere["t"])
    return said + say("sheet.worked.roots", first=first, second=second)


def _tiles(lesson: Lesson) -> list[Stop]:
    """Tiles of which the lesson shows nine rays."""
    stops = {
        stop.pixel: stop for stop in _shown(lesson, "average")
        if rays_of(lesson.scene, stop) == NINE
    }  # fmt: skip
    return list(stops.values())


def _rays_of_tile(lesson: Lesson, stop: Stop) -> str:
    rays = samples_of(lesson.worked, stop, NINE).reshape(-1, 3).tolist()
    listed = "; ".join(", ".join(map(str, ray)) for ray in rays)
    return say("sheet.worked.rays", **place(stop), listed=listed)


def _walked(lesson: Lesson) -> list[Stop]:
    """Rays that go through the whole tree, each once."""
    stops = [stop for stop in lesson.stops if walks_tree(lesson.scene, stop)]
    return list({stop.pixel: stop for stop in reversed(stops)}.values())[::-1]


def _boxes(lesson: Lesson, stop: Stop) -> str:
    visits = visits_of(lesson.worked, stop.pixel)
    counts = Counter(visit.what for visit in visits)
    return say(
        "sheet.worked.boxes", **place(stop), missed=counts[MISSED], entered=counts[ENTERED],
        off=counts[CUT_OFF], triangles=sum(visit.triangles for visit in visits),
    )  # fmt: skip


def _levels(lesson: Lesson, stop: Stop) -> str:
    asked = Counter(visit.level for visit in visits_of(lesson.worked, stop.pixel))
    listed = ", ".join(str(asked[level]) for level in sorted(asked))
    return say("sheet.worked.levels", **place(stop), listed=listed, count=len(asked))
