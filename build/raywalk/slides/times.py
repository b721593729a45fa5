"""How long a lesson takes in a hall, and which lessons go into one lecture."""

from __future__ import annotations

from raywalk.scene.model import Scene

STEP_MINUTES = 2
LIVE_MINUTES = 5  # for the live page at the end
LECTURES = (45, 90)  # minutes


def lesson_minutes(scene: Scene) -> int:
    return STEP_MINUTES * len(scene.lesson) + LIVE_MINUTES


def parted(minutes: list[int], most: int) -> list[list[int]]:
    """Lessons, by their places, in as many lectures as it takes, in order; one that is longer by
    itself has its own."""
    lectures: list[list[int]] = []
    left = 0
    for k, needed in enumerate(minutes):
        if needed > left or not lectures:
            lectures.append([])
            left = most
        lectures[-1].append(k)
        left -= needed
    return lectures
