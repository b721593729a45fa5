"""Which mistake is this? Rounds of questions, one a family: wrong pictures, each with four mistakes
to choose from, found from what clarity.py says, so that any course has them of its own scenes."""

from __future__ import annotations

from typing import Any, NamedTuple
from zlib import crc32

from raywalk.mistake_pages.best import Shown
from raywalk.mistakes.table import BY_NAME, FAMILIES, TABLE

CHOICES = 4
MOST = 6  # questions a round: ten minutes of a lesson
LEAST = 2  # of fewer a family is not asked
# Of the pixels: 5 of the small picture, a spot of 16 x 16 in the one that is shown.
SEEN = 0.005
# Twice that, and a tenth of what is wrong: two pictures that differ in less might be taken for one.
TOLD_APART, OF_WRONG = 2 * SEEN, 1 / 10
KIN = 2  # choices of the same family, if so many can be told apart
# Of other families: what changes far less than the picture does is no guess at it.
COMPARABLE = 1 / 4
# ... and one is a better guess than more kin if it leaves so much less of what is seen.
CLOSER = 1 / 2
# ... but where things stand as they should nobody suspects the camera.
PLACES = "camera"
# Seen in a small picture; in the one that is shown only by edges, laid over the right one.
NOT_BY_EYE = frozenset({"pixel-corner"})


class Question(NamedTuple):
    """A picture of a mistake in the scene that its page shows."""

    name: str
    scene: str
    choices: tuple[str, ...]  # mistakes, its own among them, in the order in which they are asked


class Round(NamedTuple):
    """Of one family, from what is seen most plainly on."""

    family: str
    questions: tuple[Question, ...]


def rounds_of(shown: dict[str, Shown], of_scenes: dict[str, dict[str, Any]]) -> tuple[Round, ...]:
    """of_scenes: what clarity.json says, by scene. Families with too few questions are left out."""
    rounds = []
    for family in FAMILIES:
        asked = []
        for name in (mistake.name for mistake in TABLE if mistake.family == family):
            if name not in shown or name in NOT_BY_EYE:
                continue
            told = of_scenes[shown[name].best]
            if told["eye"][name] >= SEEN and (choices := choices_for(name, told)):
                asked.append((told["eye"][name], Question(name, shown[name].best, choices)))
        asked.sort(key=lambda each: -each[0])
        if len(asked) >= LEAST:
            rounds.append(Round(family, tuple(spread([question for _, question in asked]))))
    return tuple(rounds)


def spread(questions: list[Question]) -> list[Question]:
    """At most MOST of them, evenly from the first to the last."""
    last = len(questions) - 1
    if last < MOST:
        return questions
    return [questions[round(k * last / (MOST - 1))] for k in range(MOST)]


def choices_for(name: str, told: dict[str, Any]) -> tuple[str, ...]:
    """Mistakes that one would weigh: kin and others that look most like it, yet cannot be taken for
    it. None if there are too few. told: what clarity.json says of the scene."""
    apart = {
        other: seen for other, seen in told["near"][name] if may_stand_beside(name, other, told)
    }
    kin = [other for other in apart if is_kin(name, other)]  # the most alike first
    rest = [other for other in apart if other not in kin[:KIN]]
    rest.sort(key=lambda other: apart[other] / (1 if is_kin(name, other) else CLOSER))
    chosen = [*kin[:KIN], *rest][: CHOICES - 1]
    if len(chosen) < CHOICES - 1:
        return ()
    return tuple(sorted([name, *chosen], key=lambda each: shuffled(name, each)))


def may_stand_beside(name: str, other: str, told: dict[str, Any]) -> bool:
    """Whether one would weigh it, and be wrong."""
    eye, seen = told["eye"], dict(told["near"][name])[other]
    if seen < max(TOLD_APART, OF_WRONG * eye[name]) or eye[other] < SEEN or other in NOT_BY_EYE:
        return False
    if is_kin(name, other):
        return True
    return BY_NAME[other].family != PLACES and bool(eye[other] >= COMPARABLE * eye[name])


def is_kin(one: str, other: str) -> bool:
    """Of one family."""
    return BY_NAME[one].family == BY_NAME[other].family


def shuffled(name: str, choice: str) -> int:
    """A place that stays from build to build and tells nothing."""
    return crc32(f"{name} or {choice}".encode())
