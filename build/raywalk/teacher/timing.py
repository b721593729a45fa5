"""How a lesson fills 45 or 90 minutes."""

from __future__ import annotations

from dataclasses import dataclass

from raywalk.scene.model import Scene
from raywalk.slides.words import say

# Minutes by what is not the lesson itself, for each of LECTURES; the rest is the lesson's.
AROUND = {
    45: {"open": 3, "sheet": 10, "close": 3},
    90: {"open": 5, "sheet": 30, "assignment": 12, "close": 5},
}
QUESTION = 2.0  # a question takes so many times what a step does: predict, vote, discuss


@dataclass(frozen=True)
class Part:
    """Of a lesson: steps that follow each other, or one question. Steps from 1."""

    first: int
    last: int
    is_question: bool

    @property
    def weight(self) -> float:
        return QUESTION if self.is_question else float(self.last - self.first + 1)

    @property
    def words(self) -> str:
        if self.is_question:
            return say("teacher.timeQuestion", step=self.first)
        if self.first == self.last:
            return say("teacher.timeStep", step=self.first)
        return say("teacher.timeSteps", first=self.first, last=self.last)


def parts_of(scene: Scene) -> list[Part]:
    parts: list[Part] = []
    for k, step in enumerate(scene.lesson, start=1):
        asks = bool(step.answer)
        if parts and not asks and not parts[-1].is_question:
            parts[-1] = Part(parts[-1].first, k, False)
        else:
            parts.append(Part(k, k, asks))
    return parts


def schedule(scene: Scene, length: int) -> list[tuple[str, int]]:
    """What is done, and its whole minutes; together the length."""
    around, parts = AROUND[length], parts_of(scene)
    left = length - sum(around.values())
    minutes = shared(left, [part.weight for part in parts])
    rows = [(say("teacher.timeOpen"), around["open"])]
    rows += [(part.words, given) for part, given in zip(parts, minutes, strict=True)]
    rows.append((say("teacher.timeSheet"), around["sheet"]))
    if "assignment" in around:
        rows.append((say("teacher.timeAssignment"), around["assignment"]))
    return [*rows, (say("teacher.timeClose"), around["close"])]


def shared(whole: int, weights: list[float]) -> list[int]:
    """Whole numbers by these weights that add up to the whole: the largest rests are rounded up."""
    exact = [whole * weight / sum(weights) for weight in weights]
    given = [int(each) for each in exact]
    by_rest = sorted(range(len(exact)), key=lambda k: given[k] - exact[k])
    for k in by_rest[: whole - sum(given)]:
        given[k] += 1
    return given
